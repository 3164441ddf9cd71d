// SPDX-License-Identifier: MIT
// Primitives and their patterns: stipples, polygon modes, sizes (CNT-16 to CNT-19).
#include <array>
#include <vector>

#include "counting/counters.h"

namespace conformance {
namespace {

class PrimitiveCounts : public CountingTest {};

COUNT_WITH_EACH(PrimitiveCounts);

// CNT-16. GL 4.5 compatibility, 14.6.2: a fragment is produced where the pattern's bit is 1, else discarded.
TEST_P(PrimitiveCounts, a_polygon_stipple_lets_its_one_bits_through) {
    glEnable(GL_POLYGON_STIPPLE);
    const auto pattern = [](GLubyte bits) {
        const std::vector<GLubyte> mask(32 * 32 / 8, bits);
        glPolygonStipple(mask.data());
    };
    pattern(0xAA);
    expect_count(kAll / 2, draw_whole);
    pattern(0x80);
    expect_count(kAll / 8, draw_whole);
    pattern(0x00);
    expect_count(0, draw_whole);
}

// CNT-16. GL 4.5 compatibility, 14.5.2.1: the same along a line.
TEST_P(PrimitiveCounts, a_line_stipple_lets_its_one_bits_through) {
    const auto line = [] {
        glBegin(GL_LINES);
        glVertex3f(8.5f, 10.5f, kMiddle);
        glVertex3f(40.5f, 10.5f, kMiddle);
        glEnd();
    };
    expect_count(32, line);
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(1, 0xAAAA);
    expect_count(16, line);
    glLineStipple(4, 0x1111);
    expect_count(8, line);
    glLineStipple(1, 0x0000);
    expect_count(0, line);
}

// CNT-17. GL 4.5, 14.6.4: with LINE the edges are drawn as lines, with POINT the corners as points. Closed
// around pixel centres, each edge has one end of its own (14.5.1, the diamond-exit rule).
TEST_P(PrimitiveCounts, an_outlined_polygon_counts_its_outline) {
    const auto square = [] {
        glBegin(GL_QUADS);
        glVertex3f(8.5f, 8.5f, kMiddle);
        glVertex3f(24.5f, 8.5f, kMiddle);
        glVertex3f(24.5f, 24.5f, kMiddle);
        glVertex3f(8.5f, 24.5f, kMiddle);
        glEnd();
    };
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    expect_count(4 * 16, square);
    EXPECT_EQ(drawn_pixels(), 4 * 16);
    glClear(GL_COLOR_BUFFER_BIT);
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    expect_count(4, square);
    EXPECT_EQ(drawn_pixels(), 4);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    draw_occluder();
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    expect_count(0, [] { draw_rect({8, 8, 16, 16}, kFar); });
}

// CNT-18. GL 4.5 compatibility, 14.4.1: without smoothing a point of size s is a square of s x s fragments; a
// line of width w has w fragments at each step (14.5.2.1).
TEST_P(PrimitiveCounts, wide_points_and_lines_count_every_fragment) {
    const auto point = [](GLfloat x, GLfloat y) {
        return [=] {
            glBegin(GL_POINTS);
            glVertex3f(x, y, kMiddle);
            glEnd();
        };
    };
    glPointSize(4.0f);
    expect_count(4 * 4, point(32.0f, 32.0f));
    glPointSize(7.0f);
    expect_count(7 * 7, point(32.5f, 32.5f));
    expect_count(7 * 4, point(0.5f, 32.5f));  // the window cuts off three columns
    glLineWidth(3.0f);
    expect_count(3 * 32, [] {
        glBegin(GL_LINES);
        glVertex3f(8.5f, 10.5f, kMiddle);
        glVertex3f(40.5f, 10.5f, kMiddle);
        glEnd();
    });
}

// CNT-19. GL 4.5 compatibility, 10.8: Rect draws a polygon at z = 0.
TEST_P(PrimitiveCounts, rect_counts_as_the_polygon_does) {
    draw_occluder();
    glDepthMask(GL_FALSE);
    const auto rect = [] { glRecti(4, 8, 20, 40); };
    glTranslatef(0.0f, 0.0f, kFar);
    expect_count(0, rect);
    glLoadIdentity();
    expect_count(16 * 32, rect);
    expect_count(16 * 32, [] {
        const std::array<GLfloat, 2> one_corner = {20.0f, 40.0f};
        const std::array<GLfloat, 2> other_corner = {4.0f, 8.0f};
        glRectfv(one_corner.data(), other_corner.data());
    });
}

}  // namespace
}  // namespace conformance
