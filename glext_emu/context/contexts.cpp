// SPDX-License-Identifier: MIT
#include "context/contexts.h"

#include <pthread.h>

#include <cstring>
#include <mutex>
#include <unordered_map>
#include <utility>

#include "context/doctor.h"
#include "context/list_pause.h"
#include "context/refusals.h"
#include "context/report.h"
#include "context/settings.h"
#include "context/unit_run.h"

namespace glext_emu {
namespace {

// Leaked on purpose: programs call GL from their own destructors.
struct Contexts {
    std::mutex mutex;
    std::unordered_map<const void*, Context*> by_handle;
};

Contexts& contexts() {
    static Contexts* const all = [] {
        auto* made = new Contexts;
        // A fork in the midst of another thread's work must not leave the child a locked door.
        pthread_atfork(
            [] {
                contexts().mutex.lock();
                Report::before_fork();
            },
            [] {
                Report::after_fork(false);
                contexts().mutex.unlock();
            },
            [] {
                Report::after_fork(true);
                for (const auto& [handle, ctx] : contexts().by_handle) ctx->frame = {};
                contexts().mutex.unlock();
            });
        return made;
    }();
    return *all;
}

void release(Context* ctx) {
    if (ctx == nullptr || --ctx->references != 0) return;
    Report::instance().end_context(*ctx);
    delete ctx;
}

GlVersion parse_version(const char* text) {
    GlVersion version;
    while (*text != '\0' && (*text < '0' || *text > '9')) ++text;
    while (*text >= '0' && *text <= '9') version.major = version.major * 10 + (*text++ - '0');
    if (*text == '.') ++text;
    while (*text >= '0' && *text <= '9') version.minor = version.minor * 10 + (*text++ - '0');
    return version;
}

GLint get(const Context& ctx, GLenum name) {
    GLint value = 0;
    ctx.real->glGetIntegerv(name, &value);
    return value;
}

// For contexts of 3.0 and later. What the driver has, whether the device hides it or not.
bool driver_has(const Context& ctx, const char* extension) {
    for (GLint i = get(ctx, GL_NUM_EXTENSIONS); i-- > 0;) {
        const GLubyte* name = ctx.real->glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
        if (name != nullptr && std::strcmp(reinterpret_cast<const char*>(name), extension) == 0) return true;
    }
    return false;
}

ContextKind read_kind(const Context& ctx) {
    ContextKind kind;
    const auto* version = reinterpret_cast<const char*>(ctx.real->glGetString(GL_VERSION));
    if (version == nullptr) version = "";
    kind.is_es = std::strncmp(version, "OpenGL ES", 9) == 0;
    kind.version = parse_version(version);
    if (kind.is_es) {
        kind.is_no_error = kind.version >= GlVersion{3, 2} &&
                           (get(ctx, GL_CONTEXT_FLAGS) & GL_CONTEXT_FLAG_NO_ERROR_BIT) != 0;
        return kind;
    }
    if (kind.version >= GlVersion{3, 2}) {
        kind.is_core_profile = (get(ctx, GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_CORE_PROFILE_BIT) != 0;
    }
    // OpenGL 3.1 had no profiles: what is no compatibility context lacks this extension.
    if (kind.version == GlVersion{3, 1}) kind.is_core_profile = !driver_has(ctx, "GL_ARB_compatibility");
    if (kind.version >= GlVersion{3, 0}) {
        kind.has_any_samples = kind.version >= GlVersion{3, 3} || driver_has(ctx, "GL_ARB_occlusion_query2");
        kind.has_query_buffer =
            kind.version >= GlVersion{4, 4} || driver_has(ctx, "GL_ARB_query_buffer_object");
        kind.has_named_buffers =
            kind.version >= GlVersion{4, 5} || driver_has(ctx, "GL_ARB_direct_state_access");
        kind.has_64_bit_results = kind.version >= GlVersion{3, 3} || driver_has(ctx, "GL_ARB_timer_query");
        kind.is_no_error = (get(ctx, GL_CONTEXT_FLAGS) & GL_CONTEXT_FLAG_NO_ERROR_BIT) != 0;
    }
    return kind;
}

std::uint32_t always_hot(const Context& ctx) {
    const Settings& wanted = settings();
    constexpr std::uint32_t kCounting =
        kHotDraw | kHotPixels | kHotImmediate | kHotCall | kHotList | kHotQuery;
    // Commands that the driver may lack are there where they are emulated.
    constexpr std::uint32_t kSupplied = kHotNvquery | kHotNvxrender | kHotInstrument | kHotVisibility |
                                        kHotFardepth | kHotRegion | kHotUnit | kHotWork;
    // What takes time on a device.
    constexpr std::uint32_t kTaking = kHotDraw | kHotPixels | kHotImmediate | kHotCall | kHotList |
                                      kHotQuery | kHotClear | kHotRead | kHotStorage | kHotWork | kHotGet;
    std::uint32_t hot = 0;
    if (!wanted.report_path.empty()) hot |= kCounting;
    if (ctx.emulates_test) hot |= kHotEnable | kHotAttrib | kHotGet;
    if (ctx.follows_text) hot |= kHotQuery;
    if (ctx.clock.delays()) hot |= kHotQuery | kHotSync;
    if (ctx.time != nullptr) hot |= kTaking;
    if (ctx.records_operations) hot |= kHotCall | kHotList;
    if (ctx.advertised->version_differs || ctx.advertised->extensions_differ) hot |= kHotString | kHotGet;
    if (ctx.clock.counts_calls()) hot |= kHotAll & ~kSupplied;
    if (ctx.emulates_regions) hot |= kHotRegion | kHotFardepth | kHotGet;
    if (ctx.emulates_unit) hot |= kHotUnit | kHotFardepth | kHotGet;
    if (ctx.known_instruments != 0) hot |= kHotInstrument | kHotPointer | kHotEnable | kHotGet;
    if (ctx.emulates_visibility_test) hot |= kHotVisibility | kHotEnable | kHotGet;
    if (ctx.emulates_nv_query) hot |= kHotNvquery;
    if (ctx.emulates_nvx_render) hot |= kHotNvxrender;
    return hot;
}

// The instruments that the device has; SGIX_instruments alone is a mechanism without one.
Counters known_instruments(const Context& ctx, const Device& device) {
    if (!ctx.kind.is_compatibility() || !device.emulates("GL_SGIX_instruments")) return 0;
    Counters known = 0;
    if (device.emulates("GL_SGIX_depth_pass_instrument")) known |= kDepthPassCounter;
    if (device.emulates("GL_SGIX_occlusion_instrument")) known |= kOcclusionCounter;
    return known;
}

bool counts_fragments(const Context& ctx) {
    return !ctx.kind.is_es &&
           (ctx.kind.version >= GlVersion{4, 6} ||
            (ctx.kind.version >= GlVersion{3, 0} && driver_has(ctx, "GL_ARB_pipeline_statistics_query")));
}

// What only the driver can tell, and only while the context is current.
void initialise(Context& ctx) {
    ctx.kind = read_kind(ctx);
    if (ctx.kind.is_compatibility()) ctx.kind.attrib_stack_depth = get(ctx, GL_MAX_ATTRIB_STACK_DEPTH);
    const Device& device = settings().device;
    ctx.follows_text = !device.is_pass_through();
    ctx.emulates_test = ctx.kind.is_compatibility() && device.emulates("GL_HP_occlusion_test");
    ctx.emulates_nv_query = ctx.kind.is_compatibility() && device.emulates("GL_NV_occlusion_query");
    ctx.emulates_visibility_test = ctx.kind.is_compatibility() && device.emulates("GL_HP_visibility_test");
    ctx.known_instruments = known_instruments(ctx, device);
    ctx.emulates_nvx_render = ctx.kind.is_compatibility() && device.emulates("GL_NVX_conditional_render");
    // They are written against desktop GL of any profile; what answers them names framebuffers and buffers
    // directly.
    const bool can_propose = !ctx.kind.is_es && ctx.kind.has_named_buffers;
    ctx.emulates_regions = can_propose && device.emulates("GL_EMU_depth_region_query");
    ctx.emulates_unit = can_propose && device.emulates("GL_EMU_occlusion_unit");
    if (ctx.time != nullptr) {
        ctx.time->initialise(counts_fragments(ctx));
        ctx.slot.work_counters = &ctx.time->counters();
    }
    ctx.advertised = advertise(ctx, device);
    ctx.probe.is_wanted = can_propose && settings().probes_unit;
    ctx.repeats_draws = ctx.kind.is_compatibility() && (ctx.emulates_unit || ctx.probe.is_wanted);
    ctx.records_operations =
        ctx.kind.is_compatibility() && (ctx.follows_text || ctx.clock.delays() || ctx.probe.is_wanted);
    ctx.always_hot = always_hot(ctx);
    ctx.is_initialised = true;
    Report::instance().begin_context(ctx);
    doctor_note(("context: " + std::string(ctx.platform) + ", OpenGL " + ctx.advertised->version_string +
                 (ctx.kind.is_core_profile ? ", core profile" : ""))
                    .c_str());
}

}  // namespace

void context_created(const char* platform, const RealGl& real, const void* handle, const void* share) {
    std::unique_lock lock(contexts().mutex);
    const auto shared = contexts().by_handle.find(share);
    auto group =
        shared != contexts().by_handle.end() ? shared->second->share_group : std::make_shared<ShareGroup>();
    auto* made = new Context(platform, &real, std::move(group));
    Context* const stale = std::exchange(contexts().by_handle[handle], made);
    lock.unlock();
    release(stale);
}

Context* forget_context(const void* handle) {
    const std::lock_guard lock(contexts().mutex);
    const auto node = contexts().by_handle.extract(handle);
    return node.empty() ? nullptr : node.mapped();
}

void end_context(Context* ctx) {
    release(ctx);
}

void restore_context(const void* handle, Context* ctx) {
    if (ctx == nullptr) return;
    std::unique_lock lock(contexts().mutex);
    if (contexts().by_handle.try_emplace(handle, ctx).second) return;
    lock.unlock();
    release(ctx);
}

void context_leaves_thread() {
    // A context that is destroyed with a query still active crashes llvmpipe, whose rasteriser writes into
    // it; the program knows of no query, so it is not the one to blame. The next draw opens another segment.
    Context* const ctx = current.context;
    if (ctx == nullptr) return;
    const bool has_active = ctx->slot.open_segment != 0 || ctx->proposed.run != nullptr;
    if (ctx->time != nullptr) ctx->time->settle();
    if (!(has_active || ctx->probe.is_wanted) || ctx->is_between_begin_and_end()) return;
    if (ctx->probe.is_wanted) settle_probes(*ctx);
    const ListPause pause(*ctx);
    close_segment(*ctx);
    if (ctx->proposed.run != nullptr) ctx->proposed.run->close_segment(*ctx);
}

void context_made_current(const char* platform, const RealGl& real, const void* handle) {
    Context* const before = current.context;
    if (handle == nullptr) {
        current = {0, current.real, nullptr};
    } else {
        const std::lock_guard lock(contexts().mutex);
        Context*& ctx = contexts().by_handle[handle];
        if (ctx == nullptr) ctx = new Context(platform, &real, std::make_shared<ShareGroup>());
        ++ctx->references;
        current = {0, ctx->real, ctx};
    }
    release(before);
    if (current.context == nullptr) return;
    Context& ctx = *current.context;
    if (!ctx.is_initialised) initialise(ctx);
    ctx.update_hot();
    // A list that is compiled and executed does so with the test's segment open.
    if (ctx.recording.is_open() && ctx.recording.mode == GL_COMPILE_AND_EXECUTE && ctx.slot.wants_segment()) {
        const ListPause pause(ctx);
        open_segment(ctx);
    }
}

void context_copied(const void* from, const void* to, GLbitfield mask) {
    if ((mask & GL_ENABLE_BIT) == 0) return;
    const std::lock_guard lock(contexts().mutex);
    const auto source = contexts().by_handle.find(from);
    const auto target = contexts().by_handle.find(to);
    if (source == contexts().by_handle.end() || target == contexts().by_handle.end()) return;
    // The enable is state of the group "enable"; the flag belongs to none.
    target->second->slot.test_enabled = source->second->slot.test_enabled;
    target->second->update_hot();
}

void for_each_context(void (*visit)(Context& ctx)) {
    // Called at exit too, which may interrupt anything: what is locked then stays untouched.
    const std::unique_lock lock(contexts().mutex, std::try_to_lock);
    if (!lock.owns_lock()) return;
    for (const auto& [handle, ctx] : contexts().by_handle) {
        const bool is_elsewhere = ctx != current.context && ctx->references > 1;
        if (!is_elsewhere) visit(*ctx);
    }
}

void buffers_swapped() {
    Context* const ctx = current.context;
    if (ctx == nullptr) return;
    ctx->clock.count_swap();
    if (ctx->time != nullptr) ctx->time->swap(window_pixels(*ctx));
    ctx->draw_surface.has_size = false;
    end_probes_frame(*ctx);
    Report::instance().end_frame(*ctx);
}

}  // namespace glext_emu
