// SPDX-License-Identifier: MIT
// How a draw is issued: the same vertices through many doors.
#include <algorithm>
#include <cstddef>

#include "witness/draws.h"
#include "witness/machine.h"

namespace conformance {

namespace {

struct ArraysCommand {
    GLuint count;
    GLuint instances;
    GLuint first;
    GLuint first_instance;
};

constexpr int kStride = sizeof(Vertex);

}  // namespace

void Draw::prepare() {
    if (entry_ == Entry::kList || entry_ == Entry::kListOfLists) {
        lists_ = glGenLists(2);
        glNewList(lists_, GL_COMPILE);
        issue_vertices(0, vertices_.size());
        glEndList();
        glNewList(lists_ + 1, GL_COMPILE);
        glCallList(lists_);
        glEndList();
    }
    if (entry_ == Entry::kIndirect && machine().has_indirect_draws) {
        const ArraysCommand arguments = {static_cast<GLuint>(vertices_.size()),
                                         static_cast<GLuint>(instances_), 0, 0};
        const auto size = static_cast<GLsizeiptr>(vertices_.size() * sizeof(Vertex));
        glGenBuffers(1, &buffer_);
        glBindBuffer(GL_ARRAY_BUFFER, buffer_);
        glBufferData(GL_ARRAY_BUFFER, size + static_cast<GLsizeiptr>(sizeof arguments), nullptr,
                     GL_STATIC_DRAW);
        glBufferSubData(GL_ARRAY_BUFFER, 0, size, vertices_.data());
        glBufferSubData(GL_ARRAY_BUFFER, size, sizeof arguments, &arguments);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
    }
}

void Draw::issue() const {
    switch (entry_) {
        case Entry::kImmediate:
            return issue_vertices(0, vertices_.size());
        case Entry::kList:
            return glCallList(lists_);
        case Entry::kListOfLists: {
            const std::array<GLubyte, 2> offsets = {0, 1};
            glListBase(lists_);
            glCallLists(2, GL_UNSIGNED_BYTE, offsets.data());
            return glListBase(0);
        }
        case Entry::kCompiledWithin: {
            const GLuint list = glGenLists(1);
            glNewList(list, GL_COMPILE_AND_EXECUTE);
            issue_vertices(0, vertices_.size());
            glEndList();
            return glDeleteLists(list, 1);
        }
        case Entry::kRect: {
            const auto [left, right] = std::minmax(vertices_[0].position[0], vertices_[1].position[0]);
            const auto [bottom, top] = std::minmax(vertices_[0].position[1], vertices_[1].position[1]);
            glColor4fv(vertices_[0].colour.data());
            glPushMatrix();
            glTranslatef(0.0f, 0.0f, vertices_[2].position[2] / vertices_[2].position[3]);
            glRectf(left, bottom, right, top);
            return glPopMatrix();
        }
        case Entry::kDrawPixels:
        case Entry::kBitmap:
            return issue_pixels();
        default:
            return issue_arrays();
    }
}

void Draw::issue_triangle(int index) const {
    const int first = 3 * index;
    if (entry_ == Entry::kImmediate) return issue_vertices(static_cast<std::size_t>(first), 3);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(4, GL_FLOAT, kStride, vertices_[0].position.data());
    glColorPointer(4, GL_FLOAT, kStride, vertices_[0].colour.data());
    if (entry_ == Entry::kArrays) {
        glDrawArrays(mode_, first, 3);
    } else {
        glDrawElements(mode_, 3, GL_UNSIGNED_SHORT, &indices_[static_cast<std::size_t>(first)]);
    }
    glDisableClientState(GL_VERTEX_ARRAY);
    glDisableClientState(GL_COLOR_ARRAY);
}

void Draw::issue_vertices(std::size_t first, std::size_t count) const {
    glBegin(mode_);
    for (std::size_t i = first; i < first + count; ++i) {
        glColor4fv(vertices_[i].colour.data());
        glVertex4fv(vertices_[i].position.data());
    }
    glEnd();
}

void Draw::issue_arrays() const {
    const auto count = static_cast<GLsizei>(vertices_.size());
    const auto last = static_cast<GLuint>(count - 1);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(4, GL_FLOAT, kStride, vertices_[0].position.data());
    glColorPointer(4, GL_FLOAT, kStride, vertices_[0].colour.data());
    switch (entry_) {
        case Entry::kElements:
            glDrawElements(mode_, count, GL_UNSIGNED_SHORT, indices_.data());
            break;
        case Entry::kRangeElements:
            glDrawRangeElements(mode_, 0, last, count, GL_UNSIGNED_SHORT, indices_.data());
            break;
        case Entry::kBaseVertex:
            glDrawElementsBaseVertex(mode_, count - 1, GL_UNSIGNED_SHORT, indices_.data(), 1);
            break;
        case Entry::kArrayElement:
            glBegin(mode_);
            for (GLint i = 0; i < count; ++i) glArrayElement(i);
            glEnd();
            break;
        case Entry::kMultiArrays: {
            const std::array<GLint, 2> firsts = {0, count / 2};
            const std::array<GLsizei, 2> counts = {count / 2, count - count / 2};
            glMultiDrawArrays(mode_, firsts.data(), counts.data(), 2);
            break;
        }
        case Entry::kInstanced:
            glDrawArraysInstanced(mode_, 0, count, instances_);
            break;
        case Entry::kIndirect:
            issue_indirect();
            break;
        default:
            glDrawArrays(mode_, 0, count);
            break;
    }
    glDisableClientState(GL_VERTEX_ARRAY);
    glDisableClientState(GL_COLOR_ARRAY);
}

void Draw::issue_indirect() const {
    if (!buffer_) return glDrawArraysInstanced(mode_, 0, static_cast<GLsizei>(vertices_.size()), instances_);
    const auto at = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glVertexPointer(4, GL_FLOAT, kStride, at(offsetof(Vertex, position)));
    glColorPointer(4, GL_FLOAT, kStride, at(offsetof(Vertex, colour)));
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, buffer_);
    glDrawArraysIndirect(mode_, at(vertices_.size() * sizeof(Vertex)));
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

void Draw::issue_pixels() const {
    const Vertex& at = vertices_[0];
    glColor4fv(at.colour.data());
    glWindowPos3f(at.position[0], at.position[1], at.position[2]);
    if (entry_ == Entry::kDrawPixels) {
        glDrawPixels(block_width_, block_height_, GL_RGBA, GL_UNSIGNED_BYTE, block_.data());
    } else {
        glBitmap(block_width_, block_height_, 0.0f, 0.0f, 0.0f, 0.0f, block_.data());
    }
}

}  // namespace conformance
