// SPDX-License-Identifier: MIT
// The shapes of the Occlusion Unit's parallel form as vertices in clip coordinates, and where in the window
// each may have fragments. Nothing here calls GL.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace glext_emu {

// Pixels; empty where width or height is 0.
struct PixelBounds {
    std::int32_t left = 0;
    std::int32_t bottom = 0;
    std::int32_t width = 0;
    std::int32_t height = 0;
};

// What clip coordinates become in the window.
struct WindowMap {
    std::array<float, 4> viewport{};  // x, y, width, height
    bool is_upside_down = false;      // CLIP_ORIGIN is UPPER_LEFT
    PixelBounds drawn;                // beyond it nothing is drawn
};

struct ShapeVertex {
    std::array<float, 4> clip{};
    // Places in the sheet of marks: of the shape's header, and those that column 0 and row 0 would have.
    std::array<std::int32_t, 3> place{};
};

struct ShapeKind {
    GLsizei floats;    // of one shape, as the program gives it
    GLsizei vertices;  // of one shape, as it is drawn
    std::span<const std::uint8_t> triangles;
};

// BOX_EMU, HEXAHEDRON_EMU or QUAD_EMU.
ShapeKind kind_of_shape(GLenum shape);

// The clip coordinates of a shape's vertices by <matrix>, in column-major order; rounded as the driver rounds
// those of fixed function: one product and one sum after the other.
void transform_shape(GLenum shape, const float* given, const float* matrix, ShapeVertex* vertices);

// Moves a shape that is not finite out of sight; true where it had to.
bool hide_if_not_finite(std::span<ShapeVertex> vertices);

// True where nothing of the shape is clipped.
bool is_inside_volume(std::span<const ShapeVertex> vertices);

// Where the shape may have fragments, a pixel more on each side than rounding can add. A shape that is not
// finite is moved out of sight, and has none.
PixelBounds bound_shape(const WindowMap& window, std::span<ShapeVertex> vertices);

// Indices of <count> shapes whose vertices follow one another.
std::vector<std::uint16_t> shape_indices(GLenum shape, GLsizei count);

}  // namespace glext_emu
