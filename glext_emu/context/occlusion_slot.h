// SPDX-License-Identifier: MIT
// The driver has one slot for occlusion queries; the program's query objects and the HP test's flag share it.
// The texts of NV_occlusion_query (4.1.6A) and ARB_occlusion_query ("Dependencies on HP_occlusion_test") know
// one counter, so the two never count apart: a program's query holds the slot while it is active, hidden
// segments of the HP test hold it otherwise, and the flag is the OR over the segments and over the program's
// queries since it was last read or reset.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <unordered_map>
#include <vector>

#include "occlusion_unit/clock.h"

namespace glext_emu {

struct Context;

// SAMPLES_PASSED, ANY_SAMPLES_PASSED or ANY_SAMPLES_PASSED_CONSERVATIVE: the targets that fill the slot.
bool is_occlusion_target(GLenum target);

// True where a sample passed in a query that has ended. Waits for the driver, and returns to client memory
// whatever query buffer is bound.
bool has_passed(Context& ctx, GLuint query);

// A query object of the program that has ended, or is active, on an occlusion target.
struct QueryRecord {
    GLenum target = 0;
    bool has_ended = false;
    bool was_seen_available = false;  // a read does not wait any more
    occlusion_unit::Tick due = 0;
};

struct OcclusionSlot {
    // The program's queries.
    GLuint app_query = 0;  // active on app_target; 0: none
    GLenum app_target = 0;
    std::unordered_map<GLuint, QueryRecord> records;

    // The HP test: enable and flag.
    bool test_enabled = false;
    bool flag = false;           // TRUE already, whatever is unread
    GLuint ended_app_query = 0;  // ended since the last read or reset: counts towards the flag
    occlusion_unit::Tick flag_due = 0;

    // Hidden queries of the test; none of these names shows to the program.
    GLuint open_segment = 0;              // active now
    std::vector<GLuint> unread_segments;  // ended, count towards the flag
    std::vector<GLuint> spare;            // free for reuse

    bool is_hidden(GLuint name) const;
    // True when a draw has to open a segment first.
    bool wants_segment() const { return test_enabled && app_query == 0 && open_segment == 0; }
};

void open_segment(Context& ctx);
// Ends the open segment, if there is one; its count stays unread.
void close_segment(Context& ctx);
// The flag's value; then it is FALSE. Waits for the driver, not for the clock.
bool take_flag(Context& ctx);
// Sets the flag to FALSE without reading it.
void reset_flag(Context& ctx);
// Gives up a hidden query's name that the program is about to use for a query of its own.
void yield_name(Context& ctx, GLuint name);

}  // namespace glext_emu
