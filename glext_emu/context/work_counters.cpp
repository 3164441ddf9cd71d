// SPDX-License-Identifier: MIT
#include "context/work_counters.h"

#include <utility>

#include "context/context.h"

namespace glext_emu {
namespace {

constexpr GLenum kFragments = GL_FRAGMENT_SHADER_INVOCATIONS;
constexpr GLenum kPrimitives = GL_PRIMITIVES_GENERATED;

}  // namespace

GLuint WorkCounters::take_name(Context& ctx, std::vector<GLuint>& spare) {
    if (spare.empty()) {
        GLuint made = 0;
        ctx.real->glGenQueries(1, &made);
        names_.insert(made);
        return made;
    }
    const GLuint name = spare.back();
    spare.pop_back();
    return name;
}

void WorkCounters::begin(Context& ctx, bool wants_fragments, bool wants_primitives) {
    if (wants_fragments && !has_left_fragments_) {
        open_.fragments = take_name(ctx, spare_fragments_);
        fragment_names_.insert(open_.fragments);
        ctx.real->glBeginQuery(kFragments, open_.fragments);
    }
    if (wants_primitives && !has_left_primitives_) {
        open_.primitives = take_name(ctx, spare_primitives_);
        ctx.real->glBeginQuery(kPrimitives, open_.primitives);
    }
}

CountedWork WorkCounters::end(Context& ctx) {
    if (open_.fragments != 0) ctx.real->glEndQuery(kFragments);
    if (open_.primitives != 0) ctx.real->glEndQuery(kPrimitives);
    return std::exchange(open_, {});
}

std::uint64_t WorkCounters::take(Context& ctx, GLuint query) {
    if (query == 0) return 0;
    const std::uint64_t count = driver_count(ctx, query);
    (fragment_names_.contains(query) ? spare_fragments_ : spare_primitives_).push_back(query);
    return count;
}

bool WorkCounters::holds(GLenum target) const {
    return (target == kFragments && open_.fragments != 0) || (target == kPrimitives && open_.primitives != 0);
}

void WorkCounters::leave_to_program(GLenum target, bool is_programs) {
    if (target == kFragments) has_left_fragments_ = is_programs;
    if (target == kPrimitives) has_left_primitives_ = is_programs;
}

void WorkCounters::forget(Context& ctx, GLuint name) {
    std::erase(spare_fragments_, name);
    std::erase(spare_primitives_, name);
    fragment_names_.erase(name);
    names_.erase(name);
    ctx.real->glDeleteQueries(1, &name);
}

}  // namespace glext_emu
