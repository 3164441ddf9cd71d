// SPDX-License-Identifier: MIT
// What a culler knows of the camera, and the two questions that must never be answered too boldly: is a box
// outside the frustum, and which proxy may stand for a box in an occlusion test? When in doubt: inside, and
// visible.
#pragma once

#include <array>
#include <optional>

#include "apps/scene/box.h"
#include "apps/scene/camera.h"

namespace apps {

struct View {
    View(const Camera& camera, int width_pixels, int height_pixels);

    glm::mat4 modelview;   // exactly the floats that GL is given
    glm::mat4 projection;  // a perspective one
    glm::vec3 eye;         // metres
    float near_metres;
    int width;                         // pixels
    int height;                        // pixels
    glm::dmat4 clip;                   // projection * modelview
    std::array<glm::dvec4, 6> planes;  // of the frustum, unit normals, positive inside
    double near_corner_metres;         // from the eye to a corner of the near rectangle
    double pixel_slope;                // metres that one pixel spans at w = 1 m, the larger of both axes
};

/// True only where no point of the box can reach a sample. Margin: 1e-5 of the distances in play, for float
/// rounding.
bool is_outside(const View& view, const Box& box);

/// The box to draw in place of what `box` encloses: grown by `growth_pixels` on the screen, at its far end
/// too. Nothing where an occlusion test may lie: the eye is in the box or near it, the near plane cuts it, or
/// a corner is not a number. The caller takes such a box as visible.
std::optional<Box> proxy_of(const View& view, const Box& box, float growth_pixels);

/// Half a pixel is what rasterisation can lose at a silhouette.
inline constexpr float kSafeGrowthPixels = 0.5F;

}  // namespace apps
