// SPDX-License-Identifier: MIT
#include "context/proposed_queries.h"

#include "context/context.h"

namespace glext_emu {

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
    const auto found = ctx.proposed.objects.find(id);
    if (found == ctx.proposed.objects.end()) return;
    if (found->second.pending != nullptr) found->second.pending->drop(ctx);
    ctx.proposed.objects.erase(found);
}

}  // namespace glext_emu
