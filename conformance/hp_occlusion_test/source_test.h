// SPDX-License-Identifier: MIT
// Ways to make fragments, as tables: each draws something at depth 0 of its own, moved by the modelview
// matrix once in front of an occluder and once behind it.
#pragma once

#include <array>

#include "hp_occlusion_test/hp_test.h"

namespace conformance {

struct Source {
    const char* name;
    int version;  // the GL that has the command
    void (*draw)();
};

inline constexpr std::array<GLfloat, 12> kCorners = {8.0f,  8.0f,  0.0f, 40.0f, 8.0f,  0.0f,
                                                     40.0f, 40.0f, 0.0f, 8.0f,  40.0f, 0.0f};
inline constexpr std::array<GLushort, 4> kOrder = {0, 1, 2, 3};

inline void draw_corners(GLenum mode) {
    glBegin(mode);
    for (std::size_t i = 0; i < kCorners.size(); i += 3) glVertex3fv(&kCorners[i]);
    glEnd();
}

class SourceTest : public HpTest, public ::testing::WithParamInterface<Source> {
  protected:
    // HP-57. NV 4.1.6A: "Whenever a fragment reaches this stage", whatever made it.
    static void expect_to_count_when_and_only_when_visible() {
        draw_occluder();
        glDepthMask(GL_FALSE);
        for (const bool visible : {true, false}) {
            glClear(GL_COLOR_BUFFER_BIT);
            glLoadIdentity();
            glTranslatef(0.0f, 0.0f, visible ? kNear : kFar);
            EXPECT_EQ(result_of(GetParam().draw), visible);
            EXPECT_EQ(drawn_pixels() > 0, visible);
            EXPECT_TRUE(no_error());
        }
    }
};

inline std::string source_name(const ::testing::TestParamInfo<Source>& info) {
    return info.param.name;
}

}  // namespace conformance
