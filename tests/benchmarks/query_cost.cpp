// SPDX-License-Identifier: MIT
// What an occlusion query costs: beginning it, a rectangle, ending it, and reading the result.
//
//     query_cost samples|any|nv|hp [options of Google Benchmark]
//
// asks by SAMPLES_PASSED, ANY_SAMPLES_PASSED, GL_NV_occlusion_query or GL_HP_occlusion_test.
// tests/benchmarks/run starts it with the layer and without, in turn, and compares. Every result is checked
// against the rectangle's geometry: a wrong one ends the program. Color and depth are not written: no query
// changes what the next one sees.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <benchmark/benchmark.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <string>

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

// A way to ask. The HP test has one result, so only one question at a time.
class Asker {
  public:
    virtual ~Asker() = default;
    virtual bool can_batch() const { return true; }
    virtual void make_names(GLsizei count, GLuint* names) { glGenQueries(count, names); }
    virtual void delete_names(GLsizei count, const GLuint* names) { glDeleteQueries(count, names); }
    virtual void ask(GLuint name, const Box& box) = 0;
    virtual GLuint answer(GLuint name) {
        GLuint result = 0;
        glGetQueryObjectuiv(name, GL_QUERY_RESULT, &result);
        return result;
    }
    virtual GLuint expected(const Box& box) const { return box.visible(); }
};

// The queries of core GL, from 1.5 on.
class CoreAsker : public Asker {
  public:
    explicit CoreAsker(GLenum target) : target_(target) {}
    void ask(GLuint name, const Box& box) override {
        glBeginQuery(target_, name);
        draw_box(box);
        glEndQuery(target_);
    }
    GLuint expected(const Box& box) const override {
        return target_ == GL_SAMPLES_PASSED ? box.visible() : static_cast<GLuint>(box.visible() > 0);
    }

  private:
    GLenum target_;
};

template <typename Function>
Function function_of_gl(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

class NvAsker : public Asker {
  public:
    void make_names(GLsizei count, GLuint* names) override { gen_(count, names); }
    void delete_names(GLsizei count, const GLuint* names) override { delete_(count, names); }
    void ask(GLuint name, const Box& box) override {
        begin_(name);
        draw_box(box);
        end_();
    }
    GLuint answer(GLuint name) override {
        GLuint result = 0;
        get_(name, GL_PIXEL_COUNT_NV, &result);
        return result;
    }

  private:
    PFNGLGENOCCLUSIONQUERIESNVPROC gen_ =
        function_of_gl<PFNGLGENOCCLUSIONQUERIESNVPROC>("glGenOcclusionQueriesNV");
    PFNGLDELETEOCCLUSIONQUERIESNVPROC delete_ =
        function_of_gl<PFNGLDELETEOCCLUSIONQUERIESNVPROC>("glDeleteOcclusionQueriesNV");
    PFNGLBEGINOCCLUSIONQUERYNVPROC begin_ =
        function_of_gl<PFNGLBEGINOCCLUSIONQUERYNVPROC>("glBeginOcclusionQueryNV");
    PFNGLENDOCCLUSIONQUERYNVPROC end_ = function_of_gl<PFNGLENDOCCLUSIONQUERYNVPROC>("glEndOcclusionQueryNV");
    PFNGLGETOCCLUSIONQUERYUIVNVPROC get_ =
        function_of_gl<PFNGLGETOCCLUSIONQUERYUIVNVPROC>("glGetOcclusionQueryuivNV");
};

class HpAsker : public Asker {
  public:
    bool can_batch() const override { return false; }
    void make_names(GLsizei, GLuint*) override {}
    void delete_names(GLsizei, const GLuint*) override {}
    void ask(GLuint, const Box& box) override {
        glEnable(GL_OCCLUSION_TEST_HP);
        draw_box(box);
        glDisable(GL_OCCLUSION_TEST_HP);
    }
    GLuint answer(GLuint) override {
        GLboolean result = 0xAA;
        glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &result);
        return result;
    }
    GLuint expected(const Box& box) const override { return static_cast<GLuint>(box.visible() > 0); }
};

std::unique_ptr<Asker> asker;

bool choose_asker(const std::string& kind) {
    if (kind == "samples") asker = std::make_unique<CoreAsker>(GL_SAMPLES_PASSED);
    if (kind == "any") asker = std::make_unique<CoreAsker>(GL_ANY_SAMPLES_PASSED);
    if (kind == "nv") asker = std::make_unique<NvAsker>();
    if (kind == "hp") asker = std::make_unique<HpAsker>();
    return asker != nullptr;
}

void read(GLuint name, const Box& box) {
    const GLuint result = asker->answer(name);
    if (result == asker->expected(box)) return;
    std::fprintf(stderr, "query_cost: result %u of a box of %d x %d with %d columns hidden, expected %u\n",
                 result, box.side, box.side, box.hidden, asker->expected(box));
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
    asker->make_names(1, &name);
    asker->ask(name, {box.side, box.side});
    read(name, {box.side, box.side});  // a box that is wholly hidden: the answer is not always the same
    for (auto _ : state) {
        asker->ask(name, box);
        read(name, box);
    }
    label(state, box, 1);
    asker->delete_names(1, &name);
}

// All queries first, then all results, as a culler that batches them.
void batched(benchmark::State& state) {
    const Box box = box_of(state);
    std::array<GLuint, kBatch> names{};
    asker->make_names(kBatch, names.data());
    for (auto _ : state) {
        for (const GLuint name : names) asker->ask(name, box);
        for (const GLuint name : names) read(name, box);
    }
    label(state, box, kBatch);
    asker->delete_names(kBatch, names.data());
}

// Side in pixels, visible share in percent: 8,100 and 126,736 pixels, as the design's table of ways to count.
void sizes(benchmark::internal::Benchmark* benchmark) {
    benchmark->ArgNames({"side", "visible_percent"})->UseRealTime();
    for (const int side : {90, 356}) {
        for (const int visible_percent : {50, 100}) benchmark->Args({side, visible_percent});
    }
}
}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (argc != 2 || !choose_asker(argv[1])) {
        std::fprintf(stderr, "usage: query_cost samples|any|nv|hp [options of Google Benchmark]\n");
        return 2;
    }
    sizes(benchmark::RegisterBenchmark("alone", alone));
    if (asker->can_batch()) sizes(benchmark::RegisterBenchmark("batched", batched));
    benchmarks::make_pbuffer_context(kWidth, kHeight);
    set_up();
    benchmark::AddCustomContext("renderer", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    benchmark::AddCustomContext("version", reinterpret_cast<const char*>(glGetString(GL_VERSION)));
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
