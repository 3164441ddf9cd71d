// SPDX-License-Identifier: MIT
// The program's draws in windows, whose fragments and triangles the driver counts together: those of one
// query, or those between two.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstdint>
#include <vector>

#include "context/fragment_sampler.h"
#include "context/work_counters.h"
#include "occlusion_unit/profile.h"

namespace glext_emu {

struct Context;

// Where a draw's vertices come from.
enum class VertexSource : std::uint8_t {
    kArrays,     // of the program's or of buffer objects: asked for
    kImmediate,  // between Begin and End
    kList,       // a display list, which lies in video memory
    kPixels,     // there are none
};

// A draw in a window.
struct DrawnBatch {
    std::uint64_t triangles = 0;
    bool is_known = true;
    bool is_copied = false;
    bool is_depth_only = false;   // writes no colour
    std::uint64_t fragments = 0;  // once the window's are known
};

// Draws whose fragments are counted together: those of one query, or those between two. Of all of them the
// calls tell the triangles, or of none.
struct WorkWindow {
    std::vector<DrawnBatch> batches;
    CountedWork counted = {};
    bool is_of_query = false;
    bool is_apart = false;  // of one draw, which is counted by itself
    bool is_depth_only = false;
    std::uint32_t samples = 1;
    std::uint64_t fragments = 0;  // of all batches, once they are known
    std::uint64_t triangles = 0;
};

// Triangles of a box: as many are part of a query's own costs, as a bounding volume's.
constexpr std::uint64_t kVolumeTriangles = 12;

// True while what is drawn is a query's.
bool draws_in_query(const Context& ctx);

class DrawWindows {
  public:
    DrawWindows(Context& ctx, const occlusion_unit::Profile& profile);
    // Once the driver can be asked what it has.
    void initialise(bool has_statistics);

    // A draw as it comes by; of one that is discarded only the driver knows.
    DrawnBatch batch_of(std::uint64_t triangles, bool is_known, VertexSource source);
    // True where the open window takes <batch> too.
    bool takes(const DrawnBatch& batch);
    // Opens a window with <batch>, and counts it unless it is <is_apart>.
    void open(const DrawnBatch& batch, bool is_of_query, bool is_apart);
    void add(const DrawnBatch& batch) { window_.batches.push_back(batch); }
    bool is_open() const { return is_open_; }
    WorkWindow close();
    // Around a draw that is apart.
    void count();
    void stop_counting();

    // Fills in what the driver has counted, for which it waits. Triangles that no call told are shared out
    // evenly, fragments by triangles.
    void take_counts(WorkWindow& window);

    void next_frame();
    // False while a list is compiled, and between Begin and End: queries are compiled, or errors.
    bool can_count() const;
    WorkCounters& counters() { return counters_; }

  private:
    bool needs_copy(VertexSource source) const;
    std::uint32_t samples();
    bool shares(const DrawnBatch& batch);

    Context& ctx_;
    const occlusion_unit::Profile& profile_;
    WorkCounters counters_;
    bool has_statistics_ = false;
    bool counts_fragments_ = false;
    FragmentSampler sampler_;
    FragmentAverage fragments_of_query_;     // a window of it
    FragmentAverage fragments_of_triangle_;  // outside queries

    static constexpr GLint kNoFramebuffer = -1;
    GLint sampled_framebuffer_ = kNoFramebuffer;  // the one that has samples_
    std::uint32_t samples_ = 1;
    static constexpr unsigned kMostSplits = 16;
    unsigned splits_left_ = kMostSplits;  // of the frame's windows, by the size of their draws

    bool is_open_ = false;
    WorkWindow window_;
};

}  // namespace glext_emu
