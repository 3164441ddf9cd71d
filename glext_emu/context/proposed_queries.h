// SPDX-License-Identifier: MIT
// Query objects that the driver does not know, of the two proposed extensions. Their names are the driver's,
// from GenQueries; what they hold is here.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "occlusion_unit/clock.h"
#include "occlusion_unit/record.h"
#include "occlusion_unit/record_arithmetic.h"

namespace glext_emu {

struct Context;
class UnitRun;

// What the driver still works on for a query that has ended. Owns the driver's objects that it needs.
struct PendingRecords {
    virtual ~PendingRecords() = default;
    // True where drain would not wait.
    virtual bool is_ready(Context& ctx) = 0;
    // Waits, fills <records> (as many as the query has, registers set) and frees the driver's objects.
    virtual void drain(Context& ctx, std::vector<occlusion_unit::Record>& records) = 0;
    // Frees the driver's objects without waiting.
    virtual void drop(Context& ctx) = 0;
};

struct ProposedQuery {
    GLenum target = 0;  // DEPTH_REGION_EMU or OCCLUSION_UNIT_EMU
    bool has_ended = false;
    bool was_seen_available = false;  // a read does not wait any more
    occlusion_unit::Tick due = 0;
    std::uint32_t word = 0;                       // DEPTH_REGION_EMU: the result
    GLsizei record_count = 0;                     // OCCLUSION_UNIT_EMU
    GLbitfield armed = 0;                         // OCCLUSION_UNIT_EMU: registers
    std::vector<occlusion_unit::Record> records;  // OCCLUSION_UNIT_EMU, once drained
    std::unique_ptr<PendingRecords> pending;      // null once drained
};

struct ProposedQueries {
    ProposedQueries();
    ~ProposedQueries();

    std::unordered_map<GLuint, ProposedQuery> objects;
    std::unordered_set<GLuint> generated;  // names of GenQueries that are no object yet, of no target
    GLuint active_unit = 0;                // the object between BeginOcclusionUnitEMU and its End; 0: none
    std::unique_ptr<UnitRun> run;  // the unit's registers while they are stepped; null: draws are not watched
    bool counts_draws = false;     // a query of the program's may count primitives or invocations
    GLenum far_end = GL_ONE;
    std::uint64_t pixels_read = 0;  // by region queries

    bool is_object(GLuint name) const { return objects.contains(name); }
    occlusion_unit::FarEnd unit_far_end() const {
        return far_end == GL_ONE ? occlusion_unit::FarEnd::kOne : occlusion_unit::FarEnd::kZero;
    }
};

// True, with the error raised, where <id> cannot become (or be again) an object of <target>: it is 0, not
// from GenQueries, active, or an object of another target.
bool refuses_proposed_name(Context& ctx, GLuint id, GLenum target);
// The object <id>, new: whatever it held is dropped. Only after refuses_proposed_name.
ProposedQuery& renew_proposed_query(Context& ctx, GLuint id, GLenum target);
// Forgets <id>, if it is one; a unit's query that is active ends.
void delete_proposed_query(Context& ctx, GLuint id);
// Waits for what a query's registers hold.
void drain_records(Context& ctx, ProposedQuery& query);
// Reads all that the driver still counts, so that the layer holds no query of its.
void drain_all_records(Context& ctx);

}  // namespace glext_emu
