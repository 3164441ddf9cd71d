// SPDX-License-Identifier: MIT
#include "context/draw_windows.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <utility>

#include "context/context.h"
#include "context/settings.h"

namespace glext_emu {
namespace {

// Draws of a window are kept until somebody asks for a time, but not more of them than this.
constexpr std::size_t kMostBatches = 1 << 14;

bool writes_color(const Context& ctx) {
    GLboolean mask[4] = {GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE};
    ctx.real->glGetBooleanv(GL_COLOR_WRITEMASK, mask);
    return std::ranges::find(mask, GL_TRUE) != std::end(mask);
}

// <whole> * <part> / <all>, exact.
std::uint64_t share(std::uint64_t whole, std::uint64_t part, std::uint64_t all) {
    __extension__ using Wide = unsigned __int128;
    return all == 0 ? 0 : static_cast<std::uint64_t>(Wide{whole} * part / all);
}

// Vertices that the program keeps in its own memory are copied at each draw.
bool reads_client_memory(const Context& ctx) {
    if (!ctx.kind.is_compatibility()) return false;
    GLint buffer = 0;
    if (ctx.real->glIsEnabled(GL_VERTEX_ARRAY) != GL_FALSE) {
        ctx.real->glGetIntegerv(GL_VERTEX_ARRAY_BUFFER_BINDING, &buffer);
        return buffer == 0;
    }
    GLint is_enabled = 0;
    ctx.real->glGetVertexAttribiv(0, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &is_enabled);
    if (is_enabled == 0) return false;
    ctx.real->glGetVertexAttribiv(0, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, &buffer);
    return buffer == 0;
}

}  // namespace

bool draws_in_query(const Context& ctx) {
    return ctx.slot.app_query != 0 || ctx.slot.open_segment != 0 || ctx.proposed.active_unit != 0;
}

DrawWindows::DrawWindows(Context& ctx, const occlusion_unit::Profile& profile)
    : ctx_(ctx), profile_(profile), sampler_(settings().counts_all_fragments) {
}

void DrawWindows::initialise(bool has_statistics) {
    has_statistics_ = has_statistics;
    const bool has_cost = profile_.fragment != 0 || profile_.depth_fragment != 0;
    const bool has_fill = settings().effects[static_cast<std::size_t>(occlusion_unit::Effect::kFill)];
    counts_fragments_ = has_statistics && has_cost && has_fill && !settings().is_dry;
}

bool DrawWindows::can_count() const {
    return !ctx_.recording.is_open() && !ctx_.inside_begin_end;
}

bool DrawWindows::needs_copy(VertexSource source) const {
    if (profile_.copied_triangle == 0 || source == VertexSource::kList || source == VertexSource::kPixels)
        return false;
    if (source == VertexSource::kImmediate || reads_client_memory(ctx_)) return true;
    return profile_.video_memory != 0 && ctx_.share_group->buffer_bytes > profile_.video_memory;
}

// Asked once of each framebuffer and frame: the driver validates its state before it answers.
std::uint32_t DrawWindows::samples() {
    GLint framebuffer = 0;
    ctx_.real->glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    if (framebuffer != sampled_framebuffer_) {
        GLint samples = 0;
        ctx_.real->glGetIntegerv(GL_SAMPLES, &samples);
        samples_ = samples > 1 ? static_cast<std::uint32_t>(samples) : 1;
        sampled_framebuffer_ = framebuffer;
    }
    return samples_;
}

DrawnBatch DrawWindows::batch_of(std::uint64_t triangles, bool is_known, VertexSource source) {
    is_known = is_known && !ctx_.conditional.is_in_driver;
    // A bounding volume's vertices are part of its query's costs, so nobody has to ask where they lie.
    const bool is_volume = is_known && triangles <= kVolumeTriangles && draws_in_query(ctx_);
    return {.triangles = triangles,
            .is_known = is_known,
            .is_copied = !is_volume && needs_copy(source),
            .is_depth_only = !writes_color(ctx_)};
}

bool DrawWindows::takes(const DrawnBatch& batch) {
    return is_open_ && !window_.is_apart && window_.batches.size() < kMostBatches &&
           batch.is_depth_only == window_.is_depth_only && draws_in_query(ctx_) == window_.is_of_query &&
           shares(batch);
}

// Draws of one window share its fragments by their triangles, so a few of two triangles are kept apart from
// many of hundreds; not as often as a mesh of mixed sizes would have it. Triangles that no call tells are
// shared evenly, so those that are copied are kept apart from those that are not.
bool DrawWindows::shares(const DrawnBatch& batch) {
    const DrawnBatch& other = window_.batches.front();
    if (batch.is_known != other.is_known) return false;
    if (!batch.is_known) return batch.is_copied == other.is_copied;
    constexpr int kFactorBits = 6;
    const auto size_of = [](std::uint64_t count) { return static_cast<int>(std::bit_width(count)); };
    if (std::abs(size_of(batch.triangles) - size_of(other.triangles)) < kFactorBits) return true;
    if (splits_left_ == 0) return true;
    --splits_left_;
    return false;
}

void DrawWindows::open(const DrawnBatch& batch, bool is_of_query, bool is_apart) {
    window_ = {};
    window_.is_of_query = is_of_query;
    window_.is_apart = is_apart;
    window_.is_depth_only = batch.is_depth_only;
    window_.samples = samples();
    window_.batches.push_back(batch);
    is_open_ = true;
    if (!is_apart) count();
}

WorkWindow DrawWindows::close() {
    stop_counting();
    is_open_ = false;
    return std::exchange(window_, {});
}

void DrawWindows::count() {
    const bool counts_triangles = !window_.batches.back().is_known;
    const bool counts_fragments = counts_fragments_ && sampler_.picks();
    if (!has_statistics_ || !can_count() || !(counts_fragments || counts_triangles)) return;
    counters_.begin(ctx_, counts_fragments, counts_triangles);
}

void DrawWindows::stop_counting() {
    if (counters_.is_open()) window_.counted = counters_.end(ctx_);
}

void DrawWindows::take_counts(WorkWindow& window) {
    const Work work = counters_.take(ctx_, window.counted);
    std::uint64_t untold = work.triangles;
    std::uint64_t batches_left = window.batches.size();
    for (DrawnBatch& batch : window.batches) {
        if (!batch.is_known) {
            batch.triangles = share(untold, 1, batches_left);
            untold -= batch.triangles;
        }
        --batches_left;
        window.triangles += batch.triangles;
    }
    if (!counts_fragments_) return;

    const std::uint64_t things = window.is_of_query ? 1 : window.triangles;
    FragmentAverage& average = window.is_of_query ? fragments_of_query_ : fragments_of_triangle_;
    const bool was_counted = window.counted.front() != 0;
    if (was_counted) average.add(work.fragments, things);
    window.fragments = was_counted ? work.fragments : average.of(things);
    std::uint64_t fragments_left = window.fragments;
    std::uint64_t triangles_left = window.triangles;
    batches_left = window.batches.size();
    for (DrawnBatch& batch : window.batches) {
        batch.fragments = triangles_left != 0 ? share(fragments_left, batch.triangles, triangles_left)
                                              : share(fragments_left, 1, batches_left);
        fragments_left -= batch.fragments;
        triangles_left -= batch.triangles;
        --batches_left;
    }
}

void DrawWindows::next_frame() {
    sampler_.next_frame();
    sampled_framebuffer_ = kNoFramebuffer;
    splits_left_ = kMostSplits;
}

}  // namespace glext_emu
