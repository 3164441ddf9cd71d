// SPDX-License-Identifier: MIT
#include "context/work_counters.h"

#include <algorithm>
#include <utility>

#include "context/context.h"

namespace glext_emu {
namespace {

enum : std::size_t { kFragments, kVertices, kPrimitives, kClipped };

// Of separate quads, triangles and polygons v vertices in p primitives are v - 2p triangles; of strips and
// fans p; of strips of quads the clipper alone knows, which makes more triangles of those that it cuts.
std::uint64_t triangles_of(std::uint64_t vertices, std::uint64_t primitives, std::uint64_t clipped) {
    const std::uint64_t separate = vertices > 2 * primitives ? vertices - 2 * primitives : 0;
    return std::max({primitives, separate, std::min(clipped, 2 * primitives)});
}

}  // namespace

void WorkCounters::begin_one(Context& ctx, std::size_t which) {
    if (is_left_[which]) return;
    GLuint& name = open_[which];
    if (spare_[which].empty()) {
        ctx.real->glGenQueries(1, &name);
        names_[name] = which;
    } else {
        name = spare_[which].back();
        spare_[which].pop_back();
    }
    ctx.real->glBeginQuery(kWorkTargets[which], name);
}

void WorkCounters::begin(Context& ctx, bool wants_fragments, bool wants_triangles) {
    if (wants_fragments) begin_one(ctx, kFragments);
    if (!wants_triangles) return;
    for (const std::size_t which : {kVertices, kPrimitives, kClipped}) begin_one(ctx, which);
}

CountedWork WorkCounters::end(Context& ctx) {
    for (std::size_t which = 0; which < kWorkCounts; ++which) {
        if (open_[which] != 0) ctx.real->glEndQuery(kWorkTargets[which]);
    }
    return std::exchange(open_, {});
}

Work WorkCounters::take(Context& ctx, const CountedWork& counted) {
    std::array<std::uint64_t, kWorkCounts> counts{};
    for (std::size_t which = 0; which < kWorkCounts; ++which) {
        if (counted[which] == 0) continue;
        counts[which] = driver_count(ctx, counted[which]);
        spare_[which].push_back(counted[which]);
    }
    return {counts[kFragments], triangles_of(counts[kVertices], counts[kPrimitives], counts[kClipped])};
}

bool WorkCounters::holds(GLenum target) const {
    const auto found = std::ranges::find(kWorkTargets, target);
    return found != kWorkTargets.end() && open_[static_cast<std::size_t>(found - kWorkTargets.begin())] != 0;
}

void WorkCounters::leave_to_program(GLenum target, bool is_programs) {
    const auto found = std::ranges::find(kWorkTargets, target);
    if (found != kWorkTargets.end())
        is_left_[static_cast<std::size_t>(found - kWorkTargets.begin())] = is_programs;
}

void WorkCounters::forget(Context& ctx, GLuint name) {
    const auto found = names_.find(name);
    std::erase(spare_[found->second], name);
    names_.erase(found);
    ctx.real->glDeleteQueries(1, &name);
}

}  // namespace glext_emu
