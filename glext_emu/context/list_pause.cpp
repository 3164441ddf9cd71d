// SPDX-License-Identifier: MIT
#include "context/list_pause.h"

#include "context/context.h"
#include "context/device_time.h"

namespace glext_emu {

// Never under the group's lock: see end_list and delete_lists.
ListRecipe::~ListRecipe() {
    const std::lock_guard lock(group.mutex);
    for (const ListStep& step : steps) {
        if (step.real_list != 0 && step.real_list != name) group.retired_lists.push_back(step.real_list);
    }
}

GLuint make_hidden_list(Context& ctx) {
    const OwnCalls own(ctx);
    const GLuint list = ctx.real->glGenLists(1);
    const std::lock_guard lock(ctx.share_group->mutex);
    ctx.share_group->hidden_lists.insert(list);
    ctx.share_group->has_own_lists = true;
    return list;
}

void delete_hidden_list(Context& ctx, GLuint list) {
    const OwnCalls own(ctx);
    {
        const std::lock_guard lock(ctx.share_group->mutex);
        ctx.share_group->hidden_lists.erase(list);
    }
    ctx.real->glDeleteLists(list, 1);
}

void note_begin_end(ShareGroup& group, const ListRecording& recording) {
    const std::lock_guard lock(group.mutex);
    if (recording.begin_end == BeginEnd::kUnchanged) {
        group.begin_ends.erase(recording.segment);
    } else {
        group.begin_ends[recording.segment] = recording.begin_end;
        group.has_own_lists = true;
    }
}

void close_step(Context& ctx) {
    ctx.real->glEndList();
    note_begin_end(*ctx.share_group, ctx.recording);
    ctx.recording.begin_end = BeginEnd::kUnchanged;
    ctx.recording.steps.push_back({ctx.recording.segment, {}});
}

void open_step(Context& ctx) {
    if (ctx.time != nullptr) ctx.time->pause();
    ctx.recording.segment = make_hidden_list(ctx);
    ctx.real->glNewList(ctx.recording.segment, ctx.recording.mode);
}

void open_draw_step(Context& ctx, GLenum mode) {
    if (ctx.time != nullptr) ctx.time->pause();
    ctx.recording.segment = make_hidden_list(ctx);
    ctx.real->glNewList(ctx.recording.segment, mode);
}

void close_draw_step(Context& ctx, DrawKind kind) {
    close_step(ctx);
    ctx.recording.steps.back().draws = kind;
}

ListPause::ListPause(Context& ctx) : ctx_(ctx), is_pausing_(ctx.recording.is_open()) {
    if (!is_pausing_) return;
    close_step(ctx_);
    ctx_.recording.is_suspended = true;
}

ListPause::~ListPause() {
    if (!is_pausing_) return;
    ctx_.recording.is_suspended = false;
    open_step(ctx_);
}

}  // namespace glext_emu
