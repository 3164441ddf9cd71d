// SPDX-License-Identifier: MIT
// State that has a Get of its own kind, with an object, a unit or a name beside the enumerant.
#include <array>
#include <sstream>

#include "harness/gl_test.h"
#include "snapshot.h"

namespace tests {

namespace {

constexpr GLuint kNames = 48;  // more objects than any test makes

template <typename T, std::size_t kCount>
std::string text_of(const std::array<T, kCount>& values) {
    std::ostringstream text;
    text.precision(17);
    for (const T value : values) text << +value << ' ';
    return text.str();
}

template <typename Get>
std::string four_of(Get get) {
    std::array<GLfloat, 4> values{};
    get(values.data());
    return text_of(values);
}

template <typename IsObject>
std::string names_of(IsObject is_object) {
    std::string names;
    for (GLuint name = 1; name <= kNames; ++name) names += is_object(name) ? '1' : '.';
    return names;
}

}  // namespace

void add_fixed_function(Snapshot& snapshot) {
    for (GLenum light = GL_LIGHT0; light <= GL_LIGHT7; ++light) {
        for (const GLenum pname : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION, GL_SPOT_DIRECTION,
                                   GL_SPOT_EXPONENT, GL_SPOT_CUTOFF, GL_CONSTANT_ATTENUATION}) {
            snapshot["Light " + std::to_string(light - GL_LIGHT0) + ' ' + std::to_string(pname)] =
                four_of([&](GLfloat* values) { glGetLightfv(light, pname, values); });
        }
    }
    for (const GLenum face : {GL_FRONT, GL_BACK}) {
        for (const GLenum pname : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS}) {
            snapshot["Material " + std::to_string(face) + ' ' + std::to_string(pname)] =
                four_of([&](GLfloat* values) { glGetMaterialfv(face, pname, values); });
        }
    }
    for (const GLenum pname : {GL_TEXTURE_ENV_MODE, GL_TEXTURE_ENV_COLOR}) {
        snapshot["TexEnv " + std::to_string(pname)] =
            four_of([&](GLfloat* values) { glGetTexEnvfv(GL_TEXTURE_ENV, pname, values); });
    }
    for (GLenum plane = GL_CLIP_PLANE0; plane <= GL_CLIP_PLANE5; ++plane) {
        std::array<GLdouble, 4> equation{};
        glGetClipPlane(plane, equation.data());
        snapshot["ClipPlane " + std::to_string(plane - GL_CLIP_PLANE0)] = text_of(equation);
    }
}

void add_object_names(Snapshot& snapshot, int version) {
    snapshot["IsTexture"] = names_of(glIsTexture);
    snapshot["IsList"] = names_of(glIsList);
    if (conformance::has_extension("GL_NV_occlusion_query"))
        snapshot["IsOcclusionQueryNV"] = names_of(glIsOcclusionQueryNV);
    if (version >= 15) {
        snapshot["IsQuery"] = names_of(glIsQuery);
        snapshot["IsBuffer"] = names_of(glIsBuffer);
    }
    if (version >= 30) {
        snapshot["IsFramebuffer"] = names_of(glIsFramebuffer);
        snapshot["IsRenderbuffer"] = names_of(glIsRenderbuffer);
        snapshot["IsVertexArray"] = names_of(glIsVertexArray);
        snapshot["IsProgram"] = names_of(glIsProgram);
        snapshot["IsShader"] = names_of(glIsShader);
    }
}

}  // namespace tests
