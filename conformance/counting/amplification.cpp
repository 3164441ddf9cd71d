// SPDX-License-Identifier: MIT
// Draws that multiply: layers, instances, viewports, geometry and tessellation shaders (CNT-40, CNT-42,
// CNT-46).
#include <array>
#include <string>

#include "counting/counters.h"

namespace conformance {
namespace {

class AmplifiedCounts : public CountingTest {};

COUNT_WITH_EACH(AmplifiedCounts);

constexpr int kCopies = 4;

void draw_strip() {
    glBegin(GL_TRIANGLE_STRIP);
    glVertex3f(0.0f, 0.0f, kMiddle);
    glVertex3f(kSize, 0.0f, kMiddle);
    glVertex3f(0.0f, kSize, kMiddle);
    glVertex3f(kSize, kSize, kMiddle);
    glEnd();
}

// Each triangle <copies> times; <choice> is a statement about the copy's number i.
std::string copying_geometry_shader(const std::string& choice, int copies = kCopies) {
    return "#version 150 compatibility\n"
           "#extension GL_ARB_viewport_array : enable\n"
           "layout(triangles) in;\n"
           "layout(triangle_strip, max_vertices = 12) out;\n"
           "void main() {\n"
           "    for (int i = 0; i < " +
           std::to_string(copies) +
           "; ++i) {\n"
           "        for (int v = 0; v < 3; ++v) {\n"
           "            " +
           choice +
           "\n"
           "            gl_Position = gl_in[v].gl_Position;\n"
           "            gl_FrontColor = gl_in[v].gl_FrontColor;\n"
           "            EmitVertex();\n"
           "        }\n"
           "        EndPrimitive();\n"
           "    }\n"
           "}\n";
}

// Clears layer <layer> of a bound framebuffer's depth texture to <depth>.
void clear_layer(GLuint texture, int layer, float depth) {
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture, 0, layer);
    glClearDepth(depth);
    glClear(GL_DEPTH_BUFFER_BIT);
}

// CNT-46. NV 4.1.6A: "Whenever a fragment reaches this stage": of whatever primitive.
TEST_P(AmplifiedCounts, what_a_geometry_shader_emits_counts) {
    if (const auto why = lacks(32)) GTEST_SKIP() << *why;
    {
        const Program copying({.vertex = kFixedVertexSource, .geometry = copying_geometry_shader("")});
        expect_count(kCopies * kAll, draw_strip);
    }
    const Program swallowing({.vertex = kFixedVertexSource, .geometry = copying_geometry_shader("", 0)});
    expect_count(0, draw_strip);
}

// CNT-40. GL 4.5, 9.8: each layer has depths of its own; what passes in any of them counts.
TEST_P(AmplifiedCounts, the_fragments_of_all_layers_count) {
    if (const auto why = lacks(32)) GTEST_SKIP() << *why;
    GLuint texture = 0;
    GLuint framebuffer = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT24, kSize, kSize, kCopies, 0, GL_DEPTH_COMPONENT,
                 GL_FLOAT, nullptr);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    const Program program(
        {.vertex = kFixedVertexSource, .geometry = copying_geometry_shader("gl_Layer = i;")});
    for (int open = 0; open <= kCopies; ++open) {
        for (int layer = 0; layer < kCopies; ++layer) {
            clear_layer(texture, layer, layer < kCopies - open ? kNear : kFar);
        }
        glFramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture, 0);
        ASSERT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
        expect_count(static_cast<std::uint64_t>(open) * kAll, draw_strip);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
}

// CNT-40. GL 4.5, 10.4: an instanced draw is as many draws.
TEST_P(AmplifiedCounts, the_fragments_of_all_instances_count) {
    if (const auto why = lacks(31)) GTEST_SKIP() << *why;
    const Program program({.vertex = "#version 140\n"
                                     "#extension GL_ARB_compatibility : require\n"
                                     "void main() {\n"
                                     "    gl_Position = ftransform();\n"
                                     "    gl_Position.x += float(gl_InstanceID);\n"  // half a window
                                     "    gl_FrontColor = gl_Color;\n"
                                     "}\n"});
    const std::array<GLfloat, 12> corners = {0.0f, 0.0f,  kMiddle, kSize, 0.0f,  kMiddle,
                                             0.0f, kSize, kMiddle, kSize, kSize, kMiddle};
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, corners.data());
    // Instance 0 is over the whole window, 1 over its right half, the others are beside it.
    expect_count(0, [] { glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, 0); });
    expect_count(kAll, [] { glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, 1); });
    expect_count(kAll + kAll / 2, [] { glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, 5); });
    glDisableClientState(GL_VERTEX_ARRAY);
}

// CNT-42, CNT-11. ARB_viewport_array: the geometry shader chooses; each viewport has a scissor rectangle.
TEST_P(AmplifiedCounts, the_fragments_of_all_viewports_count) {
    if (const auto why = lacks(41, "GL_ARB_viewport_array")) GTEST_SKIP() << *why;
    const Program program(
        {.vertex = kFixedVertexSource, .geometry = copying_geometry_shader("gl_ViewportIndex = i;")});
    for (GLuint i = 0; i < kCopies; ++i) {
        glViewportIndexedf(i, static_cast<GLfloat>(i % 2 * kHalf), static_cast<GLfloat>(i / 2 * kHalf), kHalf,
                           kHalf);
        glScissorIndexed(i, 0, 0, kSize / 4, kSize);  // half of viewports 0 and 2, nothing of 1 and 3
    }
    expect_count(kAll, draw_strip);
    for (GLuint i = 0; i < kCopies; ++i) glEnablei(GL_SCISSOR_TEST, i);
    expect_count(2 * kAll / 8, draw_strip);
    for (GLuint i = 0; i < kCopies; i += 2) glScissorIndexed(i, 0, 0, 0, 0);
    expect_count(0, draw_strip);
}

// CNT-46. GL 4.5, 11.2: a patch is made into triangles that cover it without gaps or overlaps, however many.
TEST_P(AmplifiedCounts, what_a_tessellation_makes_counts) {
    if (const auto why = lacks(40)) GTEST_SKIP() << *why;
    const Program program({.vertex = kFixedVertexSource,
                           .evaluation =
                               "#version 400 compatibility\n"
                               "layout(quads) in;\n"
                               "uniform float extent = 1.0;\n"  // of the window
                               "void main() {\n"
                               "    gl_Position = vec4(gl_TessCoord.xy * 2.0 * extent - 1.0, 0.0, 1.0);\n"
                               "    gl_FrontColor = vec4(1.0);\n"
                               "}\n"});
    const std::array<GLfloat, 3> corner{};
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, corner.data());
    glPatchParameteri(GL_PATCH_VERTICES, 1);
    const auto patch = [] { glDrawArrays(GL_PATCHES, 0, 1); };
    for (const GLfloat level : {1.0f, 7.0f}) {
        const std::array<GLfloat, 4> levels = {level, level, level, level};
        glPatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, levels.data());
        glPatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, levels.data());
        expect_count(kAll, patch);
    }
    const std::array<GLfloat, 4> none{};
    glPatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, none.data());
    expect_count(0, patch);
    glDisableClientState(GL_VERTEX_ARRAY);
}

}  // namespace
}  // namespace conformance
