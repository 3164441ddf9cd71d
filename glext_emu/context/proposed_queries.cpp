// SPDX-License-Identifier: MIT
#include "context/proposed_queries.h"

#include "context/context.h"
#include "context/unit_run.h"

namespace glext_emu {

ProposedQueries::ProposedQueries() = default;
ProposedQueries::~ProposedQueries() = default;

bool refuses_proposed_name(Context& ctx, GLuint id, GLenum target) {
    const ProposedQueries& proposed = ctx.proposed;
    const auto found = proposed.objects.find(id);
    const bool is_object_of_target = found != proposed.objects.end() && found->second.target == target;
    const bool is_fine = is_object_of_target ? id != proposed.active_unit : proposed.generated.contains(id);
    if (!is_fine) ctx.raise(GL_INVALID_OPERATION);
    return !is_fine;
}

ProposedQuery& renew_proposed_query(Context& ctx, GLuint id, GLenum target) {
    ctx.proposed.generated.erase(id);
    ProposedQuery& query = ctx.proposed.objects[id];
    if (query.pending != nullptr) query.pending->drop(ctx);
    query = ProposedQuery{};
    query.target = target;
    return query;
}

void delete_proposed_query(Context& ctx, GLuint id) {
    ctx.proposed.generated.erase(id);
    if (id != 0 && id == ctx.proposed.active_unit) {
        ctx.proposed.run->drop(ctx);
        ctx.proposed.run.reset();
        ctx.proposed.active_unit = 0;
        ctx.update_hot();
    }
    const auto found = ctx.proposed.objects.find(id);
    if (found == ctx.proposed.objects.end()) return;
    if (found->second.pending != nullptr) found->second.pending->drop(ctx);
    ctx.proposed.objects.erase(found);
}

void drain_records(Context& ctx, ProposedQuery& query) {
    if (query.pending == nullptr) return;
    query.pending->drain(ctx, query.records);
    query.pending.reset();
}

void drain_all_records(Context& ctx) {
    if (ctx.proposed.run != nullptr) ctx.proposed.run->fold(ctx);
    for (auto& [name, query] : ctx.proposed.objects) drain_records(ctx, query);
    settle_probes(ctx);
}

}  // namespace glext_emu
