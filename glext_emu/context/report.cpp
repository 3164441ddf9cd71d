// SPDX-License-Identifier: MIT
#include "context/report.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <time.h>
#include <unistd.h>

#include <charconv>
#include <cstdio>
#include <cstring>

#include "context/contexts.h"
#include "context/effect_tallies.h"
#include "context/probe.h"
#include "context/settings.h"

namespace glext_emu {
namespace {

constexpr char kHead[] = "{\"glext_emu_report\":1,\"records\":[";
constexpr char kTail[] = "\n]}\n";
constexpr long kHeadLength = sizeof kHead - 1;
constexpr long kTailLength = sizeof kTail - 1;

// A program that is killed loses at most this much of its report.
constexpr std::chrono::milliseconds kLongestDelay{100};
constexpr std::size_t kLargestBuffer = 32'768;

std::string json_string(const char* text) {
    std::string out = "\"";
    for (const char* c = text == nullptr ? "" : text; *c != '\0'; ++c) {
        const auto byte = static_cast<unsigned char>(*c);
        if (byte == '"' || byte == '\\') {
            out += '\\';
            out += *c;
        } else if (byte < 0x20 || byte >= 0x7f) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", byte);
            out += escape;
        } else {
            out += *c;
        }
    }
    return out + '"';
}

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

bool write_all(int file, const std::string& text, off_t at) {
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t n = pwrite(file, text.data() + done, text.size() - done, at + static_cast<off_t>(done));
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return false;
        done += static_cast<std::size_t>(n);
    }
    return true;
}

// A write beyond the program's file size limit is to fail, not to end the program.
class FileSizeSignalBlocked {
  public:
    FileSizeSignalBlocked() {
        sigemptyset(&signal_);
        sigaddset(&signal_, SIGXFSZ);
        pthread_sigmask(SIG_BLOCK, &signal_, &before_);
    }
    ~FileSizeSignalBlocked() {
        const timespec now{0, 0};
        if (sigismember(&before_, SIGXFSZ) == 0) sigtimedwait(&signal_, nullptr, &now);
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    FileSizeSignalBlocked(const FileSizeSignalBlocked&) = delete;
    FileSizeSignalBlocked& operator=(const FileSizeSignalBlocked&) = delete;

  private:
    sigset_t signal_;
    sigset_t before_;
};

// <records> starts with a newline and has commas between its records. Returns what went wrong, or null.
// Nothing is written over a file that is not a report, and what cannot be written whole is taken back.
const char* append_to_file(int file, const std::string& records) {
    const FileSizeSignalBlocked blocked;
    const off_t size = lseek(file, 0, SEEK_END);
    off_t at = 0;
    std::string text = kHead;
    if (size != 0) {
        char tail[kTailLength];
        if (size < kHeadLength + kTailLength ||
            pread(file, tail, kTailLength, size - kTailLength) != kTailLength ||
            std::memcmp(tail, kTail, kTailLength) != 0) {
            return "is not a report, so nothing is written to it";
        }
        at = size - kTailLength;
        text = at == kHeadLength ? "" : ",";
    }
    if (write_all(file, text + records + kTail, at)) return nullptr;
    // The old brackets take no more room than there was.
    if (ftruncate(file, size) == 0 && size != 0) write_all(file, kTail, at);
    return "cannot be written";
}

}  // namespace

Report& Report::instance() {
    static Report* const report = made_ = new Report;
    return *report;
}

std::atomic<Report*> Report::made_{nullptr};

Report::Report() : path_(settings().report_path), is_wanted_(!path_.empty()) {
}

void Report::before_fork() {
    if (Report* const report = made_) report->mutex_.lock();
}

void Report::after_fork(bool is_child) {
    Report* const report = made_;
    if (report == nullptr) return;
    // The parent writes what happened in the parent.
    if (is_child) report->buffer_.clear();
    report->mutex_.unlock();
}

void Report::begin_context(const Context& ctx) {
    if (!is_wanted()) return;
    const auto text = [&](GLenum name) { return reinterpret_cast<const char*>(ctx.real->glGetString(name)); };
    append("{\"kind\":\"context\",\"pid\":" + std::to_string(getpid()) +
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
    append("{\"kind\":\"frame\",\"pid\":" + std::to_string(getpid()) +
           ",\"context\":" + std::to_string(ctx.number) + ",\"frame\":" + std::to_string(frame.index) +
           ",\"queries_begun\":" + std::to_string(frame.queries_begun) +
           ",\"polls\":" + std::to_string(frame.polls) + ",\"waits\":" + std::to_string(frame.waits) +
           ",\"stall_ms\":" + stall_ms + ",\"results\":" + std::to_string(frame.results) + ",\"draws\":" +
           std::to_string(frame.draws) + ",\"pixels_read\":" + std::to_string(frame.pixels_read) +
           ",\"triangles\":" + (frame.triangles_are_known ? std::to_string(frame.triangles) : "null") +
           device_times(ctx) +
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
    append("{\"kind\":\"probe\",\"pid\":" + std::to_string(getpid()) +
           ",\"context\":" + std::to_string(ctx.number) + ",\"frame\":" + std::to_string(query.frame) +
           ",\"query\":" + std::to_string(query.name) + ",\"target\":" +
           json_string(target_name(query.target)) + ",\"draws\":" + std::to_string(query.draws) +
           ",\"far\":" + (query.run->far_end() == occlusion_unit::FarEnd::kOne ? "1" : "0") +
           ",\"visible\":" + known(occlusion_unit::kVisible, std::to_string(record.visible)) +
           ",\"projected_hits\":" +
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
        append("{\"kind\":\"effect\",\"pid\":" + std::to_string(getpid()) +
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
    if (!ctx.frame.is_empty()) end_frame(ctx);
    if (ctx.time != nullptr) add_effects(ctx);
    flush();
}

void Report::append(const std::string& record) {
    const std::lock_guard lock(mutex_);
    buffer_ += buffer_.empty() ? "\n" : ",\n";
    buffer_ += record;
    const auto now = std::chrono::steady_clock::now();
    if (buffer_.size() > kLargestBuffer || now - last_flush_ > kLongestDelay) {
        last_flush_ = now;
        flush_locked();
    }
}

void Report::flush() {
    const std::lock_guard lock(mutex_);
    flush_locked();
}

void Report::flush_locked() {
    if (buffer_.empty()) return;
    const char* problem = "cannot be opened";
    const int file = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file >= 0) {
        int locked = -1;
        while ((locked = flock(file, LOCK_EX)) != 0 && errno == EINTR) {
        }
        if (locked == 0) problem = append_to_file(file, buffer_);
        close(file);
    }
    buffer_.clear();
    if (problem == nullptr) return;
    std::fprintf(stderr, "glext_emu: the report %s %s.\n", path_.c_str(), problem);
    is_wanted_ = false;
}

void Report::flush_at_exit() {
    Report* const report = made_;
    // exit() from a signal handler may have interrupted a write of this very thread.
    if (report == nullptr || !report->mutex_.try_lock()) return;
    report->mutex_.unlock();
    for_each_context([](Context& ctx) { instance().end_context(ctx); });
    report->flush();
}

namespace {

// The last frame of a program that leaves its contexts to the end.
__attribute__((destructor)) void at_exit() {
    Report::flush_at_exit();
}

}  // namespace

}  // namespace glext_emu
