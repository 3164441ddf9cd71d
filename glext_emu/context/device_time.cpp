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

// Commands and draws are kept until somebody asks for a time, but not more of them than this.
constexpr std::size_t kMostKept = 1 << 14;
constexpr std::size_t kMostQueryWindows = 1 << 14;
// Results that have come are remembered by name for a while, for the timeline's file.
constexpr std::size_t kMostResults = 1 << 12;

constexpr std::uint64_t kPicosecondsPerNanosecond = 1000;

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
      windows_(ctx, profile_) {
}

void DeviceTime::initialise(bool has_statistics) {
    windows_.initialise(has_statistics);
}

void DeviceTime::pause() {
    if (!windows_.is_open()) return;
    WorkWindow window = windows_.close();
    if (window.is_of_query && query_windows_.size() < kMostQueryWindows) {
        query_windows_.push_back(std::move(window));
    } else {
        keep_draws(std::move(window));
    }
}

void DeviceTime::keep_draws(WorkWindow window) {
    Command draws{.kind = Kind::kDraws};
    draws.windows.push_back(std::move(window));
    keep(std::move(draws));
}

void DeviceTime::keep(Command command) {
    if (kept_.size() >= kMostKept && windows_.can_count()) settle();
    kept_.push_back(std::move(command));
}

void DeviceTime::keep_unfinished_query() {
    if (query_windows_.empty()) return;
    keep({.kind = Kind::kUnfinishedQuery, .windows = std::exchange(query_windows_, {})});
}

void DeviceTime::begin_query() {
    pause();
    // Those of a query that was lost before its end.
    for (WorkWindow& window : query_windows_) keep_draws(std::move(window));
    query_windows_.clear();
}

void DeviceTime::draw(std::uint64_t triangles, bool is_known, VertexSource source) {
    const DrawnBatch batch = windows_.batch_of(triangles, is_known, source);
    if (windows_.takes(batch)) return windows_.add(batch);
    pause();
    windows_.open(batch, draws_in_query(ctx_), false);
}

void DeviceTime::draw_apart(std::uint64_t triangles, bool is_known, VertexSource source) {
    const DrawnBatch batch = windows_.batch_of(triangles, is_known, source);
    pause();
    windows_.open(batch, true, true);
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
    windows_.next_frame();
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

bool DeviceTime::poll_on_gpu(Tick ticket) {
    const bool has_come_to_cpu = poll(ticket);
    return has_come_to_cpu || timeline_.gpu() >= time_of(ticket).available;
}

bool DeviceTime::has_come(Tick ticket) {
    settle();
    return timeline_.has_come(time_of(ticket));
}

void DeviceTime::wait_for(Tick ticket) {
    if (ticket == 0) return;  // nothing has ended yet
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
    if (kept_.empty() && !windows_.is_open() && query_windows_.empty()) return;
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
            windows_.take_counts(command.windows.front());
            return execute_draws(command.windows.front());
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

void DeviceTime::execute_draws(const WorkWindow& window) {
    // Lists and pairs of Begin and End that turned out to hold nothing.
    const bool was_counted = window.counted != CountedWork{};
    if (was_counted && window.triangles == 0 && !window.batches.front().is_known) return;
    for (const DrawnBatch& batch : window.batches) {
        timeline_.draw({.triangles = batch.triangles,
                        .copied_triangles = batch.is_copied ? batch.triangles : 0,
                        .fragments = {batch.fragments, window.samples, window.is_depth_only}});
    }
}

// What is more than the bounding volumes of <shapes> is drawn for its own sake. Of what is not, the fragments
// are left: the rest is part of a query's own costs.
Fragments DeviceTime::execute_windows(std::vector<WorkWindow>& windows, std::uint64_t shapes) {
    std::uint64_t triangles = 0;
    for (WorkWindow& window : windows) {
        windows_.take_counts(window);
        triangles += window.triangles;
    }
    Fragments of_volumes{.is_depth_only = true};
    for (const WorkWindow& window : windows) {
        if (triangles > kVolumeTriangles * shapes) {
            execute_draws(window);
            continue;
        }
        of_volumes.count += window.fragments;
        of_volumes.samples = std::max(of_volumes.samples, window.samples);
        of_volumes.is_depth_only = of_volumes.is_depth_only && window.is_depth_only;
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
    windows_.counters().leave_to_program(target, is_programs);
}

DiscardScope::DiscardScope(Context& ctx)
    : ctx_(ctx), was_on_(ctx.real->glIsEnabled(GL_RASTERIZER_DISCARD) != GL_FALSE) {
    if (!was_on_) ctx_.real->glEnable(GL_RASTERIZER_DISCARD);
}

DiscardScope::~DiscardScope() {
    if (!was_on_) ctx_.real->glDisable(GL_RASTERIZER_DISCARD);
}

}  // namespace glext_emu
