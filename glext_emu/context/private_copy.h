// SPDX-License-Identifier: MIT
// A private copy of the draw framebuffer's depth and stencil, on which a draw of the program's can be made
// once more: its own, unmodified. A logic op that sets every bit marks the samples that the draw would write,
// whatever colour its fragments have.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <functional>
#include <optional>

#include "context/depth_reader.h"
#include "context/fragment_tests.h"
#include "context/framebuffer_info.h"
#include "occlusion_unit/record_arithmetic.h"

namespace glext_emu {

struct Context;
class SavedState;

// How the draw's visible samples are found on the copy, and which depth of theirs is the nearest.
struct MarkingPlan {
    bool can_mark = false;             // the screen box is exact
    bool can_tell_depth = false;       // the nearest depth too
    bool marks_nothing = false;        // no sample is visible
    bool forces_depth_writes = false;  // so that the copy holds the nearest depth of each sample afterwards
    bool starts_far = false;           // the test cannot fail: every sample competes with the far depth only
};

// <registers>: those of SCREEN_BOX_BIT_EMU and NEAREST_DEPTH_BIT_EMU that are wanted.
MarkingPlan plan_marking(const FramebufferInfo& info, const FragmentTests& tests, GLbitfield registers,
                         occlusion_unit::FarEnd far_end);

// What the layer keeps of it between two draws of a context.
struct PrivateCopy {
    GLuint framebuffer = 0;  // 0: not made yet
    GLuint layer_reader = 0;
    GLuint depths = 0;  // textures
    GLuint marks = 0;
    GLenum marks_format = 0;
    FramebufferInfo shape;  // of what there is
    bool is_usable = false;

    // Copies depth and stencil as they are before the draw. False where the driver cannot.
    bool take(Context& ctx, const FramebufferInfo& info, GLenum marks_format);
    // Inside a Repetition: <draw> is made on the copy. Nearest depth and screen box of what was
    // marked.
    // Nothing where the driver cannot tell.
    std::optional<occlusion_unit::Record> mark(Context& ctx, const FragmentTests& tests,
                                               const MarkingPlan& plan, occlusion_unit::FarEnd far_end,
                                               const std::function<void()>& draw);

  private:
    bool make(Context& ctx, const FramebufferInfo& info, GLenum format_of_marks);
    void destroy(Context& ctx);
    void prepare(Context& ctx, SavedState& saved, const FragmentTests& tests, const MarkingPlan& plan,
                 occlusion_unit::FarEnd far_end);
    std::optional<occlusion_unit::Record> read(Context& ctx, SavedState& saved, const MarkingPlan& plan,
                                               occlusion_unit::FarEnd far_end);
    bool copy_layers(Context& ctx, GLbitfield buffers);
    Rect reachable(Context& ctx) const;
};

}  // namespace glext_emu
