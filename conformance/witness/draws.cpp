// SPDX-License-Identifier: MIT
// How a draw is chosen.
#include "witness/draws.h"

#include <utility>

#include "witness/machine.h"

namespace conformance {

namespace {

// Depths that several shapes share, so that equal ones meet.
float common_depth(Random& random) {
    return 0.125f * static_cast<float>(random.integer(1, 7));
}

Vertex vertex(float x, float y, float z, float w, float alpha) {
    return {{x * w, y * w, z * w, w}, {0.25f, 0.5f, 0.75f, alpha}};
}

bool is_lines_or_points(GLenum mode) {
    return mode == GL_POINTS || mode == GL_LINES || mode == GL_LINE_STRIP;
}

}  // namespace

Draw::Draw(Random& random, const TargetKind& target, int width, int height, const Pipeline& pipeline)
    : pipeline_(&pipeline), settings_(random_settings(random, pipeline, width, height)) {
    choose_mode(random, target);
    choose_vertices(random, width, height);
}

Draw::Draw(Draw&& other) noexcept
    : pipeline_(other.pipeline_),
      settings_(other.settings_),
      mode_(other.mode_),
      entry_(other.entry_),
      vertices_(std::move(other.vertices_)),
      indices_(std::move(other.indices_)),
      instances_(other.instances_),
      block_width_(other.block_width_),
      block_height_(other.block_height_),
      block_(std::move(other.block_)),
      lists_(std::exchange(other.lists_, 0u)),
      buffer_(std::exchange(other.buffer_, 0u)) {
}

Draw::~Draw() {
    if (lists_) glDeleteLists(lists_, 2);
    if (buffer_) glDeleteBuffers(1, &buffer_);
}

void Draw::choose_mode(Random& random, const TargetKind& target) {
    const bool is_whole = target.has_stencil;  // without, a triangle has to be drawn alone
    constexpr int kEntries = static_cast<int>(Entry::kBitmap) + 1;
    entry_ = static_cast<Entry>(random.below(is_whole ? kEntries : static_cast<int>(Entry::kElements) + 1));
    constexpr std::array<GLenum, 10> kModes = {
        GL_TRIANGLES,  GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_TRIANGLES,  GL_QUADS,
        GL_QUAD_STRIP, GL_POLYGON,        GL_LINES,        GL_LINE_STRIP, GL_POINTS};
    mode_ = random.one_of(kModes);
    if (!is_whole || (is_lines_or_points(mode_) && !machine().repeats_lines)) mode_ = GL_TRIANGLES;
    const Stages stages = pipeline_->stages;
    if (takes_triangles_only(stages)) {
        if (mode_ != GL_TRIANGLE_STRIP && mode_ != GL_TRIANGLE_FAN) mode_ = GL_TRIANGLES;
        if (entry_ == Entry::kRect) entry_ = Entry::kImmediate;
    }
    // Pixel rectangles have no vertices; what becomes of a vertex program then is another matter.
    if (entry_ >= Entry::kDrawPixels && stages != Stages::kFixed && stages != Stages::kDiscard) {
        entry_ = Entry::kArrays;
    }
}

void Draw::choose_vertices(Random& random, int width, int height) {
    const auto w = static_cast<float>(width);
    const auto h = static_cast<float>(height);
    const bool is_flat = random.chance(40);
    const float depth = common_depth(random);
    const bool has_perspective = !is_lines_or_points(mode_) && random.chance(25);
    const bool stays_inside = mode_ == GL_POINTS || pipeline_->polygon_mode == GL_POINT;
    int count = random.integer(3, 9);
    if (mode_ == GL_TRIANGLES) count = 3 * random.integer(1, 4);
    if (mode_ == GL_QUADS) count = 4 * random.integer(1, 2);
    if (mode_ == GL_QUAD_STRIP || mode_ == GL_LINES) count += count % 2;
    for (int i = 0; i < count; ++i) {
        const float x = stays_inside ? random.real(8.0f, w - 8.0f) : random.real(-0.2f * w, 1.2f * w);
        const float y = stays_inside ? random.real(8.0f, h - 8.0f) : random.real(-0.2f * h, 1.2f * h);
        const float slope = stays_inside ? random.real(0.05f, 0.95f) : random.real(-0.1f, 1.1f);
        const float reach = has_perspective ? random.real(0.5f, 2.0f) : 1.0f;
        vertices_.push_back(vertex(x, y, is_flat ? depth : slope, reach, random.real(0.0f, 1.0f)));
        indices_.push_back(static_cast<GLushort>(i));
    }
    instances_ = random.integer(1, 3);
    block_width_ = random.integer(1, 24);
    block_height_ = random.integer(1, 24);
    const int bytes =
        entry_ == Entry::kBitmap ? (block_width_ + 7) / 8 * block_height_ : 4 * block_width_ * block_height_;
    if (entry_ < Entry::kDrawPixels) return;
    for (int i = 0; i < bytes; ++i) block_.push_back(static_cast<GLubyte>(random.below(256)));
    // The raster position has to be inside.
    vertices_.front() =
        vertex(random.real(0.0f, w - 1.0f), random.real(0.0f, h - 1.0f), common_depth(random), 1.0f, 0.75f);
}

std::string Draw::description() const {
    constexpr const char* kNames[] = {"Begin/End",
                                      "DrawArrays",
                                      "DrawElements",
                                      "ArrayElement",
                                      "CallList",
                                      "CallLists",
                                      "COMPILE_AND_EXECUTE",
                                      "DrawRangeElements",
                                      "DrawElementsBaseVertex",
                                      "MultiDrawArrays",
                                      "DrawArraysInstanced",
                                      "DrawArraysIndirect",
                                      "Rect",
                                      "DrawPixels",
                                      "Bitmap"};
    return std::string(kNames[static_cast<int>(entry_)]) + " mode " + std::to_string(mode_) + " of " +
           std::to_string(vertices_.size()) + " vertices; " + conformance::description(*pipeline_) +
           (settings_.has_scissor ? ", scissor" : "") + (settings_.has_offset ? ", offset" : "") +
           (settings_.culled != GL_NONE ? ", culling" : "") +
           (settings_.clamps_depth ? ", depth clamp" : "") + (settings_.has_coverage ? ", coverage" : "");
}

}  // namespace conformance
