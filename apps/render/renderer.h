// SPDX-License-Identifier: MIT
// Draws a scene's objects, and the proxies of occlusion tests, with fixed-function GL 1.1: vertex arrays in
// buffer objects where the machine advertises them, else in the client's memory. One Renderer to a context.
// A placed object is drawn with the modelview matrix times its placement, multiplied in float, whoever draws
// it: its pixels are the same in every picture. Depth test LEQUAL, no face culling, no blending, no
// dithering: a picture is a function of the set of objects.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "apps/platform/platform.h"
#include "apps/scene/scene.h"

namespace apps {

class Renderer {
  public:
    Renderer(Platform& platform, const Scene& scene);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// A set of colours, one to a vertex of the scene; kBaked is the scene's own.
    using Paint = std::size_t;
    static constexpr Paint kBaked = 0;
    Paint add_paint(std::vector<glm::u8vec4> colours);

    /// Objects in the colour that is their id + 1, as 32 bits of RGBA8, also those that share a mesh.
    Paint add_owner_paint();

    /// `is_flat`: no interpolation, every pixel has exactly the colour of its vertices.
    void use_paint(Paint paint, bool is_flat);

    void set_matrices(const glm::mat4& modelview, const glm::mat4& projection, int width, int height);

    /// Clears colour and depth.
    void clear(const glm::vec4& colour);

    void draw(std::span<const ObjectId> objects);

    /// Prepares for draw(), so that it sets no state.
    void use_forwards() { use_objects(Mode::kForwards); }

    /// The same, last object first; `objects` ascending.
    void draw_backwards(std::span<const ObjectId> objects);

    /// Prepares for draw_proxies, which draws the twelve triangles of each box without changing a pixel.
    void use_proxies();
    void draw_proxies(std::span<const Box> boxes);

    /// What a picture shows besides the scene. Two corners to a line, three to a triangle; world metres, RGBA
    /// in 0..1. Blended over what is there, hidden by what is nearer unless `on_top`, and no depth is
    /// written.
    struct Shapes {
        std::vector<glm::vec3> corners;
        std::vector<glm::vec4> colours;
        void add_line(const glm::vec3& from, const glm::vec3& to, const glm::vec4& colour);
        void add_quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d,
                      const glm::vec4& colour);
    };
    void draw_lines(const Shapes& shapes, float width_pixels, bool on_top);
    void draw_triangles(const Shapes& shapes, bool on_top);

    void finish();

    /// RGBA of the whole view, bottom row first.
    std::vector<std::uint32_t> read_pixels() const;

    /// Puts RGBA, bottom row first, over the whole view; depth stays.
    void write_pixels(const std::vector<glm::u8vec4>& pixels);

    bool has_buffer_objects() const { return has_buffers_; }

  private:
    enum class Mode { kNone, kForwards, kBackwards, kProxies };
    struct Buffers;
    static constexpr Paint kNoPaint = ~Paint{0};

    void leave_mode();
    void use_objects(Mode mode);
    template <class Next>
    void draw_runs(Next&& next, std::size_t count);
    void draw_run(std::uint32_t first_index, std::uint32_t count);
    void place(std::uint32_t placement);
    void set_proxy_arrays();
    void paint_owner(ObjectId id);
    void draw_shapes(unsigned primitive, const Shapes& shapes, bool on_top);

    const Scene& scene_;
    bool has_buffers_ = false;
    std::unique_ptr<Buffers> buffers_;
    std::vector<std::uint32_t> backward_indices_;
    std::vector<std::vector<glm::u8vec4>> paints_;
    Paint paint_ = kBaked;
    Paint owner_paint_ = kNoPaint;
    std::vector<ObjectId> owners_;  // by first vertex of a mesh: in whose colour it is in the owner paint
    glm::mat4 modelview_{1};
    std::uint32_t placement_ = 0;  // that the modelview matrix holds now
    Mode mode_ = Mode::kNone;
    int width_ = 0;
    int height_ = 0;
    std::vector<glm::vec3> proxy_corners_;
    std::vector<glm::u8vec4> proxy_colours_;
    std::vector<std::uint32_t> proxy_indices_;
};

}  // namespace apps
