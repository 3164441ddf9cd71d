// SPDX-License-Identifier: MIT
// What the tests of GL_HP_visibility_test share: the commands, which no header has, the fixture, which skips
// where the extension is absent, and a buffer with a guarded end.
//
// The law is HP's OpenGL 1.1 Reference for HP-UX 11.x, glVisibilityBufferhp, p. 480-481; token and prototypes
// are those of HP's header glHpNt.h of 2001.
#pragma once

#include <algorithm>
#include <array>

#include "harness/gl_test.h"

namespace conformance {

inline constexpr GLenum kVisibilityTest = 0x837A;

// What no result is.
inline constexpr GLboolean kUnwritten = 0xAA;

class VisibilityTest : public GlTest {
  protected:
    static constexpr GLsizei kSize = 100;  // results

    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
        if (const auto why = lacks("GL_HP_visibility_test")) GTEST_SKIP() << *why;
        visibility_buffer_ = reinterpret_cast<VisibilityBuffer>(command("glVisibilityBufferHP"));
        next_test_ = reinterpret_cast<NextVisibilityTest>(command("glNextVisibilityTestHP"));
        ASSERT_NE(visibility_buffer_, nullptr);
        ASSERT_NE(next_test_, nullptr);
        results.fill(kUnwritten);
    }

    // The program's memory: kSize results, and as many that no one may write.
    std::array<GLboolean, 2 * std::size_t{kSize}> results{};

    void visibility_buffer(GLsizei size, GLboolean* buffer, GLboolean waits) const {
        visibility_buffer_(size, buffer, waits);
    }
    void next_test() const { next_test_(); }
    void define(bool waits = true, GLsizei size = kSize) {
        visibility_buffer(size, results.data(), waits ? GL_TRUE : GL_FALSE);
    }

    bool is_unwritten(std::size_t from) const {
        return std::all_of(results.begin() + static_cast<std::ptrdiff_t>(from), results.end(),
                           [](GLboolean result) { return result == kUnwritten; });
    }

    // What a Get returns: "HP's demonstration of 2001" passes an array of two.
    static std::array<GLboolean, 2> get() {
        std::array<GLboolean, 2> values = {kUnwritten, kUnwritten};
        glGetBooleanv(kVisibilityTest, values.data());
        return values;
    }
    // Gets until all results are there, but not for ever.
    static void get_all() {
        for (int gets = 0; gets < 10'000'000; ++gets) {
            if (get()[1] == GL_TRUE) return;
        }
        ADD_FAILURE() << "the results have not come";
    }

    // An occluder over all pixels, and boxes before and behind it.
    void see() const { draw_rect({10, 10, 4, 4}, kNear); }
    void miss() const { draw_rect({20, 20, 4, 4}, kFar); }
    static void occlude() {
        draw_occluder();
        glDepthMask(GL_FALSE);
    }

  private:
    using VisibilityBuffer = void (*)(GLsizei, GLboolean*, GLboolean);
    using NextVisibilityTest = void (*)();

    static void* command(const char* name) { return platform().get_proc_address(name); }

    VisibilityBuffer visibility_buffer_ = nullptr;
    NextVisibilityTest next_test_ = nullptr;
};

}  // namespace conformance
