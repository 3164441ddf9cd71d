// SPDX-License-Identifier: MIT
#include "features/features.h"

#include "context/settings.h"

namespace glext_emu::features {

GLint max_occlusion_shapes() {
    return settings().device.unit_max_shapes.value_or(65536);
}

GLint unit_counter_bits() {
    return settings().device.unit_counter_bits.value_or(64);
}

void begin_occlusion_unit_emu(Context&, GLbitfield, GLuint) {
}
void end_occlusion_unit_emu(Context&) {
}
void get_occlusion_records_emu(Context&, GLuint, GLsizei, GLsizei, GLocclusionrecordEMU*) {
}
void draw_under_unit(Context&, DrawCall call) {
    call();
}

}  // namespace glext_emu::features
