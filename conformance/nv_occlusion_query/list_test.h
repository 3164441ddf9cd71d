// SPDX-License-Identifier: MIT
// What the tests of occlusion queries in display lists share: to compile one.
#pragma once

#include "nv_occlusion_query/nv_test.h"

namespace conformance {

class ListTest : public NvTest {
  protected:
    template <typename Commands>
    static GLuint compile(Commands commands, GLenum mode = GL_COMPILE, GLuint list = glGenLists(1)) {
        glNewList(list, mode);
        commands();
        glEndList();
        EXPECT_TRUE(no_error());
        return list;
    }
};

}  // namespace conformance
