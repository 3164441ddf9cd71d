// SPDX-License-Identifier: MIT
// What the tests of device time share: the costs of ledger.toml in nanoseconds, the two clocks as a program
// reads them, and work whose cost is known.
//
// Times are exact: a test that starts on an idle machine can add up where each clock will be.
#pragma once

#include <optional>

#include "harness/gl_test.h"
#include "harness/query.h"

// After glext.h with its prototypes, which it includes without.
#include <GL/glext_emu.h>

namespace clock_tests {

inline constexpr GLint64 kBatch = 1'000;  // CPU
inline constexpr GLint64 kQuery = 2'000;
inline constexpr GLint64 kPoll = 500;
inline constexpr GLint64 kRead = 4'000;
inline constexpr GLint64 kSwap = 8'000;
inline constexpr GLint64 kCopiedTriangle = 100;
inline constexpr GLint64 kGpuBatch = 10'000;  // GPU
inline constexpr GLint64 kTriangle = 1'000;
inline constexpr GLint64 kFragment = 10;
inline constexpr GLint64 kDepthFragment = 5;
inline constexpr GLint64 kClearedPixel = 2;
inline constexpr GLint64 kSwappedPixel = 4;
inline constexpr GLint64 kGpuQuery = 20'000;
inline constexpr GLint64 kLatency = 100'000;
inline constexpr GLint64 kRegionPixel = 8;
inline constexpr GLint64 kReadPixel = 50;  // between them
inline constexpr GLsizeiptr kVideoMemory = 1 << 20;

inline constexpr GLint64 kLong = 10'000'000;  // of GPU work that outlasts what a test does on the CPU

// What fill() draws: two triangles, of whose fragments llvmpipe counts the 16 blocks of 4x4 along their
// common edge for both.
inline constexpr GLint64 kFilled = 64 * 64 + 16 * 4 * 4;
inline constexpr GLint64 kWholePixels = GLint64{conformance::kSurfaceSize} * conformance::kSurfaceSize;

// The CPU's clock.
GLint64 cpu();
// What <act> takes on it.
template <typename Act>
GLint64 on_cpu(Act act) {
    const GLint64 before = cpu();
    act();
    return cpu() - before;
}

// Where the GPU's clock is when all before is done. Waits for it.
GLint64 gpu();
// What <act> moves it by, from the program's command on. Waits for it.
template <typename Act>
GLint64 on_gpu(Act act) {
    const conformance::Query timer(GL_TIME_ELAPSED);
    timer.begin();
    act();
    timer.end();
    GLint64 elapsed = -1;
    glGetQueryObjecti64v(timer.name(), GL_QUERY_RESULT, &elapsed);
    return elapsed;
}

void work(GLuint64 nanoseconds);
template <typename Command>
Command command(const char* name) {
    return reinterpret_cast<Command>(conformance::platform().get_proc_address(name));
}

bool is_available(const conformance::Query& query);

// Triangles without area from a buffer object: they cost their vertices, no copy, and no fragment.
void draw(int triangles);
inline void draw_batches(int batches, int triangles) {
    for (int i = 0; i < batches; ++i) draw(triangles);
}
// A rectangle over all pixels, of two triangles from a buffer object.
void fill(float depth = conformance::kNear);
// A query about nothing: costs nothing but itself.
void ask(const conformance::Query& query);

class DeviceTest : public conformance::GlTest {
  protected:
    void SetUp() override;
    void TearDown() override;

    // Both clocks stand at the same time, and nothing is under way; returns that time.
    static GLint64 rest();
    // Gives the GPU so much to do that the CPU does not catch up.
    static void keep_gpu_busy() { draw(static_cast<int>(kLong / kTriangle)); }

  private:
    GLuint buffer_ = 0;
};

}  // namespace clock_tests
