// SPDX-License-Identifier: MIT
// What a samples query costs: Begin, a rectangle, End, and reading the result. tests/benchmarks/run starts it
// with the layer and without, in turn, and compares. Every result is checked against the rectangle's
// geometry: a wrong count ends the program.
//
// Only functions of OpenGL 1.5, so that a device of that version runs it. Color and depth are not written: no
// query changes what the next one sees.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <benchmark/benchmark.h>

#include <array>
#include <cstdlib>

#include "pbuffer_context.h"

namespace {

constexpr int kWidth = 1024, kHeight = 768;
constexpr int kBatch = 32;

// A rectangle of side x side pixels, whose left <hidden> columns lie behind the wall. It slopes from near to
// far, wholly on its side of the wall at either end.
struct Box {
    int side;
    int hidden;
    GLuint visible() const { return static_cast<GLuint>(side) * static_cast<GLuint>(side - hidden); }
};

// The wall covers the left half of the window at depth 0.5 of a range in which 0 is near.
constexpr int kWallRight = kWidth / 2;
constexpr float kWallDepth = 0.5f, kBoxNear = 0.6f, kBoxFar = 0.9f;

void draw_rectangle(float left, float right, float bottom, float top, float depth_bottom, float depth_top) {
    const std::array<float, 12> corners = {left,  bottom, depth_bottom, right, bottom, depth_bottom,
                                           right, top,    depth_top,    left,  top,    depth_top};
    glVertexPointer(3, GL_FLOAT, 0, corners.data());
    glDrawArrays(GL_QUADS, 0, 4);
}

void set_up() {
    glViewport(0, 0, kWidth, kHeight);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, kWidth, 0, kHeight, 0, -1);  // z is the depth in the window, 0 near
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_rectangle(0, kWallRight, 0, kHeight, kWallDepth, kWallDepth);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
}

void draw_box(const Box& box) {
    const float left = static_cast<float>(kWallRight - box.hidden), bottom = 100;
    draw_rectangle(left, left + static_cast<float>(box.side), bottom, bottom + static_cast<float>(box.side),
                   kBoxNear, kBoxFar);
}

void query(GLuint name, const Box& box) {
    glBeginQuery(GL_SAMPLES_PASSED, name);
    draw_box(box);
    glEndQuery(GL_SAMPLES_PASSED);
}

void read(GLuint name, const Box& box) {
    GLuint samples = 0;
    glGetQueryObjectuiv(name, GL_QUERY_RESULT, &samples);
    if (samples == box.visible()) return;
    std::fprintf(stderr, "query_cost: %u samples of a box of %d x %d with %d columns hidden, expected %u\n",
                 samples, box.side, box.side, box.hidden, box.visible());
    std::exit(1);
}

Box box_of(const benchmark::State& state) {
    const int side = static_cast<int>(state.range(0));
    return {side, side * static_cast<int>(100 - state.range(1)) / 100};
}

void label(benchmark::State& state, const Box& box, int queries) {
    state.SetItemsProcessed(state.iterations() * queries);
    state.counters["pixels"] = box.side * box.side;
    state.counters["visible"] = box.visible();
    state.counters["per_iteration"] = queries;
}

// Query by query, each result awaited at once.
void alone(benchmark::State& state) {
    const Box box = box_of(state);
    GLuint name = 0;
    glGenQueries(1, &name);
    for (auto _ : state) {
        query(name, box);
        read(name, box);
    }
    label(state, box, 1);
    glDeleteQueries(1, &name);
}

// All queries first, then all results, as a culler that batches them.
void batched(benchmark::State& state) {
    const Box box = box_of(state);
    std::array<GLuint, kBatch> names{};
    glGenQueries(kBatch, names.data());
    for (auto _ : state) {
        for (const GLuint name : names) query(name, box);
        for (const GLuint name : names) read(name, box);
    }
    label(state, box, kBatch);
    glDeleteQueries(kBatch, names.data());
}

// Side in pixels, visible share in percent: 8,100 and 126,736 pixels, as the design's table of ways to count.
void sizes(benchmark::internal::Benchmark* benchmark) {
    benchmark->ArgNames({"side", "visible_percent"})->UseRealTime();
    for (const int side : {90, 356}) {
        for (const int visible_percent : {50, 100}) benchmark->Args({side, visible_percent});
    }
}
BENCHMARK(alone)->Apply(sizes);
BENCHMARK(batched)->Apply(sizes);

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    benchmarks::make_pbuffer_context(kWidth, kHeight);
    set_up();
    benchmark::AddCustomContext("renderer", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    benchmark::AddCustomContext("version", reinterpret_cast<const char*>(glGetString(GL_VERSION)));
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
