// SPDX-License-Identifier: MIT
// What the Occlusion Unit is asked about in the benchmark: a box of twelve triangles, none of them parallel
// to the screen, that is hidden by a wall, stands half behind it or beside it; and the slow ways to know all
// four registers without the unit.
#pragma once

#include "rounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace benchmarks {

constexpr int kWidth = 1024, kHeight = 768;
constexpr int kWallRight = kWidth / 2;  // the wall covers the window left of it, nearer than any box
constexpr float kWallDepth = 0.5f;
constexpr GLuint kFarTexel = 0xFFFFFF;  // the depth 1 in 24 bits

// A rectangle of the window in pixels.
struct Rectangle {
    int x, y, width, height;
};

// What the four registers hold. The box is that of GLocclusionrecordEMU: inclusive, 0, 0, -1, -1 if empty.
struct Registers {
    GLuint64 projected_hits = 0, visible_hits = 0;
    GLuint nearest_texel = kFarTexel;  // in 24 bits, as the buffer has it
    std::array<GLint, 4> box = {0, 0, -1, -1};
    bool operator==(const Registers&) const = default;
};

// Oblique projection: the square of side 1.4 scale is seen with its far copy 0.6 scale right of and above it,
// so the outline is a hexagon of 3.64 scale^2 pixels, each of them covered by a front face and a back face.
class Box {
  public:
    Box(int pixels, int visible_percent) {
        scale_ = std::sqrt(static_cast<float>(pixels) / 3.64f);
        center_x_ = kWallRight + static_cast<float>(visible_percent - 50) / 50 * (scale_ + 4);
        std::array<float, 24> corners{};
        for (int corner = 0; corner < 8; ++corner) {
            const auto end = [corner](int bit) { return (corner >> bit & 1) != 0 ? 1.0f : -1.0f; };
            float* at = corners.data() + 3 * corner;
            at[0] = center_x_ + scale_ * (0.7f * end(0) + 0.3f * end(2));
            at[1] = kCenterY + scale_ * (0.7f * end(1) + 0.3f * end(2));
            at[2] = 0.75f + 0.03f * end(0) + 0.02f * end(1) + 0.1f * end(2);
        }
        const std::array<std::array<GLushort, 4>, 6> faces = {
            {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};
        std::vector<GLushort> indices;
        for (const auto& face : faces) {
            for (const int corner : {0, 1, 2, 0, 2, 3}) {
                indices.push_back(face[static_cast<std::size_t>(corner)]);
            }
        }
        glGenBuffers(2, buffers_.data());
        glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
        glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners.data(), GL_STATIC_DRAW);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(GLushort)),
                     indices.data(), GL_STATIC_DRAW);
        glVertexPointer(3, GL_FLOAT, 0, nullptr);
    }
    ~Box() { glDeleteBuffers(2, buffers_.data()); }
    Box(const Box&) = delete;
    Box& operator=(const Box&) = delete;

    void draw() const { glDrawElements(GL_TRIANGLES, 36, GL_UNSIGNED_SHORT, nullptr); }

    // Pixels that the box may touch, which the program knows beforehand.
    Rectangle bounds() const {
        const int left = static_cast<int>(center_x_ - scale_) - 1;
        const int bottom = static_cast<int>(kCenterY - scale_) - 1;
        const int side = static_cast<int>(2 * scale_) + 4;
        return {left, bottom, side, side};
    }

  private:
    static constexpr float kCenterY = kHeight / 2.0f;
    float scale_, center_x_;
    std::array<GLuint, 2> buffers_{};
};

// The wall, the cleared rest; depth writes are off afterwards.
inline void draw_scene() {
    glDepthMask(GL_TRUE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glBegin(GL_QUADS);
    glVertex3f(0, 0, kWallDepth);
    glVertex3f(kWallRight, 0, kWallDepth);
    glVertex3f(kWallRight, kHeight, kWallDepth);
    glVertex3f(0, kHeight, kWallDepth);
    glEnd();
    glDepthMask(GL_FALSE);
}

// Two ways without the unit, for a program that has no use of its own for the stencil buffer. Either draws
// the box so that visible samples leave a mark, reads the rectangle that the box may touch, and looks for
// marks.
class ReadBack {
  public:
    ReadBack() {
        glGenQueries(2, queries_.data());
        glGenRenderbuffers(1, &buffer_);
        glBindRenderbuffer(GL_RENDERBUFFER, buffer_);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, kWidth, kHeight);
        glGenFramebuffers(1, &copy_);
        glBindFramebuffer(GL_FRAMEBUFFER, copy_);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, buffer_);
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
            fail("the read-back's copy of depth and stencil is incomplete");
        }
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
    }

    // Visible hits and the screen box: marks in the stencil buffer of the window.
    Registers marks(const Box& box) {
        const Rectangle area = box.bounds();
        next_mark();
        begin_marks();
        count(0, box);
        glDisable(GL_STENCIL_TEST);
        stencil_.resize(static_cast<std::size_t>(area.width * area.height));
        glReadPixels(area.x, area.y, area.width, area.height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE,
                     stencil_.data());
        Registers found;
        find(area, found, [this](std::size_t at) { return stencil_[at] == mark_; });
        found.visible_hits = result(0);
        return found;
    }

    // All four: a second query without the depth test; and the nearest depth is written, together with the
    // mark, to a copy of the rectangle, since the depth buffer itself must not change.
    Registers all(const Box& box) {
        const Rectangle area = box.bounds();
        next_mark();
        count(0, box);
        glDisable(GL_DEPTH_TEST);
        count(1, box);
        glEnable(GL_DEPTH_TEST);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, copy_);
        glBlitFramebuffer(area.x, area.y, area.x + area.width, area.y + area.height, area.x, area.y,
                          area.x + area.width, area.y + area.height,
                          GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, GL_NEAREST);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, copy_);
        const Registers found = marks_and_depths(box);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        return with_counts(found);
    }

    // What is true: the same, but in the window itself, whose scene is drawn anew.
    Registers truth(const Box& box) {
        next_mark();
        count_both(box);
        const Registers found = marks_and_depths(box);
        draw_scene();
        return with_counts(found);
    }

  private:
    // In the window, of which the copy is made: the marks of 255 boxes ago are no marks of this one.
    void next_mark() {
        mark_ = mark_ % 255 + 1;
        if (mark_ == 1) glClear(GL_STENCIL_BUFFER_BIT);
    }
    void begin_marks() {
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_ALWAYS, static_cast<GLint>(mark_), 0xFF);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    }
    Registers marks_and_depths(const Box& box) {
        const Rectangle area = box.bounds();
        begin_marks();
        glDepthMask(GL_TRUE);
        box.draw();
        glDepthMask(GL_FALSE);
        glDisable(GL_STENCIL_TEST);
        texels_.resize(static_cast<std::size_t>(area.width * area.height));
        glReadPixels(area.x, area.y, area.width, area.height, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
                     texels_.data());
        Registers found;
        find(area, found, [this, &found](std::size_t at) {
            if ((texels_[at] & 0xFF) != mark_) return false;
            found.nearest_texel = std::min(found.nearest_texel, texels_[at] >> 8);
            return true;
        });
        return found;
    }
    void count_both(const Box& box) {
        count(0, box);
        glDisable(GL_DEPTH_TEST);
        count(1, box);
        glEnable(GL_DEPTH_TEST);
    }
    Registers with_counts(Registers found) {
        found.visible_hits = result(0);
        found.projected_hits = result(1);
        return found;
    }
    void count(std::size_t query, const Box& box) {
        glBeginQuery(GL_SAMPLES_PASSED, queries_[query]);
        box.draw();
        glEndQuery(GL_SAMPLES_PASSED);
    }
    GLuint result(std::size_t query) {
        GLuint samples = 0;
        glGetQueryObjectuiv(queries_[query], GL_QUERY_RESULT, &samples);
        return samples;
    }
    template <typename IsMarked>
    void find(const Rectangle area, Registers& found, IsMarked is_marked) {
        int left = kWidth, bottom = kHeight, right = -1, top = -1;
        for (int y = 0; y < area.height; ++y) {
            for (int x = 0; x < area.width; ++x) {
                if (!is_marked(static_cast<std::size_t>(y * area.width + x))) continue;
                left = std::min(left, x), right = std::max(right, x);
                bottom = std::min(bottom, y), top = y;
            }
        }
        if (right >= 0) found.box = {area.x + left, area.y + bottom, area.x + right, area.y + top};
    }

    std::array<GLuint, 2> queries_{};
    GLuint buffer_ = 0, copy_ = 0;
    GLuint mark_ = 0;
    std::vector<GLubyte> stencil_;
    std::vector<GLuint> texels_;
};

}  // namespace benchmarks
