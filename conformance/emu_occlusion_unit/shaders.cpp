// SPDX-License-Identifier: MIT
// Programs of every kind: what a shader places, discards and assigns is what the unit sees.
#include <string_view>

#include "emu_occlusion_unit/unit_test.h"

namespace conformance {
namespace {

class UnitShaders : public UnitTest {};

// 17.3.5.1: left after "discard by a fragment shader".
TEST_F(UnitShaders, what_a_shader_discards_is_not_even_projected) {
    const Program program({.vertex = kFixedVertexSource,
                           .fragment = "#version 120\n"
                                       "void main() {\n"
                                       "    if (gl_FragCoord.y < 16.0) discard;\n"
                                       "    gl_FragColor = vec4(1.0);\n"
                                       "}\n"});
    draw_left_occluder();
    expect_seen(seen(48 * 8, {kHalf, 16, 24, 8}, kFar), draw_half_hidden);
}

// 17.3.5.1: the depth includes "a depth that a shader assigns".
TEST_F(UnitShaders, an_assigned_depth_is_what_counts) {
    draw_left_occluder();
    const Program program({.vertex = kFixedVertexSource,
                           .fragment = "#version 120\n"
                                       "void main() {\n"
                                       "    gl_FragColor = vec4(1.0);\n"
                                       "    gl_FragDepth = gl_FragCoord.x < 16.0 ? 0.25 : 0.625;\n"
                                       "}\n"});
    expect_seen({.projected = 48 * 16, .visible = 8 * 16 + 24 * 16, .nearest = kNear, .box = {8, 8, 55, 23}},
                draw_half_hidden);
}

// 17.3.5.1: "With early fragment tests the unit is stepped where the early depth test is, before the shader."
TEST_F(UnitShaders, with_early_tests_a_discarded_sample_counts) {
    if (const auto why = lacks(42, "GL_ARB_shader_image_load_store")) GTEST_SKIP() << *why;
    const Program program({.vertex = kFixedVertexSource,
                           .fragment = "#version 420 compatibility\n"
                                       "layout(early_fragment_tests) in;\n"
                                       "void main() {\n"
                                       "    if (gl_FragCoord.y < 16.0) discard;\n"
                                       "    gl_FragColor = vec4(1.0);\n"
                                       "}\n"});
    draw_left_occluder();
    expect_seen(kHalfHidden, draw_half_hidden);
}

// With early tests and nothing discarded, an assigned depth is without effect (GL 4.5, 14.9.4).
TEST_F(UnitShaders, with_early_tests_an_assigned_depth_does_not_count) {
    if (const auto why = lacks(42, "GL_ARB_shader_image_load_store")) GTEST_SKIP() << *why;
    const Program program({.vertex = kFixedVertexSource,
                           .fragment = "#version 420 compatibility\n"
                                       "layout(early_fragment_tests) in;\n"
                                       "void main() {\n"
                                       "    gl_FragColor = vec4(1.0);\n"
                                       "    gl_FragDepth = 0.125;\n"
                                       "}\n"});
    draw_left_occluder();
    expect_seen(kHalfHidden, draw_half_hidden);
}

TEST_F(UnitShaders, a_vertex_shader_places_what_is_seen) {
    const Program program({.vertex = "#version 130\n"
                                     "uniform vec3 offset;\n"
                                     "void main() {\n"
                                     "    gl_Position = ftransform() + vec4(offset, 0.0);\n"
                                     "    gl_FrontColor = gl_Color;\n"
                                     "}\n"});
    const GLint offset = glGetUniformLocation(program.name(), "offset");
    glUniform3f(offset, 0.0f, 0.0f, 0.0f);
    draw_left_occluder();
    glUniform3f(offset, -0.5f, 0.25f, -0.25f);  // 16 pixels left, 8 up, 1/8 nearer
    expect_seen(seen(40 * 16, {kHalf, 16, 8, 16}, 0.625f),
                draw_half_hidden);  // eight columns leave the window
}

// Each triangle twice, side by side.
constexpr const char* kTwiceSource =
    "#version 150 compatibility\n"
    "layout(triangles) in;\n"
    "layout(triangle_strip, max_vertices = 6) out;\n"
    "void main() {\n"
    "    for (int copy = 0; copy < 2; ++copy) {\n"
    "        for (int v = 0; v < 3; ++v) {\n"
    "            gl_Position = gl_in[v].gl_Position + vec4(0.0, float(copy), -0.5 * float(copy), 0.0);\n"
    "            gl_FrontColor = gl_in[v].gl_FrontColor;\n"
    "            EmitVertex();\n"
    "        }\n"
    "        EndPrimitive();\n"
    "    }\n"
    "}\n";

TEST_F(UnitShaders, what_a_geometry_shader_emits_is_seen) {
    if (const auto why = lacks(32)) GTEST_SKIP() << *why;
    draw_left_occluder();
    const Program program({.vertex = kFixedVertexSource, .geometry = kTwiceSource});
    // The copy is half a window higher, and at 0.75 - 0.25: hidden by the equal depth on the left.
    expect_seen(
        {.projected = 2 * 768, .visible = 2 * 384, .nearest = kMiddle, .box = {kHalf, 8, 55, kHalf + 23}},
        draw_half_hidden_strip);
}

TEST_F(UnitShaders, what_a_tessellation_makes_is_seen) {
    if (const auto why = lacks(40)) GTEST_SKIP() << *why;
    draw_left_occluder();
    const Program program({.vertex = kFixedVertexSource,
                           .evaluation =
                               "#version 400 compatibility\n"
                               "layout(quads) in;\n"
                               "void main() {\n"
                               "    vec2 pixel = vec2(8.0, 8.0) + gl_TessCoord.xy * vec2(48.0, 16.0);\n"
                               "    gl_Position = vec4(pixel / 32.0 - 1.0, 0.5, 1.0);\n"
                               "    gl_FrontColor = vec4(1.0);\n"
                               "}\n"});
    const std::array<GLfloat, 3> corner{};
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, corner.data());
    glPatchParameteri(GL_PATCH_VERTICES, 1);
    const std::array<GLfloat, 4> levels = {4.0f, 4.0f, 4.0f, 4.0f};
    glPatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, levels.data());
    glPatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, levels.data());
    expect_seen(kHalfHidden, [] { glDrawArrays(GL_PATCHES, 0, 1); });
    glDisableClientState(GL_VERTEX_ARRAY);
}

TEST_F(UnitShaders, separable_programs_are_programs) {
    if (const auto why = lacks(41, "GL_ARB_separate_shader_objects")) GTEST_SKIP() << *why;
    const char* vertex =
        "#version 410 compatibility\n"
        "out gl_PerVertex { vec4 gl_Position; vec4 gl_FrontColor; };\n"
        "void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; "
        "gl_FrontColor = gl_Color; }\n";
    const char* fragment =
        "#version 410 compatibility\n"
        "void main() {\n"
        "    if (gl_FragCoord.y < 16.0) discard;\n"
        "    gl_FragColor = vec4(1.0);\n"
        "}\n";
    draw_left_occluder();
    const std::array programs = {glCreateShaderProgramv(GL_VERTEX_SHADER, 1, &vertex),
                                 glCreateShaderProgramv(GL_FRAGMENT_SHADER, 1, &fragment)};
    GLuint pipeline = 0;
    glGenProgramPipelines(1, &pipeline);
    glUseProgramStages(pipeline, GL_VERTEX_SHADER_BIT, programs[0]);
    glUseProgramStages(pipeline, GL_FRAGMENT_SHADER_BIT, programs[1]);
    glBindProgramPipeline(pipeline);
    ASSERT_TRUE(no_error());
    expect_seen(seen(48 * 8, {kHalf, 16, 24, 8}, kFar), draw_half_hidden);
    EXPECT_EQ(get_integer(GL_PROGRAM_PIPELINE_BINDING), static_cast<GLint>(pipeline));
    glBindProgramPipeline(0);
    glDeleteProgramPipelines(1, &pipeline);
    for (const GLuint program : programs) glDeleteProgram(program);
}

void load_assembly(GLenum target, GLuint name, std::string_view text) {
    glBindProgramARB(target, name);
    glProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, static_cast<GLsizei>(text.size()), text.data());
    ASSERT_TRUE(no_error()) << text;
    glEnable(target);
}

// ARB_vertex_program, ARB_fragment_program: KIL takes the lower half of the rectangle; the vertices are as
// they were.
TEST_F(UnitShaders, assembly_programs_are_programs) {
    if (const auto why = lacks("GL_ARB_fragment_program")) GTEST_SKIP() << *why;
    draw_left_occluder();
    std::array<GLuint, 2> names{};
    glGenProgramsARB(2, names.data());
    load_assembly(GL_FRAGMENT_PROGRAM_ARB, names[0],
                  "!!ARBfp1.0\n"
                  "TEMP height;\n"
                  "SUB height, fragment.position.y, 16.0;\n"
                  "KIL height;\n"
                  "MOV result.color, 1.0;\n"
                  "END\n");
    expect_seen(seen(48 * 8, {kHalf, 16, 24, 8}, kFar), draw_half_hidden);
    glDisable(GL_FRAGMENT_PROGRAM_ARB);
    draw_left_occluder();
    load_assembly(GL_VERTEX_PROGRAM_ARB, names[1],
                  "!!ARBvp1.0\n"
                  "OPTION ARB_position_invariant;\n"
                  "MOV result.color, vertex.color;\n"
                  "END\n");
    expect_seen(kHalfHidden, draw_half_hidden);
    glDisable(GL_VERTEX_PROGRAM_ARB);
    glDeleteProgramsARB(2, names.data());
}

}  // namespace
}  // namespace conformance
