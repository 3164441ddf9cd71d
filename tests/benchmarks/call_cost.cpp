// SPDX-License-Identifier: MIT
// Nanoseconds of single GL calls on Mesa. tests/benchmarks/run starts it with the layer and without, in turn,
// and compares.
#include <GL/gl.h>
#include <benchmark/benchmark.h>

#include "pbuffer_context.h"

namespace {

constexpr int kSize = 16;  // pixels: nothing here is about drawing

void not_hooked_color4f(benchmark::State& state) {
    for (auto _ : state) glColor4f(0.25f, 0.5f, 0.75f, 1.0f);
}
BENCHMARK(not_hooked_color4f);

void hooked_idle_get_error(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(glGetError());
}
BENCHMARK(hooked_idle_get_error);

void hooked_idle_is_enabled(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(glIsEnabled(GL_DEPTH_TEST));
}
BENCHMARK(hooked_idle_is_enabled);

// Two hooked calls and three that are not; the triangle has no area, so that rasterisation costs nothing.
void begin_3_vertex_end(benchmark::State& state) {
    for (auto _ : state) {
        glBegin(GL_TRIANGLES);
        glVertex3f(0, 0, 0);
        glVertex3f(0, 0, 0);
        glVertex3f(0, 0, 0);
        glEnd();
    }
}
BENCHMARK(begin_3_vertex_end);

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    benchmarks::make_pbuffer_context(kSize, kSize);
    benchmark::AddCustomContext("renderer", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    benchmark::AddCustomContext("version", reinterpret_cast<const char*>(glGetString(GL_VERSION)));
    benchmark::RunSpecifiedBenchmarks();
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
        std::fprintf(stderr, "call_cost: GL error 0x%x\n", error);
        return 1;
    }
    return 0;
}
