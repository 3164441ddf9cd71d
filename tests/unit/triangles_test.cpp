// SPDX-License-Identifier: MIT
#include "features/triangles.h"

#include <gtest/gtest.h>

namespace glext_emu::features {
namespace {

// GL 4.6 compatibility, 10.1, primitive by primitive.
TEST(Triangles, follow_from_mode_and_count) {
    struct Row {
        GLenum mode;
        GLsizei count;
        std::uint64_t triangles;
    };
    const Row rows[] = {{GL_TRIANGLES, 6, 2},
                        {GL_TRIANGLES, 8, 2},
                        {GL_TRIANGLE_STRIP, 2, 0},
                        {GL_TRIANGLE_STRIP, 5, 3},
                        {GL_TRIANGLE_FAN, 3, 1},
                        {GL_POLYGON, 5, 3},
                        {GL_QUADS, 7, 2},
                        {GL_QUADS, 8, 4},
                        {GL_QUAD_STRIP, 3, 0},
                        {GL_QUAD_STRIP, 7, 4},
                        {GL_LINES, 8, 0},
                        {GL_POINTS, 8, 0},
                        {GL_TRIANGLES_ADJACENCY, 12, 2},
                        {GL_TRIANGLE_STRIP_ADJACENCY, 10, 3},
                        {GL_TRIANGLE_STRIP_ADJACENCY, 5, 0}};
    for (const Row& row : rows) {
        EXPECT_EQ(triangles(row.mode, row.count).count, row.triangles) << row.mode << " " << row.count;
        EXPECT_TRUE(triangles(row.mode, row.count).is_known);
    }
}

TEST(Triangles, of_instances_are_multiplied) {
    EXPECT_EQ(triangles(GL_TRIANGLES, 9, 4).count, 12u);
}

TEST(Triangles, of_a_draw_in_error_are_none) {
    EXPECT_EQ(triangles(GL_TRIANGLES, -3).count, 0u);
    EXPECT_EQ(triangles(GL_TRIANGLES, 3, -1).count, 0u);
    EXPECT_EQ(triangles(0xffff, 30).count, 0u);
}

TEST(Triangles, of_patches_are_the_tessellators_to_say) {
    EXPECT_FALSE(triangles(GL_PATCHES, 4).is_known);
}

TEST(Triangles, of_several_draws_add_up) {
    const GLsizei counts[] = {3, 6, 9};
    EXPECT_EQ(multi_triangles(GL_TRIANGLES, counts, 3).count, 6u);
    EXPECT_EQ(multi_triangles(GL_TRIANGLES, counts, 0).count, 0u);
    EXPECT_FALSE(multi_triangles(GL_PATCHES, counts, 3).is_known);
}

}  // namespace
}  // namespace glext_emu::features
