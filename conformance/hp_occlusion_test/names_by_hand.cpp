// SPDX-License-Identifier: MIT
// Names of lists that the application picks by hand, as GL allows: an implementation that keeps lists of its
// own for the test may not be met there (HP-67). Names of queries: overlap/names_by_hand.cpp.
#include "hp_occlusion_test/hp_test.h"

namespace conformance {
namespace {

constexpr GLuint kFirstNames = 16;  // where an implementation's own objects would lie

class ListNamesByHand : public HpTest {
  protected:
    // Of many commands of the test, so that an implementation that splits the list needs several of its own.
    static void compile_test(GLuint list) {
        glNewList(list, GL_COMPILE);
        for (int i = 0; i < 4; ++i) {
            glEnable(GL_OCCLUSION_TEST_HP);
            draw_point(i, 0, 0.0f);
            glDisable(GL_OCCLUSION_TEST_HP);
        }
        glEndList();
    }
};

// HP-67. GL compatibility: IsList is TRUE of the lists that NewList made and the names that GenLists gave.
TEST_F(ListNamesByHand, no_name_is_a_list_before_the_application_makes_one) {
    compile_test(1);
    EXPECT_TRUE(glIsList(1));
    for (GLuint name = 2; name < kFirstNames; ++name) EXPECT_FALSE(glIsList(name)) << name;
    EXPECT_TRUE(no_error());
}

// HP-67. GL compatibility: NewList takes any name; what it had before is replaced.
TEST_F(ListNamesByHand, lists_of_any_name_keep_their_commands) {
    compile_test(1);
    for (GLuint name = 2; name < kFirstNames; ++name) {
        glNewList(name, GL_COMPILE);
        draw_rect({static_cast<int>(name), 8, 1, 1}, 0.0f);
        glEndList();
    }
    glCallList(1);
    EXPECT_TRUE(read_result());
    EXPECT_EQ(drawn_pixels(), 4) << "the test's list runs other commands too";
    EXPECT_FALSE(test_enabled());
    for (GLuint name = 2; name < kFirstNames; ++name) glCallList(name);
    EXPECT_FALSE(read_result());
    EXPECT_EQ(drawn_pixels({0, 8, kSurfaceSize, 1}), static_cast<int>(kFirstNames) - 2);
    EXPECT_TRUE(no_error());
}

// HP-67. GL compatibility: DeleteLists ignores names that are no list; GenLists gives a range of free ones.
TEST_F(ListNamesByHand, deleting_and_generating_other_names_does_not_harm_the_list) {
    compile_test(1);
    glDeleteLists(2, 100);
    const GLuint range = glGenLists(50);
    EXPECT_NE(range, 0u);
    for (GLuint i = 0; i < 50; ++i) EXPECT_TRUE(glIsList(range + i));
    glCallList(1);
    EXPECT_TRUE(read_result());
    EXPECT_EQ(drawn_pixels(), 4);
    glDeleteLists(1, 1);
    glCallList(1);
    EXPECT_FALSE(read_result());
    EXPECT_TRUE(no_error());
}

}  // namespace
}  // namespace conformance
