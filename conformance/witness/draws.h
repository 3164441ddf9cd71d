// SPDX-License-Identifier: MIT
// A draw of a scene: vertices in pixels and window depths, and the entry point that they go through.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "harness/gl.h"
#include "witness/pipelines.h"
#include "witness/random.h"

namespace conformance {

enum class Entry {
    kImmediate,
    kArrays,
    kElements,  // the three that can draw a primitive alone come first
    kArrayElement,
    kList,  // compiled before the query
    kListOfLists,
    kCompiledWithin,  // compiled and executed within the query
    kRangeElements,
    kBaseVertex,
    kMultiArrays,
    kInstanced,
    kIndirect,
    kRect,
    kDrawPixels,
    kBitmap,
};

struct Vertex {
    std::array<GLfloat, 4> position;  // x, y in pixels and z in [0, 1], times w
    std::array<GLfloat, 4> colour;
};

class Draw {
  public:
    Draw(Random& random, const TargetKind& target, int width, int height, const Pipeline& pipeline);
    ~Draw();
    Draw(Draw&& other) noexcept;
    Draw(const Draw&) = delete;
    Draw& operator=(const Draw&) = delete;

    // Before the query: lists and buffers.
    void prepare();
    void issue() const;
    // Of a draw of triangles through an entry point that can do that.
    int triangles() const { return static_cast<int>(vertices_.size() / 3); }
    void issue_triangle(int index) const;

    const Pipeline& pipeline() const { return *pipeline_; }
    // A pixel rectangle or a bitmap.
    bool is_of_pixels() const { return entry_ >= Entry::kDrawPixels; }
    const Settings& settings() const { return settings_; }
    std::string description() const;

  private:
    void choose_mode(Random& random, const TargetKind& target);
    void choose_vertices(Random& random, int width, int height);
    void issue_vertices(std::size_t first, std::size_t count) const;
    void issue_arrays() const;
    void issue_indirect() const;
    void issue_pixels() const;

    const Pipeline* pipeline_;
    Settings settings_;
    GLenum mode_ = GL_TRIANGLES;
    Entry entry_ = Entry::kImmediate;
    std::vector<Vertex> vertices_;
    std::vector<GLushort> indices_;
    int instances_ = 1;
    int block_width_ = 0;  // of pixel rectangles and bitmaps
    int block_height_ = 0;
    std::vector<GLubyte> block_;
    GLuint lists_ = 0;   // two
    GLuint buffer_ = 0;  // of an indirect draw: the vertices, then its arguments
};

}  // namespace conformance
