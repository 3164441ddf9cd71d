// SPDX-License-Identifier: MIT
// The state that a driver compiles for: a palette of a fixed seed, so that thousands of scenes need few
// compilations.
//
// What may vary from scene to scene for nothing (rectangles, references, ranges, culling) is in Settings.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "harness/draw.h"
#include "harness/gl.h"
#include "witness/random.h"
#include "witness/stages.h"
#include "witness/targets.h"

namespace conformance {

inline constexpr int kPipelinesPerTarget = 16;
static_assert(kTargetKinds.size() * kPipelinesPerTarget <= 150);

struct StencilFace {
    GLenum function;
    GLenum fails;
    GLenum depth_fails;
    GLenum passes;
    bool operator==(const StencilFace&) const = default;
};

struct Pipeline {
    Stages stages = Stages::kFixed;
    bool tests_depth = true;
    GLenum depth_function = GL_LESS;
    bool writes_depth = true;
    bool tests_stencil = false;
    std::array<StencilFace, 2> faces{};  // front, back
    GLuint stencil_mask = 0xFF;          // of writes
    GLuint compare_mask = 0xFF;
    GLenum alpha_function = GL_ALWAYS;  // GL_ALWAYS: no alpha test
    bool blends = false;
    bool has_logic_op = false;
    bool writes_colour = true;
    GLenum polygon_mode = GL_FILL;
    bool has_alpha_to_coverage = false;
    bool is_clipped = false;   // by a plane
    bool is_stippled = false;  // polygons
    bool is_reversed = false;  // meant for depths whose far end is 0

    bool writes_stencil() const;
};

struct Settings {
    std::array<GLint, 2> references{};  // stencil, front and back
    bool has_scissor = false;
    Rect scissor{};
    std::array<double, 2> depth_range = {0.0, 1.0};
    GLenum culled = GL_NONE;
    GLenum front = GL_CCW;
    bool has_offset = false;
    GLfloat offset_factor = 0.0f;
    GLfloat offset_units = 0.0f;
    bool clamps_depth = false;
    bool has_coverage = false;  // SAMPLE_COVERAGE
    GLfloat coverage = 1.0f;
    std::array<double, 4> plane{};  // in pixels
    GLfloat line_width = 1.0f;
    GLfloat point_size = 1.0f;
};

// Those of kTargetKinds[kind].
const std::vector<Pipeline>& pipelines_of(int kind);

Settings random_settings(Random& random, const Pipeline& pipeline, int width, int height);

// From the neutral state.
void apply(const Pipeline& pipeline, const Settings& settings);

std::string description(const Pipeline& pipeline);

// What GL_EMU_occlusion_unit lets be undetermined of a draw, on a target with or without stencil.
bool may_leave_nearest_depth(const Pipeline& pipeline, bool has_stencil, GLenum far_end);
bool may_leave_projected_hits(const Pipeline& pipeline, bool has_stencil);

}  // namespace conformance
