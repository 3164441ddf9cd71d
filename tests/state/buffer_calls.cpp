// SPDX-License-Identifier: MIT
// Results that go into a query buffer change the bytes that they are written to and no gettable state,
// delayed or not: neither a binding nor another byte.
#include <array>

#include "harness/query.h"
#include "state_test.h"

namespace tests {
namespace {

using conformance::draw_rect;
using conformance::kNear;
using conformance::kWhole;

constexpr GLuint kPoison = 0xABABABAB;
constexpr std::size_t kWords = 8, kAt = 2;  // words of the buffer, and where a result goes

class BufferCalls : public StateTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(StateTest::SetUp());
        if (const auto why = conformance::lacks(44, "GL_ARB_query_buffer_object")) GTEST_SKIP() << *why;
        glGenBuffers(1, &buffer_);
        glBindBuffer(GL_QUERY_BUFFER, buffer_);
        glGenQueries(1, &query_);
        glBeginQuery(GL_SAMPLES_PASSED, query_);
        draw_rect(kWhole, kNear);
        glEndQuery(GL_SAMPLES_PASSED);
        poison();
    }
    void TearDown() override {
        glDeleteQueries(1, &query_);
        StateTest::TearDown();
    }

    void poison() const {
        std::array<GLuint, kWords> words;
        words.fill(kPoison);
        glBufferData(GL_QUERY_BUFFER, sizeof words, words.data(), GL_DYNAMIC_COPY);
    }
    std::array<GLuint, kWords> words() const {
        std::array<GLuint, kWords> words{};
        glGetBufferSubData(GL_QUERY_BUFFER, 0, sizeof words, words.data());
        return words;
    }
    static GLuint* offset(std::size_t bytes) { return reinterpret_cast<GLuint*>(bytes); }
    void get(GLenum parameter, std::size_t bytes = kAt * sizeof(GLuint)) const {
        glGetQueryObjectuiv(query_, parameter, offset(bytes));
    }
    GLuint query() const { return query_; }
    GLuint buffer() const { return buffer_; }

  private:
    GLuint buffer_ = 0;
    GLuint query_ = 0;
};

TEST_F(BufferCalls, a_result_changes_its_own_word_and_no_state) {
    expect_nothing([this] { get(GL_QUERY_RESULT); });
    std::array<GLuint, kWords> expected;
    expected.fill(kPoison);
    expected[kAt] = kPixelsOfWhole;
    EXPECT_EQ(words(), expected);
}

TEST_F(BufferCalls, a_result_of_64_bits_changes_two_words_and_no_state) {
    expect_nothing([this] {
        glGetQueryObjectui64v(query(), GL_QUERY_RESULT, reinterpret_cast<GLuint64*>(kAt * sizeof(GLuint)));
    });
    std::array<GLuint, kWords> expected;
    expected.fill(kPoison);
    expected[kAt] = kPixelsOfWhole;
    expected[kAt + 1] = 0;
    EXPECT_EQ(words(), expected);
}

TEST_F(BufferCalls, polls_change_no_state) {
    for (const GLenum parameter : {GL_QUERY_RESULT_AVAILABLE, GL_QUERY_RESULT_NO_WAIT}) {
        SCOPED_TRACE(parameter);
        expect_nothing([=, this] { get(parameter); });
        std::array<GLuint, kWords> now = words();
        now[kAt] = kPoison;
        std::array<GLuint, kWords> poisoned;
        poisoned.fill(kPoison);
        EXPECT_EQ(now, poisoned) << "a word beside the result was written";
    }
}

TEST_F(BufferCalls, refused_reads_change_neither_state_nor_the_buffer) {
    expect_refusal(GL_INVALID_OPERATION, [this] { get(GL_QUERY_RESULT, kWords * sizeof(GLuint)); });
    expect_refusal(GL_INVALID_ENUM, [this] { get(GL_TEXTURE_2D); });
    std::array<GLuint, kWords> poisoned;
    poisoned.fill(kPoison);
    EXPECT_EQ(words(), poisoned);
}

TEST_F(BufferCalls, a_named_buffer_is_written_without_a_binding) {
    if (const auto why = conformance::lacks(45, "GL_ARB_direct_state_access")) GTEST_SKIP() << *why;
    glBindBuffer(GL_QUERY_BUFFER, 0);
    expect_nothing(
        [this] { glGetQueryBufferObjectuiv(query(), buffer(), GL_QUERY_RESULT, kAt * sizeof(GLuint)); });
    glBindBuffer(GL_QUERY_BUFFER, buffer());
    std::array<GLuint, kWords> expected;
    expected.fill(kPoison);
    expected[kAt] = kPixelsOfWhole;
    EXPECT_EQ(words(), expected);
}

TEST_F(BufferCalls, a_read_under_the_hp_test_keeps_its_state) {
    if (const auto why = conformance::lacks("GL_HP_occlusion_test")) GTEST_SKIP() << *why;
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_rect(kWhole, kNear);
    expect_nothing([this] { get(GL_QUERY_RESULT); });
    // The layer's own reads must not land in the program's buffer.
    poison();
    expect_nothing([] { conformance::get_integer(GL_OCCLUSION_TEST_RESULT_HP); });
    std::array<GLuint, kWords> poisoned;
    poisoned.fill(kPoison);
    EXPECT_EQ(words(), poisoned);
    glDisable(GL_OCCLUSION_TEST_HP);
}

}  // namespace
}  // namespace tests
