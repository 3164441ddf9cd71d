// SPDX-License-Identifier: MIT
// GL 4.5, 17.3.5 (stencil test) and 17.3.6 (depth buffer test), to the letter.
#include "witness/simulation.h"

#include <algorithm>
#include <utility>

namespace conformance {

namespace {

template <typename Value>
bool passes(GLenum function, Value incoming, Value stored) {
    switch (function) {
        case GL_NEVER:
            return false;
        case GL_LESS:
            return incoming < stored;
        case GL_EQUAL:
            return incoming == stored;
        case GL_LEQUAL:
            return incoming <= stored;
        case GL_GREATER:
            return incoming > stored;
        case GL_NOTEQUAL:
            return incoming != stored;
        case GL_GEQUAL:
            return incoming >= stored;
        default:
            return true;
    }
}

std::uint8_t operated(GLenum operation, std::uint8_t value, GLint reference) {
    switch (operation) {
        case GL_ZERO:
            return 0;
        case GL_REPLACE:
            return static_cast<std::uint8_t>(reference);
        case GL_INCR:
            return value == 0xFF ? value : static_cast<std::uint8_t>(value + 1);
        case GL_DECR:
            return value == 0 ? value : static_cast<std::uint8_t>(value - 1);
        case GL_INCR_WRAP:
            return static_cast<std::uint8_t>(value + 1);
        case GL_DECR_WRAP:
            return static_cast<std::uint8_t>(value - 1);
        case GL_INVERT:
            return static_cast<std::uint8_t>(~value);
        default:
            return value;
    }
}

}  // namespace

Simulation::Simulation(const Target& target, Buffers initial, GLenum far_end)
    : target_(target), buffers_(std::move(initial)), far_end_(far_end) {
    registers_.nearest_depth = far_end == GL_ONE ? 1.0f : 0.0f;
}

void Simulation::draw(const std::vector<FragmentLayer>& fragments, const Pipeline& pipeline,
                      const Settings& settings) {
    for (const FragmentLayer& layer : fragments) {
        for (std::size_t sample = 0; sample < layer.is_there.size(); ++sample) {
            if (!layer.is_there[sample]) continue;
            const std::size_t side = layer.is_front[sample] ? 0 : 1;
            step(sample, layer.depth[sample], side, pipeline, settings.references[side]);
        }
    }
}

void Simulation::step(std::size_t sample, float depth, std::size_t side, const Pipeline& pipeline,
                      GLint reference) {
    const bool has_stencil_test = pipeline.tests_stencil && target_.has_stencil();
    const StencilFace& face = pipeline.faces[side];
    const auto write_stencil = [&](GLenum operation) {
        if (!has_stencil_test) return;
        std::uint8_t& stencil = buffers_.stencil[sample];
        const std::uint8_t value = operated(operation, stencil, reference);
        const auto mask = static_cast<std::uint8_t>(pipeline.stencil_mask);
        stencil = static_cast<std::uint8_t>((value & mask) | (stencil & ~mask));
    };
    if (has_stencil_test) {
        const GLuint compared = pipeline.compare_mask;
        if (!passes(face.function, static_cast<GLuint>(reference) & compared,
                    buffers_.stencil[sample] & compared)) {
            return write_stencil(face.fails);
        }
    }
    ++registers_.projected_hits;
    float& stored = buffers_.depth[sample];
    if (pipeline.tests_depth && !passes(pipeline.depth_function, depth, stored))
        return write_stencil(face.depth_fails);
    write_stencil(face.passes);
    see(sample, depth);
    if (pipeline.tests_depth && pipeline.writes_depth) stored = depth;
}

void Simulation::see(std::size_t sample, float depth) {
    const std::size_t pixel = target_.pixel_of(sample);
    const int x = static_cast<int>(pixel) % target_.width();
    const int y = static_cast<int>(pixel) / target_.width();
    std::array<int, 4>& box = registers_.box;
    if (registers_.visible_hits == 0) {
        box = {x, y, x, y};
    } else {
        box = {std::min(box[0], x), std::min(box[1], y), std::max(box[2], x), std::max(box[3], y)};
    }
    ++registers_.visible_hits;
    float& nearest = registers_.nearest_depth;
    nearest = far_end_ == GL_ONE ? std::min(nearest, depth) : std::max(nearest, depth);
}

}  // namespace conformance
