// SPDX-License-Identifier: MIT
// Lines, translucent faces and finished pixels for pictures; never part of a timed frame.
#include "apps/platform/gl.h"
#include "apps/render/renderer.h"

namespace apps {

void Renderer::Shapes::add_line(const glm::vec3& from, const glm::vec3& to, const glm::vec4& colour) {
    corners.insert(corners.end(), {from, to});
    colours.insert(colours.end(), 2, colour);
}

void Renderer::Shapes::add_quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                                const glm::vec3& d, const glm::vec4& colour) {
    corners.insert(corners.end(), {a, b, c, a, c, d});
    colours.insert(colours.end(), 6, colour);
}

void Renderer::draw_shapes(unsigned primitive, const Shapes& shapes, bool on_top) {
    use_proxies();  // the arrays are in the client's memory
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    if (on_top) glDisable(GL_DEPTH_TEST);
    glVertexPointer(3, GL_FLOAT, 0, shapes.corners.data());
    glColorPointer(4, GL_FLOAT, 0, shapes.colours.data());
    glDrawArrays(primitive, 0, static_cast<GLsizei>(shapes.corners.size()));
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    use_objects(Mode::kForwards);
}

void Renderer::draw_lines(const Shapes& shapes, float width_pixels, bool on_top) {
    glLineWidth(width_pixels);
    draw_shapes(GL_LINES, shapes, on_top);
}

void Renderer::draw_triangles(const Shapes& shapes, bool on_top) {
    draw_shapes(GL_TRIANGLES, shapes, on_top);
}

void Renderer::write_pixels(const std::vector<glm::u8vec4>& pixels) {
    leave_mode();
    glDisable(GL_DEPTH_TEST);
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    glLoadIdentity();
    glRasterPos2f(-1, -1);
    glDrawPixels(width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    glPopMatrix();
    glMatrixMode(GL_PROJECTION);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    glEnable(GL_DEPTH_TEST);
}

}  // namespace apps
