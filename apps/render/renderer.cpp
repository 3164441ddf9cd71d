// SPDX-License-Identifier: MIT
// All state is set where it changes and nowhere else: a culler alternates between objects and proxies often,
// and each change of state costs more than a proxy.
#include "apps/render/renderer.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <bit>

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
        find(sub_data, "glBufferSubData");
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
    PFNGLBUFFERSUBDATAPROC sub_data = nullptr;
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
    backward_indices_.resize(scene.indices.size());
    for (std::size_t i = 0; i < scene.indices.size(); ++i)
        backward_indices_[scene.indices.size() - 3 * (i / 3 + 1) + i % 3] = scene.indices[i];
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

Renderer::Paint Renderer::add_owner_paint() {
    owners_.assign(scene_.positions.size(), ~ObjectId{0});
    std::vector<glm::u8vec4> colours(scene_.positions.size());
    for (ObjectId id = 0; id < scene_.objects.size(); ++id) {
        const Object& object = scene_.objects[id];
        if (object.vertex_count == 0) continue;
        std::fill_n(colours.begin() + object.first_vertex, object.vertex_count,
                    std::bit_cast<glm::u8vec4>(id + 1));
        owners_[object.first_vertex] = id;
    }
    owner_paint_ = add_paint(std::move(colours));
    return owner_paint_;
}

void Renderer::paint_owner(ObjectId id) {
    const Object& object = scene_.objects[id];
    if (owners_[object.first_vertex] == id) return;
    owners_[object.first_vertex] = id;
    std::vector<glm::u8vec4>& colours = paints_[paint_];
    std::fill_n(colours.begin() + object.first_vertex, object.vertex_count,
                std::bit_cast<glm::u8vec4>(id + 1));
    if (!buffers_) return;
    buffers_->bind(GL_ARRAY_BUFFER, buffers_->paints[paint_]);
    buffers_->sub_data(GL_ARRAY_BUFFER, static_cast<GLintptr>(object.first_vertex * sizeof(glm::u8vec4)),
                       static_cast<GLsizeiptr>(object.vertex_count * sizeof(glm::u8vec4)),
                       colours.data() + object.first_vertex);
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
    modelview_ = modelview;
    placement_ = 0;
    width_ = width;
    height_ = height;
}

void Renderer::clear(const glm::vec4& colour) {
    if (mode_ == Mode::kProxies) leave_mode();  // masks hold for clearing too
    glClearColor(colour.r, colour.g, colour.b, colour.a);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Renderer::place(std::uint32_t placement) {
    if (placement_ == placement) return;
    placement_ = placement;
    const glm::mat4 matrix = placement == 0 ? modelview_ : modelview_ * scene_.placements[placement];
    glLoadMatrixf(&matrix[0][0]);
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

/// `next(i)` names the i-th object to draw; neighbours in the index array are one call.
template <class Next>
void Renderer::draw_runs(Next&& next, std::size_t count) {
    const bool is_owned = paint_ == owner_paint_;
    const auto total = static_cast<std::uint32_t>(scene_.indices.size());
    const auto first_of = [&](const Object& o) {
        return mode_ == Mode::kForwards ? o.first_index : total - o.first_index - o.index_count;
    };
    for (std::size_t i = 0; i < count;) {
        const Object& object = scene_.objects[next(i)];
        if (is_owned) paint_owner(next(i));
        place(object.placement);
        const std::uint32_t first = first_of(object);
        std::uint32_t length = object.index_count;
        for (++i; i < count; ++i) {
            const Object& neighbour = scene_.objects[next(i)];
            if (first_of(neighbour) != first + length || neighbour.placement != placement_) break;
            if (is_owned && owners_[neighbour.first_vertex] != next(i)) break;
            length += neighbour.index_count;
        }
        draw_run(first, length);
    }
}

void Renderer::draw(std::span<const ObjectId> objects) {
    use_objects(Mode::kForwards);
    draw_runs([&](std::size_t i) { return objects[i]; }, objects.size());
}

void Renderer::draw_backwards(std::span<const ObjectId> objects) {
    use_objects(Mode::kBackwards);
    draw_runs([&](std::size_t i) { return objects[objects.size() - 1 - i]; }, objects.size());
}

void Renderer::use_proxies() {
    if (mode_ == Mode::kProxies) return;
    mode_ = Mode::kProxies;
    place(0);
    glDepthMask(GL_FALSE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    if (buffers_) {
        buffers_->bind(GL_ARRAY_BUFFER, 0);
        buffers_->bind(GL_ELEMENT_ARRAY_BUFFER, 0);
    }
    // Colours as the objects have: the same vertex program runs, so positions round the same way.
    set_proxy_arrays();
}

void Renderer::set_proxy_arrays() {
    glVertexPointer(3, GL_FLOAT, 0, proxy_corners_.data());
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, proxy_colours_.data());
}

void Renderer::draw_proxies(std::span<const Box> boxes) {
    use_proxies();
    if (proxy_corners_.size() < 8 * boxes.size()) {
        for (auto box = static_cast<std::uint32_t>(proxy_corners_.size() / 8); box < boxes.size(); ++box)
            for (const GLubyte corner : kBoxTriangles) proxy_indices_.push_back(8 * box + corner);
        proxy_corners_.resize(8 * boxes.size());
        proxy_colours_.resize(8 * boxes.size());
        set_proxy_arrays();
    }
    for (std::size_t box = 0; box < boxes.size(); ++box)
        for (int corner = 0; corner < 8; ++corner)
            proxy_corners_[8 * box + static_cast<std::size_t>(corner)] = boxes[box].corner(corner);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(36 * boxes.size()), GL_UNSIGNED_INT,
                   proxy_indices_.data());
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
