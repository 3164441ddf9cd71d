// SPDX-License-Identifier: MIT
// What a thousand small shapes cost in the Occlusion Unit's parallel form (GL_EMU_occlusion_unit), beside
// native samples queries of the same shapes in the same process: each awaited at once, and all begun before
// the first is read.
//
//     shapes_cost --rounds N          JSON on standard output; tests/benchmarks/run compares
//
// Every record is checked against the driver's own counts; a wrong one ends the program. Nothing is written,
// so each way finds the same scene.
#include "rounds.h"

#include <GL/glext_emu.h>

#include <array>
#include <cmath>

#include "pbuffer_context.h"

namespace {

using benchmarks::Row;

constexpr int kWidth = 1024, kHeight = 768;
constexpr int kShapes = 1000;
constexpr float kPixels = 300;      // of a shape's outline
constexpr float kWallRight = 0.2F;  // the wall covers the window from -1 to here, nearer than any shape

struct Commands {
    PFNGLOCCLUSIONUNITSHAPESEMUPROC shapes;
    PFNGLGETOCCLUSIONRECORDSEMUPROC get_records;
};
Commands emu;

using Point = std::array<float, 3>;

// A shape as the extension takes it, and as the triangles that its text makes of it.
struct Scene {
    const char* name;
    GLenum kind;
    std::vector<float> given;
    std::vector<Point> triangles;
    GLsizei vertices;  // of one shape's triangles
};

// Oblique projections of boxes as unit_cost has them: a hexagon of 3.64 scale^2 pixels, covered twice.
// Quadrilaterals slope in depth.
Scene make_scene(GLenum kind) {
    const bool is_box = kind == GL_HEXAHEDRON_EMU;
    Scene scene{is_box ? "boxes" : "quads", kind, {}, {}, is_box ? 36 : 6};
    std::mt19937 random(1);
    const auto between = [&random](float low, float high) {
        return low + (high - low) * static_cast<float>(random()) / 4294967296.0F;
    };
    const float scale = std::sqrt(kPixels / (is_box ? 3.64F : 4.0F));
    const float across = 2 * scale / kWidth, up = 2 * scale / kHeight;
    for (int shape = 0; shape < kShapes; ++shape) {
        const float x = between(-0.9F, 0.9F), y = between(-0.9F, 0.9F), z = between(0.2F, 0.7F);
        std::vector<Point> corners;
        for (int k = 0; k < (is_box ? 8 : 4); ++k) {
            const auto end = [k](int bit) { return (k >> bit & 1) != 0 ? 1.0F : -1.0F; };
            if (is_box) {
                corners.push_back({x + across * (0.7F * end(0) + 0.3F * end(2)),
                                   y + up * (0.7F * end(1) + 0.3F * end(2)), z + 0.1F * end(2)});
            } else {
                const float side = k == 1 || k == 2 ? 1.0F : -1.0F;
                corners.push_back({x + across * side, y + up * end(1), z + 0.05F * side});
            }
        }
        for (const Point& corner : corners)
            scene.given.insert(scene.given.end(), corner.begin(), corner.end());
        constexpr std::array<std::array<int, 4>, 6> kFaces = {
            {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
        constexpr std::array<int, 4> kAround = {0, 1, 2, 3};
        for (std::size_t face = 0; face < (is_box ? kFaces.size() : 1); ++face) {
            const auto& around = is_box ? kFaces[face] : kAround;
            for (const std::size_t k : {0, 1, 2, 0, 2, 3}) {
                scene.triangles.push_back(corners[static_cast<std::size_t>(around[k])]);
            }
        }
    }
    return scene;
}

// Asks about all shapes of a scene, in one way or another, and checks each answer.
class Asker {
  public:
    explicit Asker(const Scene& scene)
        : scene_(scene), queries_(kShapes), visible_(kShapes), projected_(kShapes) {
        glGenQueries(kShapes, queries_.data());
        glGenQueries(1, &object_);
        glGenBuffers(1, &buffer_);
        glBindBuffer(GL_ARRAY_BUFFER, buffer_);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(scene.triangles.size() * sizeof(Point)),
                     scene.triangles.data(), GL_STATIC_DRAW);
        glVertexPointer(3, GL_FLOAT, 0, nullptr);
        ask(0, kShapes);
        read(0, kShapes, [this](std::size_t i, GLuint samples) { visible_[i] = samples; });
        glDisable(GL_DEPTH_TEST);
        ask(0, kShapes);
        read(0, kShapes, [this](std::size_t i, GLuint samples) { projected_[i] = samples; });
        glEnable(GL_DEPTH_TEST);
    }
    ~Asker() {
        glDeleteQueries(kShapes, queries_.data());
        glDeleteQueries(1, &object_);
        glDeleteBuffers(1, &buffer_);
    }
    Asker(const Asker&) = delete;
    Asker& operator=(const Asker&) = delete;

    GLuint64 visible() const { return std::accumulate(visible_.begin(), visible_.end(), GLuint64{0}); }
    GLuint64 projected() const { return std::accumulate(projected_.begin(), projected_.end(), GLuint64{0}); }

    // <batch> questions, then their answers: 1 is stop and wait.
    void by_queries(std::size_t batch) {
        for (std::size_t first = 0; first < kShapes; first += batch) {
            ask(first, batch);
            read(first, batch, [this](std::size_t i, GLuint samples) {
                if (samples != visible_[i]) benchmarks::fail("shapes_cost: a native query: %u", samples);
            });
        }
    }
    // What no way can be faster than.
    void draw_all() const {
        glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(scene_.triangles.size()));
        glFinish();
    }
    void by_unit(GLbitfield registers) {
        records_.resize(kShapes);
        emu.shapes(registers, scene_.kind, kShapes, scene_.given.data(), nullptr, object_);
        emu.get_records(object_, 0, kShapes, records_.data());
        for (std::size_t i = 0; i < kShapes; ++i) check(registers, i);
    }

  private:
    void ask(std::size_t first, std::size_t count) const {
        for (std::size_t i = first; i < first + count; ++i) {
            glBeginQuery(GL_SAMPLES_PASSED, queries_[i]);
            glDrawArrays(GL_TRIANGLES, static_cast<GLint>(i) * scene_.vertices, scene_.vertices);
            glEndQuery(GL_SAMPLES_PASSED);
        }
    }
    template <typename Take>
    void read(std::size_t first, std::size_t count, Take take) const {
        for (std::size_t i = first; i < first + count; ++i) {
            GLuint samples = 0;
            glGetQueryObjectuiv(queries_[i], GL_QUERY_RESULT, &samples);
            take(i, samples);
        }
    }
    void check(GLbitfield registers, std::size_t i) const {
        const GLocclusionrecordEMU& record = records_[i];
        const auto is_wrong = [registers](GLbitfield bit, bool agrees) {
            return (registers & bit) != 0 && !agrees;
        };
        const bool has_pixels = record.box[2] >= record.box[0];
        if (record.registers != registers ||
            is_wrong(GL_VISIBLE_BIT_EMU, (record.visible != 0) == (visible_[i] != 0)) ||
            is_wrong(GL_VISIBLE_HITS_BIT_EMU, record.visible_hits == visible_[i]) ||
            is_wrong(GL_PROJECTED_HITS_BIT_EMU, record.projected_hits == projected_[i]) ||
            is_wrong(GL_NEAREST_DEPTH_BIT_EMU, (record.nearest_depth < 1) == (visible_[i] != 0)) ||
            is_wrong(GL_SCREEN_BOX_BIT_EMU, has_pixels == (visible_[i] != 0))) {
            benchmarks::fail("shapes_cost: record %zu: %u of %u hits visible, registers 0x%x", i,
                             static_cast<GLuint>(record.visible_hits),
                             static_cast<GLuint>(record.projected_hits), record.registers);
        }
    }

    const Scene& scene_;
    std::vector<GLuint> queries_;
    std::vector<GLuint> visible_, projected_;
    std::vector<GLocclusionrecordEMU> records_;
    GLuint object_ = 0;
    GLuint buffer_ = 0;
};

void set_up() {
    glViewport(0, 0, kWidth, kHeight);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    constexpr std::array<float, 12> kWall = {-1,         -1, -0.3F, kWallRight, -1, -0.3F,
                                             kWallRight, 1,  -0.3F, -1,         1,  -0.3F};
    glVertexPointer(3, GL_FLOAT, 0, kWall.data());
    glDrawArrays(GL_QUADS, 0, 4);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = benchmarks::rounds_of(argc, argv);
    benchmarks::make_pbuffer_context(kWidth, kHeight);
    if (!benchmarks::has_extension("GL_EMU_occlusion_unit")) {
        benchmarks::fail("shapes_cost: no GL_EMU_occlusion_unit: run it under the layer");
    }
    emu = {benchmarks::function_of_gl<PFNGLOCCLUSIONUNITSHAPESEMUPROC>("glOcclusionUnitShapesEMU"),
           benchmarks::function_of_gl<PFNGLGETOCCLUSIONRECORDSEMUPROC>("glGetOcclusionRecordsEMU")};
    set_up();
    nlohmann::ordered_json answer = {{"context", benchmarks::description_of_gl()},
                                     {"width", kWidth},
                                     {"height", kHeight},
                                     {"shapes", kShapes}};
    for (const GLenum kind : {GL_QUAD_EMU, GL_HEXAHEDRON_EMU}) {
        const Scene scene = make_scene(kind);
        Asker asker(scene);
        constexpr GLbitfield kHits = GL_PROJECTED_HITS_BIT_EMU | GL_VISIBLE_HITS_BIT_EMU;
        const std::vector<Row> rows = {
            {"native, stop and wait", 1, [&] { asker.by_queries(1); }},
            {"native, stop and wait again", 1, [&] { asker.by_queries(1); }},
            {"native, batched", 1, [&] { asker.by_queries(kShapes); }},
            {"drawing alone, one call", 1, [&] { asker.draw_all(); }},
            {"visible", 1, [&] { asker.by_unit(GL_VISIBLE_BIT_EMU); }},
            {"visible hits", 1, [&] { asker.by_unit(GL_VISIBLE_HITS_BIT_EMU); }},
            {"projected and visible hits", 1, [&] { asker.by_unit(kHits); }},
            {"nearest depth", 1, [&] { asker.by_unit(GL_NEAREST_DEPTH_BIT_EMU); }},
            {"screen box", 1, [&] { asker.by_unit(GL_SCREEN_BOX_BIT_EMU); }},
            {"all registers", 1, [&] { asker.by_unit(GL_ALL_REGISTERS_EMU); }},
        };
        answer["cases"].push_back({{"shape", scene.name},
                                   {"visible_hits", asker.visible()},
                                   {"projected_hits", asker.projected()},
                                   {"microseconds", benchmarks::measure(rows, rounds)}});
    }
    std::puts(answer.dump(1).c_str());
    return 0;
}
