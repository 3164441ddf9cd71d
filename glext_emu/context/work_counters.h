// SPDX-License-Identifier: MIT
// What a program's calls do not tell of its work: how many fragments the rasteriser makes, and how many
// triangles lie in display lists, between Begin and End or behind an indirect draw. The driver counts them in
// pipeline statistics queries of the layer's own, which are read late.
//
// llvmpipe counts fragments before the depth test, by blocks of 4x4 pixels of which a triangle touches any: a
// box of 100x100 pixels is 6 % too large, one of 6x6 three times. It counts a quad as one primitive, of which
// the clipper makes two.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace glext_emu {

struct Context;

constexpr std::size_t kWorkCounts = 4;
constexpr std::array<GLenum, kWorkCounts> kWorkTargets = {GL_FRAGMENT_SHADER_INVOCATIONS,
                                                          GL_VERTICES_SUBMITTED, GL_PRIMITIVES_SUBMITTED,
                                                          GL_CLIPPING_OUTPUT_PRIMITIVES};

// Names of queries that have ended, in the order of kWorkTargets; 0: not counted.
using CountedWork = std::array<GLuint, kWorkCounts>;

struct Work {
    std::uint64_t fragments = 0;
    std::uint64_t triangles = 0;
};

class WorkCounters {
  public:
    // Begins counting what is wanted and what the program does not count itself. Not while a list is
    // compiled, nor between Begin and End.
    void begin(Context& ctx, bool wants_fragments, bool wants_triangles);
    CountedWork end(Context& ctx);
    bool is_open() const { return open_ != CountedWork{}; }

    // What <counted> has counted; waits for the driver, and the names are free again.
    Work take(Context& ctx, const CountedWork& counted);

    // True for a name of the layer's that the driver knows and the program does not.
    bool owns(GLuint name) const { return names_.contains(name); }
    // True while the driver's slot for <target> is held by the layer.
    bool holds(GLenum target) const;
    // The program begins, or has ended, a query of its own on <target>.
    void leave_to_program(GLenum target, bool is_programs);
    // Gives up a free name that the program takes for a query of its own.
    void forget(Context& ctx, GLuint name);

  private:
    void begin_one(Context& ctx, std::size_t which);

    CountedWork open_ = {};
    std::array<bool, kWorkCounts> is_left_ = {};
    std::unordered_map<GLuint, std::size_t>
        names_;  // with their target: an object keeps that of its first begin
    std::array<std::vector<GLuint>, kWorkCounts> spare_;
};

}  // namespace glext_emu
