// SPDX-License-Identifier: MIT
// 17.3.5.3: "Shapes are drawn without writing to colour, depth and stencil buffers ..., with the current
// depth range, depth clamping, scissor, stencil and depth tests, polygon offset for filled polygons, face
// culling and multisample state. Nothing else applies". "No state of the GL is changed but the object <id>."
#include <limits>

#include "emu_occlusion_unit/unit_test.h"

namespace conformance {
namespace {

class ShapesState : public UnitTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(UnitTest::SetUp());
        if (!IsSkipped()) draw_left_occluder();
    }
};

// The rectangle of draw_half_hidden as a quadrilateral, and a box behind it.
constexpr std::array<GLfloat, 12> kQuad = {8, 8, kFar, 56, 8, kFar, 56, 24, kFar, 8, 24, kFar};
constexpr std::array<GLfloat, 6> kBox = {8, 8, kFar, 56, 24, 0.875f};

Record ask_shape(GLenum shape, const GLfloat* vertices) {
    const Query query;
    unit_shapes(kAllRegisters, shape, 1, vertices, nullptr, query.name());
    Record record{};
    get_records(query.name(), 0, 1, &record);
    EXPECT_TRUE(no_error());
    return record;
}

void expect_quad(const Seen& expected) {
    expect_record(ask_shape(GL_QUAD_EMU, kQuad.data()), kAllRegisters, expected);
}

TEST_F(ShapesState, shapes_write_to_no_buffer) {
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 3, 0xFF);
    glStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
    const auto picture = [] {
        std::vector<GLubyte> stencil(kAll);
        glReadPixels(0, 0, kSize, kSize, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil.data());
        return std::tuple(read_colours(), read_depths(), stencil);
    };
    const auto before = picture();
    expect_quad(kHalfHidden);
    EXPECT_EQ(picture(), before);
    GLint stencil_op = 0;
    glGetIntegerv(GL_STENCIL_PASS_DEPTH_PASS, &stencil_op);
    EXPECT_EQ(stencil_op, GL_REPLACE);
    EXPECT_EQ(get_integer(GL_STENCIL_WRITEMASK) & 0xFF, 0xFF);
    GLboolean mask = GL_FALSE;
    glGetBooleanv(GL_DEPTH_WRITEMASK, &mask);
    EXPECT_TRUE(mask);
    glDisable(GL_STENCIL_TEST);
}

TEST_F(ShapesState, the_scissor_and_stencil_tests_apply) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(24, 12, 16, 40);
    expect_quad(seen(16 * 12, {kHalf, 12, 8, 12}, kFar));
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NOTEQUAL, 0, 0xFF);
    expect_quad({});
    glStencilFunc(GL_EQUAL, 0, 0xFF);
    expect_quad(kHalfHidden);
    glDisable(GL_STENCIL_TEST);
}

TEST_F(ShapesState, the_depth_test_and_its_function_apply) {
    glDepthFunc(GL_ALWAYS);
    expect_quad(seen(768, kHalfHiddenRect, kFar));
    glDepthFunc(GL_NEVER);
    expect_quad(hidden(768));
    glDepthFunc(GL_GREATER);
    const Record record = ask_shape(GL_QUAD_EMU, kQuad.data());
    EXPECT_EQ(record.registers | GL_NEAREST_DEPTH_BIT_EMU, kAllRegisters);
    EXPECT_EQ(record.visible_hits, 384u);
    EXPECT_EQ(record.box[0], 8);
    EXPECT_EQ(record.box[2], kHalf - 1);
    glDisable(GL_DEPTH_TEST);
    expect_quad(seen(768, kHalfHiddenRect, kFar));
}

TEST_F(ShapesState, the_depth_range_clamping_and_offset_apply) {
    glDepthRange(0.0, 0.5);
    expect_quad(seen(768, kHalfHiddenRect, 0.375f));
    glDepthRange(0.0, 1.0);
    glTranslatef(0.0f, 0.0f, -1.0f);
    expect_quad({});
    glEnable(GL_DEPTH_CLAMP);
    expect_quad(seen(768, kHalfHiddenRect, 0.0f));
    glDisable(GL_DEPTH_CLAMP);
    glLoadIdentity();
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0.0f, -4096.0f);
    const float offset = ask_shape(GL_QUAD_EMU, kQuad.data()).nearest_depth;
    draw_half_hidden();
    EXPECT_EQ(offset, read_depths({40, 10, 1, 1}).front());
    EXPECT_LT(offset, kFar - 1024 * kDepthStep24);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

TEST_F(ShapesState, the_viewport_applies) {
    glViewport(0, 0, kHalf, kSize);  // eight pixels become four
    expect_quad(hidden(24 * 16 - 0));
    glViewport(kHalf, 0, kHalf, kSize);
    expect_quad(seen(24 * 16, {36, 8, 24, 16}, kFar));
    glViewport(0, 0, kSize, kSize);
}

// "Seen from outside, in a right-handed space, the faces of a hexahedron are counter-clockwise." Pixels and
// depths are left-handed; with x mirrored they are right-handed.
TEST_F(ShapesState, face_culling_leaves_one_side) {
    clear();
    glEnable(GL_CULL_FACE);
    const auto ask_box = [] { return ask_shape(GL_BOX_EMU, kBox.data()); };
    glTranslatef(kSize, 0.0f, 0.0f);
    glScalef(-1.0f, 1.0f, 1.0f);
    glCullFace(GL_BACK);
    expect_record(ask_box(), kAllRegisters, seen(768, kHalfHiddenRect, kFar));
    glCullFace(GL_FRONT);
    expect_record(ask_box(), kAllRegisters, seen(768, kHalfHiddenRect, 0.875f));
    glFrontFace(GL_CW);
    expect_record(ask_box(), kAllRegisters, seen(768, kHalfHiddenRect, kFar));
    glFrontFace(GL_CCW);
    glLoadIdentity();
    expect_record(ask_box(), kAllRegisters, seen(768, kHalfHiddenRect, kFar));
    glCullFace(GL_FRONT_AND_BACK);
    expect_record(ask_box(), kAllRegisters, {});
    glCullFace(GL_BACK);
    expect_quad(seen(768, kHalfHiddenRect, kFar));  // counter-clockwise in the window
    glCullFace(GL_FRONT);
    expect_quad({});
    glCullFace(GL_BACK);
    glDisable(GL_CULL_FACE);
}

TEST_F(ShapesState, nothing_else_applies) {
    const std::array<GLdouble, 4> nowhere = {0.0, 0.0, 0.0, -1.0};
    glClipPlane(GL_CLIP_PLANE0, nowhere.data());
    const std::vector<GLubyte> no_bits(32 * 32 / 8, 0);
    glPolygonStipple(no_bits.data());
    glAlphaFunc(GL_NEVER, 0.0f);
    for (const GLenum capability :
         {GL_CLIP_PLANE0, GL_POLYGON_STIPPLE, GL_ALPHA_TEST, GL_RASTERIZER_DISCARD, GL_POLYGON_SMOOTH,
          GL_COLOR_LOGIC_OP, GL_FOG, GL_LIGHTING, GL_TEXTURE_2D}) {
        SCOPED_TRACE(capability);
        glEnable(capability);
        expect_quad(kHalfHidden);
        EXPECT_TRUE(glIsEnabled(capability));
        glDisable(capability);
    }
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    expect_quad(kHalfHidden);
    std::array<GLint, 2> modes{};
    glGetIntegerv(GL_POLYGON_MODE, modes.data());
    EXPECT_EQ(modes, (std::array<GLint, 2>{GL_POINT, GL_POINT}));
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

TEST_F(ShapesState, the_current_program_does_not_apply) {
    const Program program({.vertex = kFixedVertexSource,
                           .fragment = "#version 120\nvoid main() { gl_FragDepth = 0.0; discard; }\n"});
    expect_quad(kHalfHidden);
    EXPECT_EQ(get_integer(GL_CURRENT_PROGRAM), static_cast<GLint>(program.name()));
}

TEST_F(ShapesState, conditional_rendering_does_not_apply) {
    const Query nothing;
    nothing.count([] {});
    glBeginConditionalRender(nothing.name(), GL_QUERY_WAIT);
    expect_quad(kHalfHidden);
    draw_rect({40, 40, 4, 4}, kNear);
    glEndConditionalRender();
    EXPECT_EQ(drawn_pixels({40, 40, 4, 4}), 0) << "the block goes on";
}

// Samples and their mask apply; the box is of pixels.
TEST_F(ShapesState, multisampling_applies) {
    if (const auto why = lacks(32)) GTEST_SKIP() << *why;
    const Framebuffer framebuffer({.samples = 4});
    draw_left_occluder();
    Seen expected = kHalfHidden;
    expected.projected *= 4;
    expected.visible *= 4;
    expect_quad(expected);
    glEnable(GL_SAMPLE_MASK);
    glSampleMaski(0, 0x2);
    expect_quad(kHalfHidden);
    glDisable(GL_SAMPLE_MASK);
}

TEST_F(ShapesState, the_far_end_applies) {
    far_depth(GL_ZERO);
    clear(0.0f);
    glDepthFunc(GL_GREATER);
    draw_rect(kLeft, 0.875f);
    expect_quad(kHalfHidden);
    const Record empty = ask_shape(GL_QUAD_EMU, std::array<GLfloat, 12>{}.data());
    EXPECT_EQ(empty.visible, 0u);
    EXPECT_EQ(empty.nearest_depth, 0.0f);
    far_depth(GL_ONE);
}

// "to layer 0"
TEST_F(ShapesState, shapes_go_to_the_first_layer) {
    if (const auto why = lacks(32)) GTEST_SKIP() << *why;
    GLuint texture = 0;
    GLuint framebuffer = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT24, kSize, kSize, 2, 0, GL_DEPTH_COMPONENT,
                 GL_FLOAT, nullptr);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    for (int layer = 0; layer < 2; ++layer) {
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture, 0, layer);
        layer == 0 ? draw_left_occluder() : draw_occluder();
    }
    glFramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture, 0);
    expect_quad(kHalfHidden);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
}

// The next drawing of the program's is what it would have been: arrays, buffers, current attributes, lists of
// vertices.
TEST_F(ShapesState, the_bindings_of_the_program_are_kept) {
    const std::array<GLfloat, 8> corners = {8, 8, 56, 8, 8, 24, 56, 24};
    std::array<GLuint, 2> buffers{};
    glGenBuffers(2, buffers.data());
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, sizeof(corners), corners.data(), GL_STATIC_DRAW);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, nullptr);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[1]);
    if (!lacks(43)) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffers[1]);
    glColor4f(0.0f, 1.0f, 0.0f, 1.0f);
    expect_quad(kHalfHidden);
    EXPECT_EQ(get_integer(GL_ARRAY_BUFFER_BINDING), static_cast<GLint>(buffers[1]));
    EXPECT_EQ(get_integer(GL_VERTEX_ARRAY_BUFFER_BINDING), static_cast<GLint>(buffers[0]));
    EXPECT_EQ(get_integer(GL_VERTEX_ARRAY_BINDING), 0);
    EXPECT_TRUE(glIsEnabled(GL_VERTEX_ARRAY));
    if (!lacks(43)) {
        GLint bound = 0;
        glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, 0, &bound);
        EXPECT_EQ(bound, static_cast<GLint>(buffers[1]));
        EXPECT_EQ(get_integer(GL_SHADER_STORAGE_BUFFER_BINDING), static_cast<GLint>(buffers[1]));
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, 0);
    }
    glDisable(GL_DEPTH_TEST);
    glClear(GL_COLOR_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    EXPECT_EQ(drawn_pixels(), 768);
    EXPECT_EQ(read_colours({10, 10, 1, 1}).front(), (std::array<GLubyte, 4>{0, 255, 0, 255}));
    glDisableClientState(GL_VERTEX_ARRAY);
    glDeleteBuffers(2, buffers.data());
}

// Other queries do not see the shapes. 17.3.5.2: while one counts primitives, no register need be determined.
TEST_F(ShapesState, queries_of_the_program_do_not_see_shapes) {
    const Query primitives(GL_PRIMITIVES_GENERATED);
    EXPECT_EQ(primitives.count([] {
        const Record record = ask_shape(GL_QUAD_EMU, kQuad.data());
        if (record.registers != 0) {
            EXPECT_EQ(record.visible_hits, kHalfHidden.visible);
        }
    }),
              0u);
}

// Numbers that are none make no sample that could be told, and no harm.
TEST_F(ShapesState, vertices_that_are_no_numbers_do_no_harm) {
    std::array<GLfloat, 12> quad = kQuad;
    quad[4] = std::numeric_limits<GLfloat>::quiet_NaN();
    quad[6] = std::numeric_limits<GLfloat>::infinity();
    ask_shape(GL_QUAD_EMU, quad.data());
    expect_quad(kHalfHidden);
}

}  // namespace
}  // namespace conformance
