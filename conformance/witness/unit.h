// SPDX-License-Identifier: MIT
// The commands of GL_EMU_occlusion_unit, and its records beside what the witness says.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "harness/gl.h"

#include <GL/glext_emu.h>  // behind harness/gl.h, which asks for the prototypes of GL

#include "witness/machine.h"
#include "witness/simulation.h"

namespace conformance {

inline std::array<int, 4> box_of(const GLocclusionrecordEMU& record) {
    return {record.box[0], record.box[1], record.box[2], record.box[3]};
}

// One query object of the unit.
class UnitQuery {
  public:
    UnitQuery() { glGenQueries(1, &name_); }
    ~UnitQuery() { glDeleteQueries(1, &name_); }
    UnitQuery(const UnitQuery&) = delete;
    UnitQuery& operator=(const UnitQuery&) = delete;

    GLuint name() const { return name_; }
    void begin() const {
        command<PFNGLBEGINOCCLUSIONUNITEMUPROC>("glBeginOcclusionUnitEMU")(GL_ALL_REGISTERS_EMU, name_);
    }
    void end() const { command<PFNGLENDOCCLUSIONUNITEMUPROC>("glEndOcclusionUnitEMU")(); }
    void ask_shapes(GLenum shape, GLsizei count, const GLfloat* vertices, const GLfloat* matrix) const {
        command<PFNGLOCCLUSIONUNITSHAPESEMUPROC>("glOcclusionUnitShapesEMU")(GL_ALL_REGISTERS_EMU, shape,
                                                                             count, vertices, matrix, name_);
    }
    std::vector<GLocclusionrecordEMU> records(GLsizei count = 1) const {
        std::vector<GLocclusionrecordEMU> all(static_cast<std::size_t>(count));
        command<PFNGLGETOCCLUSIONRECORDSEMUPROC>("glGetOcclusionRecordsEMU")(name_, 0, count, all.data());
        return all;
    }

  private:
    GLuint name_ = 0;
};

inline void set_far_end(GLenum end) {
    command<PFNGLFARDEPTHEMUPROC>("glFarDepthEMU")(end);
}

}  // namespace conformance
