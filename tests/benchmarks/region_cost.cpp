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

// A region that its draw does not cover still shows the cleared depth.
void check(int i, int draw_side, GLuint depth, const char* way) {
    const GLuint expected = fixed(draw_side >= kSide ? depth_of(i) : 1.0f);
    // The driver interpolates in floats: one step of the buffer more or less.
    if (std::max(depth, expected) - std::min(depth, expected) <= 1) return;
    benchmarks::fail("region_cost: %s: furthest depth %u of region %d after squares of %d, expected %u", way,
                     depth, i, draw_side, expected);
}

void read_raw(int i, GLuint* texels) {
    glReadPixels(center_x(i) - kSide / 2, center_y(i) - kSide / 2, kSide, kSide, GL_DEPTH_STENCIL,
                 GL_UNSIGNED_INT_24_8, texels);
}

GLuint furthest_by_reading(int i) {
    std::array<GLuint, kSide * kSide> texels;
    read_raw(i, texels.data());
    GLuint furthest = 0;
    for (const GLuint texel : texels) furthest = std::max(furthest, texel >> 8);
    return furthest;
}

std::array<GLint, 4> rectangle(int i) {
    return {center_x(i) - kSide / 2, center_y(i) - kSide / 2, kSide, kSide};
}

std::array<GLint, 4 * kRegions> all_rectangles() {
    std::array<GLint, 4 * kRegions> all;
    for (int i = 0; i < kRegions; ++i) std::ranges::copy(rectangle(i), all.data() + 4 * i);
    return all;
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
    return {
        {"raw read", kRegions, raw},
        {"raw read again", kRegions, raw},
        {"read and compare", kRegions,
         [=] {
             for (int i = 0; i < kRegions; ++i) check(i, draw_side, furthest_by_reading(i), "read");
         }},
        {"furthest depth", kRegions,
         [=] {
             for (int i = 0; i < kRegions; ++i) {
                 GLfloat depth = -1;
                 emu.get_region(GL_FURTHEST_DEPTH_EMU, center_x(i) - kSide / 2, center_y(i) - kSide / 2,
                                kSide, kSide, &depth);
                 check(i, draw_side, fixed(depth), "one region");
             }
         }},
        {"occluded", kRegions,
         [=] {
             for (int i = 0; i < kRegions; ++i) {
                 GLfloat occluded = -1;
                 emu.get_region(GL_REGION_OCCLUDED_EMU, center_x(i) - kSide / 2, center_y(i) - kSide / 2,
                                kSide, kSide, &occluded);
                 if ((occluded == 1) != (draw_side >= kSide))
                     benchmarks::fail("region_cost: occluded %g", occluded);
             }
         }},
    };
}

// 64 draws and 64 answers, whichever way: microseconds for all of them.
std::vector<benchmarks::Row> rows_of_pending(int draw_side, const std::array<GLuint, kRegions>& names) {
    const auto in_rounds = [=] {
        for (int i = 0; i < kRegions; ++i) {
            draw(i, draw_side);
            check(i, draw_side, furthest_by_reading(i), "draw and read");
        }
    };
    return {
        {"64 x draw and read", 1, in_rounds},
        {"64 x draw and read again", 1, in_rounds},
        {"64 draws, 64 reads", 1,
         [=] {
             draw_all(draw_side);
             for (int i = 0; i < kRegions; ++i) check(i, draw_side, furthest_by_reading(i), "reads");
         }},
        {"64 draws, one call", 1,
         [=] {
             draw_all(draw_side);
             const auto rectangles = all_rectangles();
             std::array<GLfloat, kRegions> depths{};
             emu.get_regions(GL_FURTHEST_DEPTH_EMU, kRegions, rectangles.data(), depths.data());
             for (int i = 0; i < kRegions; ++i)
                 check(i, draw_side, fixed(depths[static_cast<std::size_t>(i)]), "one call");
         }},
        {"64 draws, 64 query objects", 1,
         [=] {
             draw_all(draw_side);
             const auto rectangles = all_rectangles();
             emu.query_regions(GL_FURTHEST_DEPTH_EMU, kRegions, rectangles.data(), names.data());
             for (int i = 0; i < kRegions; ++i) {
                 GLuint bits = 0;
                 glGetQueryObjectuiv(names[static_cast<std::size_t>(i)], GL_QUERY_RESULT, &bits);
                 check(i, draw_side, fixed(std::bit_cast<float>(bits)), "query objects");
             }
         }},
        {"64 draws and glFinish", 1,
         [=] {
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
    std::array<GLuint, kRegions> names{};
    glGenQueries(kRegions, names.data());

    nlohmann::ordered_json answer = {{"context", benchmarks::description_of_gl()},
                                     {"cases", nlohmann::json::array()}};
    for (const int draw_side : {20, kSide}) {
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        draw_all(draw_side);
        answer["cases"].push_back(
            {{"draw_side", draw_side},
             {"idle", benchmarks::measure(rows_of_idle(draw_side), rounds)},
             {"pending", benchmarks::measure(rows_of_pending(draw_side, names), rounds)}});
    }
    std::printf("%s\n", answer.dump().c_str());
    return 0;
}
