// SPDX-License-Identifier: MIT
// Frames as glxgears makes them: three toothed wheels in display lists, turned a little each frame, in a
// window of 300 x 300. What a device's clock costs where draws are few and the driver alone knows what they
// draw.
#include <GL/gl.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <iterator>

#include "pbuffer_context.h"

namespace {

struct Wheel {
    float x, y, radius;
    int teeth;
};
constexpr Wheel kWheels[] = {{-3, -2, 4, 20}, {3.1F, -2, 2, 10}, {-3.1F, 4.2F, 2, 10}};
constexpr int kSide = 300;
constexpr float kPi = 3.14159265F;

void point(float radius, float angle, float z) {
    glVertex3f(radius * std::cos(angle), radius * std::sin(angle), z);
}

// Two faces of quads from the hub outwards, teeth, and the rim between the faces.
void draw_wheel(const Wheel& wheel) {
    const float step = 2 * kPi / static_cast<float>(wheel.teeth);
    for (const float z : {-0.5F, 0.5F}) {
        glNormal3f(0, 0, z < 0 ? -1.0F : 1.0F);
        glBegin(GL_QUAD_STRIP);
        for (int i = 0; i <= wheel.teeth * 2; ++i) {
            const float angle = step / 2 * static_cast<float>(i);
            point(wheel.radius / 4, angle, z);
            point(wheel.radius, angle, z);
        }
        glEnd();
        glBegin(GL_QUADS);
        for (int i = 0; i < wheel.teeth; ++i) {
            const float angle = step * static_cast<float>(i);
            point(wheel.radius, angle, z);
            point(wheel.radius + 0.7F, angle + step / 8, z);
            point(wheel.radius + 0.7F, angle + step * 3 / 8, z);
            point(wheel.radius, angle + step / 2, z);
        }
        glEnd();
    }
    glBegin(GL_QUAD_STRIP);
    for (int i = 0; i <= wheel.teeth * 4; ++i) {
        const float angle = step / 4 * static_cast<float>(i);
        glNormal3f(std::cos(angle), std::sin(angle), 0);
        point(wheel.radius, angle, -0.5F);
        point(wheel.radius, angle, 0.5F);
    }
    glEnd();
}

void set_up() {
    glViewport(0, 0, kSide, kSide);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, -1, 1, 5, 60);
    glMatrixMode(GL_MODELVIEW);
    const GLfloat light[] = {5, 5, 10, 0};
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    for (const GLenum on : {GL_LIGHTING, GL_LIGHT0, GL_DEPTH_TEST, GL_NORMALIZE}) glEnable(on);
}

void draw_frame(GLuint lists, int frame) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    GLuint list = lists;
    for (const Wheel& wheel : kWheels) {
        glLoadIdentity();
        glTranslatef(0, 0, -40);
        glRotatef(20, 1, 0, 0);
        glRotatef(30, 0, 1, 0);
        glTranslatef(wheel.x, wheel.y, 0);
        glRotatef(2.0F * static_cast<float>(frame), 0, 0, 1);
        glCallList(list++);
    }
}

}  // namespace

int main(int argc, char** argv) {
    const int frames = argc == 3 && std::strcmp(argv[1], "--frames") == 0 ? std::atoi(argv[2]) : 0;
    if (frames <= 0) {
        std::fprintf(stderr, "usage: %s --frames N\n", argv[0]);
        return 2;
    }
    benchmarks::make_pbuffer_context(kSide, kSide);
    set_up();
    const GLuint lists = glGenLists(std::size(kWheels));
    for (GLuint i = 0; i < std::size(kWheels); ++i) {
        glNewList(lists + i, GL_COMPILE);
        draw_wheel(kWheels[i]);
        glEndList();
    }
    const EGLDisplay display = eglGetCurrentDisplay();
    const EGLSurface surface = eglGetCurrentSurface(EGL_DRAW);
    for (int frame = 0; frame <= frames; ++frame) {
        draw_frame(lists, frame);
        glFinish();
        eglSwapBuffers(display, surface);
    }
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
        std::fprintf(stderr, "GL error 0x%x\n", error);
        return 1;
    }
    std::printf("%d frames of %d lists on GL %s\n", frames, static_cast<int>(std::size(kWheels)),
                reinterpret_cast<const char*>(glGetString(GL_VERSION)));
}
