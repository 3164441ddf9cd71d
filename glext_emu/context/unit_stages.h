// SPDX-License-Identifier: MIT
// What the layer itself puts into a driver to look at fragments: programs, and buffers in which these write
// what they see. Made when they are first needed; they live as long as the context, or its share group.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <deque>
#include <map>
#include <string>

#include "context/depth_quantiser.h"

namespace glext_emu {

struct Context;

// Buffers that a shader writes and the layer reads, in turn: binding one that has just been used makes the
// driver finish what it draws.
class ResultBuffers {
  public:
    struct Buffer {
        GLuint name = 0;
        GLsizeiptr bytes = 0;
    };
    // At least <bytes>, of undefined content.
    Buffer take(Context& ctx, GLsizeiptr bytes);
    void give_back(const Buffer& buffer) { free_[buffer.bytes].push_back(buffer.name); }

  private:
    std::map<GLsizeiptr, std::deque<GLuint>> free_;
};

struct UnitStages {
    bool is_known = false;          // the next ones are
    bool can_mark = false;          // a fragment stage can write to memory after the early depth test
    bool has_sub_groups = false;    // ARB_shader_ballot: fragments that are shaded together can agree first
    bool has_sample_stage = false;  // ARB_sample_shading: a fragment stage can run for each sample
    bool has_ati_stage = false;     // ATI_fragment_shader
    GLint binding_count = 0;        // of shader storage buffers

    std::map<unsigned, GLuint> proxy_programs;  // by what they mark; 0 where one cannot be made
    std::map<unsigned, GLuint> shape_programs;
    GLuint shape_arrays = 0;    // a vertex array object
    GLuint shape_vertices = 0;  // its buffer
    std::map<GLenum, GLuint> shape_indices;
    ResultBuffers results;
    DepthQuantiser quantiser;
};

// The context's own, its features known.
UnitStages& unit_stages(Context& ctx);

// A program of these stages, either of which may be empty, that writes to the shader storage block <Marks>; 0
// where the driver refuses it. Leaves no error, but says what it likes to a debug context.
GLuint build_program(Context& ctx, const std::string& vertex, const std::string& fragment);

// A binding of shader storage buffers for a while. One that the program has no use for, if there is any: then
// it need not be put back.
class ResultBinding {
  public:
    void bind(Context& ctx, GLuint buffer);
    void bind(Context& ctx, GLuint program, GLuint buffer) {
        bind(ctx, buffer);
        attach(ctx, program);
    }
    // <program> writes there.
    void attach(Context& ctx, GLuint program) const;
    void unbind(Context& ctx);

  private:
    GLuint index_ = 0;
    GLint buffer_ = 0;
    GLint64 start_ = 0;
    GLint64 size_ = 0;
};

}  // namespace glext_emu
