// SPDX-License-Identifier: MIT
// What holds on the timeline for any commands on any machine: clocks never fall, each lane is covered by its
// spans without a gap, sums are those of the spans, and an effect that was not called for changes nothing.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "span_recorder.h"

namespace occlusion_unit {
namespace {

// A command, and how much of it.
struct Command {
    enum Kind {
        kDraw,
        kCopiedDraw,
        kQuery,
        kRegions,
        kClear,
        kPoll,
        kWait,
        kWaitUntil,
        kCondition,
        kRead,
        kCopy,
        kStamp,
        kFinish,
        kSwap,
        kWork,
        kKinds
    };
    int kind = kDraw;
    std::uint64_t amount = 0;
    std::uint64_t fragments = 0;
    std::uint32_t samples = 1;
};

void showValue(const Command& command, std::ostream& os) {
    os << command.kind << ": " << command.amount << ", " << command.fragments << " x " << command.samples;
}

rc::Gen<std::vector<Command>> any_commands() {
    return rc::gen::container<std::vector<Command>>(rc::gen::map(
        rc::gen::tuple(rc::gen::inRange<int>(0, Command::kKinds), rc::gen::inRange<std::uint64_t>(0, 500),
                       rc::gen::inRange<std::uint64_t>(0, 500), rc::gen::element(1U, 1U, 1U, 4U)),
        [](const auto& drawn) {
            const auto& [kind, amount, fragments, samples] = drawn;
            return Command{kind, amount, fragments, samples};
        }));
}

Profile any_machine() {
    const auto span = [] { return *rc::gen::element<Picoseconds>(0, 1, 7, 40, 300); };
    const auto each = [] { return *rc::gen::element<Femtoseconds>(0, 1, 999, 1000, 3001); };
    Profile profile;
    for (const auto member :
         {&Profile::swap, &Profile::batch, &Profile::query, &Profile::read, &Profile::gpu_batch,
          &Profile::gpu_query, &Profile::result_latency, &Profile::fifo})
        profile.*member = span();
    for (const auto member :
         {&Profile::copied_triangle, &Profile::triangle, &Profile::fragment, &Profile::depth_fragment,
          &Profile::cleared_pixel, &Profile::swapped_pixel, &Profile::region_pixel, &Profile::read_pixel})
        profile.*member = each();
    profile.poll = 1;
    return profile;
}

void feed(Timeline& timeline, const Command& command, std::vector<ResultTime>& results) {
    const ResultTime last = results.empty() ? ResultTime{} : results.back();
    switch (command.kind) {
        case Command::kDraw:
            return timeline.draw(triangles(command.amount, command.fragments, command.samples));
        case Command::kCopiedDraw:
            return timeline.draw(copied(command.amount));
        case Command::kQuery:
            return results.push_back(timeline.query(volume(command.fragments, command.samples)));
        case Command::kRegions:
            return results.push_back(timeline.regions(command.amount % 5 + 1, command.fragments));
        case Command::kClear:
            return timeline.clear(command.amount, command.samples);
        case Command::kPoll:
            return timeline.poll(last.query);
        case Command::kWait:
            return timeline.wait(last);
        case Command::kWaitUntil:
            return timeline.wait_until(std::min(timeline.cpu() + 5, last.available), last.query);
        case Command::kCondition:
            return timeline.wait_on_gpu(last);
        case Command::kRead:
            return timeline.read(command.amount);
        case Command::kCopy:
            return timeline.copy(command.amount);
        case Command::kStamp:
            return results.push_back(timeline.stamp());
        case Command::kFinish:
            return timeline.finish();
        case Command::kSwap:
            timeline.swap(command.amount);
            return;
        default:
            return timeline.work(static_cast<Picoseconds>(command.amount));
    }
}

// The commands, and a swap after them; what was told, and the sums of all.
std::pair<SpanRecorder, TimeSums> run(const Profile& profile, Effects effects,
                                      const std::vector<Command>& commands) {
    std::pair<SpanRecorder, TimeSums> told;
    Timeline timeline(profile, effects, &told.first);
    std::vector<ResultTime> results;
    for (const Command& command : commands) feed(timeline, command, results);
    timeline.swap(0);
    told.second = timeline.total_sums();
    return told;
}

Effects any_effects() {
    return Effects(*rc::gen::inRange(0ULL, 1ULL << kEffectCount));
}

bool operator==(const Span& a, const Span& b) {
    return a.lane == b.lane && a.activity == b.activity && a.begin == b.begin && a.end == b.end &&
           a.query == b.query && a.queued == b.queued;
}

bool are_same(const SpanRecorder& a, const SpanRecorder& b) {
    return std::ranges::equal(a.spans, b.spans, [](const Span& x, const Span& y) { return x == y; });
}

RC_GTEST_PROP(TimelineOfAnyCommands, never_goes_back, ()) {
    Timeline timeline(any_machine(), any_effects());
    std::vector<ResultTime> results;
    for (const Command& command : *any_commands()) {
        const Picoseconds cpu = timeline.cpu();
        const Picoseconds gpu = timeline.gpu();
        feed(timeline, command, results);
        RC_ASSERT(timeline.cpu() >= cpu);
        RC_ASSERT(timeline.gpu() >= gpu);
    }
    for (const ResultTime& result : results) {
        RC_ASSERT(result.available >= result.done);
        timeline.wait(result);
        RC_ASSERT(timeline.has_come(result));
        RC_ASSERT(timeline.cpu() >= result.available);
    }
}

RC_GTEST_PROP(TimelineOfAnyCommands, leaves_no_gap_on_a_lane_and_no_overlap, ()) {
    // Where the GPU may work ahead, it does not say when it rests.
    const auto [told, sums] =
        run(any_machine(), any_effects().set(static_cast<std::size_t>(Effect::kStarvation)), *any_commands());
    for (const Lane lane : {Lane::kCpu, Lane::kGpu}) {
        Picoseconds end = 0;
        for (const Span& span : told.of(lane)) {
            RC_ASSERT(span.begin == end);
            RC_ASSERT(span.end > span.begin);
            RC_ASSERT(span.queued <= span.begin);
            end = span.end;
        }
        RC_ASSERT(end == sums.cpu);
    }
}

RC_GTEST_PROP(TimelineOfAnyCommands, sums_up_what_it_tells, ()) {
    const auto [told, sums] =
        run(any_machine(), any_effects().set(static_cast<std::size_t>(Effect::kStarvation)), *any_commands());
    const auto cpu = [&told = told](Activity activity) { return told.time_of(Lane::kCpu, activity); };
    const auto gpu = [&told = told](Activity activity) { return told.time_of(Lane::kGpu, activity); };
    RC_ASSERT(sums.stall == cpu(Activity::kStall));
    RC_ASSERT(sums.back_pressure == cpu(Activity::kBackPressure));
    RC_ASSERT(sums.drain == cpu(Activity::kDrain));
    RC_ASSERT(sums.starvation == gpu(Activity::kStarvation) + gpu(Activity::kCondition));
    RC_ASSERT(sums.gpu_busy + sums.starvation == sums.cpu);
    // A conditional draw's latency is the GPU's to wait for.
    RC_ASSERT(sums.latency <= sums.result_stall + sums.starvation && sums.result_stall <= sums.stall);
    RC_ASSERT(sums.read_cost + sums.fill <= sums.gpu_busy);
    Picoseconds end = 0;
    for (const SpanRecorder::Frame& frame : told.frames) {
        RC_ASSERT(frame.sums.cpu == frame.end - end);
        RC_ASSERT(frame.sums.gpu_busy + frame.sums.starvation == frame.sums.cpu);
        end = frame.end;
    }
}

RC_GTEST_PROP(TimelineOfAnyCommands, is_the_same_twice, ()) {
    const Profile profile = any_machine();
    const Effects effects = any_effects();
    const std::vector<Command> commands = *any_commands();
    RC_ASSERT(are_same(run(profile, effects, commands).first, run(profile, effects, commands).first));
}

// The predicates that effects are judged by.
RC_GTEST_PROP(TimelineOfAnyCommands, does_not_change_by_an_effect_that_was_not_called_for, ()) {
    const Profile profile = any_machine();
    const std::vector<Command> commands = *any_commands();
    const auto [told, sums] = run(profile, all_effects(), commands);
    const std::pair<Effect, bool> effects[] = {{Effect::kLatency, sums.results_asked != 0},
                                               {Effect::kBackPressure, sums.back_pressure != 0},
                                               {Effect::kFill, sums.fill != 0},
                                               {Effect::kDriverCopy, sums.copied_triangles != 0},
                                               {Effect::kMultisampling, sums.multisampled_fragments != 0},
                                               {Effect::kReadCost, sums.pixels_read != 0},
                                               {Effect::kStarvation, sums.starvation != 0},
                                               {Effect::kSaturation, false},
                                               {Effect::kDepthQuantisation, false}};
    for (const auto& [effect, is_called_for] : effects) {
        if (!is_called_for) RC_ASSERT(are_same(told, run(profile, without(effect), commands).first));
    }
}

}  // namespace
}  // namespace occlusion_unit
