// SPDX-License-Identifier: MIT
// GL_HP_occlusion_test: one flag per context that any passing fragment sets and every Get clears. The text is
// in parts silent; where it is, NV_occlusion_query 4.1.6A and 6.1.13 speak. And the capabilities of all
// extensions that are emulated.
#include "features/features.h"
#include "features/list_recorder.h"
#include "features/stall.h"

namespace glext_emu::features {
namespace {

bool is_test(const Context& ctx, GLenum cap) {
    return ctx.emulates_test && cap == GL_OCCLUSION_TEST_HP;
}

// The driver does not know <cap>.
bool is_emulated(const Context& ctx, GLenum cap) {
    return is_test(ctx, cap) || is_instrument(ctx, cap) || is_visibility_test(ctx, cap);
}

// What a list has to hold as an operation of the layer's.
bool is_recorded(const Context& ctx, GLenum cap) {
    return is_emulated(ctx, cap) || (ctx.follows_text && cap == GL_MULTISAMPLE);
}

void set_test(Context& ctx, bool is_enabled) {
    if (is_enabled != ctx.slot.test_enabled) close_segment(ctx);
    ctx.slot.test_enabled = is_enabled;
    ctx.update_hot();
}

void set_capability(Context& ctx, GLenum cap, bool is_enabled) {
    if (is_test(ctx, cap)) return set_test(ctx, is_enabled);
    if (is_visibility_test(ctx, cap)) return set_visibility_test(ctx, is_enabled);
    set_instrument(ctx, cap, is_enabled);
}

}  // namespace

void enable(Context& ctx, GLenum cap) {
    if (!is_recorded(ctx, cap) || ctx.is_between_begin_and_end()) return ctx.real->glEnable(cap);
    if (ctx.recording.is_open()) {
        return record(ctx, {[](Context& c, const ListOperation& op) { enable(c, op.first); }, cap});
    }

    if (!is_emulated(ctx, cap)) return ctx.real->glEnable(cap);
    // EMU_occlusion_unit: the test and the unit share a counter.
    if (is_test(ctx, cap) && ctx.proposed.active_unit != 0) return ctx.raise(GL_INVALID_OPERATION);
    set_capability(ctx, cap, true);
}

void disable(Context& ctx, GLenum cap) {
    if (!is_recorded(ctx, cap) || ctx.is_between_begin_and_end()) return ctx.real->glDisable(cap);
    if (ctx.recording.is_open()) {
        return record(ctx, {[](Context& c, const ListOperation& op) { disable(c, op.first); }, cap});
    }

    if (!is_emulated(ctx, cap)) return ctx.real->glDisable(cap);
    set_capability(ctx, cap, false);
}

GLboolean is_enabled(Context& ctx, GLenum cap) {
    if (!is_emulated(ctx, cap) || ctx.is_between_begin_and_end()) return ctx.real->glIsEnabled(cap);
    bool is_on = is_instrument_enabled(ctx, cap);
    if (is_test(ctx, cap)) is_on = ctx.slot.test_enabled;
    if (is_visibility_test(ctx, cap)) is_on = ctx.visibility.is_enabled;
    return is_on ? GL_TRUE : GL_FALSE;
}

// NV_occlusion_query, New State: OCCLUSION_TEST_HP belongs to the attribute group "enable", the result to
// none.
void push_attrib(Context& ctx, GLbitfield mask) {
    if (!ctx.emulates_test) return ctx.real->glPushAttrib(mask);
    if (ctx.recording.is_open()) {
        return record(ctx, {[](Context& c, const ListOperation& op) { push_attrib(c, op.first); }, mask});
    }

    // A push onto the full stack fails in the driver, and has to fail here.
    if (ctx.attrib_stack.size() < static_cast<std::size_t>(ctx.kind.attrib_stack_depth)) {
        ctx.attrib_stack.push_back({mask, ctx.slot.test_enabled});
    }
    ctx.real->glPushAttrib(mask);
}

void pop_attrib(Context& ctx) {
    // A pop may switch MULTISAMPLE too, which a list has to hold as an operation of the layer's.
    const bool is_ours = ctx.emulates_test || (ctx.follows_text && ctx.recording.is_open());
    if (!is_ours) return ctx.real->glPopAttrib();
    if (ctx.recording.is_open()) {
        return record(ctx, {[](Context& c, const ListOperation&) { pop_attrib(c); }});
    }

    if (!ctx.attrib_stack.empty()) {
        const SavedEnable saved = ctx.attrib_stack.back();
        ctx.attrib_stack.pop_back();
        if ((saved.mask & GL_ENABLE_BIT) != 0 && saved.test_enabled != ctx.slot.test_enabled) {
            set_test(ctx, saved.test_enabled);
        }
    }
    ctx.real->glPopAttrib();
}

bool read_test_result(Context& ctx) {
    // A Get is executed at once while a list is compiled, and ending a query would be compiled into it.
    const ListPause pause(ctx);
    const StallScope stall(ctx);
    const bool was_counting = ctx.slot.open_segment != 0;
    const bool result = take_flag(ctx);
    ctx.clock.wait_until(ctx.slot.flag_due);
    ctx.frame.results++;
    // While a list is compiled and executed, its draws cannot open the segment themselves.
    if (was_counting && ctx.recording.name != 0) open_segment(ctx);
    return result;
}

}  // namespace glext_emu::features
