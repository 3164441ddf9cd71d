// SPDX-License-Identifier: MIT
// A kD-tree over the objects of a scene, built by the surface-area heuristic (MacDonald, Booth: Heuristics
// for ray tracing using space subdivision, 1990), as the CHC paper uses it. A node's box is the union of
// (object's box, cut to the cell).
#pragma once

#include "apps/hierarchy/tree.h"

namespace apps {

/// Splits the leaf that gains most until `leaves` leaves exist or none gains. A scene without objects gives
/// one leaf.
Tree build_kd_tree(const Scene& scene, std::size_t leaves);

}  // namespace apps
