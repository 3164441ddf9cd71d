// SPDX-License-Identifier: MIT
#include "emu_device_time/device_time_test.h"

namespace conformance {
namespace {

template <typename Command>
Command command(const char* name) {
    return reinterpret_cast<Command>(platform().get_proc_address(name));
}

}  // namespace

GLint64 cpu_time() {
    static const auto get = command<PFNGLGETINTEGER64VPROC>("glGetInteger64v");
    GLint64 time = -1;
    get(GL_TIMESTAMP, &time);
    return time;
}

void device_work(GLuint64 nanoseconds) {
    static const auto work = command<PFNGLDEVICEWORKEMUPROC>("glDeviceWorkEMU");
    work(nanoseconds);
}

void stamp(const Query& query) {
    static const auto count = command<PFNGLQUERYCOUNTERPROC>("glQueryCounter");
    count(query.name(), GL_TIMESTAMP);
}

GLint64 time_of(const Query& query) {
    static const auto get = command<PFNGLGETQUERYOBJECTUI64VPROC>("glGetQueryObjectui64v");
    GLuint64 time = 0;
    get(query.name(), GL_QUERY_RESULT, &time);
    return static_cast<GLint64>(time);
}

bool is_there(const Query& query) {
    GLuint available = GL_FALSE;
    glGetQueryObjectuiv(query.name(), GL_QUERY_RESULT_AVAILABLE, &available);
    return available == GL_TRUE;
}

void draw_layers(int layers) {
    for (int i = 0; i < layers; ++i) draw_rect(kWhole, kNear);
}

void DeviceTimeTest::SetUp() {
    ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
    if (const auto why = lacks("GL_EMU_device_time")) GTEST_SKIP() << *why;
}

}  // namespace conformance
