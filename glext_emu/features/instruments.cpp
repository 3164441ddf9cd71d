// SPDX-License-Identifier: MIT
// GL_SGIX_instruments with two instruments: how many fragments passed the depth test
// (GL_SGIX_depth_pass_instrument), and whether none did (GL_SGIX_occlusion_instrument). A measurement is
// asked for in the pipe and comes back into the program's own memory.
#include "features/features.h"
#include "features/list_recorder.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace glext_emu::features {
namespace {

// SGIX_depth_pass_instrument and SGIX_occlusion_instrument: name, number of ints, value, marker.
constexpr GLsizei kResponseSize = 4;

Counters counter_of(const Context& ctx, GLenum cap) {
    if (cap == kDepthPassInstrument) return ctx.known_instruments & kDepthPassCounter;
    if (cap == kOcclusionInstrument) return ctx.known_instruments & kOcclusionCounter;
    return 0;
}

// Before <change>, what is drawn counts as it was; after it, as it is.
template <class Change>
void change_counting(Context& ctx, Change change) {
    Instruments& instruments = ctx.instruments;
    close_segment(ctx);
    change();
    ctx.slot.pipe = instruments.has_started ? &instruments.pipe : nullptr;
    ctx.slot.counters = instruments.has_started ? instruments.enabled : 0;
    ctx.update_hot();
}

void respond(Instruments& instruments, GLenum name, GLuint value, GLint marker) {
    GLint* const response = instruments.buffer + instruments.written;
    response[0] = static_cast<GLint>(name);
    response[1] = kResponseSize;
    response[2] = static_cast<GLint>(value);
    response[3] = marker;
    instruments.written += kResponseSize;
}

// Writes what has come out of the pipe.
void deliver(Context& ctx, bool waits) {
    Instruments& instruments = ctx.instruments;
    while (const auto reading = instruments.pipe.take(ctx, waits)) {
        if ((reading->counters & kDepthPassCounter) != 0) {
            const std::uint64_t most = depth_pass_max(ctx);
            const auto count = static_cast<GLuint>(std::min(reading->of(kDepthPassCounter), most));
            respond(instruments, kDepthPassInstrument, count, reading->marker);
        }
        if ((reading->counters & kOcclusionCounter) != 0) {
            const bool is_occluded = reading->of(kOcclusionCounter) == 0;
            respond(instruments, kOcclusionInstrument, is_occluded ? GL_TRUE : GL_FALSE, reading->marker);
        }
        instruments.markers.push_back(reading->marker);
        ctx.frame.results++;
    }
}

// What does not fit is not measured, nor is anything after it until the buffer is reset.
void measure(Context& ctx, GLint marker) {
    Instruments& instruments = ctx.instruments;
    if (instruments.enabled == 0) return;
    close_segment(ctx);
    instruments.measurements++;
    const GLsizei size = kResponseSize * std::popcount(instruments.enabled);
    if (instruments.has_overflowed || size > instruments.size - instruments.requested) {
        instruments.has_overflowed = instruments.overflow_is_news = true;
        instruments.lost++;
        return;
    }
    instruments.requested += size;
    instruments.pipe.read(marker, instruments.enabled, ctx.clock.due());
    ctx.update_hot();
}

}  // namespace

bool is_instrument(const Context& ctx, GLenum cap) {
    return counter_of(ctx, cap) != 0;
}

bool is_instrument_enabled(const Context& ctx, GLenum cap) {
    return (ctx.instruments.enabled & counter_of(ctx, cap)) != 0;
}

void set_instrument(Context& ctx, GLenum cap, bool is_enabled) {
    if (is_instrument_enabled(ctx, cap) == is_enabled) return;
    change_counting(ctx, [&] { ctx.instruments.enabled ^= counter_of(ctx, cap); });
}

// SGIX_depth_pass_instrument: "DEPTH_PASS_INSTRUMENT_MAX_SGIX may be as high as the maximum value of an
// unsigned integer".
std::uint64_t depth_pass_max(Context& ctx) {
    return (std::uint64_t{1} << std::min(counter_bits(ctx), 32)) - 1;
}

void deliver_measurements(Context& ctx) {
    deliver(ctx, true);
    ctx.update_hot();
}

void instruments_buffer_sgix(Context& ctx, GLsizei size, GLint* buffer) {
    if (size < 0) return ctx.raise(GL_INVALID_VALUE);
    // Executed at once, also while a list is compiled.
    const ListPause pause(ctx);
    Instruments& instruments = ctx.instruments;
    if (instruments.has_started) change_counting(ctx, [&] { instruments.has_started = false; });
    instruments.pipe.clear(ctx);
    const Counters enabled = instruments.enabled;
    instruments = {};
    instruments.buffer = buffer;
    instruments.size = size;
    instruments.enabled = enabled;
    ctx.update_hot();
    if (ctx.recording.mode == GL_COMPILE_AND_EXECUTE && ctx.slot.wants_segment()) open_segment(ctx);
}

void start_instruments_sgix(Context& ctx) {
    if (ctx.recording.is_open()) {
        return record(ctx, {[](Context& c, const ListOperation&) { start_instruments_sgix(c); }});
    }
    Instruments& instruments = ctx.instruments;
    if (instruments.buffer == nullptr || is_counter_taken(ctx)) return ctx.raise(GL_INVALID_OPERATION);
    change_counting(ctx, [&] { instruments.has_started = true; });
    instruments.pipe.restart(ctx);
}

void stop_instruments_sgix(Context& ctx, GLint marker) {
    if (ctx.recording.is_open()) {
        return record(ctx, {[](Context& c, const ListOperation& op) {
                                stop_instruments_sgix(c, static_cast<GLint>(op.first));
                            },
                            static_cast<GLuint>(marker)});
    }
    if (!ctx.instruments.has_started) return ctx.raise(GL_INVALID_OPERATION);
    measure(ctx, marker);
    change_counting(ctx, [&] { ctx.instruments.has_started = false; });
}

void read_instruments_sgix(Context& ctx, GLint marker) {
    if (ctx.recording.is_open()) {
        return record(ctx, {[](Context& c, const ListOperation& op) {
                                read_instruments_sgix(c, static_cast<GLint>(op.first));
                            },
                            static_cast<GLuint>(marker)});
    }
    if (!ctx.instruments.has_started) return ctx.raise(GL_INVALID_OPERATION);
    measure(ctx, marker);
}

GLint poll_instruments_sgix(Context& ctx, GLint* marker) {
    Instruments& instruments = ctx.instruments;
    ctx.frame.polls++;
    deliver(ctx, false);
    ctx.update_hot();
    if (!instruments.markers.empty()) {
        if (marker != nullptr) *marker = instruments.markers.front();
        instruments.markers.pop_front();
        return 1;
    }
    // SGIX_instruments: "An implementation may choose to delay reporting the overflow until the measurement
    // that caused the overflow is the one being polled."
    if (instruments.lost == 0 || instruments.pipe.has_reading()) return 0;
    instruments.lost--;
    return -1;
}

GLint get_instruments_sgix(Context& ctx) {
    Instruments& instruments = ctx.instruments;
    ctx.frame.polls++;
    deliver(ctx, false);
    ctx.update_hot();
    const GLsizei fresh = instruments.written - std::exchange(instruments.told, instruments.written);
    return std::exchange(instruments.overflow_is_news, false) ? -1 : fresh;
}

void get_pointerv(Context& ctx, GLenum pname, void** params) {
    if (pname != GL_INSTRUMENT_BUFFER_POINTER_SGIX || ctx.known_instruments == 0 || params == nullptr) {
        return ctx.real->glGetPointerv(pname, params);
    }
    *params = ctx.instruments.buffer;
}

}  // namespace glext_emu::features
