// SPDX-License-Identifier: MIT
// Immediate-mode drawing in pixels, and reading back what it did.
#include "harness/draw.h"

#include <algorithm>

namespace conformance {

void use_pixel_coordinates(int width, int height) {
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    // With near 0 and far -1, z_ndc = 2 z - 1, hence window depth = z.
    glOrtho(0.0, width, 0.0, height, 0.0, -1.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glColor4f(1.0f, 1.0f, 1.0f, 1.0f);
}

void clear(float depth) {
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClearDepth(depth);
    glClearStencil(0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void draw_rect(const Rect& rect, float depth) {
    const auto left = static_cast<GLfloat>(rect.x);
    const auto bottom = static_cast<GLfloat>(rect.y);
    const auto right = static_cast<GLfloat>(rect.x + rect.width);
    const auto top = static_cast<GLfloat>(rect.y + rect.height);
    glBegin(GL_QUADS);
    glVertex3f(left, bottom, depth);
    glVertex3f(right, bottom, depth);
    glVertex3f(right, top, depth);
    glVertex3f(left, top, depth);
    glEnd();
}

void draw_triangle(float depth) {
    glBegin(GL_TRIANGLES);
    glVertex3f(0.0f, 0.0f, depth);
    glVertex3f(kSurfaceSize, 0.0f, depth);
    glVertex3f(0.0f, kSurfaceSize, depth);
    glEnd();
}

void draw_point(int x, int y, float depth) {
    glBegin(GL_POINTS);
    glVertex3f(static_cast<GLfloat>(x) + 0.5f, static_cast<GLfloat>(y) + 0.5f, depth);
    glEnd();
}

void draw_occluder() {
    clear();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw_rect(kWhole, kMiddle);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

int drawn_pixels(const Rect& rect) {
    const auto colours = read_colours(rect);
    return static_cast<int>(std::count_if(colours.begin(), colours.end(), [](const auto& colour) {
        return colour[0] != 0 || colour[1] != 0 || colour[2] != 0;
    }));
}

std::vector<std::array<GLubyte, 4>> read_colours(const Rect& rect) {
    std::vector<std::array<GLubyte, 4>> colours(static_cast<std::size_t>(rect.area()));
    glReadPixels(rect.x, rect.y, rect.width, rect.height, GL_RGBA, GL_UNSIGNED_BYTE, colours.data());
    return colours;
}

std::vector<GLfloat> read_depths(const Rect& rect) {
    std::vector<GLfloat> depths(static_cast<std::size_t>(rect.area()));
    glReadPixels(rect.x, rect.y, rect.width, rect.height, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    return depths;
}

}  // namespace conformance
