// SPDX-License-Identifier: MIT
// The sources. Positions are those of fixed function, from another stage: nothing here is drawn by two of
// them.
#include "witness/stages.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <memory>
#include <string>

#include "harness/gl.h"
#include "harness/objects.h"

namespace conformance {

namespace {

const std::string kVersion = "#version 150 compatibility\n";
const std::string kVertex = kVersion +
                            "void main() {\n"
                            "    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n"
                            "    gl_ClipVertex = gl_ModelViewMatrix * gl_Vertex;\n"
                            "    gl_FrontColor = gl_Color;\n"
                            "}\n";
const std::string kPlainVertex = kVersion + "void main() { gl_Position = gl_Vertex; }\n";
const std::string kFragment = kVersion + "void main() { gl_FragColor = gl_Color.bgra; }\n";
const std::string kDiscard = kVersion +
                             "void main() {\n"
                             "    ivec2 at = ivec2(gl_FragCoord.xy);\n"
                             "    if ((at.x / 3 + at.y / 2) % 3 == 0) discard;\n"
                             "    gl_FragColor = gl_Color;\n"
                             "}\n";
const std::string kFragmentDepth =
    kVersion +
    "void main() {\n"
    "    gl_FragDepth = 0.75 * gl_FragCoord.z + 0.25 * fract(gl_FragCoord.x / 16.0);\n"
    "    gl_FragColor = gl_Color;\n"
    "}\n";
const std::string kGeometry =
    kVersion +
    "layout(triangles) in;\n"
    "layout(triangle_strip, max_vertices = 6) out;\n"
    "void main() {\n"
    "    for (int copy = 0; copy < 2; ++copy) {\n"
    "        for (int i = 0; i < 3; ++i) {\n"
    "            gl_Layer = (gl_PrimitiveIDIn + 2 * copy) % 3;\n"
    "            gl_Position = gl_in[i].gl_Position + float(copy) * vec4(0.25, 0.125, 0.125, 0.0);\n"
    "            gl_FrontColor = gl_in[i].gl_FrontColor;\n"
    "            EmitVertex();\n"
    "        }\n"
    "        EndPrimitive();\n"
    "    }\n"
    "}\n";
const std::string kGeometryVertex = kVersion +
                                    "void main() {\n"
                                    "    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n"
                                    "    gl_FrontColor = gl_Color;\n"
                                    "}\n";
// Sample i of pixel (x, y) becomes pixel (4 x + i, y).
std::string fetch(const std::string& sampler) {
    return kVersion + "uniform " + sampler +
           " samples;\n"
           "void main() {\n"
           "    ivec2 at = ivec2(gl_FragCoord.xy);\n"
           "    gl_FragColor = vec4(texelFetch(samples, ivec2(at.x / 4, at.y), at.x % 4));\n"
           "}\n";
}

constexpr const char* kAssemblyVertex =
    "!!ARBvp1.0\n"
    "OPTION ARB_position_invariant;\n"
    "MOV result.color, vertex.color;\n"
    "END\n";
constexpr const char* kAssemblyFragment =
    "!!ARBfp1.0\n"
    "MOV result.color, fragment.color.bgra;\n"
    "END\n";
// Keeps two of every four columns.
constexpr const char* kAssemblyKill =
    "!!ARBfp1.0\n"
    "TEMP at;\n"
    "MUL at.x, fragment.position.x, 0.25;\n"
    "FRC at.x, at.x;\n"
    "SUB at.x, at.x, 0.5;\n"
    "KIL at.x;\n"
    "MOV result.color, fragment.color;\n"
    "END\n";
constexpr const char* kAssemblyDepth =
    "!!ARBfp1.0\n"
    "TEMP at;\n"
    "MUL at.x, fragment.position.y, 0.0625;\n"
    "FRC at.x, at.x;\n"
    "MUL at.y, fragment.position.z, 0.75;\n"
    "MAD result.depth.z, at.x, 0.25, at.y;\n"
    "MOV result.color, fragment.color;\n"
    "END\n";

struct Assembled {
    std::map<Stages, std::unique_ptr<Program>> programs;
    std::map<const char*, GLuint> assemblies;
    GLuint pipeline = 0;
    GLuint separate[2] = {0, 0};
};

Assembled& all() {
    static Assembled stages;
    return stages;
}

Program::Sources sources_of(Stages stages) {
    switch (stages) {
        case Stages::kGlsl:
            return {.vertex = kVertex, .fragment = kFragment};
        case Stages::kDiscard:
            return {.fragment = kDiscard};
        case Stages::kFragmentDepth:
            return {.fragment = kFragmentDepth};
        case Stages::kGeometry:
            return {.vertex = kGeometryVertex, .fragment = kFragment, .geometry = kGeometry};
        case Stages::kFetch:
            return {.vertex = kPlainVertex, .fragment = fetch("sampler2DMS")};
        case Stages::kFetchStencil:
            return {.vertex = kPlainVertex, .fragment = fetch("usampler2DMS")};
        default:
            return {};
    }
}

void use_assembly(GLenum target, const char* source) {
    GLuint& name = all().assemblies[source];
    if (name == 0) {
        glGenProgramsARB(1, &name);
        glBindProgramARB(target, name);
        glProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, static_cast<GLsizei>(std::strlen(source)),
                           source);
        EXPECT_STREQ(reinterpret_cast<const char*>(glGetString(GL_PROGRAM_ERROR_STRING_ARB)), "");
    }
    glBindProgramARB(target, name);
    glEnable(target);
}

void use_separable() {
    if (all().pipeline == 0) {
        glGenProgramPipelines(1, &all().pipeline);
        // A separable vertex stage has to say which of the built-in outputs it has.
        const std::string vertex = kVersion +
                                   "#extension GL_ARB_separate_shader_objects : enable\n"
                                   "out gl_PerVertex { vec4 gl_Position; vec4 gl_FrontColor; };\n"
                                   "void main() {\n"
                                   "    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n"
                                   "    gl_FrontColor = gl_Color;\n"
                                   "}\n";
        const GLenum kinds[2] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER};
        const GLbitfield bits[2] = {GL_VERTEX_SHADER_BIT, GL_FRAGMENT_SHADER_BIT};
        const char* texts[2] = {vertex.c_str(), kFragment.c_str()};
        for (int i = 0; i < 2; ++i) {
            all().separate[i] = glCreateShaderProgramv(kinds[i], 1, &texts[i]);
            GLint is_linked = GL_FALSE;
            glGetProgramiv(all().separate[i], GL_LINK_STATUS, &is_linked);
            EXPECT_EQ(is_linked, GL_TRUE);
            glUseProgramStages(all().pipeline, bits[i], all().separate[i]);
        }
    }
    glBindProgramPipeline(all().pipeline);
}

}  // namespace

void use(Stages stages) {
    glUseProgram(0);
    glBindProgramPipeline(0);
    glDisable(GL_VERTEX_PROGRAM_ARB);
    glDisable(GL_FRAGMENT_PROGRAM_ARB);
    switch (stages) {
        case Stages::kFixed:
            return;
        case Stages::kSeparable:
            return use_separable();
        case Stages::kAssembly:
            use_assembly(GL_VERTEX_PROGRAM_ARB, kAssemblyVertex);
            return use_assembly(GL_FRAGMENT_PROGRAM_ARB, kAssemblyFragment);
        case Stages::kAssemblyKill:
            return use_assembly(GL_FRAGMENT_PROGRAM_ARB, kAssemblyKill);
        case Stages::kAssemblyDepth:
            return use_assembly(GL_FRAGMENT_PROGRAM_ARB, kAssemblyDepth);
        default:
            break;
    }
    std::unique_ptr<Program>& program = all().programs[stages];
    if (!program) program = std::make_unique<Program>(sources_of(stages));
    glUseProgram(program->name());
}

void forget_stages() {
    use(Stages::kFixed);
    for (const auto& [source, name] : all().assemblies) glDeleteProgramsARB(1, &name);
    glDeleteProgramPipelines(1, &all().pipeline);
    for (const GLuint program : all().separate) glDeleteProgram(program);
    all() = {};
}

const char* name_of(Stages stages) {
    constexpr const char* kNames[] = {"fixed function", "GLSL",      "GLSL discard", "GLSL depth",
                                      "GLSL geometry",  "separable", "assembly",     "assembly KIL",
                                      "assembly depth", "fetch",     "fetch stencil"};
    return kNames[static_cast<int>(stages)];
}

}  // namespace conformance
