// SPDX-License-Identifier: MIT
// The probe: the Occlusion Unit watches the program's own occlusion queries, and the report says of each what
// its registers would have told. Nothing that the program sees changes: the query stays the driver's, and
// keeps the driver's slot.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>

#include "context/unit_run.h"

namespace glext_emu {

struct Context;

// One of the program's occlusion queries.
struct ProbedQuery {
    GLuint name = 0;
    GLenum target = 0;
    std::uint64_t frame = 0;       // in which it was begun
    std::uint64_t draws = 0;       // made in it, once it has ended
    std::unique_ptr<UnitRun> run;  // null while the query is active: then it is the context's
};

struct ProbeLog {
    // What waits for the driver, and what is told of a frame, is bounded; what is beyond is counted.
    static constexpr std::size_t kMostUnread = 256;
    static constexpr std::uint64_t kMostOfFrame = 4096;

    bool is_wanted = false;
    bool is_unaimed = false;         // the active query has drawn nothing yet
    ProbedQuery active;              // name 0: none
    std::uint64_t draws_before = 0;  // of the current frame, when the active query began
    std::deque<ProbedQuery> unread;  // in the order of their ends
    std::uint64_t told_of_frame = 0;
};

// The program's query has begun, and has ended.
void begin_probe(Context& ctx, GLenum target, GLuint name);
void end_probe(Context& ctx);
// A draw of the active query is about to be made. Where depth is far is taken from the first one's depth
// function.
void aim_probe(Context& ctx);
// Reads what is known of the query object <name>, whose count is about to go; waits. An active query is given
// up.
void settle_probe(Context& ctx, GLuint name);
// The same for all that have ended.
void settle_probes(Context& ctx);
// A frame ends: reads what can be read without waiting.
void end_probes_frame(Context& ctx);

}  // namespace glext_emu
