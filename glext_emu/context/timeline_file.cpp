// SPDX-License-Identifier: MIT
#include "context/timeline_file.h"

#include <errno.h>
#include <unistd.h>

#include <algorithm>
#include <string_view>

#include "context/context.h"
#include "context/trace_event.h"

namespace glext_emu {
namespace {

using occlusion_unit::Activity;
using occlusion_unit::Picoseconds;
using occlusion_unit::Span;
using occlusion_unit::TimeSums;

// So many queries may be under way; an older one's arrow has no end.
constexpr std::size_t kMostFlows = 1 << 14;
constexpr std::int64_t kPicosecondsPerNanosecond = 1000;

struct Look {
    std::string_view name;
    std::string_view colour;  // of those that viewers know; empty: theirs
};

Look look_of(Activity activity) {
    switch (activity) {
        case Activity::kDraw:
            return {"draw", ""};
        case Activity::kQuery:
            return {"query", ""};
        case Activity::kClear:
            return {"clear", ""};
        case Activity::kRead:
            return {"read", ""};
        case Activity::kRegion:
            return {"region", ""};
        case Activity::kSwap:
            return {"swap", ""};
        case Activity::kPoll:
            return {"poll", ""};
        case Activity::kProgram:
            return {"program", ""};
        case Activity::kStall:
            return {"stall", "terrible"};
        case Activity::kBackPressure:
            return {"back-pressure", "bad"};
        case Activity::kDrain:
            return {"drain", "thread_state_iowait"};
        case Activity::kStarvation:
            return {"starvation", "yellow"};
        case Activity::kCondition:
            return {"condition", "olive"};
    }
    return {};
}

std::int64_t nanoseconds(Picoseconds time) {
    return time / kPicosecondsPerNanosecond;
}

// Those that are open; never freed, since programs call GL from their own destructors.
struct Timelines {
    std::mutex mutex;
    std::vector<TimelineFile*> all;
};

Timelines& timelines() {
    static Timelines* const made = new Timelines;
    return *made;
}

}  // namespace

TimelineFile::TimelineFile(SharedJsonFile& file, std::uint64_t context, FrameRange frames, std::string device)
    : file_(file),
      context_(context),
      frames_(frames),
      device_(std::move(device)),
      is_wanted_(frames.first == 0),
      generation_(file.generation()),
      pid_(static_cast<std::uint64_t>(getpid())),
      flows_(kMostFlows) {
    const std::lock_guard lock(timelines().mutex);
    timelines().all.push_back(this);
}

TimelineFile::~TimelineFile() {
    end();
    const std::lock_guard lock(timelines().mutex);
    std::erase(timelines().all, this);
}

// A child goes on with its parent's context, but with none of its queries, nor with its half of a frame.
void TimelineFile::begin_process() {
    generation_ = file_.generation();
    pid_ = static_cast<std::uint64_t>(getpid());
    has_names_ = false;
    has_cpu_draw_ = false;
    is_frame_whole_ = is_frame_whole_ && cpu_ == frame_begin_;
    frame_begin_ = cpu_;
    std::ranges::fill(flows_, OpenFlow{});
}

void TimelineFile::span(const Span& span) {
    if (!is_wanted_) return;
    const std::lock_guard lock(mutex_);
    if (generation_ != file_.generation()) begin_process();
    if (span.lane == occlusion_unit::Lane::kCpu) {
        cpu_span(span);
    } else {
        gpu_span(span);
    }
    write();
}

void TimelineFile::cpu_span(const Span& span) {
    cpu_ = span.end;
    if (span.activity == Activity::kDraw) {
        ++draws_;
        has_cpu_draw_ = true;
    }
    add_slice(kCpu, span);
    if (span.activity == Activity::kQuery || span.activity == Activity::kRegion) {
        flows_[span.query % kMostFlows] = {.query = span.query, .begin = span.begin};
        return add_flow('s', kCpu, nanoseconds(span.begin), span.query);
    }
    OpenFlow* const flow = find_flow(span.query);
    const bool asks = span.activity == Activity::kStall || span.activity == Activity::kPoll;
    if (flow == nullptr || !asks || span.end < flow->available) return;
    // In the slice's last nanosecond, since its end is the beginning of the next.
    add_flow('f', kCpu, std::max(nanoseconds(span.begin), nanoseconds(span.end) - 1), span.query);
    *flow = {};
}

void TimelineFile::gpu_span(const Span& span) {
    const bool is_work = span.activity != Activity::kStarvation && span.activity != Activity::kCondition;
    if (span.activity == Activity::kDraw) {
        if (!has_cpu_draw_) ++draws_;
        has_cpu_draw_ = false;
    }
    if (is_work) add_wait_in_fifo(span);
    add_fifo_level(is_work ? span.queued : span.begin, is_work ? span.end - span.queued : 0);
    add_slice(kGpu, span);
    add_step(span);
}

// Where starvation is switched off, work may be done before its command, and no arrow goes back in time.
void TimelineFile::add_step(const Span& span) {
    const OpenFlow* const flow = find_flow(span.query);
    if (flow != nullptr && span.begin >= flow->begin)
        add_flow('t', kGpu, nanoseconds(span.begin), span.query);
}

void TimelineFile::result(std::uint64_t query, Picoseconds, Picoseconds available) {
    if (!is_wanted_) return;
    const std::lock_guard lock(mutex_);
    OpenFlow* const flow = find_flow(query);
    if (flow == nullptr) return;
    flow->available = available;
    TraceEvent(text_, 'i', pid_, thread_of(kCpu), "query", "result", query)
        .at(nanoseconds(available))
        .field("s", "t")
        .argument("query", query);
    write();
}

// By a stall or a poll, which has come by, or without.
void TimelineFile::fetched(std::uint64_t query, Picoseconds time) {
    if (!is_wanted_) return;
    const std::lock_guard lock(mutex_);
    if (generation_ != file_.generation()) begin_process();
    OpenFlow* const flow = find_flow(query);
    if (flow == nullptr) return;
    add_flow('f', kCpu, nanoseconds(time), query, false);
    *flow = {};
    write();
}

void TimelineFile::frame(std::uint64_t index, Picoseconds end, const TimeSums& sums) {
    const std::lock_guard lock(mutex_);
    if (generation_ != file_.generation()) begin_process();
    if (is_wanted_) {
        add_fifo_level(end, 0);
        add_frame(end, &sums);
        write();
    }
    frame_begin_ = end;
    cpu_ = end;
    frame_index_ = index + 1;
    is_frame_whole_ = true;
    draws_ = 0;
    is_wanted_ = file_.is_wanted() && frame_index_ >= frames_.first && frame_index_ <= frames_.last;
}

void TimelineFile::end() {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock.owns_lock()) return;
    if (is_wanted_ && generation_ == file_.generation() && cpu_ > frame_begin_) {
        add_frame(cpu_, nullptr);
        write();
    }
    is_wanted_ = false;
    if (file_.is_idle()) file_.flush();
}

TimelineFile::OpenFlow* TimelineFile::find_flow(std::uint64_t query) {
    OpenFlow& flow = flows_[query % kMostFlows];
    return query != 0 && flow.query == query ? &flow : nullptr;
}

std::uint64_t TimelineFile::thread_of(Lane lane) const {
    return context_ * kLanes + lane;
}

// Its like is nowhere in the file, as long as a context has less than 2^32 of them.
std::uint64_t TimelineFile::id_of(std::uint64_t number) const {
    return pid_ << 42 | (context_ & 0x3ff) << 32 | (number & 0xffff'ffff);
}

void TimelineFile::add_names() {
    constexpr std::string_view kLaneNames[kLanes] = {"frames", "CPU", "FIFO", "GPU"};
    const std::string context = "context " + std::to_string(context_) + ": ";
    TraceEvent(text_, 'M', pid_, 0, "", "process_name")
        .json("name", json_string(program_invocation_short_name));
    TraceEvent(text_, 'M', pid_, 0, "", "process_labels").json("labels", json_string(device_.c_str()));
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const std::uint64_t thread = thread_of(static_cast<Lane>(lane));
        TraceEvent(text_, 'M', pid_, thread, "", "thread_name")
            .json("name", json_string((context + std::string(kLaneNames[lane])).c_str()));
        TraceEvent(text_, 'M', pid_, thread, "", "thread_sort_index").argument("sort_index", thread);
    }
}

void TimelineFile::add_slice(Lane lane, const Span& span) {
    const Look look = look_of(span.activity);
    const bool is_work = look.colour.empty();
    TraceEvent event(text_, 'X', pid_, thread_of(lane), lane == kCpu ? "cpu" : "gpu", look.name,
                     is_work ? span.query : 0);
    event.at(nanoseconds(span.begin)).lasting(nanoseconds(span.end) - nanoseconds(span.begin));
    if (!is_work) event.field("cname", look.colour);
    event.argument("ps", static_cast<std::uint64_t>(span.end - span.begin));
    if (span.activity == Activity::kDraw) event.argument("draw", draws_);
    if (span.query != 0) event.argument("query", span.query);
    if (span.triangles != 0) event.argument("triangles", span.triangles);
    if (span.fragments != 0) event.argument("fragments", span.fragments);
}

void TimelineFile::add_flow(char phase, Lane lane, std::int64_t at_ns, std::uint64_t query, bool is_within) {
    TraceEvent event(text_, phase, pid_, thread_of(lane), "query", "query");
    event.at(at_ns).id(id_of(query));
    if (phase == 'f' && is_within) event.field("bp", "e");
    event.argument("query", query);
}

// Its name has no number: viewers make a lane for each name.
void TimelineFile::add_wait_in_fifo(const Span& span) {
    if (span.queued >= span.begin) return;
    ++fifo_commands_;
    for (const char phase : {'b', 'e'}) {
        TraceEvent event(text_, phase, pid_, thread_of(kFifo), "fifo", look_of(span.activity).name);
        event.at(nanoseconds(phase == 'b' ? span.queued : span.begin)).id(id_of(fifo_commands_));
        if (phase == 'e') continue;
        event.argument("ps", static_cast<std::uint64_t>(span.begin - span.queued));
        if (span.activity == Activity::kDraw) event.argument("draw", draws_);
        if (span.query != 0) event.argument("query", span.query);
    }
}

void TimelineFile::add_fifo_level(Picoseconds at, Picoseconds work) {
    TraceEvent(text_, 'C', pid_, thread_of(kFifo), "fifo", "FIFO of context", context_)
        .at(nanoseconds(at))
        .microseconds("us", work);
}

void TimelineFile::add_frame(Picoseconds end, const TimeSums* sums) {
    const std::int64_t begin_ns = nanoseconds(frame_begin_);
    TraceEvent event(text_, 'X', pid_, thread_of(kFrames), "frame", "frame " + std::to_string(frame_index_));
    event.at(begin_ns).lasting(nanoseconds(end) - begin_ns);
    event.argument("ps", static_cast<std::uint64_t>(end - frame_begin_));
    event.argument("context", context_).argument("frame", frame_index_);
    event.json("is_whole", sums != nullptr && is_frame_whole_ ? "true" : "false");
    if (sums == nullptr) return;
    event.milliseconds("gpu_busy_ms", sums->gpu_busy).milliseconds("stall_ms", sums->stall);
    event.milliseconds("back_pressure_ms", sums->back_pressure);
    event.milliseconds("starvation_ms", sums->starvation).milliseconds("drain_ms", sums->drain);
}

void TimelineFile::write() {
    if (text_.empty()) return;
    if (!has_names_) {
        has_names_ = true;
        std::string events = std::move(text_);
        text_.clear();
        add_names();
        text_ += ",\n" + events;
    }
    file_.append(text_);
    text_.clear();
}

std::unique_ptr<occlusion_unit::TimelineListener> open_timeline_file(const Context& ctx) {
    if (settings().timeline_path.empty()) return nullptr;
    static auto* const file = new SharedJsonFile(settings().timeline_path, kTimelineKind);
    return std::make_unique<TimelineFile>(*file, static_cast<std::uint64_t>(ctx.number),
                                          settings().timeline_frames, settings().device.name);
}

void end_timeline_files() {
    const std::unique_lock lock(timelines().mutex, std::try_to_lock);
    if (!lock.owns_lock()) return;
    for (TimelineFile* const timeline : timelines().all) timeline->end();
}

void hold_timeline_files() {
    timelines().mutex.lock();
}

void release_timeline_files() {
    timelines().mutex.unlock();
}

}  // namespace glext_emu
