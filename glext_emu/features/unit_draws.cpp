// SPDX-License-Identifier: MIT
// A draw that the Occlusion Unit watches. The driver counts the visible hits of the draw itself; the
// projected hits are those of the draw once more without depth test, beforehand; the marks come from the
// program's own draw on a private copy of depth and stencil, or from an instrumented fragment stage. What
// cannot be had exactly is given up, never guessed.
#include <algorithm>
#include <memory>

#include "context/fragment_tests.h"
#include "context/framebuffer_info.h"
#include "context/private_copy.h"
#include "context/proxy_stage.h"
#include "context/repetition.h"
#include "context/saved_state.h"
#include "context/unit_run.h"
#include "features/features.h"

namespace glext_emu::features {
namespace {

constexpr GLbitfield kProjected = GL_PROJECTED_HITS_BIT_EMU;
constexpr GLbitfield kVisible = GL_VISIBLE_BIT_EMU | GL_VISIBLE_HITS_BIT_EMU;
constexpr GLbitfield kThrownAway = GL_SCREEN_BOX_BIT_EMU;  // no register that counts
constexpr GLbitfield kMarks = GL_NEAREST_DEPTH_BIT_EMU | GL_SCREEN_BOX_BIT_EMU;

// What is copied and read back lies in one scissor rectangle.
bool has_one_scissor(Context& ctx) {
    if (ctx.kind.version < GlVersion{4, 1}) return true;
    const RealGl& real = *ctx.real;
    GLint viewports = 1;
    real.glGetIntegerv(GL_MAX_VIEWPORTS, &viewports);
    GLint first[4] = {};
    real.glGetIntegerv(GL_SCISSOR_BOX, first);
    const GLboolean is_on = real.glIsEnabled(GL_SCISSOR_TEST);
    for (GLint i = 1; i < viewports; ++i) {
        const auto index = static_cast<GLuint>(i);
        GLint box[4] = {};
        if (real.glIsEnabledi(GL_SCISSOR_TEST, index) != is_on) return false;
        real.glGetIntegeri_v(GL_SCISSOR_BOX, index, box);
        if (is_on != GL_FALSE && !std::ranges::equal(box, first)) return false;
    }
    return true;
}

// llvmpipe compares alpha in the precision of the colour buffer, so the marks lie in one that has it too.
GLenum marks_format(Context& ctx) {
    if (!ctx.kind.is_compatibility() || ctx.real->glIsEnabled(GL_ALPHA_TEST) == GL_FALSE) return GL_R8;
    GLint alpha_bits = 0;
    ctx.real->glGetIntegerv(GL_ALPHA_BITS, &alpha_bits);
    return alpha_bits == 8 ? GL_RGBA8 : GL_R8;
}

// How the marks of one draw are found.
class Marking {
  public:
    Marking(Context& ctx, UnitRun& run, const FragmentTests& tests, DrawKind kind)
        : ctx_(ctx), run_(run), tests_(tests), kind_(kind), wanted_(run.wanted(kMarks)) {
        if (wanted_ == 0) return;
        if (kind != DrawKind::kPixels && ProxyMarks::serves(ctx, wanted_, run.far_end(), tests)) {
            is_along_ = ProxyMarks::writes_nothing(ctx, tests);
            // A query of the program's may count primitives.
            if (is_along_ || can_repeat(ctx, kind)) {
                proxy_ = proxy_of_run();
            } else {
                run.give_up(kMarks);
            }
        } else {
            plan_copy();
        }
    }

    // The draw beforehand, once more than it is made.
    void before(DrawCall call) {
        if (copies_ && !ctx_.private_copy.take(ctx_, info_, marks_format_)) return run_.give_up(kMarks);
        if (copies_) {
            const Repetition repetition(ctx_, kind_);
            const auto draw = [&] {
                // Softpipe interpolates depths of 16 bits otherwise while nothing counts.
                run_.count_for(ctx_, run_.counts_visible() ? kThrownAway : 0, 1);
                call();
                run_.close_segment(ctx_);
            };
            const auto marks = ctx_.private_copy.mark(ctx_, tests_, plan_, run_.far_end(), draw);
            if (!marks) return run_.give_up(kMarks);
            run_.mark(*marks);
        }
        if (proxy_ == nullptr) return;
        proxy_->aim(ctx_);
        if (!is_along_) {
            const Repetition repetition(ctx_, kind_);
            SavedState saved(ctx_);
            saved.write_nothing();
            proxy_->begin_draw(ctx_);
            call();
            proxy_->end_draw(ctx_);
        }
    }
    // True where the draw itself runs the stage that marks.
    bool runs_along() const { return proxy_ != nullptr && is_along_; }
    // True where it runs along and a depth test is made.
    bool runs_along_depth_test() const { return runs_along() && tests_.depth_test && proxy_->has_depth(); }
    // The draw itself.
    void draw(DrawCall call) {
        if (!runs_along()) return call();
        proxy_->begin_draw(ctx_);
        call();
        proxy_->end_draw(ctx_);
    }

  private:
    ProxyMarks* proxy_of_run() {
        std::unique_ptr<DriverMarks>& marks = run_.driver_marks();
        if (marks == nullptr) marks = std::make_unique<ProxyMarks>(run_.armed() & kMarks, run_.far_end());
        return static_cast<ProxyMarks*>(marks.get());
    }

    void plan_copy() {
        const bool can_copy = ctx_.kind.has_named_buffers && ctx_.conditional.query == 0 &&
                              can_repeat(ctx_, kind_) && has_one_scissor(ctx_);
        if (!can_copy) return run_.give_up(kMarks);
        info_ = draw_framebuffer_info(ctx_);
        if (!info_.is_complete) return;
        // Where a pixel's samples are not drawn one by one, llvmpipe colours those too that fail the depth
        // test.
        const bool draws_pixels =
            kind_ == DrawKind::kPixels || ctx_.real->glIsEnabled(GL_MULTISAMPLE) == GL_FALSE;
        if (info_.samples != 0 && draws_pixels) return run_.give_up(kMarks);
        plan_ = plan_marking(info_, tests_, wanted_, run_.far_end());
        if (!plan_.can_tell_depth) run_.give_up(GL_NEAREST_DEPTH_BIT_EMU);
        copies_ = plan_.can_mark && !plan_.marks_nothing && run_.wants(kMarks);
        marks_format_ = marks_format(ctx_);
    }

    Context& ctx_;
    UnitRun& run_;
    const FragmentTests& tests_;
    DrawKind kind_;
    GLbitfield wanted_;
    ProxyMarks* proxy_ = nullptr;
    bool is_along_ = false;  // the draw itself runs the proxy's stage
    bool copies_ = false;
    GLenum marks_format_ = GL_R8;
    FramebufferInfo info_;
    MarkingPlan plan_;
};

// The draw once more, counted without a trace: all of it without depth test, or what the depth test hides.
void count_projected(Context& ctx, UnitRun& run, const FragmentTests& tests, DrawKind kind,
                     bool is_hidden_only, DrawCall call) {
    if (!can_repeat(ctx, kind)) return run.give_up(kProjected);
    const Repetition repetition(ctx, kind);
    SavedState saved(ctx);
    saved.write_nothing();
    if (is_hidden_only) {
        saved.depth_func(opposite_depth_func(tests.depth_func));
    } else if (tests.depth_test) {
        saved.set(GL_DEPTH_TEST, false);
    }
    run.count_for(ctx, kProjected, samples_per_count(ctx));
    call();
    run.close_segment(ctx);
}

}  // namespace

// GL 4.6 compatibility, 19.3, 19.4: in feedback and selection mode nothing is rasterised; a repeated draw
// would be told twice.
bool makes_fragments(Context& ctx) {
    if (ctx.real->glIsEnabled(GL_RASTERIZER_DISCARD) != GL_FALSE) return false;
    GLint mode = GL_RENDER;
    if (ctx.kind.is_compatibility()) ctx.real->glGetIntegerv(GL_RENDER_MODE, &mode);
    return mode == GL_RENDER;
}

void draw_under_unit(Context& ctx, DrawKind kind, DrawCall call) {
    aim_probe(ctx);
    UnitRun& run = *ctx.proposed.run;
    const GLbitfield counts = run.counts_visible() ? GL_VISIBLE_HITS_BIT_EMU : 0;
    if (!run.wants(kProjected | kMarks)) {
        run.count_for(ctx, counts, samples_per_count(ctx));
        return call();
    }

    if (!makes_fragments(ctx)) return call();
    const FragmentTests tests = read_fragment_tests(ctx);
    // Where every fragment passes, the draw itself has the projected hits; not while the query that is
    // watched has the driver's slot.
    const bool counts_along = !tests.depth_can_fail() && !run.watches();
    if (run.wants(kProjected) && !counts_along && tests.stencil_feeds_back()) run.give_up(kProjected);
    const bool counts_projected = run.wants(kProjected);
    Marking marking(ctx, run, tests, kind);
    marking.before(call);
    // Of fixed function that writes nothing, what is visible and what is hidden are all there is, and early
    // depth tests make short work of one of them.
    const bool counts_hidden = marking.runs_along_depth_test() && !run.watches();
    if (counts_projected && !counts_along) count_projected(ctx, run, tests, kind, counts_hidden, call);
    const bool draw_is_projected = run.wants(kProjected) && (counts_along || counts_hidden);
    run.count_for(ctx, counts | (draw_is_projected ? kProjected : 0), samples_per_count(ctx));
    marking.draw(call);
}

}  // namespace glext_emu::features
