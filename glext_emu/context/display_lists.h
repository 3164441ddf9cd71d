// SPDX-License-Identifier: MIT
// Display lists that hold emulated operations. The driver knows nothing of those, so such a list is split: a
// recipe of the driver's lists with our operations between them. Lists without one stay the driver's alone.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <atomic>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "occlusion_unit/clock.h"

namespace glext_emu {

struct Context;

// What a draw makes fragments of, and how. <kCollected>: of primitives, by a list of the driver's; it leaves
// its last vertex' attributes behind, as kPixels may leave the raster position elsewhere.
enum class DrawKind { kNothing, kPrimitives, kCollected, kPixels };

// No primitive that Begin takes.
inline constexpr GLenum kNoPrimitive = ~0u;

// An emulated command with its arguments, as it was compiled.
struct ListOperation {
    void (*run)(Context& ctx, const ListOperation& operation);
    GLuint first = 0;
    GLuint second = 0;
    std::vector<std::byte> bytes = {};
    bool calls_lists = false;  // and so may stand between Begin and End
};

struct ListStep {
    GLuint real_list = 0;  // 0: the operation
    ListOperation operation{};
    DrawKind draws = DrawKind::kNothing;  // the list is one draw, which can be repeated
    GLenum primitive = kNoPrimitive;      // the list is what stands between its Begin and End
};

struct ShareGroup;

// What a list of the program's is made of. Other threads may still be playing it when it is replaced, so the
// driver's lists are retired by whoever lets go of it last.
struct ListRecipe {
    ListRecipe(ShareGroup& its_group, GLuint its_name, std::vector<ListStep> its_steps)
        : group(its_group), name(its_name), steps(std::move(its_steps)) {}
    ~ListRecipe();
    ListRecipe(const ListRecipe&) = delete;
    ListRecipe& operator=(const ListRecipe&) = delete;

    ShareGroup& group;
    GLuint name;
    std::vector<ListStep> steps;
};

// What playing a list does to a Begin/End pair: most lists leave it as it is.
enum class BeginEnd { kUnchanged, kOpens, kCloses };

// A fence of the program's, and when what ended before it is due on the clock of the context that made it.
struct Fence {
    occlusion_unit::Tick due = 0;
    int maker = 0;  // Context::number
};

// What the contexts of a share group have in common.
struct ShareGroup {
    std::mutex mutex;
    std::map<GLsync, Fence> fences;                     // while a clock delays
    std::map<int, occlusion_unit::Tick> seen_complete;  // by other contexts than the maker, which is the key
    std::atomic<bool> has_seen_complete{false};
    std::map<GLuint, BeginEnd> begin_ends;   // of the driver's lists that change it
    std::atomic<bool> has_own_lists{false};  // there is, or was, something in the next five
    std::vector<GLuint> retired_lists;       // the driver's, of recipes that are gone
    std::map<GLuint, std::shared_ptr<const ListRecipe>> recipes;  // by the program's name
    std::set<GLuint> defined_lists;  // by the program's EndList, in contexts that record operations
    std::set<GLuint> hidden_lists;   // names of the driver's that the program never sees
    std::unordered_map<GLuint, std::int64_t> buffer_sizes;  // of vertices and indices, under a device's clock
    std::atomic<std::int64_t> buffer_bytes{0};              // of all of them
};

// The list that is being compiled.
struct ListRecording {
    GLuint name = 0;  // 0: none
    GLenum mode = 0;
    GLuint segment = 0;  // the driver's list that is open now
    std::vector<ListStep> steps;
    BeginEnd begin_end = BeginEnd::kUnchanged;  // what the open segment does so far
    bool was_list = false;                      // <name>, before it was compiled
    bool is_in_draw_step = false;               // between the Begin and End of a draw that stands alone
    bool is_suspended = false;  // our own work is under way: commands are executed, not compiled

    // <change> is compiled.
    void follow(BeginEnd change) {
        if (change == BeginEnd::kOpens) begin_end = BeginEnd::kOpens;
        if (change != BeginEnd::kCloses) return;
        begin_end = begin_end == BeginEnd::kOpens ? BeginEnd::kUnchanged : BeginEnd::kCloses;
    }
    // True for a list that was never defined: its first part has its name, and to the program it does not
    // exist.
    bool is_making(GLuint list) const {
        return list != 0 && list == name && (steps.empty() ? segment : steps.front().real_list) == name;
    }
    bool is_open() const { return name != 0 && !is_suspended; }
    // True while commands are compiled and not executed.
    bool only_compiles() const { return is_open() && mode == GL_COMPILE; }
};

}  // namespace glext_emu
