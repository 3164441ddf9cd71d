// SPDX-License-Identifier: MIT
// Pipeline statistics: their targets, what they count and what they must not (PIPE-01 to PIPE-08).
#include <array>
#include <vector>

#include "harness/gl_test.h"
#include "harness/objects.h"
#include "harness/query.h"

namespace conformance {
namespace {

class Statistics : public GlTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
        if (const auto why = lacks(46, "GL_ARB_pipeline_statistics_query")) GTEST_SKIP() << *why;
    }
};

// Those of the eleven whose stages this machine has: the dependencies of the text take the others away.
std::vector<GLenum> targets() {
    std::vector<GLenum> all = {GL_VERTICES_SUBMITTED,        GL_PRIMITIVES_SUBMITTED,
                               GL_VERTEX_SHADER_INVOCATIONS, GL_FRAGMENT_SHADER_INVOCATIONS,
                               GL_CLIPPING_INPUT_PRIMITIVES, GL_CLIPPING_OUTPUT_PRIMITIVES};
    if (!lacks(32, "GL_ARB_geometry_shader4")) {
        all.insert(all.end(), {GL_GEOMETRY_SHADER_INVOCATIONS, GL_GEOMETRY_SHADER_PRIMITIVES_EMITTED});
    }
    if (!lacks(40, "GL_ARB_tessellation_shader")) {
        all.insert(all.end(), {GL_TESS_CONTROL_SHADER_PATCHES, GL_TESS_EVALUATION_SHADER_INVOCATIONS});
    }
    if (!lacks(43, "GL_ARB_compute_shader")) all.push_back(GL_COMPUTE_SHADER_INVOCATIONS);
    return all;
}

constexpr GLfloat kSize = kSurfaceSize;

// Two triangles over all pixels, from an array: what is submitted is no more than these six vertices.
void draw_two_triangles() {
    static constexpr std::array<GLfloat, 18> corners = {
        0, 0, kNear, kSize, 0, kNear, kSize, kSize, kNear, 0, 0, kNear, kSize, kSize, kNear, 0, kSize, kNear};
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, corners.data());
    glDrawArrays(GL_TRIANGLES, 0, 6);
}

// PIPE-01. New Tokens: the targets are "Accepted by the <target> parameter of BeginQuery, EndQuery,
// GetQueryiv, BeginQueryIndexed, EndQueryIndexed and GetQueryIndexediv".
TEST_F(Statistics, every_command_takes_every_target) {
    for (const GLenum target : targets()) {
        const Query query(target);
        EXPECT_EQ(current_query(target), 0) << target;
        query.begin();
        EXPECT_EQ(current_query(target), static_cast<GLint>(query.name())) << target;
        query.end();
        EXPECT_EQ(current_query(target), 0) << target;
        query.result();
        glBeginQueryIndexed(target, 0, query.name());
        GLint current = -1;
        glGetQueryIndexediv(target, 0, GL_CURRENT_QUERY, &current);
        EXPECT_EQ(current, static_cast<GLint>(query.name())) << target;
        glEndQueryIndexed(target, 0);
        EXPECT_TRUE(no_error()) << target;
    }
}

// PIPE-01. "An INVALID_OPERATION error is generated if <target> is a valid target other than
// PRIMITIVES_GENERATED or TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, and <index> is not zero", where GL 4.5 has
// INVALID_VALUE. Decided: either.
TEST_F(Statistics, an_index_other_than_zero_is_refused) {
    const auto was_refused = [] {
        const GLenum error = glGetError();
        return error == GL_INVALID_OPERATION || error == GL_INVALID_VALUE;
    };
    for (const GLenum target : targets()) {
        const Query query(target);
        GLint current = -1;
        glBeginQueryIndexed(target, 1, query.name());
        EXPECT_TRUE(was_refused()) << target;
        EXPECT_FALSE(glIsQuery(query.name())) << target;
        glGetQueryIndexediv(target, 1, GL_CURRENT_QUERY, &current);
        EXPECT_TRUE(was_refused()) << target;
        EXPECT_EQ(current, -1) << target;
        query.begin();
        glEndQueryIndexed(target, 1);
        EXPECT_TRUE(was_refused()) << target;
        EXPECT_EQ(current_query(target), static_cast<GLint>(query.name())) << target;
        query.end();
    }
}

// PIPE-02. GL 4.5, 4.2: a query of each target may be active.
TEST_F(Statistics, all_of_them_and_an_occlusion_query_run_at_once) {
    const Query vertices(GL_VERTICES_SUBMITTED);
    const Query primitives(GL_PRIMITIVES_SUBMITTED);
    const Query input(GL_CLIPPING_INPUT_PRIMITIVES);
    const Query samples;
    EXPECT_EQ(vertices.count([&] {
        EXPECT_EQ(primitives.count([&] {
            EXPECT_GE(input.count([&] { EXPECT_EQ(samples.count(draw_two_triangles), 4096u); }), 2u);
            EXPECT_EQ(samples.count([] {}), 0u);
        }),
                  2u);
        draw_two_triangles();
    }),
              12u);
    EXPECT_TRUE(no_error());
}

// PIPE-03. GL 4.5, 4.2: INVALID_OPERATION "if the active query object name for target is non-zero".
TEST_F(Statistics, a_second_query_of_a_target_is_refused) {
    for (const GLenum target : targets()) {
        const Query first(target);
        const Query second(target);
        first.begin();
        second.begin();
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << target;
        EXPECT_EQ(current_query(target), static_cast<GLint>(first.name())) << target;
        first.end();
        second.end();
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << target;
    }
}

// PIPE-04. 4.2.1: "if the number of bits is non-zero, the minimum number of bits allowed is 32".
TEST_F(Statistics, the_counters_have_no_bits_or_enough) {
    for (const GLenum target : targets()) {
        GLint bits = -1;
        glGetQueryiv(target, GL_QUERY_COUNTER_BITS, &bits);
        EXPECT_TRUE(bits == 0 || (bits >= 32 && bits <= 64)) << bits;
    }
}

// PIPE-05. Issue 3: no conditional rendering by pipeline statistics; GL 4.5, 10.9: INVALID_OPERATION.
TEST_F(Statistics, none_decides_conditional_rendering) {
    for (const GLenum target : targets()) {
        const Query query(target);
        query.count([] {});
        glBeginConditionalRender(query.name(), GL_QUERY_WAIT);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << target;
    }
}

// PIPE-06. Issue 23: commands that do not draw primitives by the pipeline, as Clear and TexSubImage, are not
// counted, whatever the implementation draws for them; nor what an occlusion test of old needs beneath.
TEST_F(Statistics, what_is_no_drawing_is_not_counted) {
    constexpr GLenum kOcclusionTest = 0x8165;
    constexpr GLenum kOcclusionTestResult = 0x8166;
    const std::vector<GLubyte> texels(4 * 16 * 16, 255);
    const bool has_hp = !lacks("GL_HP_occlusion_test");
    for (const GLenum target : {GL_VERTICES_SUBMITTED, GL_PRIMITIVES_SUBMITTED}) {
        const Query query(target);
        const GLuint drawn = target == GL_VERTICES_SUBMITTED ? 6u : 2u;
        EXPECT_EQ(query.count([&] {
            clear();
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
            glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 16, 16, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
            glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 16, 16);
            glGenerateMipmap(GL_TEXTURE_2D);
            read_colours();
            const Query samples;
            if (has_hp) glEnable(kOcclusionTest);
            draw_two_triangles();
            GLboolean flag = GL_FALSE;
            if (has_hp) glGetBooleanv(kOcclusionTestResult, &flag);
            EXPECT_EQ(flag == GL_TRUE, has_hp);
            if (has_hp) glDisable(kOcclusionTest);
            samples.count([] {});
        }),
                  drawn);
    }
}

// PIPE-07. 15.3: "the counter is incremented every time the fragment shader is invoked"; 15.2 allows more
// invocations. Decided: one a drawn pixel at least, and none where nothing is drawn.
TEST_F(Statistics, fragments_are_counted_at_least_once_a_pixel) {
    const Program program({.vertex = kFixedVertexSource,
                           .fragment = "#version 120\nvoid main() { gl_FragColor = gl_Color; }\n"});
    const Query query(GL_FRAGMENT_SHADER_INVOCATIONS);
    EXPECT_EQ(query.count([] {}), 0u);
    EXPECT_GE(query.count([] { draw_rect({3, 3, 10, 10}, kNear); }), 100u);
    EXPECT_GE(query.count([] { draw_rect(kWhole, kNear); }), 4096u);
}

// PIPE-08. 10.11: every vertex transferred to the GL is counted, and every point, line, triangle, or patch.
TEST_F(Statistics, submitted_vertices_and_primitives_are_counted_exactly) {
    const Query vertices(GL_VERTICES_SUBMITTED);
    const Query primitives(GL_PRIMITIVES_SUBMITTED);
    for (const int times : {0, 1, 7}) {
        const auto draw = [&] {
            for (int i = 0; i < times; ++i) draw_two_triangles();
        };
        EXPECT_EQ(vertices.count(draw), static_cast<GLuint>(6 * times));
        EXPECT_EQ(primitives.count(draw), static_cast<GLuint>(2 * times));
    }
}

// PIPE-08. 19.2: "the counter is incremented every time the compute shader is invoked".
TEST_F(Statistics, compute_invocations_are_counted_exactly) {
    if (const auto why = lacks(43)) GTEST_SKIP() << *why;
    const char* const source = "#version 430\nlayout(local_size_x = 4) in;\nvoid main() {}\n";
    const GLuint program = glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &source);
    const Query query(GL_COMPUTE_SHADER_INVOCATIONS);
    glUseProgram(program);
    EXPECT_EQ(query.count([] { glDispatchCompute(2, 3, 1); }), 24u);
    EXPECT_EQ(query.count([] {}), 0u);
    glUseProgram(0);
    glDeleteProgram(program);
}

}  // namespace
}  // namespace conformance
