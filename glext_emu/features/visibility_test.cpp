// SPDX-License-Identifier: MIT
// GL_HP_visibility_test: a batch of tests whose results, TRUE where something passed the depth test, land in
// an array of the program's. HP's OpenGL 1.1 Reference, glVisibilityBufferhp, is the law; no registry has a
// text.
#include "features/features.h"
#include "features/list_recorder.h"
#include "features/stall.h"

namespace glext_emu::features {
namespace {

// "If an incorrect 'size' is specified, memory corruption may occur": here it does not.
void end_test(Context& ctx) {
    VisibilityTests& tests = ctx.visibility;
    close_segment(ctx);
    if (tests.test < tests.size && tests.buffer != nullptr) {
        tests.pipe.read(tests.test, kVisibilityCounter, ctx.clock.due());
    }
    tests.pipe.restart(ctx);
    tests.test++;
}

void lend_counter(Context& ctx, bool to_tests) {
    ctx.slot.pipe = to_tests ? &ctx.visibility.pipe : nullptr;
    ctx.slot.counters = to_tests ? kVisibilityCounter : 0;
    ctx.visibility.is_enabled = to_tests;
    ctx.update_hot();
}

}  // namespace

bool is_visibility_test(const Context& ctx, GLenum cap) {
    return ctx.emulates_visibility_test && cap == kVisibilityTest;
}

void set_visibility_test(Context& ctx, bool is_enabled) {
    VisibilityTests& tests = ctx.visibility;
    if (is_enabled == tests.is_enabled) return;
    if (!is_enabled) {
        end_test(ctx);
        return lend_counter(ctx, false);
    }
    if (!tests.has_buffer || is_counter_taken(ctx)) return ctx.raise(GL_INVALID_OPERATION);
    close_segment(ctx);
    tests.pipe.clear(ctx);
    tests.test = 0;
    lend_counter(ctx, true);
}

void visibility_buffer_hp(Context& ctx, GLsizei size, GLboolean* buffer, GLboolean wait_on_get) {
    VisibilityTests& tests = ctx.visibility;
    if (size < 0) return ctx.raise(GL_INVALID_VALUE);
    if (tests.is_enabled) return ctx.raise(GL_INVALID_OPERATION);
    // What has not come yet belongs to the old array, which may be gone.
    tests.pipe.clear(ctx);
    tests.has_buffer = true;
    tests.buffer = buffer;
    tests.size = size;
    tests.waits = wait_on_get != GL_FALSE;
}

void next_visibility_test_hp(Context& ctx) {
    if (ctx.recording.is_open()) {
        return record(ctx, {[](Context& c, const ListOperation&) { next_visibility_test_hp(c); }});
    }
    if (!ctx.visibility.is_enabled) return ctx.raise(GL_INVALID_OPERATION);
    end_test(ctx);
}

// "Calling glGet causes the contents of 'buffer' to be up to date (based on the value of the 'wait_on_get'
// parameter)", once the tests are disabled.
bool read_visibility_tests(Context& ctx) {
    VisibilityTests& tests = ctx.visibility;
    if (tests.is_enabled) return false;
    std::optional<StallScope> stall;
    if (tests.waits && tests.pipe.has_reading()) stall.emplace(ctx);
    while (const auto reading = tests.pipe.take(ctx, tests.waits)) {
        tests.buffer[reading->marker] = reading->of(kVisibilityCounter) != 0 ? GL_TRUE : GL_FALSE;
        ctx.frame.results++;
    }
    return !tests.pipe.has_reading();
}

}  // namespace glext_emu::features
