// SPDX-License-Identifier: MIT
// forward_progress calls|frames|device FIRST LAST [STEP]: whatever a program waits by, and however long the
// latency, it goes on, and within the number of polls that the clock promises.
//
// A process has one clock for life, so each latency from FIRST to LAST gets a child, forked before any GL is
// loaded. DEVICE names the machine; under `device` it is one whose results come so many microseconds late, of
// which a poll takes one. Queries count nothing and conditions are seen by Clear: nothing has to be
// compiled, which would take longer than all else. Exit status: 0 done, 1 a latency failed, 2 bad use.
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "harness/draw.h"
#include "harness/gl_test.h"
#include "harness/query.h"
#include "old_commands.h"

namespace clock_tests {
namespace {

using conformance::Query;

constexpr unsigned kChildSeconds = 60;  // of wall time; a hundred times what the longest latency takes
constexpr std::uint64_t kPollsPerFrame =
    1000;  // "under frames 1,000 x N polls without a swap make a result due"
constexpr GLuint64 kPatience = 10'000'000'000;  // nanoseconds
constexpr GLuint kPoison = 0xABABABAB;

struct Clock {
    std::string kind;
    std::uint64_t amount = 0;

    // A poll is a call, or a microsecond: after N of them a result is due, or after 1,000 N polls without a
    // swap.
    std::uint64_t most_polls() const {
        return std::max<std::uint64_t>(1, kind == "frames" ? kPollsPerFrame * amount : amount);
    }
    std::string text() const { return kind == "device" ? kind : kind + "=" + std::to_string(amount); }
};

// A device file that is this process's own.
std::string machine_of_latency(std::uint64_t microseconds) {
    const std::string text = R"(name = "late"
description = "results come late, a poll takes a microsecond, and nothing else takes time"
source = "no machine"
[extensions]
emulate = ["GL_HP_occlusion_test", "GL_NV_occlusion_query"]
[time]
source = "no machine"
quality = "assumed"
poll_us = 1.0
result_latency_us = )" + std::to_string(microseconds) +
                             ".0\n";
    const int file = memfd_create("machine", 0);
    const bool is_written = write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    return is_written ? "/proc/self/fd/" + std::to_string(file) : "";
}

class Machine {
  public:
    Machine() {
        glGenBuffers(1, &buffer_);
        glBindBuffer(GL_COPY_WRITE_BUFFER, buffer_);
        glBufferData(GL_COPY_WRITE_BUFFER, sizeof kPoison, &kPoison, GL_DYNAMIC_COPY);
        nv_.generate(1, &nv_query_);
    }
    ~Machine() {
        if (fence_) glDeleteSync(fence_);
        glDeleteBuffers(1, &buffer_);
        nv_.remove(1, &nv_query_);
    }
    Machine(const Machine&) = delete;
    Machine& operator=(const Machine&) = delete;

    bool is_complete() const {
        return is_current_ && conformance::has_extension("GL_NV_occlusion_query") &&
               conformance::gl_version() >= 45;
    }
    void swap() const { surface_.swap(); }

    void ask() const {
        query_.begin();
        query_.end();
    }
    void ask_nv() const {
        nv_.begin(nv_query_);
        nv_.end();
    }

    void ask_with_fence() {
        ask();
        if (fence_) glDeleteSync(fence_);
        fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    }
    bool is_signalled() const {
        GLint status = GL_UNSIGNALED;
        glGetSynciv(fence_, GL_SYNC_STATUS, 1, nullptr, &status);
        return status == GL_SIGNALED;
    }
    bool waits_for_fence(GLuint64 nanoseconds) const {
        const GLenum answer = glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, nanoseconds);
        return answer == GL_CONDITION_SATISFIED || answer == GL_ALREADY_SIGNALED;
    }

    GLuint read(GLenum parameter) const {
        GLuint value = kPoison;
        glGetQueryObjectuiv(query_.name(), parameter, &value);
        return value;
    }
    GLuint read_nv(GLenum parameter) const {
        GLuint value = kPoison;
        nv_.get_unsigned(nv_query_, parameter, &value);
        return value;
    }
    GLuint write_bound(GLenum parameter) const {
        poison();
        glBindBuffer(GL_QUERY_BUFFER, buffer_);
        glGetQueryObjectuiv(query_.name(), parameter, nullptr);
        glBindBuffer(GL_QUERY_BUFFER, 0);
        return written();
    }
    GLuint write_named(GLenum parameter) const {
        poison();
        glGetQueryBufferObjectuiv(query_.name(), buffer_, parameter, 0);
        return written();
    }
    // Whether a block is discarded, as the result, zero, wants it.
    bool is_discarded(GLenum mode) const {
        glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
        glClear(GL_COLOR_BUFFER_BIT);
        glBeginConditionalRender(query_.name(), mode);
        glClearColor(1.0f, 1.0f, 1.0f, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
        glEndConditionalRender();
        return conformance::drawn_pixels({0, 0, 1, 1}) == 0;
    }

  private:
    void poison() const { glBufferSubData(GL_COPY_WRITE_BUFFER, 0, sizeof kPoison, &kPoison); }
    GLuint written() const {
        GLuint value = 0;
        glGetBufferSubData(GL_COPY_WRITE_BUFFER, 0, sizeof value, &value);
        return value;
    }

    conformance::Surface surface_;
    conformance::Context context_;
    bool is_current_ = context_.make_current(surface_);  // before the members that talk to it
    NvCommands nv_;
    Query query_;
    GLuint nv_query_ = 0;
    GLuint buffer_ = 0;
    GLsync fence_ = nullptr;
};

// A way to wait: begins and ends a query, then is asked again and again until it says that the result was
// there.
struct Poll {
    const char* name;
    std::function<void(Machine&)> ask;
    std::function<bool(const Machine&)> is_there;
};

const std::vector<Poll> kPolls = {
    {"available", &Machine::ask,
     [](const Machine& m) { return m.read(GL_QUERY_RESULT_AVAILABLE) == GL_TRUE; }},
    {"available of NV", &Machine::ask_nv,
     [](const Machine& m) { return m.read_nv(GL_PIXEL_COUNT_AVAILABLE_NV) == GL_TRUE; }},
    {"no wait", &Machine::ask, [](const Machine& m) { return m.read(GL_QUERY_RESULT_NO_WAIT) == 0; }},
    {"available into the bound buffer", &Machine::ask,
     [](const Machine& m) { return m.write_bound(GL_QUERY_RESULT_AVAILABLE) == GL_TRUE; }},
    {"no wait into the bound buffer", &Machine::ask,
     [](const Machine& m) { return m.write_bound(GL_QUERY_RESULT_NO_WAIT) == 0; }},
    {"available into a buffer", &Machine::ask,
     [](const Machine& m) { return m.write_named(GL_QUERY_RESULT_AVAILABLE) == GL_TRUE; }},
    {"no wait into a buffer", &Machine::ask,
     [](const Machine& m) { return m.write_named(GL_QUERY_RESULT_NO_WAIT) == 0; }},
    {"conditions without wait", &Machine::ask,
     [](const Machine& m) { return m.is_discarded(GL_QUERY_NO_WAIT); }},
    {"a fence", &Machine::ask_with_fence, [](const Machine& m) { return m.is_signalled(); }},
    {"a fence without patience", &Machine::ask_with_fence,
     [](const Machine& m) { return m.waits_for_fence(0); }},
};

// A way to wait that does not return before the result is there, and says whether it was right.
const std::vector<Poll> kWaits = {
    {"result", &Machine::ask, [](const Machine& m) { return m.read(GL_QUERY_RESULT) == 0; }},
    {"result of NV", &Machine::ask_nv, [](const Machine& m) { return m.read_nv(GL_PIXEL_COUNT_NV) == 0; }},
    {"result into the bound buffer", &Machine::ask,
     [](const Machine& m) { return m.write_bound(GL_QUERY_RESULT) == 0; }},
    {"result into a buffer", &Machine::ask,
     [](const Machine& m) { return m.write_named(GL_QUERY_RESULT) == 0; }},
    {"conditions with wait", &Machine::ask, [](const Machine& m) { return m.is_discarded(GL_QUERY_WAIT); }},
    {"a fence with patience", &Machine::ask_with_fence,
     [](const Machine& m) { return m.waits_for_fence(kPatience); }},
    {"finish", &Machine::ask,
     [](const Machine& m) {
         glFinish();
         return m.read(GL_QUERY_RESULT_AVAILABLE) == GL_TRUE;
     }},
};

bool complain(const Clock& clock, const char* name, const std::string& what) {
    std::fprintf(stderr, "%s=%llu, %s: %s\n", clock.kind.c_str(),
                 static_cast<unsigned long long>(clock.amount), name, what.c_str());
    return false;
}

bool polls_end(Machine& machine, const Clock& clock) {
    bool is_good = true;
    for (const Poll& poll : kPolls) {
        poll.ask(machine);
        std::uint64_t polls = 1;
        while (!poll.is_there(machine) && polls <= clock.most_polls()) ++polls;
        if (polls > clock.most_polls())
            is_good = complain(clock, poll.name, "still not there after the last poll");
    }
    // The plain poll is one call, and takes as many as the clock says. (Of frames, polls before this count
    // too.)
    machine.ask();
    std::uint64_t polls = 1;
    while (machine.read(GL_QUERY_RESULT_AVAILABLE) != GL_TRUE) ++polls;
    if (clock.kind != "frames" && polls != clock.most_polls()) {
        is_good = complain(clock, "available", "there after " + std::to_string(polls) + " polls");
    }
    return is_good;
}

bool swaps_end(Machine& machine, const Clock& clock) {
    bool is_good = true;
    for (const Poll& poll : kPolls) {
        machine.swap();  // forgets the polls of before
        poll.ask(machine);
        std::uint64_t swaps = 0;
        for (; !poll.is_there(machine) && swaps <= clock.amount; ++swaps) machine.swap();
        if (swaps != clock.amount) {
            is_good = complain(clock, poll.name, "there after " + std::to_string(swaps) + " swaps");
        }
    }
    return is_good;
}

bool waits_end(Machine& machine, const Clock& clock) {
    bool is_good = true;
    for (const Poll& wait : kWaits) {
        wait.ask(machine);
        if (!wait.is_there(machine)) is_good = complain(clock, wait.name, "came without the result");
    }
    return is_good;
}

bool run_under(const Clock& clock, const std::string& device) {
    const std::string machine_name = clock.kind == "device" ? machine_of_latency(clock.amount) : device;
    const std::string setting = "device=" + machine_name + ",clock=" + clock.text();
    setenv("GLEXT_EMU", setting.c_str(), 1);
    alarm(kChildSeconds);
    if (!conformance::open_platform("egl")) return complain(clock, "EGL", "no display");
    Machine machine;
    if (!machine.is_complete())
        return complain(clock, "the machine", "lacks queries: the layer is not beneath");
    bool is_good = polls_end(machine, clock);
    if (clock.kind == "frames") is_good = swaps_end(machine, clock) && is_good;
    is_good = waits_end(machine, clock) && is_good;
    const GLenum error = glGetError();
    if (error != GL_NO_ERROR) is_good = complain(clock, "an error", conformance::error_name(error));
    return is_good;
}

int run_all(const std::string& kind, std::uint64_t first, std::uint64_t last, std::uint64_t step,
            const std::string& device) {
    int failures = 0;
    for (std::uint64_t amount = first; amount <= last; amount += step) {
        const Clock clock{kind, amount};
        const pid_t child = fork();
        if (child == 0) _exit(run_under(clock, device) ? 0 : 1);
        int status = 0;
        if (child < 0 || waitpid(child, &status, 0) != child || status != 0) {
            complain(clock, "the child", WIFSIGNALED(status) ? "killed: endless?" : "failed");
            ++failures;
        }
    }
    return failures;
}

}  // namespace
}  // namespace clock_tests

int main(int argc, char** argv) {
    const char* const device = std::getenv("DEVICE");
    const std::string kind = argc > 1 ? argv[1] : "";
    if (argc < 4 || argc > 5 || !device || (kind != "calls" && kind != "frames" && kind != "device")) {
        std::fprintf(stderr, "usage: DEVICE=NAME forward_progress calls|frames|device FIRST LAST [STEP]\n");
        return 2;
    }
    const auto number = [&](int i) { return std::strtoull(argv[i], nullptr, 10); };
    const auto step = argc == 5 ? std::max(1ull, number(4)) : 1;
    return clock_tests::run_all(kind, number(2), number(3), step, device) == 0 ? 0 : 1;
}
