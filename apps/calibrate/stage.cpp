// SPDX-License-Identifier: MIT
// State changes where what is drawn changes, and nowhere else.
#include "apps/calibrate/stage.h"

#include <string>

namespace apps {
namespace {

// Corner k has max on axis i where bit i of k is set; counter-clockwise from outside.
constexpr GLubyte kBoxTriangles[36] = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                       2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
constexpr float kDepth = 0.5F;
constexpr GLubyte kBoxColours[32] = {};

std::vector<float> mesh_positions(MeshSize size) {
    const QuadSize quad = quad_size(size);
    std::vector<float> positions;
    for (int row = 0; row <= kMeshRows; ++row)
        for (int column = 0; column <= kMeshColumns; ++column) {
            positions.push_back(static_cast<float>(quad.width * column));
            positions.push_back(static_cast<float>(quad.height * row));
            positions.push_back(kDepth);
        }
    return positions;
}

}  // namespace

Stage::Stage(Platform& platform, int width, int height) : width_(width), height_(height) {
    load_functions(platform);
    make_meshes();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDisable(GL_DITHER);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    set_view(width, height);
    clear();
}

Stage::~Stage() {
    drop_framebuffer();
    delete_queries_(static_cast<GLsizei>(queries_.size()), queries_.data());
    delete_buffers_(static_cast<GLsizei>(buffers_.size()), buffers_.data());
}

void Stage::load_functions(Platform& platform) {
    const auto find = [&](auto& function, const std::string& name) {
        function =
            reinterpret_cast<std::remove_reference_t<decltype(function)>>(platform.function(name.c_str()));
    };
    if (!platform.has_extension("GL_ARB_vertex_buffer_object") && !platform.is_at_least(1, 5))
        throw PlatformError("this GL has no buffer objects, so nothing can be in its video memory");
    if (!platform.has_extension("GL_ARB_occlusion_query") && !platform.is_at_least(1, 5))
        throw PlatformError("this GL has no GL_ARB_occlusion_query to time");
    const std::string buffer = platform.has_extension("GL_ARB_vertex_buffer_object") ? "ARB" : "";
    find(gen_buffers_, "glGenBuffers" + buffer);
    find(delete_buffers_, "glDeleteBuffers" + buffer);
    find(bind_buffer_, "glBindBuffer" + buffer);
    find(buffer_data_, "glBufferData" + buffer);
    const std::string query = platform.has_extension("GL_ARB_occlusion_query") ? "ARB" : "";
    find(gen_queries_, "glGenQueries" + query);
    find(delete_queries_, "glDeleteQueries" + query);
    find(begin_query_, "glBeginQuery" + query);
    find(end_query_, "glEndQuery" + query);
    find(get_query_object_, "glGetQueryObjectuiv" + query);
    if (!platform.has_extension("GL_ARB_framebuffer_object") && !platform.is_at_least(3, 0)) return;
    find(framebuffers_.gen, "glGenFramebuffers");
    find(framebuffers_.remove, "glDeleteFramebuffers");
    find(framebuffers_.bind, "glBindFramebuffer");
    find(framebuffers_.gen_store, "glGenRenderbuffers");
    find(framebuffers_.remove_store, "glDeleteRenderbuffers");
    find(framebuffers_.bind_store, "glBindRenderbuffer");
    find(framebuffers_.store, "glRenderbufferStorage");
    find(framebuffers_.attach, "glFramebufferRenderbuffer");
}

template <class T>
GLuint Stage::make_buffer(GLenum target, const std::vector<T>& values) {
    GLuint name = 0;
    gen_buffers_(1, &name);
    bind_buffer_(target, name);
    buffer_data_(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
    bind_buffer_(target, 0);
    buffers_.push_back(name);
    return name;
}

void Stage::make_meshes() {
    for (int row = 0; row < kMeshRows; ++row)
        for (int column = 0; column < kMeshColumns; ++column) {
            const auto corner = static_cast<GLuint>(row * (kMeshColumns + 1) + column);
            const GLuint above = corner + kMeshColumns + 1;
            indices_.insert(indices_.end(), {corner, corner + 1, above, above, corner + 1, above + 1});
        }
    sub_pixel_ = mesh_positions(MeshSize::kSubPixel);
    colours_.assign(sub_pixel_.size() / 3 * 4, 200);
    std::vector<float> quads;
    for (int eighths = 1; eighths <= 8; ++eighths) {
        const auto right = static_cast<float>(width_ * eighths / 8);
        const auto top = static_cast<float>(height_ * eighths / 8);
        for (const auto& [x, y] :
             {std::pair{0.0F, 0.0F}, {right, 0.0F}, {right, top}, {0.0F, 0.0F}, {right, top}, {0.0F, top}})
            quads.insert(quads.end(), {x, y, kDepth});
    }
    sub_pixel_buffer_ = make_buffer(GL_ARRAY_BUFFER, sub_pixel_);
    pixels_buffer_ = make_buffer(GL_ARRAY_BUFFER, mesh_positions(MeshSize::kPixels));
    quad_buffer_ = make_buffer(GL_ARRAY_BUFFER, quads);
    colour_buffer_ = make_buffer(GL_ARRAY_BUFFER, colours_);
    index_buffer_ = make_buffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
}

void Stage::set_view(int width, int height) {
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, width, 0, height, 0, -1);  // z is the depth in the window
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

void Stage::use_buffers(GLuint positions) {
    bind_buffer_(GL_ARRAY_BUFFER, positions);
    glVertexPointer(3, GL_FLOAT, 0, nullptr);
    bind_buffer_(GL_ARRAY_BUFFER, colour_buffer_);
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, nullptr);
    bind_buffer_(GL_ELEMENT_ARRAY_BUFFER, index_buffer_);
}

void Stage::use(Mode mode) {
    if (mode_ == mode) return;
    const bool was_proxies = mode_ == Mode::kProxies;
    const bool is_proxies = mode == Mode::kProxies;
    if (was_proxies != is_proxies) {
        const GLboolean writes = is_proxies ? GL_FALSE : GL_TRUE;
        glDepthMask(writes);
        glColorMask(writes, writes, writes, writes);
    }
    mode_ = mode;
    if (mode == Mode::kSubPixel) use_buffers(sub_pixel_buffer_);
    if (mode == Mode::kPixels) use_buffers(pixels_buffer_);
    if (mode == Mode::kQuads) use_buffers(quad_buffer_);
    if (mode != Mode::kClient && mode != Mode::kProxies) return;
    bind_buffer_(GL_ARRAY_BUFFER, 0);
    bind_buffer_(GL_ELEMENT_ARRAY_BUFFER, 0);
    glVertexPointer(3, GL_FLOAT, 0, is_proxies ? corners_.data() : sub_pixel_.data());
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, is_proxies ? kBoxColours : colours_.data());
}

void Stage::mesh(int triangles, MeshSize size) {
    use(size == MeshSize::kSubPixel ? Mode::kSubPixel : Mode::kPixels);
    glDrawElements(GL_TRIANGLES, 3 * triangles, GL_UNSIGNED_INT, nullptr);
}

void Stage::client_mesh(int triangles) {
    use(Mode::kClient);
    glDrawElements(GL_TRIANGLES, 3 * triangles, GL_UNSIGNED_INT, indices_.data());
}

void Stage::quad(int eighths) {
    use(Mode::kQuads);
    glDrawArrays(GL_TRIANGLES, 6 * (eighths - 1), 6);
}

void Stage::query(int side) {
    if (next_query_ == queries_.size()) {
        queries_.push_back(0);
        gen_queries_(1, &queries_.back());
    }
    use(Mode::kProxies);
    for (std::size_t corner = 0; corner < 8; ++corner) {
        corners_[3 * corner] = (corner & 1) != 0 ? static_cast<float>(side) : 0;
        corners_[3 * corner + 1] = (corner & 2) != 0 ? static_cast<float>(side) : 0;
        corners_[3 * corner + 2] = (corner & 4) != 0 ? kDepth : kDepth / 2;
    }
    begin_query_(GL_SAMPLES_PASSED, queries_[next_query_++]);
    glDrawElements(GL_TRIANGLES, 36, GL_UNSIGNED_BYTE, kBoxTriangles);
    end_query_(GL_SAMPLES_PASSED);
}

void Stage::wait(std::size_t query) {
    GLuint samples = 0;
    get_query_object_(queries_.at(query), GL_QUERY_RESULT, &samples);
}

void Stage::poll() {
    GLuint is_there = 0;
    get_query_object_(queries_.at(0), GL_QUERY_RESULT_AVAILABLE, &is_there);
}

void Stage::read(int side) {
    depths_.resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    glReadPixels(0, 0, side, side, GL_DEPTH_COMPONENT, GL_FLOAT, depths_.data());
}

void Stage::clear() {
    if (mode_ == Mode::kProxies) use(Mode::kSubPixel);  // masks hold for clearing too
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Stage::finish() {
    glFinish();
}

void Stage::drop_framebuffer() {
    if (framebuffer_ == 0) return;
    framebuffers_.bind(GL_FRAMEBUFFER, 0);
    framebuffers_.remove(1, &framebuffer_);
    framebuffers_.remove_store(2, stores_.data());
    framebuffer_ = 0;
}

void Stage::use_framebuffer(int width, int height) {
    if (width == framebuffer_width_ && height == framebuffer_height_) return;
    drop_framebuffer();
    framebuffer_width_ = width;
    framebuffer_height_ = height;
    if (width == 0) {
        set_view(width_, height_);
        return;
    }
    framebuffers_.gen(1, &framebuffer_);
    framebuffers_.bind(GL_FRAMEBUFFER, framebuffer_);
    framebuffers_.gen_store(2, stores_.data());
    const std::array<std::pair<GLenum, GLenum>, 2> kinds = {
        {{GL_RGBA8, GL_COLOR_ATTACHMENT0}, {GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT}}};
    for (std::size_t i = 0; i < 2; ++i) {
        framebuffers_.bind_store(GL_RENDERBUFFER, stores_[i]);
        framebuffers_.store(GL_RENDERBUFFER, kinds[i].first, width, height);
        framebuffers_.attach(GL_FRAMEBUFFER, kinds[i].second, GL_RENDERBUFFER, stores_[i]);
    }
    set_view(width, height);
}

}  // namespace apps
