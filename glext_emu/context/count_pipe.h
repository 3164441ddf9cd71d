// SPDX-License-Identifier: MIT
// Counters that are read while drawing goes on: the instruments of SGIX_instruments and the batch of
// HP_visibility_test. What the program asks for flows down a pipe behind the draws that are counted: hidden
// queries, restarts and readings, in the order of the program's commands; a reading comes out at the end with
// what was counted since the restart before it. Nothing waits but whoever wants a reading at once.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "occlusion_unit/clock.h"

namespace glext_emu {

struct Context;

// Tokens that glext.h lacks: of the registry, of no section of it; of the text of SGIX_occlusion_instrument;
// and of HP's header glHpNt.h of 2001.
inline constexpr GLenum kDepthPassInstrument = 0x8310;
inline constexpr GLenum kDepthPassCounters = 0x8311;
inline constexpr GLenum kDepthPassMax = 0x8312;
inline constexpr GLenum kOcclusionInstrument = 0x6060;
inline constexpr GLenum kVisibilityTest = 0x837A;

// A set of counters: bit i is counter i of a reading.
using Counters = unsigned;
inline constexpr Counters kDepthPassCounter = 1;
inline constexpr Counters kOcclusionCounter = 2;
inline constexpr Counters kVisibilityCounter = 4;
inline constexpr std::size_t kCounterCount = 3;

struct Reading {
    GLint marker = 0;       // of the command that asked
    Counters counters = 0;  // those that were asked for
    std::array<std::uint64_t, kCounterCount> fragments{};

    std::uint64_t of(Counters counter) const;
};

class CountPipe {
  public:
    // All counters are 0 for what comes.
    void restart(Context& ctx);
    // The hidden <query> has ended; it has counted for <counters>, <samples> for each fragment.
    void add(Context& ctx, GLuint query, Counters counters, GLuint samples);
    // Asks what <counters> have counted up to here.
    void read(GLint marker, Counters counters, occlusion_unit::Tick due);
    // The oldest reading, once the clock has reached it and the driver has counted; <waits> for that. Nothing
    // where it is not there yet, or there is none.
    std::optional<Reading> take(Context& ctx, bool waits);
    // Forgets all that is in the pipe.
    void clear(Context& ctx);
    // Waits for the driver, so that no query is in the pipe any more.
    void settle(Context& ctx);

    bool has_reading() const { return readings_ != 0; }

  private:
    enum class Kind { kCounted, kRestart, kReading };
    struct Step {
        Kind kind = Kind::kRestart;
        GLuint query = 0;    // kCounted: not settled yet
        GLuint samples = 1;  // kCounted
        Counters counters = 0;
        std::uint64_t fragments = 0;  // kCounted: settled
        GLint marker = 0;             // kReading
        occlusion_unit::Tick due = 0;
    };

    static void settle(Context& ctx, Step& step);
    static void give_back(Context& ctx, const Step& step);
    // Counts what lies before the oldest reading; false where that would wait.
    bool advance(Context& ctx, bool waits);

    std::deque<Step> steps_;
    std::array<std::uint64_t, kCounterCount> fragments_{};  // counted before the oldest step
    std::size_t readings_ = 0;
    std::size_t unsettled_ = 0;
};

}  // namespace glext_emu
