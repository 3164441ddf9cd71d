// SPDX-License-Identifier: MIT
// Display lists. A list that holds emulated operations becomes a recipe: the driver's lists with our
// operations between them. Where emulated operations can occur, a nested CallList counts as one, since the
// inner list may hold some by the time it is called.
#include "context/device_time.h"
#include "features/features.h"
#include "features/list_recorder.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace glext_emu::features {
namespace {

// GL 4.6 compatibility, 21.4: calls nested deeper than MAX_LIST_NESTING (at least 64) are ignored.
constexpr int kDeepestNesting = 64;
thread_local constinit int nesting __attribute__((tls_model("initial-exec"))) = 0;

bool is_hidden(Context& ctx, GLuint list) {
    const std::lock_guard lock(ctx.share_group->mutex);
    return ctx.share_group->hidden_lists.contains(list);
}

// A name from GenLists is a list too, but an empty one: nobody misses it when it is replaced early.
bool is_defined(Context& ctx, GLuint list) {
    const std::lock_guard lock(ctx.share_group->mutex);
    return ctx.share_group->defined_lists.contains(list);
}

std::shared_ptr<const ListRecipe> recipe_of(Context& ctx, GLuint list) {
    const std::lock_guard lock(ctx.share_group->mutex);
    const auto found = ctx.share_group->recipes.find(list);
    return found == ctx.share_group->recipes.end() ? nullptr : found->second;
}

// Frees the driver's lists that nobody plays any more.
void delete_retired(Context& ctx) {
    std::vector<GLuint> lists;
    {
        // First: once one is deleted, the driver may give its name to another thread.
        const std::lock_guard lock(ctx.share_group->mutex);
        lists.swap(ctx.share_group->retired_lists);
        for (const GLuint list : lists) {
            ctx.share_group->hidden_lists.erase(list);
            ctx.share_group->begin_ends.erase(list);
        }
    }
    for (const GLuint list : lists) ctx.real->glDeleteLists(list, 1);
}

// Draws that are compiled and executed cannot open the test's segment, so it stands open before them.
void open_segment_ahead(Context& ctx) {
    if (ctx.recording.mode == GL_COMPILE_AND_EXECUTE && ctx.slot.wants_segment()) open_segment(ctx);
}

// What is known of one of the driver's lists; of most of them nothing.
struct Known {
    std::shared_ptr<const ListRecipe> recipe;
    bool is_hidden = false;
    BeginEnd begin_end = BeginEnd::kUnchanged;
};

Known look_up(Context& ctx, GLuint list) {
    ShareGroup& group = *ctx.share_group;
    const std::lock_guard lock(group.mutex);
    Known known;
    if (const auto found = group.recipes.find(list); found != group.recipes.end())
        known.recipe = found->second;
    if (const auto found = group.begin_ends.find(list); found != group.begin_ends.end()) {
        known.begin_end = found->second;
    }
    known.is_hidden = group.hidden_lists.contains(list);
    return known;
}

// Plays a list of the driver's own.
void play(Context& ctx, GLuint real_list, BeginEnd begin_end, DrawKind kind = DrawKind::kCollected) {
    if (begin_end == BeginEnd::kOpens) remember_list_base(ctx);
    const auto call = [&] { ctx.real->glCallList(real_list); };
    if (kind == DrawKind::kNothing && begin_end == BeginEnd::kUnchanged) {
        call();
    } else {
        draw(ctx, {0, false, kind}, call);
    }
    if (ctx.recording.is_open()) ctx.recording.follow(begin_end);
    if (begin_end != BeginEnd::kUnchanged && !ctx.recording.only_compiles()) {
        ctx.set_inside_begin_end(begin_end == BeginEnd::kOpens);
    }
}

void execute(Context& ctx, GLuint list) {
    const Known known = look_up(ctx, list);
    if (known.recipe == nullptr) {
        // To the program, a name of the layer's is a list that does not exist; one in the making does not
        // yet.
        if (!known.is_hidden && !ctx.recording.is_making(list)) play(ctx, list, known.begin_end);
        return;
    }
    if (nesting == kDeepestNesting) return;
    ++nesting;
    for (const ListStep& step : known.recipe->steps) {
        if (step.real_list == 0) {
            // Between Begin and End the question has made the error already.
            const bool is_in_error = !step.operation.calls_lists && ctx.is_between_begin_and_end();
            if (!is_in_error) step.operation.run(ctx, step.operation);
        } else {
            if (step.primitive != kNoPrimitive) {
                draw_collected(ctx, step.primitive, step.real_list);
                continue;
            }
            // Of a list that is not split into its draws, nobody knows what it draws.
            const DrawKind kind = ctx.repeats_draws ? step.draws : DrawKind::kCollected;
            play(ctx, step.real_list, look_up(ctx, step.real_list).begin_end, kind);
        }
    }
    --nesting;
}

// GL 4.6 compatibility, 21.4, table 21.3: the offset that element <i> of <lists> holds; nothing for an
// unknown <type>.
std::size_t element_size(GLenum type) {
    switch (type) {
        case GL_BYTE:
        case GL_UNSIGNED_BYTE:
            return 1;
        case GL_SHORT:
        case GL_UNSIGNED_SHORT:
        case GL_2_BYTES:
            return 2;
        case GL_3_BYTES:
            return 3;
        case GL_INT:
        case GL_UNSIGNED_INT:
        case GL_FLOAT:
        case GL_4_BYTES:
            return 4;
        default:
            return 0;
    }
}

template <class T>
T element(const std::byte* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

GLuint offset_at(const std::byte* at, GLenum type) {
    const auto byte = [at](int i) { return std::to_integer<GLuint>(at[i]); };
    switch (type) {
        case GL_BYTE:
            return static_cast<GLuint>(element<GLbyte>(at));
        case GL_UNSIGNED_BYTE:
            return byte(0);
        case GL_SHORT:
            return static_cast<GLuint>(element<GLshort>(at));
        case GL_UNSIGNED_SHORT:
            return element<GLushort>(at);
        case GL_FLOAT:
            return static_cast<GLuint>(static_cast<GLint64>(element<GLfloat>(at)));
        case GL_2_BYTES:
            return byte(0) << 8 | byte(1);
        case GL_3_BYTES:
            return byte(0) << 16 | byte(1) << 8 | byte(2);
        case GL_4_BYTES:
            return byte(0) << 24 | byte(1) << 16 | byte(2) << 8 | byte(3);
        default:
            return element<GLuint>(at);
    }
}

}  // namespace

void remember_list_base(Context& ctx) {
    const bool may_be_asked = ctx.records_operations && ctx.share_group->has_own_lists;
    if (may_be_asked && !ctx.inside_begin_end) ctx.real->glGetIntegerv(GL_LIST_BASE, &ctx.list_base);
}

void record(Context& ctx, ListOperation operation) {
    close_step(ctx);
    if (ctx.recording.mode == GL_COMPILE_AND_EXECUTE) {
        ctx.recording.is_suspended = true;
        operation.run(ctx, operation);
        open_segment_ahead(ctx);
        ctx.recording.is_suspended = false;
    }
    ctx.recording.steps.push_back({0, std::move(operation)});
    open_step(ctx);
}

void new_list(Context& ctx, GLuint list, GLenum mode) {
    const bool is_accepted = ctx.kind.is_compatibility() && list != 0 &&
                             (mode == GL_COMPILE || mode == GL_COMPILE_AND_EXECUTE) &&
                             ctx.recording.name == 0;
    if (!is_accepted) return ctx.real->glNewList(list, mode);

    const bool was_list = is_list(ctx, list) != GL_FALSE;
    ctx.recording = {.name = list, .mode = mode, .segment = list, .steps = {}, .was_list = was_list};
    // A name that the layer uses is compiled elsewhere; so is an old list of the program's, which stands
    // until EndList.
    if (ctx.records_operations && (is_hidden(ctx, list) || is_defined(ctx, list))) {
        ctx.recording.segment = make_hidden_list(ctx);
    }
    open_segment_ahead(ctx);
    // The end of a query that counts for the device's time would be compiled.
    if (ctx.time != nullptr) ctx.time->pause();
    ctx.real->glNewList(ctx.recording.segment, mode);
    ctx.update_hot();
}

void end_list(Context& ctx) {
    if (!ctx.recording.is_open()) return ctx.real->glEndList();

    ListRecording done = std::exchange(ctx.recording, {});
    ctx.real->glEndList();
    note_begin_end(*ctx.share_group, done);
    ShareGroup& group = *ctx.share_group;
    const bool is_split = !done.steps.empty() || done.segment != done.name;
    done.steps.push_back({done.segment, {}});
    std::shared_ptr<const ListRecipe> recipe;
    if (is_split) recipe = std::make_shared<const ListRecipe>(group, done.name, std::move(done.steps));
    {
        // At once, for other threads: the old list or the new one.
        const std::lock_guard lock(group.mutex);
        if (ctx.records_operations) group.defined_lists.insert(done.name);
        if (is_split) {
            group.recipes[done.name].swap(recipe);
        } else if (auto old = group.recipes.extract(done.name)) {
            recipe = std::move(old.mapped());
        }
    }
    recipe.reset();
    delete_retired(ctx);
    ctx.update_hot();
}

void call_list(Context& ctx, GLuint list) {
    const bool may_be_ours = ctx.recording.is_open() || ctx.share_group->has_own_lists;
    if (!may_be_ours && (ctx.hot & kHotDraw) == 0) [[likely]]
        return ctx.real->glCallList(list);
    // Between Begin and End a list cannot be split; no emulated operation is allowed there anyway.
    if (ctx.recording.is_open() && ctx.records_operations && !ctx.inside_begin_end) {
        ListOperation operation{[](Context& c, const ListOperation& op) { call_list(c, op.first); }, list};
        operation.calls_lists = true;
        return record(ctx, std::move(operation));
    }
    execute(ctx, list);
}

void call_lists(Context& ctx, GLsizei n, GLenum type, const void* lists) {
    const std::size_t size = element_size(type);
    const bool may_hold_ours = ctx.recording.is_open() || ctx.share_group->has_own_lists;
    if (n <= 0 || size == 0 || lists == nullptr || !ctx.records_operations || !may_hold_ours) {
        return draw(ctx, {0, false, DrawKind::kCollected}, [&] { ctx.real->glCallLists(n, type, lists); });
    }
    const auto* const bytes = static_cast<const std::byte*>(lists);
    if (ctx.recording.is_open() && !ctx.inside_begin_end) {
        ListOperation operation{[](Context& c, const ListOperation& op) {
                                    call_lists(c, static_cast<GLsizei>(op.first), op.second, op.bytes.data());
                                },
                                static_cast<GLuint>(n), type};
        operation.calls_lists = true;
        operation.bytes.assign(bytes, bytes + static_cast<std::size_t>(n) * size);
        return record(ctx, std::move(operation));
    }

    remember_list_base(ctx);
    const GLint base = ctx.list_base;
    for (GLsizei i = 0; i < n; ++i) {
        execute(ctx, static_cast<GLuint>(base) + offset_at(bytes + static_cast<std::size_t>(i) * size, type));
    }
}

void delete_lists(Context& ctx, GLuint list, GLsizei range) {
    const GLuint last = list + static_cast<GLuint>(range) - 1;
    if (range <= 0 || last < list) return ctx.real->glDeleteLists(list, range);

    std::vector<std::shared_ptr<const ListRecipe>> recipes;
    std::vector<GLuint> kept;
    {
        const std::lock_guard lock(ctx.share_group->mutex);
        ShareGroup& group = *ctx.share_group;
        group.defined_lists.erase(group.defined_lists.lower_bound(list),
                                  group.defined_lists.upper_bound(last));
        for (auto r = group.recipes.lower_bound(list); r != group.recipes.end() && r->first <= last;) {
            recipes.push_back(std::move(r->second));
            r = group.recipes.erase(r);
        }
        for (auto h = group.hidden_lists.lower_bound(list); h != group.hidden_lists.end() && *h <= last;
             ++h) {
            kept.push_back(*h);
        }
        const GLuint made = ctx.recording.name;
        if (made >= list && made <= last && ctx.recording.is_making(made)) kept.push_back(made);
        std::ranges::sort(kept);
    }
    // What lies between the layer's own lists.
    for (const GLuint hidden : kept) {
        if (hidden > list) ctx.real->glDeleteLists(list, static_cast<GLsizei>(hidden - list));
        list = hidden + 1;
    }
    if (list <= last) ctx.real->glDeleteLists(list, static_cast<GLsizei>(last - list + 1));
    recipes.clear();
    delete_retired(ctx);
}

GLboolean is_list(Context& ctx, GLuint list) {
    if (ctx.recording.is_making(list)) return ctx.recording.was_list ? GL_TRUE : GL_FALSE;
    if (recipe_of(ctx, list) != nullptr) return GL_TRUE;
    return is_hidden(ctx, list) ? GL_FALSE : ctx.real->glIsList(list);
}

}  // namespace glext_emu::features
