// SPDX-License-Identifier: MIT
// GL_HP_occlusion_test: is a rectangle behind a wall visible, and one before it?
#include <GL/gl.h>
#include <GL/glext.h>
#include <SDL2/SDL.h>

static void test(const char* name, float z) {
    GLboolean is_visible = GL_FALSE;
    glLoadIdentity(), glTranslatef(0, 0, z), glRectf(-0.5f, -0.5f, 0.5f, 0.5f);
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &is_visible);
    printf("%s the wall: %s\n", name, is_visible ? "visible" : "occluded");
}

int main(void) {
    SDL_GL_CreateContext(SDL_CreateWindow("", 0, 0, 64, 64, SDL_WINDOW_OPENGL));
    glEnable(GL_DEPTH_TEST), glClear(GL_DEPTH_BUFFER_BIT), glRectf(-1, -1, 1, 1);
    glEnable(GL_OCCLUSION_TEST_HP);
    test("behind", 0.5f), test("before", -0.5f);
}
