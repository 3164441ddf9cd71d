// SPDX-License-Identifier: MIT
// Fragments from buffer objects, instances, indirect commands and shaders (HP-57).
#include "harness/objects.h"
#include "hp_occlusion_test/source_test.h"

namespace conformance {
namespace {

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
    draw_corners(GL_POINTS);
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
    draw_corners(GL_PATCHES);
}

const Source kSources[] = {
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

class BufferSources : public SourceTest {};

TEST_P(BufferSources, counts_when_and_only_when_it_passes) {
    if (const auto why = lacks(GetParam().version)) GTEST_SKIP() << *why;
    expect_to_count_when_and_only_when_visible();
}

INSTANTIATE_TEST_SUITE_P(Each, BufferSources, ::testing::ValuesIn(kSources), source_name);

}  // namespace
}  // namespace conformance
