// SPDX-License-Identifier: MIT
// What the Occlusion Unit's registers cost (GL_EMU_occlusion_unit), beside a native samples query of the same
// box in the same process, and beside reading marks back without the unit.
//
//     unit_cost --rounds N            JSON on standard output; tests/benchmarks/run compares
//
// Every record is checked against the driver's own counts and against marks and depths that are read back; a
// wrong one ends the program. Depth is not written, so each way finds the same scene.
#include "rounds.h"

#include <GL/glext_emu.h>

#include "box_scene.h"
#include "pbuffer_context.h"

namespace {

using benchmarks::Box;
using benchmarks::ReadBack;
using benchmarks::Registers;
using benchmarks::Row;

constexpr std::size_t kMostInBatch = 32;

struct Commands {
    PFNGLBEGINOCCLUSIONUNITEMUPROC begin;
    PFNGLENDOCCLUSIONUNITEMUPROC end;
    PFNGLGETOCCLUSIONRECORDSEMUPROC get_records;
};
Commands emu;

// How a program draws; the box is the same.
enum class Drawing { kFixedFunction, kColorWrites, kProgram };
constexpr std::array kDrawings = {Drawing::kFixedFunction, Drawing::kColorWrites, Drawing::kProgram};
const char* name_of(Drawing drawing) {
    return std::array{"fixed function", "with color writes",
                      "GLSL program"}[static_cast<std::size_t>(drawing)];
}

// A program as simple as fixed function, so that the difference is the way and not the shader.
GLuint make_program() {
    const GLuint program = glCreateProgram();
    const auto attach = [program](GLenum stage, const char* source) {
        const GLuint shader = glCreateShader(stage);
        glShaderSource(shader, 1, &source, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    };
    attach(GL_VERTEX_SHADER, "void main() { gl_Position = ftransform(); gl_FrontColor = gl_Color; }");
    attach(GL_FRAGMENT_SHADER, "void main() { gl_FragColor = gl_Color; }");
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked == GL_FALSE) benchmarks::fail("unit_cost: the program does not link");
    return program;
}

// Asks about one box, by the unit or by the driver's query, and checks each answer.
class Asker {
  public:
    Asker(const Box& box, const Registers& truth) : box_(box), truth_(truth) {
        glGenQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
        glGenQueries(static_cast<GLsizei>(objects_.size()), objects_.data());
    }
    ~Asker() {
        glDeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
        glDeleteQueries(static_cast<GLsizei>(objects_.size()), objects_.data());
    }
    Asker(const Asker&) = delete;
    Asker& operator=(const Asker&) = delete;

    // <batch> questions, then their answers: 1 is stop and wait.
    void by_query(std::size_t batch) const {
        for (std::size_t i = 0; i < batch; ++i) {
            glBeginQuery(GL_SAMPLES_PASSED, queries_[i]);
            box_.draw();
            glEndQuery(GL_SAMPLES_PASSED);
        }
        for (std::size_t i = 0; i < batch; ++i) {
            GLuint samples = 0;
            glGetQueryObjectuiv(queries_[i], GL_QUERY_RESULT, &samples);
            if (samples != truth_.visible_hits) benchmarks::fail("unit_cost: a native query: %u", samples);
        }
    }
    // True where the unit can tell all of <registers> of this box.
    bool can_tell(GLbitfield registers) const {
        emu.begin(registers, objects_[0]);
        box_.draw();
        emu.end();
        GLuint determined = 0;
        glGetQueryObjectuiv(objects_[0], GL_REGISTERS_EMU, &determined);
        return determined == registers;
    }
    void by_unit(GLbitfield registers, std::size_t batch) const {
        for (std::size_t i = 0; i < batch; ++i) {
            emu.begin(registers, objects_[i]);
            box_.draw();
            emu.end();
        }
        for (std::size_t i = 0; i < batch; ++i) {
            GLocclusionrecordEMU record{};
            emu.get_records(objects_[i], 0, 1, &record);
            check(registers, record);
        }
    }

  private:
    void check(GLbitfield registers, const GLocclusionrecordEMU& record) const {
        const auto is_wrong = [registers](GLbitfield bit, bool agrees) {
            return (registers & bit) != 0 && !agrees;
        };
        const auto texel = static_cast<GLuint>(
            std::lround(static_cast<double>(record.nearest_depth) * benchmarks::kFarTexel));
        if (record.registers == registers &&
            !is_wrong(GL_VISIBLE_BIT_EMU, record.visible == (truth_.visible_hits > 0 ? 1 : 0)) &&
            !is_wrong(GL_PROJECTED_HITS_BIT_EMU, record.projected_hits == truth_.projected_hits) &&
            !is_wrong(GL_VISIBLE_HITS_BIT_EMU, record.visible_hits == truth_.visible_hits) &&
            !is_wrong(GL_NEAREST_DEPTH_BIT_EMU, texel == truth_.nearest_texel) &&
            !is_wrong(GL_SCREEN_BOX_BIT_EMU, std::ranges::equal(record.box, truth_.box))) {
            return;
        }
        benchmarks::fail(
            "unit_cost: registers 0x%x of 0x%x: projected %llu (%llu), visible %llu (%llu), nearest %u (%u), "
            "box %d %d %d %d (%d %d %d %d); in brackets what was read back",
            record.registers, registers, static_cast<unsigned long long>(record.projected_hits),
            static_cast<unsigned long long>(truth_.projected_hits),
            static_cast<unsigned long long>(record.visible_hits),
            static_cast<unsigned long long>(truth_.visible_hits), texel, truth_.nearest_texel, record.box[0],
            record.box[1], record.box[2], record.box[3], truth_.box[0], truth_.box[1], truth_.box[2],
            truth_.box[3]);
    }

    const Box& box_;
    const Registers truth_;
    std::array<GLuint, kMostInBatch> queries_{}, objects_{};
};

void set_up() {
    glViewport(0, 0, benchmarks::kWidth, benchmarks::kHeight);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, benchmarks::kWidth, 0, benchmarks::kHeight, 0, -1);  // z is the depth in the window, 0 near
    glMatrixMode(GL_MODELVIEW);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnable(GL_DEPTH_TEST);
}

// The box has the share of it visible that it was made for, within the pixels along its outline.
void check_share(const Registers& truth, int pixels, int visible_percent) {
    const double allowed = 16 * std::sqrt(pixels);
    const double drawn = 2.0 * pixels, seen = drawn * visible_percent / 100;
    if (std::abs(static_cast<double>(truth.projected_hits) - drawn) > allowed ||
        std::abs(static_cast<double>(truth.visible_hits) - seen) > (visible_percent == 0 ? 0 : allowed)) {
        benchmarks::fail("unit_cost: a box of %d pixels, %d %% visible: projected %llu, visible %llu", pixels,
                         visible_percent, static_cast<unsigned long long>(truth.projected_hits),
                         static_cast<unsigned long long>(truth.visible_hits));
    }
}

// The nearest depth lies in another framebuffer there; see ReadBack.
void check_read_back(Registers found, const Registers& truth) {
    constexpr GLuint kRounding = 16;  // of 2^24 steps
    const GLuint nearer = std::min(found.nearest_texel, truth.nearest_texel);
    const GLuint farther = std::max(found.nearest_texel, truth.nearest_texel);
    found.nearest_texel = truth.nearest_texel;
    if (farther - nearer > kRounding || found != truth)
        benchmarks::fail("unit_cost: wrong registers are read back");
}

// As few boxes a turn as give about a millisecond; a batch of large boxes need not be long.
int asks_for(int pixels) {
    return pixels < 50'000 ? 8 : 2;
}
std::size_t batch_for(int pixels) {
    return pixels < 50'000 ? kMostInBatch : 8;
}

std::vector<Row> rows_of(const Asker& asker, ReadBack& read_back, const Box& box, const Registers& truth,
                         int pixels, Drawing drawing) {
    const int asks = asks_for(pixels);
    const std::size_t batch = batch_for(pixels);
    std::vector<Row> rows;
    const auto native = [&asker, asks] {
        for (int i = 0; i < asks; ++i) asker.by_query(1);
    };
    // A row whose registers are undetermined is left out.
    const auto unit = [&](const char* name, GLbitfield registers) {
        if (!asker.can_tell(registers)) return;
        rows.push_back({name, asks, [&asker, asks, registers] {
                            for (int i = 0; i < asks; ++i) asker.by_unit(registers, 1);
                        }});
    };
    rows.push_back({"native", asks, native});
    rows.push_back({"native again", asks, native});
    unit("visible hits", GL_VISIBLE_HITS_BIT_EMU);
    if (drawing == Drawing::kFixedFunction) {
        unit("visible", GL_VISIBLE_BIT_EMU);
        unit("projected hits", GL_PROJECTED_HITS_BIT_EMU);
        unit("nearest depth", GL_NEAREST_DEPTH_BIT_EMU);
        unit("screen box", GL_SCREEN_BOX_BIT_EMU);
    }
    unit("visible hits and screen box", GL_VISIBLE_HITS_BIT_EMU | GL_SCREEN_BOX_BIT_EMU);
    unit("projected and visible hits", GL_PROJECTED_HITS_BIT_EMU | GL_VISIBLE_HITS_BIT_EMU);
    unit("all registers", GL_ALL_REGISTERS_EMU);
    if (drawing == Drawing::kFixedFunction) {
        rows.push_back({"marks read back", asks, [&box, &read_back, &truth, asks] {
                            for (int i = 0; i < asks; ++i) {
                                if (read_back.marks(box).box != truth.box)
                                    benchmarks::fail("unit_cost: marks");
                            }
                        }});
        rows.push_back({"all read back", asks, [&box, &read_back, &truth, asks] {
                            for (int i = 0; i < asks; ++i) {
                                check_read_back(read_back.all(box), truth);
                            }
                        }});
    }
    const auto batched = static_cast<int>(batch);
    rows.push_back({"native, batched", batched, [&asker, batch] { asker.by_query(batch); }});
    rows.push_back({"native, batched again", batched, [&asker, batch] { asker.by_query(batch); }});
    const auto unit_batched = [&](const char* name, GLbitfield registers) {
        if (!asker.can_tell(registers)) return;
        rows.push_back({name, batched, [&asker, batch, registers] { asker.by_unit(registers, batch); }});
    };
    unit_batched("visible hits, batched", GL_VISIBLE_HITS_BIT_EMU);
    unit_batched("all registers, batched", GL_ALL_REGISTERS_EMU);
    return rows;
}

// One box, all rows in turn. <chosen>: only rows of these names; all if empty.
nlohmann::ordered_json measure_case(ReadBack& read_back, int pixels, int visible_percent, Drawing drawing,
                                    int rounds, const std::vector<std::string>& chosen = {}) {
    const Box box(pixels, visible_percent);
    const Registers truth = read_back.truth(box);
    check_share(truth, pixels, visible_percent);
    const Asker asker(box, truth);
    std::vector<Row> rows = rows_of(asker, read_back, box, truth, pixels, drawing);
    if (!chosen.empty()) {
        std::erase_if(
            rows, [&chosen](const Row& row) { return std::ranges::find(chosen, row.name) == chosen.end(); });
    }
    return {{"pixels", pixels},
            {"visible_percent", visible_percent},
            {"projected_hits", truth.projected_hits},
            {"visible_hits", truth.visible_hits},
            {"drawing", name_of(drawing)},
            {"microseconds", benchmarks::measure(rows, rounds)}};
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = benchmarks::rounds_of(argc, argv);
    benchmarks::make_pbuffer_context(benchmarks::kWidth, benchmarks::kHeight, 8);
    if (!benchmarks::has_extension("GL_EMU_occlusion_unit")) {
        benchmarks::fail(
            "unit_cost: no GL_EMU_occlusion_unit: run it under the layer, on a device that has it");
    }
    emu = {benchmarks::function_of_gl<PFNGLBEGINOCCLUSIONUNITEMUPROC>("glBeginOcclusionUnitEMU"),
           benchmarks::function_of_gl<PFNGLENDOCCLUSIONUNITEMUPROC>("glEndOcclusionUnitEMU"),
           benchmarks::function_of_gl<PFNGLGETOCCLUSIONRECORDSEMUPROC>("glGetOcclusionRecordsEMU")};
    set_up();
    benchmarks::draw_scene();
    const GLuint program = make_program();
    ReadBack read_back;

    nlohmann::ordered_json answer = {{"context", benchmarks::description_of_gl()}};
    for (const Drawing drawing : kDrawings) {
        glUseProgram(drawing == Drawing::kProgram ? program : 0);
        const auto color = static_cast<GLboolean>(drawing == Drawing::kColorWrites);
        glColorMask(color, color, color, color);
        for (const int pixels : {300, 8'000, 126'000}) {
            for (const int visible_percent : {0, 50, 100}) {
                if (drawing != Drawing::kFixedFunction && visible_percent != 50) continue;
                answer["cases"].push_back(measure_case(read_back, pixels, visible_percent, drawing, rounds));
            }
        }
    }
    glUseProgram(0);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    for (const int pixels : {100, 300, 1'000, 3'000, 8'000, 20'000, 50'000, 126'000, 200'000}) {
        answer["sweep"].push_back(measure_case(read_back, pixels, 50, Drawing::kFixedFunction, rounds,
                                               {"native", "native again", "visible hits and screen box",
                                                "all registers", "marks read back", "all read back"}));
    }
    std::printf("%s\n", answer.dump().c_str());
    return 0;
}
