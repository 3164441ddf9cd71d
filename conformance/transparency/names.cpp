// SPDX-License-Identifier: MIT
// No query of the implementation's own shows (XPAR-03, XPAR-04).
#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "transparency/transparency_test.h"

namespace conformance {
namespace {

class OwnNames : public TransparencyTest {};

// XPAR-03. GL 4.5, 4.2: IsQuery "returns TRUE if id is the name of a query object", and the program has made
// none.
TEST_F(OwnNames, no_name_is_a_query_that_the_program_did_not_make) {
    std::vector<GLuint> names;
    for (GLuint name = 0; name < 10'000; ++name) names.push_back(name);
    for (GLuint bit = 16; bit != 0; bit <<= 1) {
        for (GLuint near = 0; near < 64; ++near) names.insert(names.end(), {bit - near, bit + near});
    }
    for (GLuint near = 0; near < 10'000; ++near) names.push_back(~near);
    const auto is_query = [](GLuint name) { return glIsQuery(name) == GL_TRUE; };
    EXPECT_EQ(std::count_if(names.begin(), names.end(), is_query), 0);
    glDisable(GL_OCCLUSION_TEST_HP);
    EXPECT_EQ(std::count_if(names.begin(), names.end(), is_query), 0) << "with the result not yet read";
    EXPECT_TRUE(visible());
    EXPECT_EQ(std::count_if(names.begin(), names.end(), is_query), 0);
}

// XPAR-03. GL 4.5, 4.2: GenQueries "returns n previously unused query object names", and each can be used.
TEST_F(OwnNames, generated_names_are_the_programs_alone) {
    std::array<GLuint, 100> names{};
    glGenQueries(static_cast<GLsizei>(names.size()), names.data());
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
    for (const GLuint name : names) {
        EXPECT_FALSE(glIsQuery(name));
        draw_point(0, 0, kMiddle);  // for the HP test
        glBeginQuery(GL_SAMPLES_PASSED, name);
        draw_rect({0, 0, static_cast<int>(name % 20), 1}, kMiddle);
        glEndQuery(GL_SAMPLES_PASSED);
    }
    for (const GLuint name : names) {
        GLuint count = kUntouched;
        glGetQueryObjectuiv(name, GL_QUERY_RESULT, &count);
        EXPECT_EQ(count, name % 20) << name;
    }
    glDeleteQueries(static_cast<GLsizei>(names.size()), names.data());
    EXPECT_TRUE(visible());
    draw_point(0, 0, kMiddle);
    EXPECT_TRUE(visible()) << "the test has gone with the program's names";
}

// XPAR-04. GL 4.5, 4.2.1: CURRENT_QUERY is "the name of the currently active query for target, or zero".
TEST_F(OwnNames, no_query_is_current_that_the_program_did_not_begin) {
    std::vector<GLenum> targets = {GL_SAMPLES_PASSED};
    if (!lacks(30))
        targets.insert(targets.end(), {GL_PRIMITIVES_GENERATED, GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN});
    if (!lacks(33)) targets.insert(targets.end(), {GL_ANY_SAMPLES_PASSED, GL_TIME_ELAPSED, GL_TIMESTAMP});
    if (!lacks(43)) targets.push_back(GL_ANY_SAMPLES_PASSED_CONSERVATIVE);
    const auto expect_none = [&] {
        for (const GLenum target : targets) EXPECT_EQ(current_query(target), 0) << std::hex << target;
        if (lacks(40)) return;
        GLint name = -1;
        glGetQueryIndexediv(GL_SAMPLES_PASSED, 0, GL_CURRENT_QUERY, &name);
        EXPECT_EQ(name, 0);
    };
    expect_none();
    EXPECT_TRUE(visible());
    expect_none();
    draw_point(0, 0, kMiddle);
    glDisable(GL_OCCLUSION_TEST_HP);
    expect_none();
}

}  // namespace
}  // namespace conformance
