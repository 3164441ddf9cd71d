// SPDX-License-Identifier: MIT
// All state is set where it changes and nowhere else: a culler alternates between objects and proxies often,
// and each change of state costs more than a proxy.
#include "apps/render/renderer.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>

#include "apps/platform/gl.h"

namespace apps {

/// Buffer objects by name: GL_ARB_vertex_buffer_object, or GL 1.5 which made it core.
struct Renderer::Buffers {
    explicit Buffers(Platform& platform) {
        const std::string suffix = platform.has_extension("GL_ARB_vertex_buffer_object") ? "ARB" : "";
        const auto find = [&](auto& function, const char* name) {
            function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(
                platform.function((name + suffix).c_str()));
        };
        find(gen, "glGenBuffers");
        find(remove, "glDeleteBuffers");
        find(bind, "glBindBuffer");
        find(data, "glBufferData");
    }

    template <class T>
    GLuint make(GLenum target, const std::vector<T>& values) {
        GLuint name = 0;
        gen(1, &name);
        bind(target, name);
        data(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
        bind(target, 0);
        all.push_back(name);
        return name;
    }

    PFNGLGENBUFFERSPROC gen = nullptr;
    PFNGLDELETEBUFFERSPROC remove = nullptr;
    PFNGLBINDBUFFERPROC bind = nullptr;
    PFNGLBUFFERDATAPROC data = nullptr;
    GLuint positions = 0;
    GLuint indices = 0;
    GLuint backward_indices = 0;
    std::vector<GLuint> paints;
    std::vector<GLuint> all;
};

namespace {

// Corner k has max on axis i where bit i of k is set; counter-clockwise from outside.
constexpr GLubyte kBoxTriangles[36] = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                       2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};

}  // namespace

Renderer::Renderer(Platform& platform, const Scene& scene) : scene_(scene) {
    has_buffers_ = platform.has_extension("GL_ARB_vertex_buffer_object") || platform.is_at_least(1, 5);
    for (auto object = scene.objects.rbegin(); object != scene.objects.rend(); ++object) {
        const auto first = scene.indices.begin() + object->first_index;
        backward_indices_.insert(backward_indices_.end(), first, first + object->index_count);
    }
    if (has_buffers_) {
        buffers_ = std::make_unique<Buffers>(platform);
        buffers_->positions = buffers_->make(GL_ARRAY_BUFFER, scene.positions);
        buffers_->indices = buffers_->make(GL_ELEMENT_ARRAY_BUFFER, scene.indices);
        buffers_->backward_indices = buffers_->make(GL_ELEMENT_ARRAY_BUFFER, backward_indices_);
    }
    add_paint(scene.colours);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDisable(GL_DITHER);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    // Case 6, depth resolution: what lies on the face of its box must not lose to it, whatever the triangles
    // round to.
    glPolygonOffset(-1, -1);
}

Renderer::~Renderer() {
    if (buffers_) buffers_->remove(static_cast<GLsizei>(buffers_->all.size()), buffers_->all.data());
}

Renderer::Paint Renderer::add_paint(std::vector<glm::u8vec4> colours) {
    if (buffers_) buffers_->paints.push_back(buffers_->make(GL_ARRAY_BUFFER, colours));
    paints_.push_back(std::move(colours));
    leave_mode();
    return paints_.size() - 1;
}

void Renderer::use_paint(Paint paint, bool is_flat) {
    paint_ = paint;
    leave_mode();
    glShadeModel(is_flat ? GL_FLAT : GL_SMOOTH);
}

void Renderer::set_matrices(const glm::mat4& modelview, const glm::mat4& projection, int width, int height) {
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(&projection[0][0]);
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixf(&modelview[0][0]);
    width_ = width;
    height_ = height;
}

void Renderer::clear(const glm::vec4& colour) {
    if (mode_ == Mode::kProxies) leave_mode();  // masks hold for clearing too
    glClearColor(colour.r, colour.g, colour.b, colour.a);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Renderer::leave_mode() {
    if (mode_ == Mode::kProxies) {
        glDisable(GL_POLYGON_OFFSET_FILL);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glDepthMask(GL_TRUE);
    }
    mode_ = Mode::kNone;
}

void Renderer::use_objects(Mode mode) {
    if (mode_ == mode) return;
    leave_mode();
    mode_ = mode;
    if (!buffers_) {
        glVertexPointer(3, GL_FLOAT, 0, scene_.positions.data());
        glColorPointer(4, GL_UNSIGNED_BYTE, 0, paints_[paint_].data());
        return;
    }
    buffers_->bind(GL_ARRAY_BUFFER, buffers_->positions);
    glVertexPointer(3, GL_FLOAT, 0, nullptr);
    buffers_->bind(GL_ARRAY_BUFFER, buffers_->paints[paint_]);
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, nullptr);
    buffers_->bind(GL_ELEMENT_ARRAY_BUFFER,
                   mode == Mode::kForwards ? buffers_->indices : buffers_->backward_indices);
}

void Renderer::draw_run(std::uint32_t first_index, std::uint32_t count) {
    const std::vector<std::uint32_t>& indices = mode_ == Mode::kForwards ? scene_.indices : backward_indices_;
    const std::uint32_t* base = buffers_ ? nullptr : indices.data();
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT, base + first_index);
}

void Renderer::draw(std::span<const ObjectId> objects) {
    use_objects(Mode::kForwards);
    for (std::size_t i = 0; i < objects.size();) {  // neighbours in the arrays are one call
        const Object& first = scene_.objects[objects[i]];
        std::uint32_t count = first.index_count;
        for (++i; i < objects.size() && objects[i] == objects[i - 1] + 1; ++i)
            count += scene_.objects[objects[i]].index_count;
        draw_run(first.first_index, count);
    }
}

void Renderer::draw_backwards(std::span<const ObjectId> objects) {
    use_objects(Mode::kBackwards);
    const auto total = static_cast<std::uint32_t>(scene_.indices.size());
    for (std::size_t i = objects.size(); i > 0;) {
        const Object& last = scene_.objects[objects[--i]];
        std::uint32_t count = last.index_count;
        for (; i > 0 && objects[i - 1] + 1 == objects[i]; --i)
            count += scene_.objects[objects[i - 1]].index_count;
        draw_run(total - last.first_index - last.index_count, count);
    }
}

void Renderer::use_proxies() {
    if (mode_ == Mode::kProxies) return;
    mode_ = Mode::kProxies;
    glDepthMask(GL_FALSE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    if (buffers_) {
        buffers_->bind(GL_ARRAY_BUFFER, 0);
        buffers_->bind(GL_ELEMENT_ARRAY_BUFFER, 0);
    }
    // Colours as the objects have: the same vertex program runs, so positions round the same way.
    glVertexPointer(3, GL_FLOAT, 0, proxy_corners_);
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, proxy_colours_);
}

void Renderer::draw_proxy(const Box& box) {
    use_proxies();
    for (int corner = 0; corner < 8; ++corner) proxy_corners_[corner] = box.corner(corner);
    glDrawElements(GL_TRIANGLES, 36, GL_UNSIGNED_BYTE, kBoxTriangles);
}

void Renderer::finish() {
    glFinish();
}

std::vector<std::uint32_t> Renderer::read_pixels() const {
    std::vector<std::uint32_t> pixels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
}

}  // namespace apps
