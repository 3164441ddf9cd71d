// SPDX-License-Identifier: MIT
#include "context/report.h"

#include <errno.h>
#include <unistd.h>

#include <charconv>
#include <cstdio>

#include "context/contexts.h"
#include "context/effect_tallies.h"
#include "context/probe.h"
#include "context/settings.h"
#include "context/timeline_file.h"

namespace glext_emu {
namespace {

const char* target_name(GLenum target) {
    return target == GL_SAMPLES_PASSED       ? "SAMPLES_PASSED"
           : target == GL_ANY_SAMPLES_PASSED ? "ANY_SAMPLES_PASSED"
                                             : "ANY_SAMPLES_PASSED_CONSERVATIVE";
}

// By hand: printf's decimal point is the locale's.
std::string milliseconds(std::int64_t picoseconds) {
    char text[48];
    std::snprintf(text, sizeof text, "%lld.%09lld", static_cast<long long>(picoseconds / 1'000'000'000),
                  static_cast<long long>(picoseconds % 1'000'000'000));
    return text;
}

// The frame's time on the device.
std::string device_times(const Context& ctx) {
    if (ctx.time == nullptr) return "";
    const occlusion_unit::TimeSums& frame = ctx.time->last_frame();
    return ",\"device_ms\":" + milliseconds(frame.cpu) + ",\"gpu_busy_ms\":" + milliseconds(frame.gpu_busy) +
           ",\"device_stall_ms\":" + milliseconds(frame.stall) +
           ",\"back_pressure_ms\":" + milliseconds(frame.back_pressure) +
           ",\"starvation_ms\":" + milliseconds(frame.starvation) +
           ",\"drain_ms\":" + milliseconds(frame.drain);
}

}  // namespace

Report& Report::instance() {
    static Report* const report = made_ = new Report;
    return *report;
}

std::atomic<Report*> Report::made_{nullptr};

Report::Report() : file_(settings().report_path, kReportKind) {
}

void Report::before_fork() {
    hold_timeline_files();
    SharedJsonFile::before_fork();
}

void Report::after_fork(bool is_child) {
    SharedJsonFile::after_fork(is_child);
    release_timeline_files();
}

void Report::begin_context(const Context& ctx) {
    if (!is_wanted()) return;
    const auto text = [&](GLenum name) { return reinterpret_cast<const char*>(ctx.real->glGetString(name)); };
    file_.append("{\"kind\":\"context\",\"pid\":" + std::to_string(getpid()) +
                 ",\"program\":" + json_string(program_invocation_short_name) +
                 ",\"context\":" + std::to_string(ctx.number) + ",\"platform\":" + json_string(ctx.platform) +
                 ",\"device\":" + json_string(settings().device.name.c_str()) +
                 ",\"clock\":" + json_string(settings().latency.text().c_str()) +
                 ",\"renderer\":" + json_string(text(GL_RENDERER)) +
                 ",\"version\":" + json_string(ctx.advertised->version_string.c_str()) + "}");
}

void Report::add_frame(Context& ctx) {
    const FrameCounts& frame = ctx.frame;
    // By hand: printf's decimal point is the locale's.
    char stall_ms[48];
    std::snprintf(stall_ms, sizeof stall_ms, "%llu.%06llu", frame.stall_ns / 1'000'000ULL,
                  frame.stall_ns % 1'000'000ULL);
    file_.append("{\"kind\":\"frame\",\"pid\":" + std::to_string(getpid()) +
                 ",\"context\":" + std::to_string(ctx.number) + ",\"frame\":" + std::to_string(frame.index) +
                 ",\"queries_begun\":" + std::to_string(frame.queries_begun) +
                 ",\"polls\":" + std::to_string(frame.polls) + ",\"waits\":" + std::to_string(frame.waits) +
                 ",\"stall_ms\":" + stall_ms + ",\"results\":" + std::to_string(frame.results) +
                 ",\"draws\":" + std::to_string(frame.draws) +
                 ",\"pixels_read\":" + std::to_string(frame.pixels_read) + ",\"triangles\":" +
                 (frame.triangles_are_known ? std::to_string(frame.triangles) : "null") + device_times(ctx) +
                 (settings().probes_unit ? ",\"unprobed\":" + std::to_string(frame.unprobed) : "") + "}");
}

void Report::add_probe(const Context& ctx, const ProbedQuery& query, const occlusion_unit::Record& record) {
    const auto known = [&](std::uint32_t a_register, const std::string& text) {
        return (record.registers & a_register) != 0 ? text : "null";
    };
    const occlusion_unit::Box& box = record.box;
    const std::string corners = "[" + std::to_string(box.left) + "," + std::to_string(box.bottom) + "," +
                                std::to_string(box.right) + "," + std::to_string(box.top) + "]";
    // By to_chars: the shortest that reads back as the same float, whatever the locale.
    char depth[32];
    char* const depth_end = std::to_chars(depth, depth + sizeof depth, record.nearest_depth).ptr;
    file_.append(
        "{\"kind\":\"probe\",\"pid\":" + std::to_string(getpid()) +
        ",\"context\":" + std::to_string(ctx.number) + ",\"frame\":" + std::to_string(query.frame) +
        ",\"query\":" + std::to_string(query.name) + ",\"target\":" + json_string(target_name(query.target)) +
        ",\"draws\":" + std::to_string(query.draws) +
        ",\"far\":" + (query.run->far_end() == occlusion_unit::FarEnd::kOne ? "1" : "0") + ",\"visible\":" +
        known(occlusion_unit::kVisible, std::to_string(record.visible)) + ",\"projected_hits\":" +
        known(occlusion_unit::kProjectedHits, std::to_string(record.projected_hits)) +
        ",\"visible_hits\":" + known(occlusion_unit::kVisibleHits, std::to_string(record.visible_hits)) +
        ",\"nearest_depth\":" + known(occlusion_unit::kNearestDepth, std::string(depth, depth_end)) +
        ",\"screen_box\":" + known(occlusion_unit::kScreenBox, corners) + "}");
}

void Report::add_effects(const Context& ctx) {
    for (const EffectTally& tally : tally_effects(ctx)) {
        const char* const is_called_for = !tally.is_called_for   ? "null"
                                          : *tally.is_called_for ? "true"
                                                                 : "false";
        file_.append("{\"kind\":\"effect\",\"pid\":" + std::to_string(getpid()) +
                     ",\"context\":" + std::to_string(ctx.number) + ",\"effect\":\"" +
                     std::string(occlusion_unit::kEffectNames[static_cast<std::size_t>(tally.effect)]) +
                     "\",\"on\":" + (tally.is_on ? "true" : "false") + ",\"called_for\":" + is_called_for +
                     ",\"reason\":" + json_string(tally.reason.c_str()) +
                     ",\"ms\":" + (tally.time ? milliseconds(*tally.time) : "null") + "}");
    }
}

void Report::end_frame(Context& ctx) {
    if (!is_wanted()) return;
    add_frame(ctx);
    ctx.frame.next_frame();
}

void Report::end_context(Context& ctx) {
    if (!is_wanted() || !ctx.is_initialised) return;
    if (ctx.time != nullptr) ctx.time->end_unfinished_frame();
    if (!ctx.frame.is_empty()) end_frame(ctx);
    if (ctx.time != nullptr) add_effects(ctx);
    file_.flush();
}

void Report::flush_at_exit() {
    Report* const report = made_;
    // exit() from a signal handler may have interrupted a write of this very thread.
    if (report == nullptr || !report->file_.is_idle()) return;
    for_each_context([](Context& ctx) { instance().end_context(ctx); });
    report->file_.flush();
    end_timeline_files();
}

namespace {

// The last frame of a program that leaves its contexts to the end.
__attribute__((destructor)) void at_exit() {
    Report::flush_at_exit();
}

}  // namespace

}  // namespace glext_emu
