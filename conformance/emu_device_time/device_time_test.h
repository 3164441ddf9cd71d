// SPDX-License-Identifier: MIT
// What the tests of GL_EMU_device_time share: its command, the two clocks by whichever way the machine has,
// and work of unknown but positive cost. Nothing here knows what anything costs.
//
// The commands of ARB_timer_query are asked of the window system: below GL 3.3 no library has to export them.
#pragma once

#include "harness/gl_test.h"
#include "harness/query.h"

// After glext.h with its prototypes, which it includes without.
#include <GL/glext_emu.h>

namespace conformance {

// The CPU's clock: a Get of TIMESTAMP, nanoseconds.
GLint64 cpu_time();
void device_work(GLuint64 nanoseconds);

// A stamp of the GPU's clock; its result is waited for by `time_of`.
void stamp(const Query& query);
GLint64 time_of(const Query& query);
bool is_there(const Query& query);

// Draws all pixels so many times: the GPU works longer at it than the CPU does.
void draw_layers(int layers);

class DeviceTimeTest : public GlTest {
  protected:
    void SetUp() override;
};

}  // namespace conformance
