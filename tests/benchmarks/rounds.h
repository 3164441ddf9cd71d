// SPDX-License-Identifier: MIT
// Rows that are timed in turn within each round: whatever else the machine does meets all of them, so what
// one row costs in terms of another varies less than either. Times go to tests/benchmarks/run as JSON, a
// figure a row and round.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <chrono>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace benchmarks {

struct Row {
    std::string name;
    int asks;                             // how many of what is timed one call of <run> does
    std::function<void()> run;            // ends when the answers are there
    std::function<void()> check = [] {};  // of the answers; not timed
};

[[noreturn, gnu::format(printf, 1, 2)]] inline void fail(const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    std::vfprintf(stderr, format, arguments);
    va_end(arguments);
    std::fputc('\n', stderr);
    std::exit(1);
}

inline double microseconds_of(const std::function<void()>& run) {
    const auto start = std::chrono::steady_clock::now();
    run();
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

// {row: [microseconds an ask, one a round]}. A turn is made twice and timed once: what the driver compiles,
// uploads or switches after another row's turn (a new state costs 35 to 60 ms) is none of the row's. The
// order changes from round to round.
inline nlohmann::ordered_json measure(const std::vector<Row>& rows, int rounds) {
    std::vector<std::size_t> order(rows.size());
    std::iota(order.begin(), order.end(), 0);
    std::mt19937 random(1);
    std::vector<std::vector<double>> times(rows.size());
    for (int round = 0; round < rounds; ++round) {
        std::shuffle(order.begin(), order.end(), random);
        for (const std::size_t at : order) {
            rows[at].run();
            glFinish();
            times[at].push_back(microseconds_of(rows[at].run) / rows[at].asks);
            rows[at].check();
        }
    }
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) fail("GL error 0x%x while measuring", error);
    nlohmann::ordered_json named;
    for (std::size_t at = 0; at < rows.size(); ++at) named[rows[at].name] = times[at];
    return named;
}

inline bool has_extension(const char* name) {
    const auto* all = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
    const std::size_t length = std::strlen(name);
    for (const char* at = all; (at = std::strstr(at, name)) != nullptr; at += length) {
        if ((at == all || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0')) return true;
    }
    return false;
}

template <typename Function>
Function function_of_gl(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

inline nlohmann::ordered_json description_of_gl() {
    const auto text = [](GLenum name) {
        return std::string(reinterpret_cast<const char*>(glGetString(name)));
    };
    return {{"renderer", text(GL_RENDERER)}, {"version", text(GL_VERSION)}};
}

// The number after `--rounds`, the only option.
inline int rounds_of(int argc, char** argv) {
    const int rounds = argc == 3 && std::strcmp(argv[1], "--rounds") == 0 ? std::atoi(argv[2]) : 0;
    if (rounds > 0) return rounds;
    std::fprintf(stderr, "usage: %s --rounds N\n", argv[0]);
    std::exit(2);
}

}  // namespace benchmarks
