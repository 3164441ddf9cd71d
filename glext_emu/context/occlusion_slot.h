// SPDX-License-Identifier: MIT
// The driver has one slot for occlusion queries; the program's query objects and the HP test's flag share it.
// The texts of NV_occlusion_query (4.1.6A) and ARB_occlusion_query ("Dependencies on HP_occlusion_test") know
// one counter, so the two never count apart: a program's query holds the slot while it is active, hidden
// segments of the HP test hold it otherwise, and the flag is the OR over the segments and over the program's
// queries since it was last read or reset.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "context/count_pipe.h"
#include "occlusion_unit/clock.h"

namespace glext_emu {

struct Context;
class WorkCounters;

// SAMPLES_PASSED, ANY_SAMPLES_PASSED or ANY_SAMPLES_PASSED_CONSERVATIVE: the targets that fill the slot.
bool is_occlusion_target(GLenum target);

// What the driver has counted in a query that has ended; waits for it. And whether it has: does not wait.
std::uint64_t driver_count(Context& ctx, GLuint query);
bool is_driver_ready(Context& ctx, GLuint query);
bool has_passed(Context& ctx, GLuint query);

// The driver's target for one of the program's. Where the text is followed, the two boolean targets are one,
// since GL 4.5, 4.2, lets an object of either be used with the other and Mesa does not.
GLenum real_target(const Context& ctx, GLenum target);

// A query object of the program that has ended, or is active, on an occlusion target. Its result is
// earlier + samples_per_count * (what the driver has counted).
struct QueryRecord {
    GLenum target = 0;      // as the program began or created it
    bool was_begun = true;  // false while it is only created
    bool has_ended = false;
    bool was_seen_available = false;  // a read does not wait any more
    bool has_drawn = false;           // since samples_per_count was set
    GLuint samples_per_count = 1;
    std::uint64_t earlier = 0;  // counted at another number of samples per count
    occlusion_unit::Tick due = 0;
    occlusion_unit::Tick begun = 0;  // of a timer query under the device's clock

    bool is_as_counted() const { return earlier == 0 && samples_per_count == 1; }
};

struct OcclusionSlot {
    // The program's queries.
    GLuint app_query = 0;  // active on app_target; 0: none
    GLenum app_target = 0;
    std::unordered_map<GLuint, QueryRecord> records;

    // Names that the program has deleted and the driver keeps, because the object is still in use.
    std::vector<GLuint> doomed;

    // The HP test: enable and flag.
    bool test_enabled = false;
    bool flag = false;           // TRUE already, whatever is unread
    GLuint ended_app_query = 0;  // ended since the last read or reset: counts towards the flag
    occlusion_unit::Tick flag_due = 0;

    // Hidden queries of the test; none of these names shows to the program.
    GLuint open_segment = 0;              // active now
    GLenum open_target = 0;               // of it
    std::vector<GLuint> unread_segments;  // ended, count towards the flag
    std::vector<GLuint> spare;            // free for reuse

    // The Occlusion Unit's, which count samples: an object of the driver's keeps the target of its first
    // begin.
    std::vector<GLuint> lent_counters;
    std::vector<GLuint> spare_counters;

    // The device time's, which count fragments and primitives.
    const WorkCounters* work_counters = nullptr;

    // What counts beside the flag while the program's queries do not: hidden segments, which go down a pipe.
    CountPipe* pipe = nullptr;  // null: nothing
    Counters counters = 0;      // of the pipe, that count now
    GLuint samples_per_fragment = 1;

    // True for a name that the driver knows and the program does not.
    bool is_hidden(GLuint name) const;
    bool is_doomed(GLuint name) const;
    // True while draws have to be watched for the number of samples that a count stands for.
    bool counts_samples() const { return app_query != 0 && app_target == GL_SAMPLES_PASSED; }
    // True when a draw has to open a segment first.
    bool wants_segment() const {
        return (test_enabled || counters != 0) && app_query == 0 && open_segment == 0;
    }
};

// A hidden query of SAMPLES_PASSED for the Occlusion Unit, and back.
GLuint take_counter(Context& ctx);
void give_back_counter(Context& ctx, GLuint query);

void open_segment(Context& ctx);
// Ends the open segment, if there is one; its count stays unread.
void close_segment(Context& ctx);
// The open segment, if there is one, goes on with another number of samples for a fragment.
void set_samples_per_fragment(Context& ctx, GLuint samples);
// True while a query, a pipe or the Occlusion Unit has the machine's one counter.
bool is_counter_taken(const Context& ctx);
// The flag's value; then it is FALSE. Waits for the driver, not for the clock.
bool take_flag(Context& ctx);
// Sets the flag to FALSE without reading it.
void reset_flag(Context& ctx);
// The program's query goes on with another number of samples for each of the driver's counts.
void set_samples_per_count(Context& ctx, GLuint samples);
// Inside this scope nothing is counted; what was counted before is kept.
class CountPause {
  public:
    explicit CountPause(Context& ctx);
    ~CountPause();
    CountPause(const CountPause&) = delete;
    CountPause& operator=(const CountPause&) = delete;

  private:
    Context& ctx_;
};
// True for the name of an object that the program may use.
bool is_object(Context& ctx, GLuint name);
// Deletes what is doomed and no longer in use.
void delete_doomed(Context& ctx);
// Gives up a hidden query's name that the program is about to use for a query of its own.
void yield_name(Context& ctx, GLuint name);

}  // namespace glext_emu
