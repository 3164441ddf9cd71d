// SPDX-License-Identifier: MIT
// A bounding volume hierarchy of axis-aligned boxes, over the objects of a scene or over bare triangles, by
// the surface area heuristic in bins (Wald: On fast construction of SAH-based bounding volume hierarchies,
// 2007). Each object or triangle hangs in one leaf, so that what moves can take its boxes along. Built by as
// many threads as there are; the same bits whatever their number.
#pragma once

#include <span>

#include "apps/hierarchy/soup.h"
#include "apps/hierarchy/tree.h"

namespace apps {

/// When to stop dividing. Both limits are reached before it stops, except that a leaf of one object, or of
/// one triangle of a soup, is not divided.
struct BvhLimits {
    static constexpr std::size_t kAny = ~std::size_t{0};
    /// Leaves to make, those first that lower the expected cost of the tree most; at least 1.
    std::size_t leaves = 1;
    /// Most triangles in a leaf.
    std::size_t leaf_triangles = kAny;
};

/// A scene without objects gives one leaf with an empty box.
Tree build_bvh(const Scene& scene, const BvhLimits& limits);

/// A tree over triangles without objects: Tree::objects lists triangle numbers. At most 2^32 - 1 triangles;
/// needs 36 bytes a triangle while it builds.
Tree build_bvh(std::span<const SoupTriangle> soup, const BvhLimits& limits);

}  // namespace apps
