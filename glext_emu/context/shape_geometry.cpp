// SPDX-License-Identifier: MIT
#include "context/shape_geometry.h"

#include <GL/glext_emu.h>

#include <algorithm>
#include <cmath>

namespace glext_emu {
namespace {

// EMU_occlusion_unit: (a, b, c) and (a, c, d) of each face, counter-clockwise as seen from outside.
constexpr std::array<std::uint8_t, 6> kQuadTriangles = {0, 1, 2, 0, 2, 3};
constexpr std::array<std::uint8_t, 36> kHexahedronTriangles = {
    0, 4, 6, 0, 6, 2,  // smaller x
    1, 3, 7, 1, 7, 5,  // larger x
    0, 1, 5, 0, 5, 4,  // smaller y
    2, 6, 7, 2, 7, 3,  // larger y
    0, 2, 3, 0, 3, 1,  // smaller z
    4, 5, 7, 4, 7, 6,  // larger z
};

bool is_finite(const ShapeVertex& vertex) {
    return std::ranges::all_of(vertex.clip, [](float value) { return std::isfinite(value); });
}

}  // namespace

ShapeKind kind_of_shape(GLenum shape) {
    switch (shape) {
        case GL_BOX_EMU:
            return {6, 8, kHexahedronTriangles};
        case GL_HEXAHEDRON_EMU:
            return {24, 8, kHexahedronTriangles};
        default:
            return {12, 4, kQuadTriangles};
    }
}

void transform_shape(GLenum shape, const float* given, const float* matrix, ShapeVertex* vertices) {
    const bool is_box = shape == GL_BOX_EMU;
    const GLsizei count = kind_of_shape(shape).vertices;
    for (GLsizei k = 0; k < count; ++k) {
        const float* const point = given + 3 * k;
        const float x = is_box ? given[(k & 1) != 0 ? 3 : 0] : point[0];
        const float y = is_box ? given[(k & 2) != 0 ? 4 : 1] : point[1];
        const float z = is_box ? given[(k & 4) != 0 ? 5 : 2] : point[2];
        for (std::size_t row = 0; row < 4; ++row) {
            vertices[k].clip[row] =
                x * matrix[row] + y * matrix[4 + row] + z * matrix[8 + row] + matrix[12 + row];
        }
    }
}

bool hide_if_not_finite(std::span<ShapeVertex> vertices) {
    if (std::ranges::all_of(vertices, is_finite)) return false;
    for (ShapeVertex& vertex : vertices) vertex.clip = {2, 2, 2, 1};
    return true;
}

bool is_inside_volume(std::span<const ShapeVertex> vertices) {
    return std::ranges::all_of(vertices, [](const ShapeVertex& vertex) {
        const auto& [x, y, z, w] = vertex.clip;
        const float most = std::max({std::abs(x), std::abs(y), std::abs(z)});
        return w > 0 && most < w;
    });
}

PixelBounds bound_shape(const WindowMap& window, std::span<ShapeVertex> vertices) {
    if (hide_if_not_finite(vertices)) return {};
    constexpr float kMargin = 2;
    constexpr float kTiny = 1e-6F;  // of the coordinates: a point so near the eye may be anywhere
    const auto& [x, y, width, height] = window.viewport;
    const float far_right = static_cast<float>(window.drawn.left + window.drawn.width);
    const float far_top = static_cast<float>(window.drawn.bottom + window.drawn.height);
    float left = far_right, right = 0, bottom = far_top, top = 0;
    for (const ShapeVertex& vertex : vertices) {
        const auto& [cx, cy, cz, cw] = vertex.clip;
        if (!(cw > kTiny * (std::abs(cx) + std::abs(cy) + std::abs(cz)))) return window.drawn;
        const float at_x = x + width / 2 * (1 + cx / cw);
        const float at_y = y + height / 2 * (1 + (window.is_upside_down ? -cy : cy) / cw);
        left = std::min(left, at_x);
        right = std::max(right, at_x);
        bottom = std::min(bottom, at_y);
        top = std::max(top, at_y);
    }
    const auto clamped = [](float value, std::int32_t first, std::int32_t size) {
        const auto end = static_cast<float>(first + size);
        return static_cast<std::int32_t>(std::clamp(std::floor(value), static_cast<float>(first), end));
    };
    PixelBounds bounds;
    bounds.left = clamped(left - kMargin, window.drawn.left, window.drawn.width);
    bounds.bottom = clamped(bottom - kMargin, window.drawn.bottom, window.drawn.height);
    bounds.width =
        std::max(clamped(right + kMargin + 1, window.drawn.left, window.drawn.width) - bounds.left, 0);
    bounds.height =
        std::max(clamped(top + kMargin + 1, window.drawn.bottom, window.drawn.height) - bounds.bottom, 0);
    return bounds;
}

std::vector<std::uint16_t> shape_indices(GLenum shape, GLsizei count) {
    const ShapeKind kind = kind_of_shape(shape);
    std::vector<std::uint16_t> indices;
    indices.reserve(static_cast<std::size_t>(count) * kind.triangles.size());
    for (GLsizei i = 0; i < count; ++i) {
        for (const std::uint8_t corner : kind.triangles) {
            indices.push_back(static_cast<std::uint16_t>(i * kind.vertices + corner));
        }
    }
    return indices;
}

}  // namespace glext_emu
