// SPDX-License-Identifier: MIT
// Display lists that are called, opened or closed in the midst of a primitive, while lists are compiled and
// executed, or under names that are in use (HP-67, HP-68, HP-72: "as before for all other state").
//
// GL 4.5 compatibility, 10.7.5 and 21.4: CallList and CallLists are legal between Begin and End, and what a
// list holds is executed as if it stood there; a list may hold a Begin without its End, or the reverse; the
// old definition of a list stands until EndList.
#include "hp_occlusion_test/hp_test.h"

namespace conformance {
namespace {

class ListsAndPrimitives : public HpTest {
  protected:
    void SetUp() override {
        HpTest::SetUp();
        use_pixel_coordinates();
    }
    template <typename Commands>
    static void define(GLuint list, Commands commands, GLenum mode = GL_COMPILE) {
        glNewList(list, mode);
        commands();
        glEndList();
    }
    static void corner(int x, int y) {
        glVertex3f(static_cast<GLfloat>(x), static_cast<GLfloat>(y), kMiddle);
    }
    // The lower left half, vertex by vertex.
    static void first_corner() { corner(0, 0); }
    static void other_corners() {
        corner(kSurfaceSize, 0);
        corner(0, kSurfaceSize);
    }
    static int pixels_of(void (*draw)()) {
        clear();
        draw();
        return drawn_pixels();
    }
    static int half() {
        return pixels_of([] {
            glBegin(GL_TRIANGLES);
            first_corner();
            other_corners();
            glEnd();
        });
    }
};

TEST_F(ListsAndPrimitives,
       a_list_called_inside_a_primitive_of_a_list_that_is_compiled_and_executed_adds_to_it) {
    const int expected = half();
    define(7, first_corner);
    const auto primitive = [] {
        glBegin(GL_TRIANGLES);
        glCallList(7);
        other_corners();
        glEnd();
    };
    clear();
    define(8, primitive, GL_COMPILE_AND_EXECUTE);
    EXPECT_EQ(drawn_pixels(), expected) << "executed";
    EXPECT_EQ(pixels_of([] { glCallList(8); }), expected) << "called";
    EXPECT_TRUE(no_error());
}

TEST_F(ListsAndPrimitives, call_lists_inside_a_primitive_adds_the_list_base) {
    const int expected = half();
    define(107, first_corner);
    glListBase(100);
    EXPECT_EQ(pixels_of([] {
                  const GLubyte offset = 7;
                  glBegin(GL_TRIANGLES);
                  glCallLists(1, GL_UNSIGNED_BYTE, &offset);
                  other_corners();
                  glEnd();
              }),
              expected);
    EXPECT_TRUE(no_error());
}

TEST_F(ListsAndPrimitives, a_list_may_close_the_primitive_that_the_program_opened) {
    define(7, [] { glEnd(); });
    glBegin(GL_TRIANGLES);
    first_corner();
    other_corners();
    glCallList(7);
    glEnable(GL_OCCLUSION_TEST_HP);
    EXPECT_TRUE(test_enabled());
    draw_point(0, 0, kNear);
    EXPECT_TRUE(read_result());
    EXPECT_TRUE(no_error());
}

TEST_F(ListsAndPrimitives, a_list_may_open_the_primitive_that_the_program_closes) {
    define(7, [] { glBegin(GL_TRIANGLES); });
    glEnable(GL_OCCLUSION_TEST_HP);
    glCallList(7);
    GLboolean untouched = 0xAA;
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &untouched);
    EXPECT_EQ(untouched, 0xAA);
    first_corner();
    other_corners();
    glEnd();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "of the Get between Begin and End";
    EXPECT_TRUE(read_result());
}

TEST_F(ListsAndPrimitives, a_name_that_was_never_defined_draws_nothing) {
    const int expected = half();
    define(1, [] {
        glEnable(GL_OCCLUSION_TEST_HP);
        glDisable(GL_OCCLUSION_TEST_HP);
        glBegin(GL_TRIANGLES);
        first_corner();
        other_corners();
        glEnd();
    });
    clear();
    for (GLuint list = 2; list < 20; ++list) glCallList(list);
    EXPECT_EQ(drawn_pixels(), 0);
    EXPECT_EQ(pixels_of([] { glCallList(1); }), expected);
}

TEST_F(ListsAndPrimitives, the_old_list_stands_until_the_new_one_is_ended) {
    const int expected = half();
    const auto triangle = [] {
        glBegin(GL_TRIANGLES);
        first_corner();
        other_corners();
        glEnd();
    };
    define(1, triangle);
    clear();
    define(
        1,
        [] {
            glDisable(GL_OCCLUSION_TEST_HP);
            glCallList(1);
        },
        GL_COMPILE_AND_EXECUTE);
    EXPECT_EQ(drawn_pixels(), expected) << "the list of before was called";
    EXPECT_TRUE(no_error());
    define(1, [] {});
    EXPECT_EQ(pixels_of([] { glCallList(1); }), 0) << "the new one is empty";
}

}  // namespace
}  // namespace conformance
