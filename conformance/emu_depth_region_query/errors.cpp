// SPDX-License-Identifier: MIT
// What every form of the question refuses, and that nothing is written then.
#include <functional>

#include "emu_depth_region_query/region_test.h"

namespace conformance {
namespace {

// Runs a command of each form; fails where it raises another error than <expected>, or writes.
class RegionErrors : public RegionTest {
  protected:
    void expect_refused(GLenum expected, GLenum pname, GLsizei count, const Rect* rects) {
        std::array<GLfloat, 4> values{kUnwritten, kUnwritten, kUnwritten, kUnwritten};
        const auto untouched = values;
        get_regions(pname, count, rects, values.data());
        EXPECT_TRUE(error_is(expected)) << "GetDepthRegionsfvEMU";
        if (count == 1) {
            get_region(pname, rects[0], values.data());
            EXPECT_TRUE(error_is(expected)) << "GetDepthRegionfvEMU";
        }
        EXPECT_EQ(values, untouched);

        std::array<GLuint, 4> ids{};
        glGenQueries(4, ids.data());
        query_regions(pname, count, rects, ids.data());
        EXPECT_TRUE(error_is(expected)) << "QueryDepthRegionsEMU";
        for (const GLuint id : ids) EXPECT_EQ(glIsQuery(id), GL_FALSE);
        glDeleteQueries(4, ids.data());

        GLuint buffer = 0;
        const std::array<GLuint, 4> marks{kUntouched, kUntouched, kUntouched, kUntouched};
        glGenBuffers(1, &buffer);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        glBufferData(GL_ARRAY_BUFFER, sizeof marks, marks.data(), GL_STREAM_READ);
        query_regions_into(pname, count, rects, buffer, 0);
        EXPECT_TRUE(error_is(expected)) << "QueryDepthRegionsBufferEMU";
        auto held = marks;
        glGetBufferSubData(GL_ARRAY_BUFFER, 0, sizeof held, held.data());
        EXPECT_EQ(held, marks);
        glDeleteBuffers(1, &buffer);
    }
};

// "INVALID_ENUM ... <pname> is not REGION_OCCLUDED_EMU, FURTHEST_DEPTH_EMU or NEAREST_DEPTH_EMU"
TEST_F(RegionErrors, another_question_is_refused) {
    for (const GLenum pname : {GL_DEPTH_REGION_EMU, GL_FAR_DEPTH_EMU, GL_DEPTH_COMPONENT, 0}) {
        expect_refused(GL_INVALID_ENUM, static_cast<GLenum>(pname), 1, &kWhole);
    }
}

// "INVALID_VALUE ... width or height of a rectangle is negative"
TEST_F(RegionErrors, a_negative_size_is_refused_wherever_it_stands) {
    for (const GLenum pname : kEachQuestion) {
        const Rect narrow = {0, 0, -1, 4};
        const Rect low = {0, 0, 4, -1};
        expect_refused(GL_INVALID_VALUE, pname, 1, &narrow);
        expect_refused(GL_INVALID_VALUE, pname, 1, &low);
        const Rect rects[] = {kWhole, kWhole, low};
        expect_refused(GL_INVALID_VALUE, pname, 3, rects);
    }
}

// "INVALID_VALUE ... <count> is negative or greater than MAX_DEPTH_REGIONS_EMU"
TEST_F(RegionErrors, a_count_outside_the_limit_is_refused) {
    expect_refused(GL_INVALID_VALUE, GL_FURTHEST_DEPTH_EMU, -1, nullptr);
    const GLint most = get_integer(GL_MAX_DEPTH_REGIONS_EMU);
    const std::vector<Rect> rects(static_cast<std::size_t>(most) + 1, Rect{0, 0, 1, 1});
    expect_refused(GL_INVALID_VALUE, GL_FURTHEST_DEPTH_EMU, most + 1, rects.data());
}

// "INVALID_FRAMEBUFFER_OPERATION ... the draw framebuffer is not complete"
TEST_F(RegionErrors, an_incomplete_framebuffer_is_refused) {
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    for (const GLenum pname : kEachQuestion) {
        expect_refused(GL_INVALID_FRAMEBUFFER_OPERATION, pname, 1, &kWhole);
    }
    glDeleteFramebuffers(1, &framebuffer);
}

// "INVALID_OPERATION ... the draw framebuffer has no depth buffer"
TEST_F(RegionErrors, a_framebuffer_without_depths_is_refused) {
    const Framebuffer without({.depth_stencil = false});
    for (const GLenum pname : kEachQuestion) expect_refused(GL_INVALID_OPERATION, pname, 1, &kWhole);
}

// As above, of the default framebuffer.
TEST_F(RegionErrors, a_surface_without_depths_is_refused) {
    const Surface without({.depth_bits = 0, .stencil_bits = 0});
    if (!without) GTEST_SKIP() << "no surface without depth";
    come_back(without);
    if (get_integer(GL_DEPTH_BITS) != 0) GTEST_SKIP() << "a surface has depth whether asked for or not";
    expect_refused(GL_INVALID_OPERATION, GL_FURTHEST_DEPTH_EMU, 1, &kWhole);
    come_back();
}

// "INVALID_OPERATION ... between Begin and End"
TEST_F(RegionErrors, every_command_is_refused_between_begin_and_end) {
    GLfloat value = kUnwritten;
    GLuint id = 0;
    glGenQueries(1, &id);
    const std::function<void()> commands[] = {
        [] { far_depth(GL_ZERO); },
        [&] { get_region(GL_FURTHEST_DEPTH_EMU, kWhole, &value); },
        [&] { get_regions(GL_FURTHEST_DEPTH_EMU, 1, &kWhole, &value); },
        [&] { query_regions(GL_FURTHEST_DEPTH_EMU, 1, &kWhole, &id); },
        [] { query_regions_into(GL_FURTHEST_DEPTH_EMU, 1, &kWhole, 1, 0); },
    };
    for (const auto& command : commands) {
        glBegin(GL_POINTS);
        command();
        glEnd();
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    }
    EXPECT_EQ(value, kUnwritten);
    EXPECT_EQ(glIsQuery(id), GL_FALSE);
    EXPECT_EQ(get_integer(GL_FAR_DEPTH_EMU), GL_ONE);
    glDeleteQueries(1, &id);
}

// GL 4.5, 2.3.1: the first error stays until it is asked for; an answer is given all the same.
TEST_F(RegionErrors, an_error_that_is_pending_stays_and_hides_nothing) {
    put_depth(kWhole, kTwoFifths);
    glEnable(GL_DEPTH);  // no capability
    EXPECT_EQ(occluded(kWhole), 1.0f);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_TRUE(no_error());
}

// "A <count> of zero asks nothing"
TEST_F(RegionErrors, a_count_of_zero_asks_nothing) {
    get_regions(GL_FURTHEST_DEPTH_EMU, 0, nullptr, nullptr);
    query_regions(GL_FURTHEST_DEPTH_EMU, 0, nullptr, nullptr);
    EXPECT_TRUE(no_error());
    EXPECT_EQ(pixels_read(), 0u);
}

}  // namespace
}  // namespace conformance
