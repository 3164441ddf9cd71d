// SPDX-License-Identifier: MIT
#include "context/device_time.h"

#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "context/context.h"
#include "context/list_pause.h"
#include "context/settings.h"
#include "context/timeline_file.h"

namespace glext_emu {
namespace {

using occlusion_unit::Effect;
using occlusion_unit::Fragments;
using occlusion_unit::Picoseconds;
using occlusion_unit::ResultTime;

// Triangles of a box: as many are part of a query's own costs, as a bounding volume's.
constexpr std::uint64_t kVolumeTriangles = 12;
// Commands and draws are kept until somebody asks for a time, but not more of them than this.
constexpr std::size_t kMostKept = 1 << 14;
constexpr std::size_t kMostBatches = 1 << 14;
// Results that have come are remembered by name for a while, for the timeline's file.
constexpr std::size_t kMostResults = 1 << 12;

constexpr std::uint64_t kPicosecondsPerNanosecond = 1000;

bool has(Effect effect) {
    return settings().effects[static_cast<std::size_t>(effect)];
}

// <whole> * <part> / <all>, exact.
std::uint64_t share(std::uint64_t whole, std::uint64_t part, std::uint64_t all) {
    __extension__ using Wide = unsigned __int128;
    return all == 0 ? 0 : static_cast<std::uint64_t>(Wide{whole} * part / all);
}

bool writes_color(const Context& ctx) {
    GLboolean mask[4] = {GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE};
    ctx.real->glGetBooleanv(GL_COLOR_WRITEMASK, mask);
    return std::ranges::find(mask, GL_TRUE) != std::end(mask);
}

bool draws_in_query(const Context& ctx) {
    return ctx.slot.app_query != 0 || ctx.slot.open_segment != 0 || ctx.proposed.active_unit != 0;
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

void need_pixels(const char* command) {
    if (!settings().is_dry) return;
    std::fprintf(stderr,
                 "glext_emu: --dry rasterises nothing, and this program asks by %s for what was; run it "
                 "without.\n",
                 command);
    _exit(2);
}

DeviceTime::DeviceTime(Context& ctx)
    : ctx_(ctx),
      profile_(settings().device.time->profile),
      file_(open_timeline_file(ctx)),
      timeline_(profile_, settings().effects, file_.get()),
      sampler_(settings().counts_all_fragments) {
}

void DeviceTime::initialise(bool has_statistics) {
    has_statistics_ = has_statistics;
    const bool has_cost = profile_.fragment != 0 || profile_.depth_fragment != 0;
    counts_fragments_ = has_statistics && has_cost && has(Effect::kFill) && !settings().is_dry;
}

// Asked once of each framebuffer and frame: the driver validates its state before it answers.
std::uint32_t DeviceTime::samples() {
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

// Queries are compiled into lists, and are errors between Begin and End.
bool DeviceTime::can_count() const {
    return !ctx_.recording.is_open() && !ctx_.inside_begin_end;
}

bool DeviceTime::needs_copy(VertexSource source) {
    if (profile_.copied_triangle == 0 || source == VertexSource::kList || source == VertexSource::kPixels)
        return false;
    if (source == VertexSource::kImmediate || reads_client_memory(ctx_)) return true;
    return profile_.video_memory != 0 && ctx_.share_group->buffer_bytes > profile_.video_memory;
}

void DeviceTime::open_window(bool is_of_query, bool is_depth_only) {
    window_ = {};
    window_.is_of_query = is_of_query;
    window_.is_depth_only = is_depth_only;
    window_.samples = samples();
    is_window_open_ = true;
}

void DeviceTime::count() {
    const bool counts_triangles = !window_.batches.empty() && !window_.batches.back().is_known;
    const bool counts_fragments = counts_fragments_ && sampler_.picks();
    if (!has_statistics_ || !can_count() || !(counts_fragments || counts_triangles)) return;
    counters_.begin(ctx_, counts_fragments, counts_triangles);
}

void DeviceTime::stop_counting() {
    if (!counters_.is_open()) return;
    window_.counted = counters_.end(ctx_);
}

void DeviceTime::pause() {
    if (!is_window_open_) return;
    is_window_open_ = false;
    stop_counting();
    if (window_.is_of_query && query_windows_.size() < kMostBatches) {
        query_windows_.push_back(std::exchange(window_, {}));
    } else {
        Command draws{.kind = Kind::kDraws};
        draws.windows.push_back(std::exchange(window_, {}));
        keep(std::move(draws));
    }
}

void DeviceTime::keep(Command command) {
    if (kept_.size() >= kMostKept && can_count()) settle();
    kept_.push_back(std::move(command));
}

void DeviceTime::keep_unfinished_query() {
    if (query_windows_.empty()) return;
    keep({.kind = Kind::kUnfinishedQuery, .windows = std::exchange(query_windows_, {})});
}

void DeviceTime::begin_query() {
    pause();
    // Those of a query that was lost before its end.
    for (WorkWindow& window : query_windows_) {
        Command draws{.kind = Kind::kDraws};
        draws.windows.push_back(std::move(window));
        keep(std::move(draws));
    }
    query_windows_.clear();
}

// Draws of one window share its fragments by their triangles, so a few of two triangles are kept apart from
// many of hundreds; not as often as a mesh of mixed sizes would have it. Triangles that no call tells are
// shared evenly, so those that are copied are kept apart from those that are not.
bool DeviceTime::shares(const DrawnBatch& batch) {
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

void DeviceTime::draw(std::uint64_t triangles, bool is_known, VertexSource source) {
    // What is discarded is not drawn, and only the driver knows.
    if (ctx_.conditional.is_in_driver) is_known = false;
    const bool is_depth_only = !writes_color(ctx_);
    const DrawnBatch batch{triangles, is_known, needs_copy(source)};
    const bool goes_on = is_window_open_ && !window_.is_apart && window_.batches.size() < kMostBatches &&
                         is_depth_only == window_.is_depth_only &&
                         draws_in_query(ctx_) == window_.is_of_query && shares(batch);
    if (!goes_on) {
        pause();
        open_window(draws_in_query(ctx_), is_depth_only);
    }
    window_.batches.push_back(batch);
    if (!goes_on) count();
}

void DeviceTime::draw_apart(std::uint64_t triangles, bool is_known, VertexSource source) {
    pause();
    open_window(true, !writes_color(ctx_));
    window_.is_apart = true;
    window_.batches.push_back({triangles, is_known, needs_copy(source)});
}

void DeviceTime::clear(std::uint64_t pixels, std::uint32_t samples) {
    pause();
    keep({.kind = Kind::kClear, .count = samples, .amount = pixels});
}

void DeviceTime::read_back(std::uint64_t pixels) {
    settle();
    timeline_.read(pixels);
}

void DeviceTime::copy_to_buffer(std::uint64_t pixels) {
    pause();
    keep({.kind = Kind::kCopy, .amount = pixels});
}

void DeviceTime::ask_about_shapes(std::uint64_t count) {
    shapes_ = count;
}

void DeviceTime::ask_about_regions(std::uint64_t count, std::uint64_t pixels) {
    regions_ = count;
    region_pixels_ = pixels;
}

void DeviceTime::wait_on_gpu(Tick ticket) {
    pause();
    keep({.kind = Kind::kCondition, .amount = ticket});
}

void DeviceTime::work(std::uint64_t nanoseconds) {
    pause();
    keep({.kind = Kind::kWork, .amount = nanoseconds});
}

void DeviceTime::finish() {
    settle();
    timeline_.finish();
}

void DeviceTime::swap(std::uint64_t pixels) {
    settle();
    last_frame_ = timeline_.swap(pixels);
    sampled_framebuffer_ = kNoFramebuffer;
    splits_left_ = kMostSplits;
    sampler_.next_frame();
}

DeviceTime::Tick DeviceTime::stamp() {
    pause();
    keep_unfinished_query();
    keep({.kind = Kind::kStamp, .amount = last_ticket_ + 1});
    return ++last_ticket_;
}

DeviceTime::Tick DeviceTime::mark() {
    pause();
    keep({.kind = Kind::kStamp});
    return ++last_ticket_;
}

std::uint64_t DeviceTime::stamped_ns(Tick ticket) {
    settle();
    const auto found = stamps_.find(ticket);
    return found == stamps_.end() ? 0 : static_cast<std::uint64_t>(found->second) / kPicosecondsPerNanosecond;
}

std::uint64_t DeviceTime::now_ns() {
    settle();
    return static_cast<std::uint64_t>(timeline_.cpu()) / kPicosecondsPerNanosecond;
}

DeviceTime::Tick DeviceTime::end_query() {
    pause();
    if (regions_ != 0) {
        keep({.kind = Kind::kRegions,
              .count = std::exchange(regions_, 0),
              .amount = std::exchange(region_pixels_, 0)});
    } else {
        keep({.kind = Kind::kQuery,
              .count = std::exchange(shapes_, 1),
              .windows = std::exchange(query_windows_, {})});
    }
    return ++last_ticket_;
}

bool DeviceTime::poll(Tick ticket) {
    settle();
    timeline_.poll(time_of(ticket).query);
    return has_come(ticket);
}

bool DeviceTime::has_come(Tick ticket) {
    settle();
    return timeline_.has_come(time_of(ticket));
}

void DeviceTime::wait_for(Tick ticket) {
    settle();
    timeline_.wait(time_of(ticket));
}

bool DeviceTime::wait_for(Tick ticket, std::uint64_t most_ns) {
    settle();
    const ResultTime result = time_of(ticket);
    // Times are far below 2^62, so the sum does not overflow.
    constexpr std::uint64_t kLongest = std::uint64_t{1} << 52;
    const auto most = static_cast<Picoseconds>(std::min(most_ns, kLongest) * kPicosecondsPerNanosecond);
    const Picoseconds end = timeline_.cpu() + most;
    if (result.available > end) {
        timeline_.wait_until(end, result.query);
        return false;
    }
    timeline_.wait(result);
    return true;
}

void DeviceTime::settle() {
    if (kept_.empty() && !is_window_open_ && query_windows_.empty()) return;
    if (ctx_.is_between_begin_and_end()) return;
    const ListPause pause_of_list(ctx_);
    pause();
    keep_unfinished_query();
    std::vector<Command> commands = std::exchange(kept_, {});
    for (Command& command : commands) execute(command);
    // The room is used again.
    commands.clear();
    if (kept_.empty()) kept_ = std::move(commands);
    drop_seen();
}

void DeviceTime::execute(Command& command) {
    switch (command.kind) {
        case Kind::kDraws:
            return execute_draws(command.windows.front(), take_counts(command.windows.front()));
        case Kind::kQuery:
            return execute_query(command.windows, command.count);
        case Kind::kUnfinishedQuery:
            return execute_unfinished_query(command.windows);
        case Kind::kRegions:
            results_.push_back(timeline_.regions(command.count, command.amount));
            return;
        case Kind::kClear:
            return timeline_.clear(command.amount, static_cast<std::uint32_t>(command.count));
        case Kind::kCopy:
            return timeline_.copy(command.amount);
        case Kind::kCondition:
            return timeline_.wait_on_gpu(time_of(command.amount));
        case Kind::kWork:
            return timeline_.work(static_cast<Picoseconds>(std::min(command.amount, std::uint64_t{1} << 50) *
                                                           kPicosecondsPerNanosecond));
        case Kind::kStamp: {
            const ResultTime stamp = timeline_.stamp();
            if (command.amount != 0) stamps_[command.amount] = stamp.done;
            results_.push_back(stamp);
            return;
        }
    }
}

DeviceTime::Counted DeviceTime::take_counts(WorkWindow& window) {
    Counted counted;
    std::uint64_t untold = 0;
    if (window.counted != CountedWork{}) {
        const OwnCalls own(ctx_);
        const Work work = counters_.take(ctx_, window.counted);
        counted.fragments = work.fragments;
        untold = work.triangles;
    }
    std::uint64_t batches_left = window.batches.size();
    for (DrawnBatch& batch : window.batches) {
        if (!batch.is_known) {
            batch.triangles = share(untold, 1, batches_left);
            untold -= batch.triangles;
        }
        --batches_left;
        counted.triangles += batch.triangles;
        if (batch.is_copied) counted.copied_triangles += batch.triangles;
    }
    if (!counts_fragments_) return counted;
    const std::uint64_t things = window.is_of_query ? 1 : counted.triangles;
    FragmentAverage& average = window.is_of_query ? fragments_of_query_ : fragments_of_triangle_;
    if (window.counted.front() != 0) {
        average.add(counted.fragments, things);
    } else {
        counted.fragments = average.of(things);
    }
    return counted;
}

// Fragments are shared out by triangles: the driver counts them together.
void DeviceTime::execute_draws(const WorkWindow& window, const Counted& counted) {
    // Lists and pairs of Begin and End that turned out to hold nothing.
    const bool was_counted = window.counted != CountedWork{};
    if (was_counted && counted.triangles == 0 && !window.batches.front().is_known) return;
    std::uint64_t fragments_left = counted.fragments;
    std::uint64_t triangles_left = counted.triangles;
    std::uint64_t batches_left = window.batches.size();
    for (const DrawnBatch& batch : window.batches) {
        const std::uint64_t fragments = triangles_left != 0
                                            ? share(fragments_left, batch.triangles, triangles_left)
                                            : share(fragments_left, 1, batches_left);
        fragments_left -= fragments;
        triangles_left -= batch.triangles;
        --batches_left;
        timeline_.draw({.triangles = batch.triangles,
                        .copied_triangles = batch.is_copied ? batch.triangles : 0,
                        .fragments = {fragments, window.samples, window.is_depth_only}});
    }
}

// What is more than the bounding volumes of <shapes> is drawn for its own sake. Of what is not, the fragments
// are left: the rest is part of a query's own costs.
Fragments DeviceTime::execute_windows(std::vector<WorkWindow>& windows, std::uint64_t shapes) {
    std::vector<Counted> counts;
    std::uint64_t triangles = 0;
    for (WorkWindow& window : windows) {
        counts.push_back(take_counts(window));
        triangles += counts.back().triangles;
    }
    Fragments of_volumes{.is_depth_only = true};
    for (std::size_t i = 0; i < windows.size(); ++i) {
        if (triangles > kVolumeTriangles * shapes) {
            execute_draws(windows[i], counts[i]);
            continue;
        }
        of_volumes.count += counts[i].fragments;
        of_volumes.samples = std::max(of_volumes.samples, windows[i].samples);
        of_volumes.is_depth_only = of_volumes.is_depth_only && windows[i].is_depth_only;
    }
    return of_volumes;
}

void DeviceTime::execute_unfinished_query(std::vector<WorkWindow>& windows) {
    const Fragments of_volume = execute_windows(windows, 1);
    if (of_volume.count != 0) timeline_.draw({.batches = 0, .fragments = of_volume});
}

void DeviceTime::execute_query(std::vector<WorkWindow>& windows, std::uint64_t shapes) {
    const Fragments of_volumes = execute_windows(windows, shapes);
    results_.push_back(timeline_.query(of_volumes, shapes));
}

ResultTime DeviceTime::time_of(Tick ticket) const {
    if (ticket < first_result_) return {};  // seen long ago
    const Tick at = ticket - first_result_;
    // Not worked off yet, which only happens between Begin and End.
    if (at >= results_.size()) return {.query = 0, .done = INT64_MAX, .available = INT64_MAX};
    return results_[at];
}

void DeviceTime::drop_seen() {
    while (results_.size() > kMostResults && timeline_.has_come(results_.front())) {
        results_.pop_front();
        ++first_result_;
    }
}

void DeviceTime::leave_to_program(GLenum target, bool is_programs) {
    pause();
    counters_.leave_to_program(target, is_programs);
}

DiscardScope::DiscardScope(Context& ctx)
    : ctx_(ctx), was_on_(ctx.real->glIsEnabled(GL_RASTERIZER_DISCARD) != GL_FALSE) {
    if (!was_on_) ctx_.real->glEnable(GL_RASTERIZER_DISCARD);
}

DiscardScope::~DiscardScope() {
    if (!was_on_) ctx_.real->glDisable(GL_RASTERIZER_DISCARD);
}

}  // namespace glext_emu
