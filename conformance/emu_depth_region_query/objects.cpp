// SPDX-License-Identifier: MIT
// Many regions at once: into memory, into query objects, into a buffer.
#include <cstring>

#include "emu_depth_region_query/region_test.h"

namespace conformance {
namespace {

constexpr Rect kRegions[] = {{0, 0, 8, 8}, {8, 8, 8, 8}, {4, 4, 40, 9}, {70, 70, 5, 5}, {0, 0, 64, 64}};
constexpr GLsizei kCount = 5;

GLuint bits(GLfloat value) {
    GLuint word = 0;
    std::memcpy(&word, &value, sizeof word);
    return word;
}

// The word of a result.
GLuint word(GLenum pname, GLfloat value) {
    return pname == GL_REGION_OCCLUDED_EMU ? static_cast<GLuint>(value) : bits(value);
}

GLuint get(GLuint id, GLenum pname) {
    GLuint value = kUntouched;
    glGetQueryObjectuiv(id, pname, &value);
    return value;
}

class RegionObjects : public RegionTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(RegionTest::SetUp());
        if (IsSkipped()) return;
        put_depth({0, 0, 32, 64}, kTwoFifths);
        put_depth({2, 2, 1, 1}, kFifth);
        put_depth({9, 9, 1, 1}, kFourFifths);
        glGenQueries(kCount, ids.data());
    }
    void TearDown() override {
        glDeleteQueries(kCount, ids.data());
        RegionTest::TearDown();
    }
    std::array<GLuint, kCount> ids{};
};

// "values[i] is what GetDepthRegionfvEMU returns for rectangle i"
TEST_F(RegionObjects, many_regions_are_answered_as_each_alone) {
    for (const GLenum pname : kEachQuestion) {
        std::array<GLfloat, kCount> values{};
        get_regions(pname, kCount, kRegions, values.data());
        for (std::size_t i = 0; i < kCount; ++i) EXPECT_EQ(values[i], ask(pname, kRegions[i])) << i;
    }
}

// "QUERY_RESULT is ... zero or one ... or the bits of the float"
TEST_F(RegionObjects, an_object_holds_the_answer_of_its_region) {
    for (const GLenum pname : kEachQuestion) {
        query_regions(pname, kCount, kRegions, ids.data());
        for (std::size_t i = 0; i < kCount; ++i) {
            const GLuint expected = word(pname, ask(pname, kRegions[i]));
            EXPECT_EQ(get(ids[i], GL_QUERY_RESULT), expected) << i;
            EXPECT_EQ(get(ids[i], GL_QUERY_RESULT_AVAILABLE), static_cast<GLuint>(GL_TRUE));
            GLuint64 wide = 0;
            glGetQueryObjectui64v(ids[i], GL_QUERY_RESULT, &wide);
            EXPECT_EQ(wide, expected);
        }
    }
}

// "A result becomes available in finite time"
TEST_F(RegionObjects, polling_finds_the_result) {
    query_regions(GL_FURTHEST_DEPTH_EMU, 1, &kRegions[0], ids.data());
    GLuint is_there = 0;
    for (int i = 0; i < 1'000'000 && is_there == 0; ++i) is_there = get(ids[0], GL_QUERY_RESULT_AVAILABLE);
    EXPECT_EQ(is_there, 1u);
    EXPECT_EQ(get(ids[0], GL_QUERY_RESULT), bits(furthest(kRegions[0])));
}

// "... of target DEPTH_REGION_EMU"
TEST_F(RegionObjects, an_object_is_of_the_target_once_it_is_asked) {
    EXPECT_EQ(glIsQuery(ids[0]), GL_FALSE);
    query_regions(GL_NEAREST_DEPTH_EMU, 1, &kRegions[0], ids.data());
    EXPECT_EQ(glIsQuery(ids[0]), GL_TRUE);
    if (lacks(45)) return;
    EXPECT_EQ(get(ids[0], GL_QUERY_TARGET), static_cast<GLuint>(GL_DEPTH_REGION_EMU));
}

// "The result is that of the depths when the command was executed", and of the last command
TEST_F(RegionObjects, an_answer_stays_until_the_object_is_asked_anew) {
    query_regions(GL_FURTHEST_DEPTH_EMU, 1, &kRegions[0], ids.data());
    put_depth(kWhole, kFourFifths);
    EXPECT_NE(get(ids[0], GL_QUERY_RESULT), bits(furthest(kRegions[0])));
    query_regions(GL_FURTHEST_DEPTH_EMU, 1, &kRegions[0], ids.data());
    EXPECT_EQ(get(ids[0], GL_QUERY_RESULT), bits(furthest(kRegions[0])));
}

// "INVALID_OPERATION ... an element of <ids> is zero, no name of GenQueries, an object of another target, or
// stands twice"
TEST_F(RegionObjects, names_that_cannot_be_asked_are_refused) {
    const Query counting;
    counting.count([] { draw_point(1, 1, kNear); });
    for (const GLuint bad : {0u, 0x7000u, counting.name(), ids[0]}) {
        const std::array<GLuint, 3> names = {ids[0], ids[1], bad};
        query_regions(GL_FURTHEST_DEPTH_EMU, 3, kRegions, names.data());
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << bad;
    }
    EXPECT_EQ(glIsQuery(ids[0]), GL_FALSE);
    EXPECT_EQ(glIsQuery(ids[1]), GL_FALSE);
    counting.begin();
    const GLuint active = counting.name();
    query_regions(GL_FURTHEST_DEPTH_EMU, 1, kRegions, &active);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    counting.end();
}

// "INVALID_OPERATION by BeginQuery, BeginConditionalRender ... with an object of the target DEPTH_REGION_EMU"
TEST_F(RegionObjects, other_commands_refuse_the_object) {
    query_regions(GL_FURTHEST_DEPTH_EMU, 1, &kRegions[0], ids.data());
    const GLuint before = get(ids[0], GL_QUERY_RESULT);
    glBeginQuery(GL_SAMPLES_PASSED, ids[0]);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glBeginConditionalRender(ids[0], GL_QUERY_WAIT);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(get(ids[0], GL_QUERY_RESULT), before);
}

// GL 4.5, 4.2: a deleted name is unused
TEST_F(RegionObjects, a_deleted_object_is_no_query) {
    query_regions(GL_FURTHEST_DEPTH_EMU, 1, &kRegions[0], ids.data());
    glDeleteQueries(1, ids.data());
    EXPECT_EQ(glIsQuery(ids[0]), GL_FALSE);
    get(ids[0], GL_QUERY_RESULT);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    query_regions(GL_FURTHEST_DEPTH_EMU, 1, &kRegions[0], ids.data());
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
}

class RegionBuffers : public RegionObjects {
  protected:
    static constexpr GLsizei kWords = 8;
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(RegionObjects::SetUp());
        if (IsSkipped()) return;
        const std::vector<GLuint> marks(kWords, kUntouched);
        glGenBuffers(1, &buffer);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        glBufferData(GL_ARRAY_BUFFER, kWords * 4, marks.data(), GL_STREAM_COPY);
    }
    void TearDown() override {
        glDeleteBuffers(1, &buffer);
        RegionObjects::TearDown();
    }
    static std::vector<GLuint> held() {
        std::vector<GLuint> words(kWords);
        glGetBufferSubData(GL_ARRAY_BUFFER, 0, kWords * 4, words.data());
        return words;
    }
    GLuint buffer = 0;
};

// "the commands that write a result into a buffer generate INVALID_OPERATION for it"
TEST_F(RegionBuffers, query_buffers_refuse_the_object) {
    if (const auto why = lacks(45)) GTEST_SKIP() << *why;
    query_regions(GL_FURTHEST_DEPTH_EMU, 1, &kRegions[0], ids.data());
    glGetQueryBufferObjectuiv(ids[0], buffer, GL_QUERY_RESULT, 0);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glBindBuffer(GL_QUERY_BUFFER, buffer);
    glGetQueryObjectuiv(ids[0], GL_QUERY_RESULT, nullptr);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glBindBuffer(GL_QUERY_BUFFER, 0);
    EXPECT_EQ(held(), std::vector<GLuint>(kWords, kUntouched));
}

// "<count> words of 32 bits at <offset> of the data store of <buffer>"
TEST_F(RegionBuffers, answers_are_written_at_the_offset_and_nothing_else) {
    for (const GLenum pname : kEachQuestion) {
        query_regions_into(pname, kCount, kRegions, buffer, 8);
        std::vector<GLuint> expected(kWords, kUntouched);
        for (std::size_t i = 0; i < kCount; ++i) expected[2 + i] = word(pname, ask(pname, kRegions[i]));
        EXPECT_EQ(held(), expected);
    }
    EXPECT_EQ(get_integer(GL_ARRAY_BUFFER_BINDING), static_cast<GLint>(buffer));
}

// "as if by a command of the GL server, in the order of commands"
TEST_F(RegionBuffers, a_copy_after_the_command_has_the_answers) {
    GLuint copy = 0;
    glGenBuffers(1, &copy);
    glBindBuffer(GL_COPY_WRITE_BUFFER, copy);
    glBufferData(GL_COPY_WRITE_BUFFER, 4, nullptr, GL_STREAM_READ);
    query_regions_into(GL_FURTHEST_DEPTH_EMU, 1, kRegions, buffer, 28);
    glCopyBufferSubData(GL_ARRAY_BUFFER, GL_COPY_WRITE_BUFFER, 28, 0, 4);
    query_regions_into(GL_NEAREST_DEPTH_EMU, 1, kRegions, buffer, 28);
    GLuint first = 0;
    glGetBufferSubData(GL_COPY_WRITE_BUFFER, 0, 4, &first);
    EXPECT_EQ(first, bits(furthest(kRegions[0])));
    EXPECT_EQ(held()[7], bits(nearest(kRegions[0])));
    glDeleteBuffers(1, &copy);
}

// "INVALID_VALUE if <offset> is negative, no multiple of four, or the words would lie beyond the buffer"
TEST_F(RegionBuffers, offsets_outside_the_buffer_are_refused) {
    for (const GLintptr offset : {-4, 2, 3, 16, 32, 0x7FFFFFF0}) {
        query_regions_into(GL_FURTHEST_DEPTH_EMU, kCount, kRegions, buffer, offset);
        EXPECT_TRUE(error_is(GL_INVALID_VALUE)) << offset;
    }
    EXPECT_EQ(held(), std::vector<GLuint>(kWords, kUntouched));
}

// "INVALID_OPERATION if <buffer> is not the name of a buffer object, or is mapped"
TEST_F(RegionBuffers, what_is_no_buffer_or_is_mapped_is_refused) {
    for (const GLuint bad : {0u, 0x7000u}) {
        query_regions_into(GL_FURTHEST_DEPTH_EMU, 1, kRegions, bad, 0);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    }
    glMapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
    query_regions_into(GL_FURTHEST_DEPTH_EMU, 1, kRegions, buffer, 0);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glUnmapBuffer(GL_ARRAY_BUFFER);
    EXPECT_EQ(held(), std::vector<GLuint>(kWords, kUntouched));
}

}  // namespace
}  // namespace conformance
