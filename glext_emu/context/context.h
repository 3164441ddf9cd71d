// SPDX-License-Identifier: MIT
// What the layer remembers of one GL context. Only the thread in which it is current touches it, so nothing
// here is locked; what contexts of a share group have in common is ShareGroup.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "context/advertised.h"
#include "context/conditional_render.h"
#include "context/current.h"
#include "context/depth_reader.h"
#include "context/device.h"
#include "context/device_time.h"
#include "context/discard_scope.h"
#include "context/display_lists.h"
#include "context/draw_surface.h"
#include "context/frame_counts.h"
#include "context/instruments.h"
#include "context/narrowing.h"
#include "context/occlusion_slot.h"
#include "context/private_copy.h"
#include "context/probe.h"
#include "context/proposed_queries.h"
#include "context/visibility_tests.h"
#include "occlusion_unit/clock.h"

namespace glext_emu {

struct UnitStages;

// The HP test's enable, as PushAttrib(ENABLE_BIT) saved it.
struct SavedEnable {
    GLbitfield mask;
    bool test_enabled;
};

// What a context is, read once through the driver when it is first made current.
struct ContextKind {
    bool is_es = false;
    bool is_core_profile = false;
    GlVersion version;             // the driver's
    bool has_any_samples = false;  // ANY_SAMPLES_PASSED is a target of the driver's
    bool has_query_buffer = false;
    bool is_no_error = false;
    GLint attrib_stack_depth = 0;     // compatibility contexts only
    bool has_64_bit_results = false;  // GetQueryObjectui64v
    bool has_named_buffers = false;   // ARB_direct_state_access

    bool is_compatibility() const { return !is_es && !is_core_profile; }
};

struct Context {
    Context(const char* platform_name, const RealGl* real_gl, std::shared_ptr<ShareGroup> group);

    // Recomputes the hot word. Call after whatever it depends on has changed.
    void update_hot();
    // A GL error of the layer's own, after whatever error the driver already holds: the first one sticks.
    void raise(GLenum code);
    // Takes the driver's error, so that the next one is that of the calls to come; it sticks if it is the
    // first.
    void keep_error();
    // True where the driver is between Begin and End. Only for commands that are in error there, since the
    // driver may note the question as one.
    bool is_between_begin_and_end() {
        if (tracks_begin_end) return inside_begin_end && confirm_begin_end();
        return kind.is_compatibility() && confirm_begin_end();
    }
    // Moves a deterministic clock to what another context has seen complete.
    void catch_up();
    // Begin and End have come by.
    void set_inside_begin_end(bool is_inside);

    const char* platform;  // "glx", "egl" or "osmesa"
    const RealGl* real;    // the driver below; `ctx.real->` marks every contact with it
    int number;            // 1, 2, ... in order of creation, for reports
    std::shared_ptr<ShareGroup> share_group;
    std::atomic<int> references{1};  // the handle, and each thread in which it is current

    bool is_initialised = false;  // by the first MakeCurrent
    ContextKind kind;
    const Advertised* advertised = nullptr;
    bool emulates_test = false;             // GL_HP_occlusion_test
    bool emulates_nv_query = false;         // GL_NV_occlusion_query
    bool emulates_nvx_render = false;       // GL_NVX_conditional_render
    Counters known_instruments = 0;         // GL_SGIX_instruments, with those that it has
    bool emulates_visibility_test = false;  // GL_HP_visibility_test
    bool emulates_regions = false;          // GL_EMU_depth_region_query
    bool emulates_unit = false;             // GL_EMU_occlusion_unit
    bool repeats_draws = false;             // so a list's draws have to stand alone
    bool follows_text = false;  // where the driver departs from it; false on a device that passes through
    bool records_operations =
        false;  // lists may hold what the driver must not compile, or the layer must see
    std::uint32_t always_hot = 0;

    std::uint32_t hot = 0;
    GLenum pending_error = GL_NO_ERROR;  // returned by the next GetError, before the driver's
    int own_calls = 0;                   // nested OwnCalls scopes
    bool tracks_begin_end = false;       // Begin and End come by
    bool inside_begin_end = false;       // as far as Begin, which may have failed, and End tell
    GLuint collected_primitive = 0;      // the driver's list of a Begin and End that are to be repeated
    GLenum collected_mode = 0;           // of that Begin
    std::optional<DiscardScope> dry_primitive;  // around a Begin and End under --dry
    GLint list_base = 0;  // while inside Begin/End, where it can neither change nor be asked for
    ListRecording recording;
    std::vector<SavedEnable> attrib_stack;
    OcclusionSlot slot;
    Instruments instruments;
    VisibilityTests visibility;
    ConditionalRender conditional;
    ProposedQueries proposed;
    PrivateCopy private_copy;
    ProbeLog probe;
    std::shared_ptr<UnitStages> unit_stages;  // once fragments were looked at
    DrawSurface draw_surface;                 // behind the default framebuffer, for drawing
    DepthReader depth_reader;
    std::unique_ptr<DeviceTime> time;  // null but under the device's clock
    occlusion_unit::Clock clock;
    FrameCounts frame;
    Narrowing narrowing;

  private:
    bool confirm_begin_end();
};

// Makes a call of the driver's in the program's name; true where it raised no error.
template <class Call>
bool driver_accepts(Context& ctx, Call call) {
    ctx.keep_error();
    call();
    const GLenum error = ctx.real->glGetError();
    if (error != GL_NO_ERROR && ctx.pending_error == GL_NO_ERROR) ctx.pending_error = error;
    ctx.update_hot();
    return error == GL_NO_ERROR;
}

// The layer's own calls of the driver in the midst of the program's: an error that the program has pending
// survives them, an error of theirs is not seen. Never between Begin and End.
class OwnCalls {
  public:
    explicit OwnCalls(Context& ctx);
    ~OwnCalls();
    OwnCalls(const OwnCalls&) = delete;
    OwnCalls& operator=(const OwnCalls&) = delete;

  private:
    Context& ctx_;
};

}  // namespace glext_emu
