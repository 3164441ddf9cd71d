// SPDX-License-Identifier: MIT
// Query objects: names, begin, end. The program's objects are the driver's own; what is remembered of them is
// when they ended, for the clock and for the HP test's flag, and what a count of theirs stands for.
#include "context/refusals.h"
#include "context/settings.h"
#include "features/features.h"
#include "features/list_recorder.h"

namespace glext_emu::features {
namespace {

// Targets that the driver's context does not know raise their error there, and are asked for nothing else.
bool driver_knows(const Context& ctx, GLenum target) {
    if (target == GL_SAMPLES_PASSED) return !ctx.kind.is_es;
    if (ctx.kind.is_es) {
        return ctx.kind.version >= GlVersion{3, 0} || ctx.advertised->has("GL_EXT_occlusion_query_boolean");
    }
    return ctx.kind.has_any_samples;
}

GLuint active_query(Context& ctx, GLenum target) {
    GLint name = 0;
    ctx.real->glGetQueryiv(target, GL_CURRENT_QUERY, &name);
    return static_cast<GLuint>(name);
}

// GL 1.5, 4.1.7: "Calling either GenQueries or DeleteQueries while any query of any target is active causes
// an INVALID_OPERATION error"; GL 3.0 dropped that.
bool refuses_names_now(const Context& ctx) {
    return ctx.follows_text && !ctx.kind.is_es && ctx.advertised->version < GlVersion{3, 0} &&
           ctx.slot.app_query != 0;
}

// GL 4.6, 5.1.3: the name of an object in use becomes unused at once, the object stays until it is used no
// more.
bool is_in_use(const Context& ctx, GLuint name) {
    return ctx.follows_text && name != 0 && (name == ctx.slot.app_query || name == ctx.conditional.query);
}

// GL 4.6, 4.2: INVALID_OPERATION "if id is the name of an existing query object whose type does not match
// target": the driver knows no object of the proposed extensions, and so cannot refuse it.
bool refuses_as_proposed(const Context& ctx, GLuint id) {
    return !ctx.recording.is_open() && ctx.proposed.is_object(id);
}

}  // namespace

void note_object(Context& ctx, GLuint id) {
    if (!ctx.proposed.generated.contains(id) || ctx.recording.is_open()) return;
    if (ctx.real->glIsQuery(id) != GL_FALSE) ctx.proposed.generated.erase(id);
}

void gen_queries(Context& ctx, GLsizei n, GLuint* ids) {
    if (refuses_names_now(ctx)) return ctx.raise(GL_INVALID_OPERATION);
    ctx.real->glGenQueries(n, ids);
    if (!(ctx.emulates_regions || ctx.emulates_unit) || ids == nullptr) return;
    for (GLsizei i = 0; i < n; ++i) ctx.proposed.generated.insert(ids[i]);
}

void create_queries(Context& ctx, GLenum target, GLsizei n, GLuint* ids) {
    if (refuses_target(ctx, target)) return ctx.raise(GL_INVALID_ENUM);
    if (!ctx.follows_text || !is_occlusion_target(target)) return ctx.real->glCreateQueries(target, n, ids);
    const GLenum real = real_target(ctx, target);
    if (!driver_accepts(ctx, [&] { ctx.real->glCreateQueries(real, n, ids); })) return;
    for (GLsizei i = 0; i < n; ++i) {
        ctx.slot.records[ids[i]] = {
            .target = target, .was_begun = false, .has_ended = true, .was_seen_available = true};
    }
}

void delete_queries(Context& ctx, GLsizei n, const GLuint* ids) {
    if (n < 0 || ids == nullptr) return ctx.real->glDeleteQueries(n, ids);
    if (refuses_names_now(ctx)) return ctx.raise(GL_INVALID_OPERATION);

    std::vector<GLuint> names;
    for (GLsizei i = 0; i < n; ++i) {
        const GLuint name = ids[i];
        if (ctx.slot.is_hidden(name) || ctx.slot.is_doomed(name)) continue;
        if (is_in_use(ctx, name)) {
            ctx.slot.doomed.push_back(name);
            continue;
        }
        names.push_back(name);
        // What counts towards the HP flag is read before its object goes.
        if (name != 0 && name == ctx.slot.ended_app_query) {
            ctx.slot.flag = has_passed(ctx, name) || ctx.slot.flag;
            ctx.slot.ended_app_query = 0;
        }
        settle_probe(ctx, name);
        forget_timer(ctx, name);
        if (name == ctx.slot.app_query) ctx.slot.app_query = 0;
        delete_proposed_query(ctx, name);
        ctx.slot.records.erase(name);
    }
    ctx.real->glDeleteQueries(static_cast<GLsizei>(names.size()), names.data());
    ctx.update_hot();
}

GLboolean is_query(Context& ctx, GLuint id) {
    const bool is_unknown = ctx.slot.is_hidden(id) || ctx.slot.is_doomed(id);
    if (ctx.proposed.is_object(id)) return GL_TRUE;
    return is_unknown ? GL_FALSE : ctx.real->glIsQuery(id);
}

void begin_query(Context& ctx, GLenum target, GLuint id) {
    if (refuses_target(ctx, target)) return ctx.raise(GL_INVALID_ENUM);
    if (ctx.recording.is_open() && is_occlusion_target(target) && ctx.records_operations) {
        return record(ctx, {[](Context& c, const ListOperation& op) { begin_query(c, op.first, op.second); },
                            target, id});
    }
    if (ctx.recording.is_open()) return ctx.real->glBeginQuery(target, id);
    start_query(ctx, target, id);
}

void start_query(Context& ctx, GLenum target, GLuint id) {
    // NV_conditional_render 2.14: an object that is used for conditional rendering cannot be begun; nor can a
    // name whose object is still in use.
    if (ctx.follows_text && id != 0 && (id == ctx.conditional.query || ctx.slot.is_doomed(id))) {
        return ctx.raise(GL_INVALID_OPERATION);
    }
    if (refuses_as_proposed(ctx, id) || (is_occlusion_target(target) && ctx.proposed.active_unit != 0)) {
        return ctx.raise(GL_INVALID_OPERATION);
    }
    // Decision 2: there is one counter, and whatever counts in a pipe has it.
    if (ctx.slot.pipe != nullptr && is_occlusion_target(target)) return ctx.raise(GL_INVALID_OPERATION);
    yield_name(ctx, id);
    const GLenum real = real_target(ctx, target);
    // The driver refuses a second query in the slot, and targets of other slots are its own affair.
    if (!is_occlusion_target(target) || !driver_knows(ctx, target) || ctx.slot.app_query != 0) {
        ctx.proposed.counts_draws |= !is_occlusion_target(target) && target != GL_TIME_ELAPSED;
        if (ctx.time != nullptr) return start_timed_query(ctx, target, id);
        ctx.real->glBeginQuery(real, id);
        return note_object(ctx, id);
    }

    close_segment(ctx);
    settle_probe(ctx, id);
    need_pixels("an occlusion query");
    if (ctx.time != nullptr) ctx.time->begin_query();
    ctx.real->glBeginQuery(real, id);
    if (id == 0 || active_query(ctx, real) != id) return ctx.update_hot();
    // ARB_occlusion_query, issues: BeginQuery "resets the sample count (and therefore the occlusion test
    // result)".
    reset_flag(ctx);
    note_object(ctx, id);
    ctx.slot.app_query = id;
    ctx.slot.app_target = target;
    ctx.slot.records[id] = {.target = target};
    begin_probe(ctx, target, id);
    ctx.frame.queries_begun++;
    ctx.update_hot();
}

void begin_query_indexed(Context& ctx, GLenum target, GLuint index, GLuint id) {
    // GL 4.6, 4.2: BeginQueryIndexed with index zero is BeginQuery.
    if (index == 0 && (is_occlusion_target(target) || ctx.time != nullptr))
        return begin_query(ctx, target, id);
    if (refuses_as_proposed(ctx, id)) return ctx.raise(GL_INVALID_OPERATION);
    if (!ctx.recording.is_open()) yield_name(ctx, id);
    ctx.proposed.counts_draws = true;
    ctx.real->glBeginQueryIndexed(target, index, id);
    note_object(ctx, id);
}

void end_query(Context& ctx, GLenum target) {
    if (!is_occlusion_target(target)) {
        return ctx.time != nullptr ? end_timed_query(ctx, target) : ctx.real->glEndQuery(target);
    }
    if (refuses_target(ctx, target)) return ctx.raise(GL_INVALID_ENUM);
    if (ctx.recording.is_open() && ctx.records_operations) {
        return record(ctx, {[](Context& c, const ListOperation& op) { end_query(c, op.first); }, target});
    }
    finish_query(ctx, target);
}

void finish_query(Context& ctx, GLenum target) {
    // With none of the program's active, the driver would end the layer's own; and what is one target to the
    // driver may be two to the program.
    const bool is_other_target = ctx.follows_text && ctx.slot.app_query != 0 && target != ctx.slot.app_target;
    if (ctx.slot.open_segment != 0 || is_other_target) return ctx.raise(GL_INVALID_OPERATION);

    ctx.real->glEndQuery(real_target(ctx, target));
    if (ctx.recording.is_open() || ctx.slot.app_query == 0 || target != ctx.slot.app_target) return;
    QueryRecord& record = ctx.slot.records[ctx.slot.app_query];
    record.has_ended = true;
    record.due = ctx.clock.due();
    if (ctx.emulates_test) {
        ctx.slot.ended_app_query = ctx.slot.app_query;
        ctx.slot.flag_due = record.due;
    }
    ctx.slot.app_query = 0;
    end_probe(ctx);
    delete_doomed(ctx);
    ctx.update_hot();
}

void end_query_indexed(Context& ctx, GLenum target, GLuint index) {
    if (index == 0 && (is_occlusion_target(target) || ctx.time != nullptr)) return end_query(ctx, target);
    ctx.real->glEndQueryIndexed(target, index);
}

void query_counter(Context& ctx, GLuint id, GLenum target) {
    if (refuses_as_proposed(ctx, id)) return ctx.raise(GL_INVALID_OPERATION);
    if (!ctx.recording.is_open()) yield_name(ctx, id);
    if (ctx.time != nullptr) return stamp_query(ctx, id, target);
    ctx.real->glQueryCounter(id, target);
    note_object(ctx, id);
}

void get_queryiv(Context& ctx, GLenum target, GLenum pname, GLint* params) {
    if (refuses_target(ctx, target)) return ctx.raise(GL_INVALID_ENUM);
    if (pname == GL_CURRENT_QUERY && params != nullptr && ctx.time != nullptr &&
        ctx.time->counters().holds(target)) {
        *params = 0;
        return;
    }
    if (!is_occlusion_target(target) || params == nullptr)
        return ctx.real->glGetQueryiv(target, pname, params);

    constexpr GLint kUntouched = -7;  // no width and no name
    GLint value = kUntouched;
    ctx.real->glGetQueryiv(real_target(ctx, target), pname, &value);
    if (value == kUntouched) return;  // in error
    const std::optional<int> bits = settings().device.counter_bits;
    if (pname == GL_QUERY_COUNTER_BITS && target == GL_SAMPLES_PASSED && bits) value = *bits;
    if (pname == GL_CURRENT_QUERY && ctx.slot.open_segment != 0) value = 0;
    if (pname == GL_CURRENT_QUERY && ctx.follows_text) {
        value = target == ctx.slot.app_target ? static_cast<GLint>(ctx.slot.app_query) : 0;
    }
    *params = value;
}

void get_query_indexediv(Context& ctx, GLenum target, GLuint index, GLenum pname, GLint* params) {
    if (index == 0 && is_occlusion_target(target)) return get_queryiv(ctx, target, pname, params);
    ctx.real->glGetQueryIndexediv(target, index, pname, params);
}

// KHR_debug: INVALID_VALUE "if <name> is not the name of a valid object of the type specified by
// <identifier>"; a generated name becomes one at its first begin.
void object_label(Context& ctx, GLenum identifier, GLuint name, GLsizei length, const GLchar* label) {
    const bool is_checked = identifier == GL_QUERY && ctx.follows_text;
    if (is_checked && !is_object(ctx, name)) return ctx.raise(GL_INVALID_VALUE);
    ctx.real->glObjectLabel(identifier, name, length, label);
}

void get_object_label(Context& ctx, GLenum identifier, GLuint name, GLsizei size, GLsizei* length,
                      GLchar* label) {
    const bool is_checked = identifier == GL_QUERY && ctx.follows_text;
    if (is_checked && !is_object(ctx, name)) return ctx.raise(GL_INVALID_VALUE);
    ctx.real->glGetObjectLabel(identifier, name, size, length, label);
}

}  // namespace glext_emu::features
