// SPDX-License-Identifier: MIT
// Fragments of fixed function, from immediate mode to client arrays (HP-57).
#include "hp_occlusion_test/source_test.h"

namespace conformance {
namespace {

template <typename Draw>
void with_client_array(Draw draw) {
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, kCorners.data());
    draw();
    glDisableClientState(GL_VERTEX_ARRAY);
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

const Source kSources[] = {
    {"points", 10, [] { draw_corners(GL_POINTS); }},
    {"lines", 10, [] { draw_corners(GL_LINES); }},
    {"line_strip", 10, [] { draw_corners(GL_LINE_STRIP); }},
    {"line_loop", 10, [] { draw_corners(GL_LINE_LOOP); }},
    {"triangles", 10, [] { draw_corners(GL_TRIANGLES); }},
    {"triangle_strip", 10, [] { draw_corners(GL_TRIANGLE_STRIP); }},
    {"triangle_fan", 10, [] { draw_corners(GL_TRIANGLE_FAN); }},
    {"quads", 10, [] { draw_corners(GL_QUADS); }},
    {"quad_strip", 10, [] { draw_corners(GL_QUAD_STRIP); }},
    {"polygon", 10, [] { draw_corners(GL_POLYGON); }},
    {"glRecti", 10, [] { glRecti(8, 8, 40, 40); }},
    {"glRectfv", 10, [] { glRectfv(&kCorners[0], &kCorners[6]); }},
    {"display_list", 10, [] { through_list([] { draw_corners(GL_QUADS); }); }},
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
};

class FixedSources : public SourceTest {};

TEST_P(FixedSources, counts_when_and_only_when_it_passes) {
    if (const auto why = lacks(GetParam().version)) GTEST_SKIP() << *why;
    expect_to_count_when_and_only_when_visible();
}

INSTANTIATE_TEST_SUITE_P(Each, FixedSources, ::testing::ValuesIn(kSources), source_name);

}  // namespace
}  // namespace conformance
