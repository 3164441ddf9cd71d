// SPDX-License-Identifier: MIT
// Every way to make fragments counts: each draws something at depth 0 of its own, moved by the modelview
// matrix once in front of an occluder and once behind it (HP-57).
#include <array>

#include "harness/objects.h"
#include "hp_occlusion_test/hp_test.h"

namespace conformance {
namespace {

// HP, Overview: "render some geometry": NV 4.1.6A: "Whenever a fragment reaches this stage", whatever made
// it.
struct Source {
    const char* name;
    int version;  // the GL that has the command
    void (*draw)();
};

constexpr std::array<GLfloat, 12> kCorners = {8.0f,  8.0f,  0.0f, 40.0f, 8.0f,  0.0f,
                                              40.0f, 40.0f, 0.0f, 8.0f,  40.0f, 0.0f};
constexpr std::array<GLushort, 4> kOrder = {0, 1, 2, 3};

void immediate(GLenum mode) {
    glBegin(mode);
    for (std::size_t i = 0; i < kCorners.size(); i += 3) glVertex3fv(&kCorners[i]);
    glEnd();
}

template <typename Draw>
void with_client_array(Draw draw) {
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, kCorners.data());
    draw();
    glDisableClientState(GL_VERTEX_ARRAY);
}

// Buffer objects for vertices (bound as array), indices and, as raw words, indirect commands.
template <typename Draw>
void with_buffers(Draw draw) {
    std::array<GLuint, 2> buffers{};
    glGenBuffers(2, buffers.data());
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, sizeof kCorners, kCorners.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof kOrder, kOrder.data(), GL_STATIC_DRAW);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, nullptr);
    draw();
    glDisableClientState(GL_VERTEX_ARRAY);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    glDeleteBuffers(2, buffers.data());
}

template <typename Draw, std::size_t kWords>
void with_indirect(const std::array<GLuint, kWords>& words, Draw draw) {
    with_buffers([&] {
        GLuint commands = 0;
        glGenBuffers(1, &commands);
        glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commands);
        glBufferData(GL_DRAW_INDIRECT_BUFFER, sizeof words, words.data(), GL_STATIC_DRAW);
        draw();
        glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
        glDeleteBuffers(1, &commands);
    });
}

template <typename Draw>
void through_list(Draw draw) {
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    draw();
    glEndList();
    glCallList(list);
    glDeleteLists(list, 1);
}

template <typename Set, typename Draw>
void with_mesh(Set set, Draw draw) {
    set();
    draw();
    glDisable(GL_MAP1_VERTEX_3);
    glDisable(GL_MAP2_VERTEX_3);
}

void set_line_map() {
    glMap1f(GL_MAP1_VERTEX_3, 0.0f, 1.0f, 3, 2, kCorners.data());
    glMapGrid1f(4, 0.0f, 1.0f);
    glEnable(GL_MAP1_VERTEX_3);
}

void set_surface_map() {
    constexpr std::array<GLfloat, 12> kPatch = {8.0f, 8.0f,  0.0f, 40.0f, 8.0f,  0.0f,
                                                8.0f, 40.0f, 0.0f, 40.0f, 40.0f, 0.0f};
    glMap2f(GL_MAP2_VERTEX_3, 0.0f, 1.0f, 3, 2, 0.0f, 1.0f, 6, 2, kPatch.data());
    glMapGrid2f(4, 0.0f, 1.0f, 4, 0.0f, 1.0f);
    glEnable(GL_MAP2_VERTEX_3);
}

constexpr std::array<GLint, 2> kFirsts = {0, 0};
constexpr std::array<GLsizei, 2> kCounts = {4, 4};
constexpr std::array<const void*, 2> kClientIndices = {kOrder.data(), kOrder.data()};

const char* const kWhiteFragment = "#version 150 compatibility\nvoid main() { gl_FragColor = vec4(1.0); }\n";
const char* const kPassVertex = "#version 150 compatibility\nvoid main() { gl_Position = gl_Vertex; }\n";

void through_geometry_shader() {
    const Program program(
        {.vertex = kPassVertex,
         .fragment = kWhiteFragment,
         .geometry = "#version 150 compatibility\n"
                     "layout(points) in;\n"
                     "layout(triangle_strip, max_vertices = 4) out;\n"
                     "void main() {\n"
                     "  for (int i = 0; i < 4; ++i) {\n"
                     "    vec4 at = gl_in[0].gl_Position + vec4(9.0 * (i & 1), 9.0 * (i >> 1), 0.0, 0.0);\n"
                     "    gl_Position = gl_ModelViewProjectionMatrix * at;\n"
                     "    EmitVertex();\n"
                     "  }\n"
                     "}\n"});
    immediate(GL_POINTS);
}

void through_tessellation() {
    const Program program(
        {.vertex = kPassVertex,
         .fragment = kWhiteFragment,
         .evaluation = "#version 400 compatibility\n"
                       "layout(quads) in;\n"
                       "void main() {\n"
                       "  vec4 low = mix(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_TessCoord.x);\n"
                       "  vec4 high = mix(gl_in[3].gl_Position, gl_in[2].gl_Position, gl_TessCoord.x);\n"
                       "  gl_Position = gl_ModelViewProjectionMatrix * mix(low, high, gl_TessCoord.y);\n"
                       "}\n"});
    glPatchParameteri(GL_PATCH_VERTICES, 4);
    immediate(GL_PATCHES);
}

const Source kSources[] = {
    {"points", 10, [] { immediate(GL_POINTS); }},
    {"lines", 10, [] { immediate(GL_LINES); }},
    {"line_strip", 10, [] { immediate(GL_LINE_STRIP); }},
    {"line_loop", 10, [] { immediate(GL_LINE_LOOP); }},
    {"triangles", 10, [] { immediate(GL_TRIANGLES); }},
    {"triangle_strip", 10, [] { immediate(GL_TRIANGLE_STRIP); }},
    {"triangle_fan", 10, [] { immediate(GL_TRIANGLE_FAN); }},
    {"quads", 10, [] { immediate(GL_QUADS); }},
    {"quad_strip", 10, [] { immediate(GL_QUAD_STRIP); }},
    {"polygon", 10, [] { immediate(GL_POLYGON); }},
    {"glRecti", 10, [] { glRecti(8, 8, 40, 40); }},
    {"glRectfv", 10, [] { glRectfv(&kCorners[0], &kCorners[6]); }},
    {"display_list", 10, [] { through_list([] { immediate(GL_QUADS); }); }},
    {"display_list_of_array", 11,
     [] { with_client_array([] { through_list([] { glDrawArrays(GL_QUADS, 0, 4); }); }); }},
    {"glEvalMesh1", 10, [] { with_mesh(set_line_map, [] { glEvalMesh1(GL_LINE, 0, 4); }); }},
    {"glEvalMesh2", 10, [] { with_mesh(set_surface_map, [] { glEvalMesh2(GL_FILL, 0, 4, 0, 4); }); }},
    {"glEvalPoint2", 10,
     [] {
         with_mesh(set_surface_map, [] {
             glBegin(GL_POINTS);
             glEvalPoint2(2, 2);
             glEnd();
         });
     }},
    {"glDrawArrays", 11, [] { with_client_array([] { glDrawArrays(GL_QUADS, 0, 4); }); }},
    {"glDrawElements", 11,
     [] { with_client_array([] { glDrawElements(GL_QUADS, 4, GL_UNSIGNED_SHORT, kOrder.data()); }); }},
    {"glArrayElement", 11,
     [] {
         with_client_array([] {
             glBegin(GL_QUADS);
             for (GLint i = 0; i < 4; ++i) glArrayElement(i);
             glEnd();
         });
     }},
    {"glInterleavedArrays", 11,
     [] {
         glInterleavedArrays(GL_V3F, 0, kCorners.data());
         glDrawArrays(GL_QUADS, 0, 4);
         glDisableClientState(GL_VERTEX_ARRAY);
     }},
    {"glDrawRangeElements", 12,
     [] {
         with_client_array([] { glDrawRangeElements(GL_QUADS, 0, 3, 4, GL_UNSIGNED_SHORT, kOrder.data()); });
     }},
    {"glMultiDrawArrays", 14,
     [] { with_client_array([] { glMultiDrawArrays(GL_QUADS, kFirsts.data(), kCounts.data(), 2); }); }},
    {"glMultiDrawElements", 14,
     [] {
         with_client_array([] {
             glMultiDrawElements(GL_QUADS, kCounts.data(), GL_UNSIGNED_SHORT, kClientIndices.data(), 2);
         });
     }},
    {"buffer_objects", 15,
     [] { with_buffers([] { glDrawElements(GL_QUADS, 4, GL_UNSIGNED_SHORT, nullptr); }); }},
    {"glDrawArraysInstanced", 31, [] { with_buffers([] { glDrawArraysInstanced(GL_QUADS, 0, 4, 2); }); }},
    {"glDrawElementsInstanced", 31,
     [] { with_buffers([] { glDrawElementsInstanced(GL_QUADS, 4, GL_UNSIGNED_SHORT, nullptr, 2); }); }},
    {"glDrawElementsBaseVertex", 32,
     [] { with_buffers([] { glDrawElementsBaseVertex(GL_QUADS, 4, GL_UNSIGNED_SHORT, nullptr, 0); }); }},
    {"geometry_shader", 32, through_geometry_shader},
    {"tessellation", 40, through_tessellation},
    {"glDrawArraysIndirect", 40,
     [] {
         with_indirect(std::array<GLuint, 4>{4, 1, 0, 0}, [] { glDrawArraysIndirect(GL_QUADS, nullptr); });
     }},
    {"glDrawElementsIndirect", 40,
     [] {
         with_indirect(std::array<GLuint, 5>{4, 1, 0, 0, 0},
                       [] { glDrawElementsIndirect(GL_QUADS, GL_UNSIGNED_SHORT, nullptr); });
     }},
    {"glMultiDrawArraysIndirect", 43,
     [] {
         with_indirect(std::array<GLuint, 8>{4, 1, 0, 0, 4, 1, 0, 0},
                       [] { glMultiDrawArraysIndirect(GL_QUADS, nullptr, 2, 0); });
     }},
};

class FragmentSources : public HpTest, public ::testing::WithParamInterface<Source> {};

// HP-57.
TEST_P(FragmentSources, what_it_draws_counts_when_and_only_when_it_passes) {
    if (const auto why = lacks(GetParam().version)) GTEST_SKIP() << *why;
    draw_occluder();
    glDepthMask(GL_FALSE);
    for (const bool visible : {true, false}) {
        glClear(GL_COLOR_BUFFER_BIT);
        glLoadIdentity();
        glTranslatef(0.0f, 0.0f, visible ? kNear : kFar);
        EXPECT_EQ(result_of(GetParam().draw), visible);
        EXPECT_EQ(drawn_pixels() > 0, visible);
        EXPECT_TRUE(no_error());
    }
}

INSTANTIATE_TEST_SUITE_P(Each, FragmentSources, ::testing::ValuesIn(kSources),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace conformance
