// SPDX-License-Identifier: MIT
// Results in a buffer as the GL's own input, and of every kind of query (QBO-11, QBO-13).
#include <algorithm>
#include <array>

#include "arb_query_buffer_object/query_buffer_test.h"
#include "harness/objects.h"

namespace conformance {
namespace {

class QueryBufferUse : public QueryBufferTest {};

constexpr GLfloat kSize = kSurfaceSize;

// Runs a query of <count> samples and writes the result into the bound query buffer, waiting for nothing.
void count_into_buffer(const Query& query, int count, std::intptr_t offset) {
    query.begin();
    draw_rect({0, 0, count, 1}, kNear);
    query.end();
    clear();
    write_object<GLuint>(query.name(), GL_QUERY_RESULT, offset);
}

// QBO-11. Usage Examples, 4: a result is a field of an indirect draw.
TEST_F(QueryBufferUse, a_result_is_the_count_of_an_indirect_draw) {
    const std::array<GLfloat, 12> corners = {0,     0,     kNear, kSize, 0,     kNear,
                                             kSize, kSize, kNear, 0,     kSize, kNear};
    GLuint vertices = 0;
    glGenBuffers(1, &vertices);
    glBindBuffer(GL_ARRAY_BUFFER, vertices);
    glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners.data(), GL_STATIC_DRAW);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, nullptr);
    for (const int count : {4, 0, 3, 4}) {
        const std::array<GLuint, 4> command = {99, 1, 0, 0};  // count, instances, first, base instance
        const QueryBuffer buffer(sizeof command);
        glBufferSubData(GL_QUERY_BUFFER, 0, sizeof command, command.data());
        const Query query;
        count_into_buffer(query, count, 0);
        glBindBuffer(GL_DRAW_INDIRECT_BUFFER, buffer.name());
        glDrawArraysIndirect(GL_QUADS, nullptr);
        EXPECT_EQ(drawn_pixels(), count == 4 ? kWhole.area() : 0) << count;
    }
    glDeleteBuffers(1, &vertices);
}

// QBO-11. Usage Examples, 1: "Using occlusion query result in shader".
TEST_F(QueryBufferUse, a_result_is_a_uniform_of_a_block) {
    const Program program({.vertex = kFixedVertexSource,
                           .fragment = "#version 140\n"
                                       "layout(std140) uniform Result { uint samples; };\n"
                                       "out vec4 colour;\n"
                                       "void main() { colour = vec4(float(samples) / 255.0); }\n"});
    for (const int count : {7, 0, 60}) {
        const QueryBuffer buffer;
        const Query query;
        glUseProgram(0);
        count_into_buffer(query, count, 0);
        glUseProgram(program.name());
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, buffer.name());
        draw_rect(kWhole, kNear);
        EXPECT_EQ(int{read_colours()[0][0]}, count);
    }
}

// QBO-11, as an index.
TEST_F(QueryBufferUse, a_result_is_an_index) {
    std::array<GLfloat, 3 * 16> points{};
    for (std::size_t i = 0; i < 16; ++i) {
        points[3 * i] = static_cast<GLfloat>(i) + 0.5f;
        points[3 * i + 1] = 9.5f;
        points[3 * i + 2] = kNear;
    }
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, points.data());
    for (const int count : {11, 0, 15}) {
        const QueryBuffer buffer;
        const Query query;
        count_into_buffer(query, count, 4);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer.name());
        glDrawElements(GL_POINTS, 1, GL_UNSIGNED_INT, to_offset(4));
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
        EXPECT_EQ(drawn_pixels(), 1);
        EXPECT_EQ(drawn_pixels({count, 9, 1, 1}), 1) << count;
    }
}

// QBO-11. GL 4.5, 6.6: copied by the GL, after the result.
TEST_F(QueryBufferUse, a_result_is_copied_from_buffer_to_buffer) {
    const QueryBuffer buffer;
    GLuint copy = 0;
    glGenBuffers(1, &copy);
    glBindBuffer(GL_ARRAY_BUFFER, copy);
    glBufferData(GL_ARRAY_BUFFER, 4, nullptr, GL_STATIC_COPY);
    for (const int count : {11, 0, 15}) {
        const Query query;
        count_into_buffer(query, count, 8);
        glCopyBufferSubData(GL_QUERY_BUFFER, GL_ARRAY_BUFFER, 8, 0, 4);
        GLint got = -1;
        glGetBufferSubData(GL_ARRAY_BUFFER, 0, sizeof got, &got);
        EXPECT_EQ(got, count);
    }
    glDeleteBuffers(1, &copy);
}

// QBO-13. ARB_occlusion_query, Issues: a counter that overflows saturates; a buffer gets what the counter
// shows.
TEST_F(QueryBufferUse, a_count_too_large_for_the_counter_is_written_as_it_is_read) {
    GLint bits = -1;
    glGetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS, &bits);
    const auto largest = static_cast<GLuint64>(bits >= 32 ? 0xFFFFFFFF : (1u << bits) - 1);
    constexpr int kLayers = 3;
    const Query query;
    query.begin();
    for (int i = 0; i < kLayers; ++i) draw_rect(kWhole, kNear);
    query.end();
    const GLuint64 expected = std::min<GLuint64>(largest, kLayers * static_cast<GLuint64>(kWhole.area()));
    for_each_type([&](auto type) {
        using Type = decltype(type);
        for (const GLenum parameter : {GL_QUERY_RESULT, GL_QUERY_RESULT_NO_WAIT}) {
            const QueryBuffer buffer;
            write_object<Type>(query.name(), parameter, 8);
            EXPECT_EQ(buffer.value_at<Type>(8), static_cast<Type>(expected));
            EXPECT_TRUE(buffer.is_poisoned_but(8, sizeof(Type)));
        }
    });
    EXPECT_EQ(query.result(), expected);
}

// QBO-13. Issue 6: "Should the extension support all query types supported by the current GL implementation?
// RESOLVED: YES." What is in the buffer is what the client reads.
TEST_F(QueryBufferUse, results_of_every_target_are_written) {
    std::vector<GLenum> targets = {GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_PRIMITIVES_GENERATED,
                                   GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, GL_TIME_ELAPSED};
    if (!lacks(43, "GL_ARB_ES3_compatibility")) targets.push_back(GL_ANY_SAMPLES_PASSED_CONSERVATIVE);
    if (!lacks(46, "GL_ARB_transform_feedback_overflow_query")) {
        for (const GLenum target : {GL_TRANSFORM_FEEDBACK_OVERFLOW, GL_TRANSFORM_FEEDBACK_STREAM_OVERFLOW}) {
            targets.push_back(target);
        }
    }
    if (!lacks(46, "GL_ARB_pipeline_statistics_query")) {
        for (const GLenum target :
             {GL_VERTICES_SUBMITTED, GL_PRIMITIVES_SUBMITTED, GL_VERTEX_SHADER_INVOCATIONS,
              GL_TESS_CONTROL_SHADER_PATCHES, GL_TESS_EVALUATION_SHADER_INVOCATIONS,
              GL_GEOMETRY_SHADER_INVOCATIONS, GL_GEOMETRY_SHADER_PRIMITIVES_EMITTED,
              GL_FRAGMENT_SHADER_INVOCATIONS, GL_COMPUTE_SHADER_INVOCATIONS, GL_CLIPPING_INPUT_PRIMITIVES,
              GL_CLIPPING_OUTPUT_PRIMITIVES}) {
            targets.push_back(target);
        }
    }
    const auto expect_same = [](GLuint name, GLenum target) {
        for_each_type([&](auto type) {
            using Type = decltype(type);
            Type in_memory = 0;
            get_object(name, GL_QUERY_RESULT, &in_memory);
            const QueryBuffer buffer;
            write_object<Type>(name, GL_QUERY_RESULT, 8);
            EXPECT_EQ(buffer.value_at<Type>(8), in_memory) << target;
            EXPECT_TRUE(buffer.is_poisoned_but(8, sizeof(Type))) << target;
            EXPECT_TRUE(no_error()) << target;
        });
    };
    for (const GLenum target : targets) {
        const Query query(target);
        query.begin();
        draw_rect({0, 0, 5, 1}, kNear);
        query.end();
        expect_same(query.name(), target);
    }
    const Query stamp;
    glQueryCounter(stamp.name(), GL_TIMESTAMP);
    expect_same(stamp.name(), GL_TIMESTAMP);
}

}  // namespace
}  // namespace conformance
