// SPDX-License-Identifier: MIT
// What a program's calls do not tell of its work: how many fragments the rasteriser makes, and how many
// triangles lie in display lists, between Begin and End or behind an indirect draw. The driver counts them in
// queries of the layer's own, FRAGMENT_SHADER_INVOCATIONS and PRIMITIVES_GENERATED, which are read late.
// llvmpipe counts the fragments of 2x2 pixels of which any is covered, before the depth test.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstdint>
#include <unordered_set>
#include <vector>

namespace glext_emu {

struct Context;

// Names of queries that have ended; 0: not counted.
struct CountedWork {
    GLuint fragments = 0;
    GLuint primitives = 0;
};

class WorkCounters {
  public:
    // Begins counting what is wanted and what the program does not count itself. Not while a list is
    // compiled, nor between Begin and End.
    void begin(Context& ctx, bool wants_fragments, bool wants_primitives);
    CountedWork end(Context& ctx);
    bool is_open() const { return open_.fragments != 0 || open_.primitives != 0; }
    bool counts_primitives() const { return open_.primitives != 0; }

    // What <query> has counted, which is 0 for 0; waits for the driver, and the name is free again.
    std::uint64_t take(Context& ctx, GLuint query);

    // True for a name of the layer's that the driver knows and the program does not.
    bool owns(GLuint name) const { return names_.contains(name); }
    // True while the driver's slot for <target> is held by the layer.
    bool holds(GLenum target) const;
    // The program begins, or has ended, a query of its own on <target>.
    void leave_to_program(GLenum target, bool is_programs);
    // True where the program counts fragments itself, so that the layer cannot.
    bool has_left_fragments() const { return has_left_fragments_; }
    // Gives up a free name that the program takes for a query of its own.
    void forget(Context& ctx, GLuint name);

  private:
    GLuint take_name(Context& ctx, std::vector<GLuint>& spare);

    CountedWork open_;
    bool has_left_fragments_ = false;
    bool has_left_primitives_ = false;
    std::unordered_set<GLuint> names_;
    std::unordered_set<GLuint> fragment_names_;  // of them, whose target is the first
    // An object keeps the target of its first begin.
    std::vector<GLuint> spare_fragments_;
    std::vector<GLuint> spare_primitives_;
};

}  // namespace glext_emu
