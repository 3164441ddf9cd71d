// SPDX-License-Identifier: MIT
#include "occlusion_unit/timeline.h"

#include <algorithm>

namespace occlusion_unit {

TimeSums& TimeSums::operator+=(const TimeSums& other) {
    cpu += other.cpu;
    gpu_busy += other.gpu_busy;
    stall += other.stall;
    result_stall += other.result_stall;
    back_pressure += other.back_pressure;
    starvation += other.starvation;
    drain += other.drain;
    fill += other.fill;
    multisampling += other.multisampling;
    driver_copy += other.driver_copy;
    read_cost += other.read_cost;
    latency += other.latency;
    results_asked += other.results_asked;
    copied_triangles += other.copied_triangles;
    pixels_read += other.pixels_read;
    multisampled_fragments += other.multisampled_fragments;
    return *this;
}

void Timeline::tell(const Span& span) {
    if (listener_ != nullptr && span.begin < span.end) listener_->span(span);
}

void Timeline::spend(Activity activity, Picoseconds span, std::uint64_t query, std::uint64_t triangles) {
    const Picoseconds begin = cpu_;
    cpu_ += span;
    tell({Lane::kCpu, activity, begin, cpu_, query, triangles});
}

void Timeline::stall_until(Picoseconds end, Activity activity, Picoseconds& sum, std::uint64_t query) {
    if (end <= cpu_) return;
    sum += end - cpu_;
    tell({Lane::kCpu, activity, cpu_, end, query});
    cpu_ = end;
}

void Timeline::make_room() {
    if (!has(Effect::kBackPressure) || profile_.fifo == 0) return;
    stall_until(gpu_ - profile_.fifo, Activity::kBackPressure, sums_.back_pressure);
}

void Timeline::execute(Activity activity, Picoseconds ready, Picoseconds span, Span about) {
    if (has(Effect::kStarvation) && gpu_ < ready) {
        sums_.starvation += ready - gpu_;
        tell({Lane::kGpu, Activity::kStarvation, gpu_, ready});
        gpu_ = ready;
    }
    about.lane = Lane::kGpu;
    about.activity = activity;
    about.queued = std::min(ready, gpu_);
    about.begin = gpu_;
    gpu_ += span;
    about.end = gpu_;
    sums_.gpu_busy += span;
    tell(about);
}

Picoseconds Timeline::fill_of(std::uint64_t count, std::uint32_t samples, Femtoseconds each) {
    if (!has(Effect::kFill)) return 0;
    const Picoseconds of_pixels = cost_of(count, each);
    if (samples <= 1) return of_pixels;
    sums_.multisampled_fragments += count;
    if (!has(Effect::kMultisampling)) return of_pixels;
    const Picoseconds of_samples = cost_of(count * samples, each);
    sums_.multisampling += of_samples - of_pixels;
    return of_samples;
}

Picoseconds Timeline::fill_of(const Fragments& fragments) {
    return fill_of(fragments.count, fragments.samples,
                   fragments.is_depth_only ? profile_.depth_fragment : profile_.fragment);
}

void Timeline::draw(const DrawWork& work) {
    make_room();
    // The first command is made before the GPU can see it; the others, and what is copied, follow while it
    // works.
    const Picoseconds ready = cpu_ + (work.batches != 0 ? profile_.batch : 0);
    Picoseconds copying = 0;
    sums_.copied_triangles += work.copied_triangles;
    if (has(Effect::kDriverCopy)) copying = cost_of(work.copied_triangles, profile_.copied_triangle);
    sums_.driver_copy += copying;
    spend(Activity::kDraw, static_cast<Picoseconds>(work.batches) * profile_.batch + copying, 0,
          work.triangles);

    const Picoseconds vertices = cost_of(work.triangles, profile_.triangle);
    const Picoseconds fill = fill_of(work.fragments);
    sums_.fill += std::max<Picoseconds>(0, fill - vertices);
    execute(Activity::kDraw, ready,
            static_cast<Picoseconds>(work.batches) * profile_.gpu_batch + std::max(vertices, fill),
            {.triangles = work.triangles, .fragments = work.fragments.count});
}

ResultTime Timeline::end_of(std::uint64_t query) {
    const Picoseconds latency = has(Effect::kLatency) ? profile_.result_latency : 0;
    const ResultTime result{query, gpu_, gpu_ + latency};
    if (listener_ != nullptr) listener_->result(query, result.done, result.available);
    return result;
}

ResultTime Timeline::query(const Fragments& volume, std::uint64_t shapes) {
    make_room();
    const std::uint64_t number = ++queries_;
    spend(Activity::kQuery, profile_.query, number);
    const Picoseconds fill = fill_of(volume);
    sums_.fill += fill;
    execute(Activity::kQuery, cpu_, static_cast<Picoseconds>(shapes) * profile_.gpu_query + fill,
            {.query = number, .fragments = volume.count});
    return end_of(number);
}

ResultTime Timeline::regions(std::uint64_t count, std::uint64_t pixels) {
    make_room();
    const std::uint64_t number = ++queries_;
    spend(Activity::kRegion, profile_.query, number);
    const Picoseconds reading = has(Effect::kReadCost) ? cost_of(pixels, profile_.region_pixel) : 0;
    sums_.read_cost += reading;
    sums_.pixels_read += pixels;
    execute(Activity::kRegion, cpu_, static_cast<Picoseconds>(count) * profile_.gpu_query + reading,
            {.query = number, .fragments = pixels});
    return end_of(number);
}

void Timeline::clear(std::uint64_t pixels, std::uint32_t samples) {
    make_room();
    const Picoseconds fill = fill_of(pixels, samples, profile_.cleared_pixel);
    sums_.fill += fill;
    execute(Activity::kClear, cpu_, fill, {.fragments = pixels});
}

void Timeline::poll(std::uint64_t query) {
    ++sums_.results_asked;
    spend(Activity::kPoll, profile_.poll, query);
}

void Timeline::wait(const ResultTime& result) {
    ++sums_.results_asked;
    const Picoseconds before = cpu_;
    stall_until(result.available, Activity::kStall, sums_.stall, result.query);
    sums_.result_stall += cpu_ - before;
    sums_.latency += cpu_ - std::clamp(result.done, before, cpu_);
    if (listener_ != nullptr && result.query != 0) listener_->fetched(result.query, cpu_);
}

void Timeline::wait_until(Picoseconds end, std::uint64_t query) {
    ++sums_.results_asked;
    const Picoseconds before = cpu_;
    stall_until(end, Activity::kStall, sums_.stall, query);
    sums_.result_stall += cpu_ - before;
}

void Timeline::wait_on_gpu(const ResultTime& result) {
    ++sums_.results_asked;
    if (result.available <= gpu_) return;
    sums_.latency += result.available - std::clamp(result.done, gpu_, result.available);
    sums_.starvation += result.available - gpu_;
    tell({Lane::kGpu, Activity::kCondition, gpu_, result.available, result.query});
    gpu_ = result.available;
}

void Timeline::read(std::uint64_t pixels) {
    stall_until(gpu_, Activity::kStall, sums_.stall);
    const Picoseconds reading = has(Effect::kReadCost) ? cost_of(pixels, profile_.read_pixel) : 0;
    sums_.read_cost += reading;
    sums_.pixels_read += pixels;
    const Picoseconds ready = cpu_;
    spend(Activity::kRead, profile_.read + reading);
    execute(Activity::kRead, ready, reading, {.fragments = pixels});
}

void Timeline::copy(std::uint64_t pixels) {
    make_room();
    const Picoseconds reading = has(Effect::kReadCost) ? cost_of(pixels, profile_.read_pixel) : 0;
    sums_.read_cost += reading;
    sums_.pixels_read += pixels;
    spend(Activity::kRead, profile_.read);
    execute(Activity::kRead, cpu_, reading, {.fragments = pixels});
}

ResultTime Timeline::stamp() {
    make_room();
    execute(Activity::kQuery, cpu_, 0, {});
    const Picoseconds latency = has(Effect::kLatency) ? profile_.result_latency : 0;
    return {0, gpu_, gpu_ + latency};
}

void Timeline::finish() {
    stall_until(gpu_, Activity::kDrain, sums_.drain);
}

TimeSums Timeline::swap(std::uint64_t pixels) {
    make_room();
    spend(Activity::kSwap, profile_.swap);
    const Picoseconds copying = has(Effect::kFill) ? cost_of(pixels, profile_.swapped_pixel) : 0;
    sums_.fill += copying;
    execute(Activity::kSwap, cpu_, copying, {.fragments = pixels});
    finish();
    // What is left of the frame on the GPU is nothing: both clocks stand at its end.
    gpu_ = std::max(gpu_, cpu_);
    const TimeSums frame = frame_sums();
    if (listener_ != nullptr) listener_->frame(frame_index_, cpu_, frame);
    total_ += frame;
    sums_ = {};
    frame_begin_ = cpu_;
    ++frame_index_;
    return frame;
}

void Timeline::work(Picoseconds span) {
    spend(Activity::kProgram, span);
}

TimeSums Timeline::frame_sums() const {
    TimeSums sums = sums_;
    sums.cpu = cpu_ - frame_begin_;
    return sums;
}

TimeSums Timeline::total_sums() const {
    TimeSums sums = total_;
    sums += frame_sums();
    return sums;
}

}  // namespace occlusion_unit
