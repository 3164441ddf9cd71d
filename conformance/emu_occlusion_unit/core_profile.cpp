// SPDX-License-Identifier: MIT
// A core profile has the extension too: without matrices, lists, and the fixed function.
#include "emu_occlusion_unit/unit_test.h"

namespace conformance {
namespace {

class UnitInCore : public UnitTest {
  protected:
    ContextWish wish() const override { return {.api = Api::kCore, .major = 3, .minor = 3}; }
    void prepare() override {}

    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(UnitTest::SetUp());
        if (IsSkipped()) return;
        glGenVertexArrays(1, &array_);
        glBindVertexArray(array_);
        glGenBuffers(1, &buffer_);
        glBindBuffer(GL_ARRAY_BUFFER, buffer_);
        glEnableVertexAttribArray(0);
        glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
        glViewport(0, 0, kSize, kSize);
        glEnable(GL_DEPTH_TEST);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
    void TearDown() override {
        if (buffer_ != 0) {
            glDeleteBuffers(1, &buffer_);
            glDeleteVertexArrays(1, &array_);
        }
        UnitTest::TearDown();
    }

    static void draw(const Rect& rect, float depth) {
        const auto left = static_cast<GLfloat>(rect.x) / kHalf - 1.0f;
        const auto bottom = static_cast<GLfloat>(rect.y) / kHalf - 1.0f;
        const auto right = left + static_cast<GLfloat>(rect.width) / kHalf;
        const auto top = bottom + static_cast<GLfloat>(rect.height) / kHalf;
        const GLfloat z = 2.0f * depth - 1.0f;
        const std::array<GLfloat, 12> corners = {left, bottom, z, right, bottom, z,
                                                 left, top,    z, right, top,    z};
        glBufferData(GL_ARRAY_BUFFER, sizeof(corners), corners.data(), GL_STREAM_DRAW);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }

  private:
    GLuint array_ = 0;
    GLuint buffer_ = 0;
};

constexpr const char* kVertexSource =
    "#version 150\n"
    "in vec3 corner;\n"
    "void main() { gl_Position = vec4(corner, 1.0); }\n";
constexpr const char* kFragmentSource =
    "#version 150\n"
    "out vec4 colour;\n"
    "void main() { colour = vec4(1.0); }\n";
constexpr std::array<GLfloat, 12> kQuad = {8, 8, kFar, 56, 8, kFar, 56, 24, kFar, 8, 24, kFar};

// Overview of 17.3.5.1 in a core profile.
TEST_F(UnitInCore, every_register_is_told) {
    const Program program({.vertex = kVertexSource, .fragment = kFragmentSource});
    draw(kLeft, kMiddle);
    expect_seen(kHalfHidden, [] { draw(kHalfHiddenRect, kFar); });
    EXPECT_EQ(get_integer(GL_CURRENT_PROGRAM), static_cast<GLint>(program.name()));
}

// 17.3.5.3: "INVALID_VALUE is generated ... if <matrix> is NULL in a core profile."
TEST_F(UnitInCore, shapes_need_a_matrix) {
    const Program program({.vertex = kVertexSource, .fragment = kFragmentSource});
    draw(kLeft, kMiddle);
    const Query query;
    unit_shapes(kAllRegisters, GL_QUAD_EMU, 1, kQuad.data(), nullptr, query.name());
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    EXPECT_FALSE(glIsQuery(query.name()));
    const std::array<GLfloat, 16> pixels = {1.0f / kHalf, 0,  0,  0, 0, 1.0f / kHalf, 0, 0, 0, 0, 2, 0,
                                            -1,           -1, -1, 1};
    unit_shapes(kAllRegisters, GL_QUAD_EMU, 1, kQuad.data(), pixels.data(), query.name());
    Record record{};
    get_records(query.name(), 0, 1, &record);
    expect_record(record, kAllRegisters, kHalfHidden);
    draw({0, 40, 8, 8}, kNear);  // with the program, array and buffer of before
    EXPECT_EQ(drawn_pixels({0, 40, 8, 8}), 64);
}

}  // namespace
}  // namespace conformance
