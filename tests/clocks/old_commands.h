// SPDX-License-Identifier: MIT
// The commands and names of GL_NV_occlusion_query and GL_HP_occlusion_test, which no library but libGL links.
#pragma once

#include "harness/gl.h"
#include "harness/gl_test.h"

namespace clock_tests {

inline constexpr GLenum kOcclusionTest = 0x8165;
inline constexpr GLenum kOcclusionTestResult = 0x8166;

struct NvCommands {
    PFNGLGENOCCLUSIONQUERIESNVPROC generate = find<PFNGLGENOCCLUSIONQUERIESNVPROC>("glGenOcclusionQueriesNV");
    PFNGLDELETEOCCLUSIONQUERIESNVPROC remove =
        find<PFNGLDELETEOCCLUSIONQUERIESNVPROC>("glDeleteOcclusionQueriesNV");
    PFNGLBEGINOCCLUSIONQUERYNVPROC begin = find<PFNGLBEGINOCCLUSIONQUERYNVPROC>("glBeginOcclusionQueryNV");
    PFNGLENDOCCLUSIONQUERYNVPROC end = find<PFNGLENDOCCLUSIONQUERYNVPROC>("glEndOcclusionQueryNV");
    PFNGLGETOCCLUSIONQUERYIVNVPROC get = find<PFNGLGETOCCLUSIONQUERYIVNVPROC>("glGetOcclusionQueryivNV");
    PFNGLGETOCCLUSIONQUERYUIVNVPROC get_unsigned =
        find<PFNGLGETOCCLUSIONQUERYUIVNVPROC>("glGetOcclusionQueryuivNV");

  private:
    template <typename Command>
    static Command find(const char* name) {
        return reinterpret_cast<Command>(conformance::platform().get_proc_address(name));
    }
};

}  // namespace clock_tests
