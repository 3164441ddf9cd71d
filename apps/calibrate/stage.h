// SPDX-License-Identifier: MIT
// The commands of the benchmarks on GL, in the state that the cullers' renderer uses: vertex arrays in buffer
// objects, fixed function with a colour a vertex, proxies from client memory without colour or depth writes.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <vector>

#include "apps/calibrate/commands.h"
#include "apps/platform/platform.h"

namespace apps {

class Stage final : public Commands {
  public:
    /// The context of <platform> is current and its window has this size, multiples of 8. Throws
    /// PlatformError where it lacks buffer objects or occlusion queries.
    Stage(Platform& platform, int width, int height);
    ~Stage() override;
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    void mesh(int triangles, MeshSize size) override;
    void quad(int eighths) override;
    void query(int side) override;
    void wait(std::size_t query) override;
    void read(int side) override;
    void clear() override;
    void finish() override;

    /// The same as mesh, from client memory.
    void client_mesh(int triangles);
    /// Asks whether query 0 is there.
    void poll();
    /// The next query() is number 0 again; those before have to be finished.
    void restart() { next_query_ = 0; }
    void flush() { glFlush(); }

    bool has_framebuffers() const { return framebuffers_.gen != nullptr; }
    /// Draws into a framebuffer object of its own of that size from now on; 0 x 0: into the window again.
    void use_framebuffer(int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }

  private:
    enum class Mode { kNone, kSubPixel, kPixels, kQuads, kClient, kProxies };
    struct Framebuffers {
        PFNGLGENFRAMEBUFFERSPROC gen = nullptr;
        PFNGLDELETEFRAMEBUFFERSPROC remove = nullptr;
        PFNGLBINDFRAMEBUFFERPROC bind = nullptr;
        PFNGLGENRENDERBUFFERSPROC gen_store = nullptr;
        PFNGLDELETERENDERBUFFERSPROC remove_store = nullptr;
        PFNGLBINDRENDERBUFFERPROC bind_store = nullptr;
        PFNGLRENDERBUFFERSTORAGEPROC store = nullptr;
        PFNGLFRAMEBUFFERRENDERBUFFERPROC attach = nullptr;
    };

    template <class T>
    GLuint make_buffer(GLenum target, const std::vector<T>& values);
    void load_functions(Platform& platform);
    void make_meshes();
    void use(Mode mode);
    void use_buffers(GLuint positions);
    void set_view(int width, int height);
    void drop_framebuffer();

    int width_, height_;
    Mode mode_ = Mode::kNone;
    PFNGLGENBUFFERSPROC gen_buffers_ = nullptr;
    PFNGLDELETEBUFFERSPROC delete_buffers_ = nullptr;
    PFNGLBINDBUFFERPROC bind_buffer_ = nullptr;
    PFNGLBUFFERDATAPROC buffer_data_ = nullptr;
    PFNGLGENQUERIESPROC gen_queries_ = nullptr;
    PFNGLDELETEQUERIESPROC delete_queries_ = nullptr;
    PFNGLBEGINQUERYPROC begin_query_ = nullptr;
    PFNGLENDQUERYPROC end_query_ = nullptr;
    PFNGLGETQUERYOBJECTUIVPROC get_query_object_ = nullptr;
    Framebuffers framebuffers_;
    GLuint framebuffer_ = 0;
    int framebuffer_width_ = 0, framebuffer_height_ = 0;
    std::array<GLuint, 2> stores_{};
    std::vector<GLuint> buffers_;
    std::vector<GLuint> queries_;
    std::size_t next_query_ = 0;
    std::vector<float> sub_pixel_;
    std::vector<GLubyte> colours_;
    std::vector<GLuint> indices_;
    GLuint sub_pixel_buffer_ = 0, pixels_buffer_ = 0, quad_buffer_ = 0, colour_buffer_ = 0, index_buffer_ = 0;
    std::array<float, 24> corners_{};
    std::vector<float> depths_;
};

}  // namespace apps
