// SPDX-License-Identifier: MIT
// How many triangles a draw command draws, as far as its arguments tell.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <cstdint>

#include "context/display_lists.h"

namespace glext_emu::features {

struct Triangles {
    std::uint64_t count = 0;
    bool is_known = true;
    DrawKind kind = DrawKind::kPrimitives;
};

constexpr Triangles unknown() {
    return {0, false};
}
// Of a rectangle of pixels.
constexpr Triangles no_triangles(DrawKind kind = DrawKind::kPixels) {
    return {0, true, kind};
}
constexpr Triangles rectangle() {
    return {2, true};
}

// GL 4.6 compatibility, 10.1: triangles of <count> vertices as primitives of <mode>. How many a patch becomes
// is the tessellator's to say.
constexpr Triangles triangles(GLenum mode, GLsizei count, GLsizei instances = 1) {
    const auto n = static_cast<std::uint64_t>(std::max(count, 0));
    const auto times = static_cast<std::uint64_t>(std::max(instances, 0));
    const auto at_least = [n](std::uint64_t first) { return n >= first ? n - first + 1 : 0; };
    switch (mode) {
        case GL_TRIANGLES:
            return {n / 3 * times};
        case GL_TRIANGLE_STRIP:
        case GL_TRIANGLE_FAN:
        case GL_POLYGON:
            return {at_least(3) * times};
        case GL_QUADS:
            return {n / 4 * 2 * times};
        case GL_QUAD_STRIP:
            return {(n >= 4 ? (n / 2 - 1) * 2 : 0) * times};
        case GL_TRIANGLES_ADJACENCY:
            return {n / 6 * times};
        case GL_TRIANGLE_STRIP_ADJACENCY:
            return {(n >= 6 ? (n - 4) / 2 : 0) * times};
        case GL_PATCHES:
            return unknown();
        default:
            return {};
    }
}

constexpr Triangles multi_triangles(GLenum mode, const GLsizei* count, GLsizei draws) {
    Triangles sum;
    for (GLsizei i = 0; i < draws; ++i) {
        const Triangles one = triangles(mode, count[i]);
        sum.count += one.count;
        sum.is_known = sum.is_known && one.is_known;
    }
    return sum;
}

}  // namespace glext_emu::features
