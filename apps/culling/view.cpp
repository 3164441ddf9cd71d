// SPDX-License-Identifier: MIT
// Conservative answers about boxes. In double: the camera's floats are exact in it, and rounding is 1e-16,
// not 1e-7.
#include "apps/culling/view.h"

#include <cmath>

namespace apps {
namespace {

double w_of(const View& view, const glm::vec3& point) {
    return view.clip[0].w * point.x + view.clip[1].w * point.y + view.clip[2].w * point.z + view.clip[3].w;
}

}  // namespace

View::View(const Camera& camera, int width_pixels, int height_pixels)
    : modelview(camera.view_matrix()),
      projection(camera.projection_matrix(width_pixels, height_pixels)),
      eye(camera.eye),
      near_metres(camera.lens.near_metres),
      width(width_pixels),
      height(height_pixels),
      clip(glm::dmat4(projection) * glm::dmat4(modelview)) {
    const auto row = [&](int i) { return glm::dvec4(clip[0][i], clip[1][i], clip[2][i], clip[3][i]); };
    for (int axis = 0; axis < 3; ++axis) {
        planes[static_cast<std::size_t>(2 * axis)] = row(3) + row(axis);
        planes[static_cast<std::size_t>(2 * axis + 1)] = row(3) - row(axis);
    }
    for (glm::dvec4& plane : planes) plane /= glm::length(glm::dvec3(plane));

    // Tangents of half the angles of view: clip.x = eye.x / tan_x where w = -eye.z.
    const double tan_x = 1 / static_cast<double>(projection[0][0]);
    const double tan_y = 1 / static_cast<double>(projection[1][1]);
    near_corner_metres = near_metres * std::sqrt(1 + tan_x * tan_x + tan_y * tan_y);
    pixel_slope = 2 * std::max(tan_x / width, tan_y / height);
}

bool is_outside(const View& view, const Box& box) {
    for (const glm::dvec4& plane : view.planes) {
        const glm::dvec3 normal(plane);
        const glm::dvec3 low(box.min);
        const glm::dvec3 high(box.max);
        // The corner farthest along the normal: if it is outside, all are.
        const glm::dvec3 farthest = glm::mix(low, high, glm::greaterThan(normal, glm::dvec3(0)));
        const double distance = glm::dot(normal, farthest) + plane.w;
        const double margin = 1e-5 * (1 + glm::length(farthest) + std::abs(plane.w));
        if (distance < -margin) return true;
    }
    return false;
}

std::optional<Box> proxy_of(const View& view, const Box& box, float growth_pixels) {
    double w_max = 0;
    for (int corner = 0; corner < 8; ++corner) w_max = std::max(w_max, w_of(view, box.corner(corner)));
    // Case 4, sub-pixel boxes: a sphere of this radius covers growth_pixels at every depth up to w_max.
    const auto growth = static_cast<float>(growth_pixels * w_max * view.pixel_slope);
    const Box grown = box.grown(growth);

    // Case 2, the eye in the box: not even between the eye and a corner of the near rectangle.
    if (grown.grown(static_cast<float>(view.near_corner_metres) * 1.001F).contains(view.eye))
        return std::nullopt;
    // Case 1, cut by the near plane; case 3, no number: `!(w > near)` holds for NaN, `w <= near` would not.
    for (int corner = 0; corner < 8; ++corner)
        if (!(w_of(view, grown.corner(corner)) > view.near_metres * 1.001)) return std::nullopt;
    return grown;
}

}  // namespace apps
