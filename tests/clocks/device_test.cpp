// SPDX-License-Identifier: MIT
#include "device_test.h"

#include <initializer_list>
#include <utility>
#include <vector>

namespace clock_tests {
namespace {

// The first of the buffer's vertices that are not all the same point.
constexpr GLint kZeros = 30'000;
constexpr GLint kFloats = 3;  // of a vertex

}  // namespace

GLint64 cpu() {
    GLint64 time = -1;
    glGetInteger64v(GL_TIMESTAMP, &time);
    return time;
}

GLint64 gpu() {
    const conformance::Query stamp;
    glQueryCounter(stamp.name(), GL_TIMESTAMP);
    GLint64 time = -1;
    glGetQueryObjecti64v(stamp.name(), GL_QUERY_RESULT, &time);
    return time;
}

void work(GLuint64 nanoseconds) {
    static const auto device_work = command<PFNGLDEVICEWORKEMUPROC>("glDeviceWorkEMU");
    device_work(nanoseconds);
}

bool is_available(const conformance::Query& query) {
    GLuint available = GL_FALSE;
    glGetQueryObjectuiv(query.name(), GL_QUERY_RESULT_AVAILABLE, &available);
    return available == GL_TRUE;
}

void draw(int triangles) {
    glDrawArrays(GL_TRIANGLES, 0, 3 * triangles);
}

void fill(float depth) {
    glPushMatrix();
    glTranslatef(0.0f, 0.0f, depth);
    glDrawArrays(GL_TRIANGLES, kZeros, 6);
    glPopMatrix();
}

void ask(const conformance::Query& query) {
    query.begin();
    query.end();
}

void DeviceTest::SetUp() {
    ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
    if (const auto why = conformance::lacks("GL_EMU_device_time")) GTEST_SKIP() << *why;
    constexpr float kEnd = conformance::kSurfaceSize;
    std::vector<GLfloat> vertices(std::size_t{kZeros} * kFloats, 0.0f);
    for (const auto& [x, y] : std::initializer_list<std::pair<float, float>>{
             {0, 0}, {kEnd, 0}, {kEnd, kEnd}, {0, 0}, {kEnd, kEnd}, {0, kEnd}})
        vertices.insert(vertices.end(), {x, y, 0.0f});
    glGenBuffers(1, &buffer_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(GLfloat)), vertices.data(),
                 GL_STATIC_DRAW);
    glVertexPointer(kFloats, GL_FLOAT, 0, nullptr);
    glEnableClientState(GL_VERTEX_ARRAY);
    rest();
}

void DeviceTest::TearDown() {
    glDeleteBuffers(1, &buffer_);
    GlTest::TearDown();
}

GLint64 DeviceTest::rest() {
    glFinish();
    return cpu();
}

}  // namespace clock_tests
