// SPDX-License-Identifier: MIT
// A region query changes nothing and is changed by nothing: pixel state, bindings, lists, queries,
// conditions.
#include <cstring>

#include "emu_depth_region_query/region_test.h"

namespace conformance {
namespace {

using RegionUndisturbed = RegionTest;

// "No pixel storage or transfer state affects the query", and it changes none
TEST_F(RegionUndisturbed, pixel_state_neither_matters_nor_changes) {
    put_depth(kWhole, kTwoFifths);
    put_depth({33, 20, 1, 1}, kFourFifths);
    constexpr GLenum kStores[] = {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS,
                                  GL_PACK_ALIGNMENT};
    constexpr GLint kValues[] = {100, 3, 5, 8};
    for (int i = 0; i < 4; ++i) glPixelStorei(kStores[i], kValues[i]);
    glPixelStorei(GL_PACK_SWAP_BYTES, GL_TRUE);
    glPixelTransferf(GL_DEPTH_SCALE, 0.25f);
    glPixelTransferf(GL_DEPTH_BIAS, 0.5f);
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    glBufferData(GL_PIXEL_PACK_BUFFER, 16, nullptr, GL_STREAM_READ);

    EXPECT_NEAR(furthest({0, 0, 33, 63}), kTwoFifths, kLittle);
    EXPECT_NEAR(furthest({3, 5, 31, 33}), kFourFifths, kLittle);
    const Rect rects[] = {{1, 1, 31, 3}, {30, 19, 5, 5}, {34, 20, 2, 2}};
    GLfloat values[3] = {};
    get_regions(GL_FURTHEST_DEPTH_EMU, 3, rects, values);
    EXPECT_NEAR(values[0], kTwoFifths, kLittle);
    EXPECT_NEAR(values[1], kFourFifths, kLittle);
    EXPECT_NEAR(values[2], kTwoFifths, kLittle);

    for (int i = 0; i < 4; ++i) EXPECT_EQ(get_integer(kStores[i]), kValues[i]);
    EXPECT_EQ(get_integer(GL_PACK_SWAP_BYTES), GL_TRUE);
    EXPECT_EQ(get_integer(GL_PIXEL_PACK_BUFFER_BINDING), static_cast<GLint>(buffer));
    GLfloat transfer[2] = {};
    glGetFloatv(GL_DEPTH_SCALE, &transfer[0]);
    glGetFloatv(GL_DEPTH_BIAS, &transfer[1]);
    EXPECT_EQ(transfer[0], 0.25f);
    EXPECT_EQ(transfer[1], 0.5f);
    glDeleteBuffers(1, &buffer);
}

// "Scissor, masks and tests do not affect the query"
TEST_F(RegionUndisturbed, per_fragment_state_does_not_matter) {
    put_depth(kWhole, kTwoFifths);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 1, 1);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NEVER, 0, 0);
    glDepthMask(GL_FALSE);
    glDepthRange(0.9, 1.0);
    EXPECT_EQ(occluded(kWhole), 1.0f);
    EXPECT_NEAR(furthest(kWhole), kTwoFifths, kLittle);
    EXPECT_TRUE(glIsEnabled(GL_SCISSOR_TEST));
}

// "... counts in no occlusion query", and conditional rendering does not discard it
TEST_F(RegionUndisturbed, queries_and_conditions_do_not_see_it) {
    put_depth(kWhole, kTwoFifths);
    const Query query;
    query.begin();
    EXPECT_EQ(occluded(kWhole), 1.0f);
    draw_rect({0, 0, 4, 4}, kFifth);
    EXPECT_EQ(occluded(kWhole), 1.0f);
    query.end();
    EXPECT_EQ(query.result(), 16u);
    const Query nothing;
    nothing.count([] {});
    glBeginConditionalRender(nothing.name(), GL_QUERY_WAIT);
    EXPECT_NEAR(furthest(kWhole), kTwoFifths, kLittle);
    glEndConditionalRender();
}

// As both above, where the framebuffer is multisampled.
TEST_F(RegionUndisturbed, a_multisampled_framebuffer_is_asked_unseen) {
    if (get_integer(GL_MAX_SAMPLES) < 4) GTEST_SKIP() << "needs four samples";
    const Framebuffer framebuffer({.samples = 4});
    put_depth(kWhole, kTwoFifths);
    const Query nothing;
    nothing.count([] {});
    const Program program({.fragment = "#version 120\nvoid main() { gl_FragColor = vec4(1.0); }\n"});
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 1, 1);
    glActiveTexture(GL_TEXTURE3);
    const Query query;
    query.begin();
    glBeginConditionalRender(nothing.name(), GL_QUERY_WAIT);
    EXPECT_NEAR(furthest(kWhole), kTwoFifths, kLittle);
    glEndConditionalRender();
    query.end();
    EXPECT_EQ(query.result(), 0u);
    EXPECT_EQ(get_integer(GL_CURRENT_PROGRAM), static_cast<GLint>(program.name()));
    EXPECT_EQ(get_integer(GL_ACTIVE_TEXTURE), GL_TEXTURE3);
    EXPECT_EQ(get_integer(GL_DRAW_FRAMEBUFFER_BINDING), static_cast<GLint>(framebuffer.name()));
    EXPECT_EQ(get_integer(GL_READ_FRAMEBUFFER_BINDING), static_cast<GLint>(framebuffer.name()));
    EXPECT_TRUE(glIsEnabled(GL_SCISSOR_TEST));
}

// "Commands of this extension are executed at once; none is compiled"
TEST_F(RegionUndisturbed, lists_hold_none_of_the_commands) {
    put_depth(kWhole, kTwoFifths);
    glPixelTransferf(GL_DEPTH_BIAS, 0.125f);
    GLuint id = 0;
    glGenQueries(1, &id);
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    far_depth(GL_ZERO);
    const GLfloat at_once = furthest(kWhole);
    query_regions(GL_FURTHEST_DEPTH_EMU, 1, &kWhole, &id);
    glEndList();
    EXPECT_NEAR(at_once, kTwoFifths, kLittle);
    EXPECT_EQ(get_integer(GL_FAR_DEPTH_EMU), GL_ZERO);
    EXPECT_EQ(glIsQuery(id), GL_TRUE);

    far_depth(GL_ONE);
    glDeleteQueries(1, &id);
    glPixelTransferf(GL_DEPTH_BIAS, 0.25f);
    const GLuint64 before = pixels_read();
    glCallList(list);
    EXPECT_EQ(get_integer(GL_FAR_DEPTH_EMU), GL_ONE);
    EXPECT_EQ(pixels_read(), before);
    GLfloat bias = 0;
    glGetFloatv(GL_DEPTH_BIAS, &bias);
    EXPECT_EQ(bias, 0.25f);
    glDeleteLists(list, 1);
}

class RegionCore : public GlTest {
  protected:
    ContextWish wish() const override { return {.api = Api::kCore, .major = 3, .minor = 3}; }
    void prepare() override {}
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
        if (IsSkipped()) return;
        if (const auto why = lacks("GL_EMU_depth_region_query")) GTEST_SKIP() << *why;
    }
};

// "OpenGL 3.0 ... core profile"
TEST_F(RegionCore, a_core_profile_answers_too) {
    put_depth(kWhole, kTwoFifths);
    put_depth({5, 5, 1, 1}, 1.0f);
    EXPECT_EQ(occluded(kWhole), 0.0f);
    EXPECT_EQ(occluded({6, 0, 58, 64}), 1.0f);
    EXPECT_NEAR(furthest({6, 0, 58, 64}), kTwoFifths, kLittle);
    EXPECT_EQ(get_integer(GL_FAR_DEPTH_EMU), GL_ONE);
}

}  // namespace
}  // namespace conformance
