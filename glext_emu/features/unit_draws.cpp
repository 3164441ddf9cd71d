// SPDX-License-Identifier: MIT
// A draw that the Occlusion Unit watches. The driver counts the visible hits of the draw itself; the
// projected hits are those of the draw once more without depth test; the marks come from the program's own
// draw on a private copy of depth and stencil, or from an instrumented fragment stage. What cannot be had
// exactly is given up, never guessed.
#include <vector>

#include "context/fragment_tests.h"
#include "context/repetition.h"
#include "context/unit_run.h"
#include "features/features.h"

namespace glext_emu::features {
namespace {

constexpr GLbitfield kProjected = GL_PROJECTED_HITS_BIT_EMU;
constexpr GLbitfield kVisible = GL_VISIBLE_BIT_EMU | GL_VISIBLE_HITS_BIT_EMU;
constexpr GLbitfield kMarks = GL_NEAREST_DEPTH_BIT_EMU | GL_SCREEN_BOX_BIT_EMU;

// NV_occlusion_query, issues: samples are counted "even if GL_MULTISAMPLE is disabled"; Mesa counts pixels
// then.
GLuint samples_per_count(Context& ctx) {
    if (ctx.real->glIsEnabled(GL_MULTISAMPLE) != GL_FALSE) return 1;
    GLint samples = 0;
    ctx.real->glGetIntegerv(GL_SAMPLES, &samples);
    return samples > 1 ? static_cast<GLuint>(samples) : 1;
}

// The draw once more, counted without depth test and without a trace.
void count_projected(Context& ctx, UnitRun& run, DrawCall call) {
    if (!can_repeat(ctx)) return run.give_up(kProjected);
    const Repetition repetition(ctx);
    const WritesOff writes_off(ctx);
    ctx.real->glDisable(GL_DEPTH_TEST);
    run.count_for(ctx, kProjected, samples_per_count(ctx));
    call();
    run.close_segment(ctx);
    ctx.real->glEnable(GL_DEPTH_TEST);
}

}  // namespace

void draw_under_unit(Context& ctx, DrawCall call) {
    UnitRun& run = *ctx.proposed.run;
    const GLbitfield counts = run.wants(kVisible) && !run.watches() ? GL_VISIBLE_HITS_BIT_EMU : 0;
    if (!run.wants(kProjected | kMarks)) {
        run.count_for(ctx, counts, samples_per_count(ctx));
        return call();
    }

    const FragmentTests tests = read_fragment_tests(ctx);
    const bool passes_always = !tests.depth_can_fail();
    if (run.wants(kProjected) && !passes_always && tests.stencil_feeds_back()) run.give_up(kProjected);
    const bool counts_projected = run.wants(kProjected);
    run.count_for(ctx, counts | (counts_projected && passes_always ? kProjected : 0), samples_per_count(ctx));
    call();
    if (counts_projected && !passes_always) count_projected(ctx, run, call);
    if (run.wants(kMarks)) run.give_up(kMarks);
}

}  // namespace glext_emu::features
