// SPDX-License-Identifier: MIT
// The fixture, and what the current context says of itself.
#include "harness/gl_test.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>

namespace conformance {

void GlTest::SetUp() {
    surface_.emplace();
    context_.emplace(wish());
    ASSERT_TRUE(*surface_) << "no 64 x 64 surface with RGBA8, 24-bit depth and 8-bit stencil";
    if (wish().api == Api::kCompatibility) {
        ASSERT_TRUE(*context_) << "no compatibility context";
    } else if (!*context_) {
        GTEST_SKIP() << "no context of this API";
    }
    ASSERT_TRUE(context_->make_current(*surface_));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    prepare();
    ASSERT_TRUE(no_error());
}

void GlTest::prepare() {
    use_pixel_coordinates();
    clear();
}

void GlTest::TearDown() {
    if (context_ && *context_ && context_->make_current(*surface_)) {
        EXPECT_TRUE(no_error()) << "the test left an error behind";
    }
    Context::release_current();
    context_.reset();
    surface_.reset();
}

void GlTest::come_back() const {
    ASSERT_TRUE(context_->make_current(*surface_));
}

void GlTest::come_back(const Surface& other) const {
    ASSERT_TRUE(context_->make_current(other));
}

int gl_version() {
    const auto* text = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    if (!text) return 0;
    int major = 0;
    int minor = 0;
    if (std::sscanf(text, "OpenGL ES %d.%d", &major, &minor) != 2) std::sscanf(text, "%d.%d", &major, &minor);
    return major * 10 + minor;
}

std::vector<std::string> extensions() {
    const auto* text = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
    if (!text) return {};
    std::istringstream words(text);
    std::vector<std::string> names;
    for (std::string word; words >> word;) names.push_back(word);
    return names;
}

std::vector<std::string> indexed_extensions() {
    std::vector<std::string> names;
    const GLint count = get_integer(GL_NUM_EXTENSIONS);
    for (GLint i = 0; i < count; ++i) {
        const auto* name = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
        names.emplace_back(name ? name : "(null)");
    }
    return names;
}

bool has_extension(const std::string& name) {
    // A core profile has only the indexed form, GL below 3.0 only the string.
    const auto names = gl_version() >= 30 ? indexed_extensions() : extensions();
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::optional<std::string> lacks(int version) {
    if (gl_version() >= version) return std::nullopt;
    return "needs GL " + std::to_string(version / 10) + "." + std::to_string(version % 10);
}

std::optional<std::string> lacks(const std::string& extension) {
    if (has_extension(extension)) return std::nullopt;
    return "needs " + extension;
}

std::optional<std::string> lacks(int version, const std::string& extension) {
    const auto why = lacks(version);
    return why && lacks(extension) ? std::optional(*why + " or " + extension) : std::nullopt;
}

std::string error_name(GLenum error) {
    switch (error) {
        case GL_NO_ERROR:
            return "NO_ERROR";
        case GL_INVALID_ENUM:
            return "INVALID_ENUM";
        case GL_INVALID_VALUE:
            return "INVALID_VALUE";
        case GL_INVALID_OPERATION:
            return "INVALID_OPERATION";
        case GL_STACK_OVERFLOW:
            return "STACK_OVERFLOW";
        case GL_STACK_UNDERFLOW:
            return "STACK_UNDERFLOW";
        case GL_OUT_OF_MEMORY:
            return "OUT_OF_MEMORY";
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            return "INVALID_FRAMEBUFFER_OPERATION";
        default:
            break;
    }
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "0x%04X", error);
    return text.data();
}

::testing::AssertionResult error_is(GLenum expected) {
    const GLenum error = glGetError();
    if (error == expected) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure()
           << "GL error " << error_name(error) << ", expected " << error_name(expected);
}

GLint get_integer(GLenum name) {
    GLint value = -1;
    glGetIntegerv(name, &value);
    return value;
}

}  // namespace conformance
