// SPDX-License-Identifier: MIT
// What a question about a region of the depth buffer costs (GL_EMU_depth_region_query), beside what a program
// does without it: glReadPixels, and the largest depth by its own hands.
//
//     region_cost --rounds N          JSON on standard output; tests/benchmarks/run compares
//
// Every answer is checked against the depth that was drawn: a wrong one ends the program.
#include "rounds.h"

#include <GL/glext_emu.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "pbuffer_context.h"

namespace {

constexpr int kWidth = 1024, kHeight = 768;
constexpr int kRegions = 64, kColumns = 8;
constexpr int kSide = 32;  // of a region, in pixels
constexpr GLuint kDepthBits = 24;

struct Commands {
    PFNGLGETDEPTHREGIONFVEMUPROC get_region;
    PFNGLGETDEPTHREGIONSFVEMUPROC get_regions;
    PFNGLQUERYDEPTHREGIONSEMUPROC query_regions;
};
Commands emu;

// Region i lies in the middle of a cell of its own; the draw for it is a square about the same middle.
int center_x(int i) {
    return kWidth * (2 * (i % kColumns) + 1) / (2 * kColumns);
}
int center_y(int i) {
    return kHeight * (2 * (i / kColumns) + 1) / (2 * kRegions / kColumns);
}
float depth_of(int i) {
    return 0.9f - 0.01f * static_cast<float>(i);
}

void draw(int i, int side) {
    const auto left = static_cast<float>(center_x(i) - side / 2), right = left + static_cast<float>(side);
    const auto bottom = static_cast<float>(center_y(i) - side / 2), top = bottom + static_cast<float>(side);
    const float depth = depth_of(i);
    glBegin(GL_QUADS);
    glVertex3f(left, bottom, depth);
    glVertex3f(right, bottom, depth);
    glVertex3f(right, top, depth);
    glVertex3f(left, top, depth);
    glEnd();
}

GLuint fixed(float depth) {
    return static_cast<GLuint>(std::lround(static_cast<double>(depth) * ((1u << kDepthBits) - 1)));
}

// What is asked and answered, apart from the timing.
struct Answers {
    std::array<GLint, 4 * kRegions> rectangles;
    std::array<GLfloat, kRegions> depths{};
    std::array<GLuint, kRegions> texels{};
    std::array<GLuint, kRegions> names{};
};
Answers answers;

// A region that its draw does not cover still shows the cleared depth.
void check_texel(int i, int draw_side, GLuint depth) {
    const GLuint expected = fixed(draw_side >= kSide ? depth_of(i) : 1.0f);
    // The driver interpolates in floats: one step of the buffer more or less.
    if (std::max(depth, expected) - std::min(depth, expected) <= 1) return;
    benchmarks::fail("region_cost: furthest depth %u of region %d after squares of %d, expected %u", depth, i,
                     draw_side, expected);
}

std::function<void()> checks_texels(int draw_side) {
    return [draw_side] {
        for (int i = 0; i < kRegions; ++i)
            check_texel(i, draw_side, answers.texels[static_cast<std::size_t>(i)]);
        answers.texels.fill(0);
    };
}

std::function<void()> checks_depths(int draw_side) {
    return [draw_side] {
        for (int i = 0; i < kRegions; ++i) {
            check_texel(i, draw_side, fixed(answers.depths[static_cast<std::size_t>(i)]));
        }
        answers.depths.fill(-1);
    };
}

const GLint* rectangle(int i) {
    return answers.rectangles.data() + 4 * i;
}

void read_raw(int i, GLuint* texels) {
    const GLint* at = rectangle(i);
    glReadPixels(at[0], at[1], at[2], at[3], GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, texels);
}

void read_furthest(int i) {
    std::array<GLuint, kSide * kSide> texels;
    read_raw(i, texels.data());
    GLuint furthest = 0;
    for (const GLuint texel : texels) furthest = std::max(furthest, texel >> 8);
    answers.texels[static_cast<std::size_t>(i)] = furthest;
}

void ask_about(int i, GLenum what) {
    const GLint* at = rectangle(i);
    emu.get_region(what, at[0], at[1], at[2], at[3], &answers.depths[static_cast<std::size_t>(i)]);
}

void draw_all(int draw_side) {
    for (int i = 0; i < kRegions; ++i) draw(i, draw_side);
}

// One region a call, and nothing drawn since the last answer.
std::vector<benchmarks::Row> rows_of_idle(int draw_side) {
    const auto raw = [] {
        std::array<GLuint, kSide * kSide> texels;
        for (int i = 0; i < kRegions; ++i) read_raw(i, texels.data());
    };
    const auto check_states = [draw_side] {
        const GLfloat expected = draw_side >= kSide ? 1 : 0;
        for (const GLfloat state : answers.depths) {
            if (state != expected) benchmarks::fail("region_cost: occluded %g, expected %g", state, expected);
        }
    };
    return {
        {"raw read", kRegions, raw},
        {"raw read again", kRegions, raw},
        {"read and compare", kRegions,
         [] {
             for (int i = 0; i < kRegions; ++i) read_furthest(i);
         },
         checks_texels(draw_side)},
        {"furthest depth", kRegions,
         [] {
             for (int i = 0; i < kRegions; ++i) ask_about(i, GL_FURTHEST_DEPTH_EMU);
         },
         checks_depths(draw_side)},
        {"occluded", kRegions,
         [] {
             for (int i = 0; i < kRegions; ++i) ask_about(i, GL_REGION_OCCLUDED_EMU);
         },
         check_states},
    };
}

// 64 draws and 64 answers, whichever way: microseconds for all of them.
std::vector<benchmarks::Row> rows_of_pending(int draw_side) {
    const auto in_rounds = [draw_side] {
        for (int i = 0; i < kRegions; ++i) {
            draw(i, draw_side);
            read_furthest(i);
        }
    };
    return {
        {"64 x draw and read", 1, in_rounds, checks_texels(draw_side)},
        {"64 x draw and read again", 1, in_rounds, checks_texels(draw_side)},
        {"64 draws, 64 reads", 1,
         [draw_side] {
             draw_all(draw_side);
             for (int i = 0; i < kRegions; ++i) read_furthest(i);
         },
         checks_texels(draw_side)},
        {"64 draws, one call", 1,
         [draw_side] {
             draw_all(draw_side);
             emu.get_regions(GL_FURTHEST_DEPTH_EMU, kRegions, answers.rectangles.data(),
                             answers.depths.data());
         },
         checks_depths(draw_side)},
        {"64 draws, 64 query objects", 1,
         [draw_side] {
             draw_all(draw_side);
             emu.query_regions(GL_FURTHEST_DEPTH_EMU, kRegions, answers.rectangles.data(),
                               answers.names.data());
             for (std::size_t i = 0; i < kRegions; ++i) {
                 GLuint bits = 0;
                 glGetQueryObjectuiv(answers.names[i], GL_QUERY_RESULT, &bits);
                 answers.depths[i] = std::bit_cast<float>(bits);
             }
         },
         checks_depths(draw_side)},
        {"64 draws and glFinish", 1,
         [draw_side] {
             draw_all(draw_side);
             glFinish();
         }},
    };
}

void set_up() {
    glViewport(0, 0, kWidth, kHeight);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, kWidth, 0, kHeight, 0, -1);  // z is the depth in the window, 0 near
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);  // each round's draws write what the last one's did
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = benchmarks::rounds_of(argc, argv);
    benchmarks::make_pbuffer_context(kWidth, kHeight, 8);
    if (!benchmarks::has_extension("GL_EMU_depth_region_query")) {
        benchmarks::fail(
            "region_cost: no GL_EMU_depth_region_query: run it under the layer, on a device that has it");
    }
    emu = {benchmarks::function_of_gl<PFNGLGETDEPTHREGIONFVEMUPROC>("glGetDepthRegionfvEMU"),
           benchmarks::function_of_gl<PFNGLGETDEPTHREGIONSFVEMUPROC>("glGetDepthRegionsfvEMU"),
           benchmarks::function_of_gl<PFNGLQUERYDEPTHREGIONSEMUPROC>("glQueryDepthRegionsEMU")};
    set_up();
    glGenQueries(kRegions, answers.names.data());
    for (int i = 0; i < kRegions; ++i) {
        const std::array at = {center_x(i) - kSide / 2, center_y(i) - kSide / 2, kSide, kSide};
        std::ranges::copy(at, answers.rectangles.data() + 4 * i);
    }

    nlohmann::ordered_json answer = {{"context", benchmarks::description_of_gl()},
                                     {"cases", nlohmann::json::array()}};
    for (const int draw_side : {20, kSide}) {
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        draw_all(draw_side);
        answer["cases"].push_back({{"draw_side", draw_side},
                                   {"idle", benchmarks::measure(rows_of_idle(draw_side), rounds)},
                                   {"pending", benchmarks::measure(rows_of_pending(draw_side), rounds)}});
    }
    std::printf("%s\n", answer.dump().c_str());
    return 0;
}
