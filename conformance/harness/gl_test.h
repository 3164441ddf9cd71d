// SPDX-License-Identifier: MIT
// The fixture under every conformance test: a fresh compatibility context on a fresh surface, and assertions
// about GL.
//
// A test that leaves an error behind fails, so that no call of a test goes unexamined.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "harness/draw.h"
#include "harness/gl.h"
#include "harness/platform.h"

namespace conformance {

class GlTest : public ::testing::Test {
  protected:
    void SetUp() override;
    void TearDown() override;

    // Which context a fixture runs on, and what it sets in it before each test; overridden by those of
    // another API.
    virtual ContextWish wish() const { return {}; }
    virtual void prepare();

    const Surface& surface() const { return *surface_; }
    const Context& context() const { return *context_; }
    // Makes this test's own context current again, on its own surface or another.
    void come_back() const;
    void come_back(const Surface& other) const;

  private:
    std::optional<Surface> surface_;
    std::optional<Context> context_;
};

// The version that the current context states, e.g. 45 for 4.5; 0 without a context. An ES context counts its
// own way.
int gl_version();

std::vector<std::string> extensions();          // of glGetString, word by word; empty in a core profile
std::vector<std::string> indexed_extensions();  // of glGetStringi
bool has_extension(const std::string& name);    // by whichever of the two the context has

// Why a test cannot run here, or nothing: `if (const auto why = lacks(30)) GTEST_SKIP() << *why;`
std::optional<std::string> lacks(int version);
std::optional<std::string> lacks(const std::string& extension);
std::optional<std::string> lacks(int version, const std::string& extension);  // neither of the two

// Takes one error from GL and compares it.
::testing::AssertionResult error_is(GLenum expected);
inline ::testing::AssertionResult no_error() {
    return error_is(GL_NO_ERROR);
}

std::string error_name(GLenum error);

GLint get_integer(GLenum name);

}  // namespace conformance
