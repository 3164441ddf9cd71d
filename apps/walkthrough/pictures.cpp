// SPDX-License-Identifier: MIT
// The pictures of a frame. Edges are smoothed by averaging passes that are shifted by parts of a pixel.
#include "apps/walkthrough/pictures.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numeric>

#include "apps/report/picture.h"
#include "apps/walkthrough/lighting.h"

namespace apps {
namespace {

constexpr int kGrid = 3;        // passes per axis
constexpr int kCoarseGrid = 2;  // of scenes that take seconds to draw
constexpr std::uint64_t kManyTriangles = 4'000'000;

/// Edges of a box: pairs of corner numbers that differ in one bit.
constexpr int kEdges[12][2] = {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3},
                               {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
constexpr int kFaces[6][4] = {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4},
                              {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}};

/// The passes of a picture, each a part of a pixel aside; lighting is most of their cost, and two pictures
/// share it.
struct Passes {
    std::vector<Eye> eyes;
    std::vector<std::vector<Lit>> pixels;
};

Passes light(Lighting& lighting, const Frame& frame, const Eye& eye, std::span<const ObjectId> objects) {
    const int width = frame.view.width;
    const int height = frame.view.height;
    const int grid = triangles_of(frame.scene, objects) > kManyTriangles ? kCoarseGrid : kGrid;
    Passes passes;
    for (int pass = 0; pass < grid * grid; ++pass) {
        const glm::vec2 cell(pass % grid, pass / grid);
        const glm::vec2 shift = (cell + 0.5F) / static_cast<float>(grid) - 0.5F;
        passes.eyes.push_back({eye.modelview, shifted(eye.projection, shift, width, height)});
        passes.pixels.push_back(
            lighting.light(passes.eyes.back(), width, height, objects, static_cast<unsigned>(pass)));
    }
    return passes;
}

/// `colour` turns a lit pixel into what is shown; `overlay` draws over it, `hidden_by` what is nearer of
/// them.
template <class Colour, class Overlay>
void save(Renderer& renderer, const Frame& frame, const Passes& passes, std::span<const ObjectId> hidden_by,
          const std::filesystem::path& file, Colour&& colour, Overlay&& overlay) {
    Picture picture(frame.view.width, frame.view.height);
    std::vector<glm::u8vec4> shown(passes.pixels.front().size());
    for (std::size_t pass = 0; pass < passes.eyes.size(); ++pass) {
        std::transform(
            passes.pixels[pass].begin(), passes.pixels[pass].end(), shown.begin(), [&](const Lit& lit) {
                return glm::u8vec4(glm::u8vec3(glm::clamp(colour(lit), 0.0F, 1.0F) * 255.0F + 0.5F), 255);
            });
        renderer.set_matrices(passes.eyes[pass].modelview, passes.eyes[pass].projection, frame.view.width,
                              frame.view.height);
        renderer.clear(glm::vec4(1));
        renderer.draw(hidden_by);
        renderer.write_pixels(shown);
        overlay();
        picture.add(renderer.read_pixels());
    }
    picture.save(file);
}

void add_box(Renderer::Shapes* lines, Renderer::Shapes* faces, const Box& box, const glm::vec4& line,
             const glm::vec4& face) {
    if (lines)
        for (const auto& edge : kEdges) lines->add_line(box.corner(edge[0]), box.corner(edge[1]), line);
    if (faces)
        for (const auto& f : kFaces)
            faces->add_quad(box.corner(f[0]), box.corner(f[1]), box.corner(f[2]), box.corner(f[3]), face);
}

/// From above and behind the south, over everything that stands up, and the eye.
Eye from_above(const Frame& frame) {
    const float height = frame.scene.bounds.max.z - frame.scene.bounds.min.z;
    Box part;
    part.add(frame.view.eye);
    for (const Object& object : frame.scene.objects)
        if (object.box.max.z - object.box.min.z > 0.02F * height) part.add(object.box);
    const glm::vec3 towards = glm::normalize(glm::vec3(-0.35F, 0.62F, -0.80F));
    Box all = frame.scene.bounds;
    all.add(part);
    const float reach = glm::length(all.max - all.min);
    const glm::mat4 modelview =
        glm::lookAt(part.centre() - reach * towards, part.centre(), glm::vec3(0, 0, 1));
    Box seen;
    for (int corner = 0; corner < 8; ++corner)
        seen.add(glm::vec3(modelview * glm::vec4(part.corner(corner), 1)));
    const glm::vec3 half = (seen.max - seen.min) * 0.5F;
    const float aspect = static_cast<float>(frame.view.width) / static_cast<float>(frame.view.height);
    const float half_height = 1.02F * std::max(half.y, half.x / aspect);
    const glm::vec3 c = seen.centre();
    return {modelview, glm::ortho(c.x - half_height * aspect, c.x + half_height * aspect, c.y - half_height,
                                  c.y + half_height, 0.0F, 2 * reach)};
}

/// The camera's frustum on the ground, as far as the scene reaches.
void add_frustum(const Frame& frame, Renderer::Shapes& lines, Renderer::Shapes& faces) {
    const glm::mat4 to_world = glm::inverse(frame.view.projection * frame.view.modelview);
    const auto along = [&](float x, float y) {
        const glm::vec4 p = to_world * glm::vec4(x, y, 0, 1);
        return glm::normalize(glm::vec3(p) / p.w - frame.view.eye);
    };
    const Box& bounds = frame.scene.bounds;
    const float reach =
        std::max(0.55F * glm::length(bounds.max - bounds.min), glm::length(bounds.centre() - frame.view.eye));
    const float height = std::max(frame.view.eye.z, 1.0F);
    const auto flat = [&](float x) {
        const glm::vec3 ray = along(x, 0);
        return glm::vec3(glm::vec2(frame.view.eye) + reach * glm::normalize(glm::vec2(ray)), height);
    };
    const glm::vec3 eye(glm::vec2(frame.view.eye), height);
    const glm::vec4 blue{0.05F, 0.30F, 0.75F, 0.95F};
    lines.add_line(eye, flat(-1), blue);
    lines.add_line(eye, flat(1), blue);
    const glm::vec4 wash{0.20F, 0.50F, 0.95F, 0.13F};
    faces.corners.insert(faces.corners.end(), {eye, flat(-1), flat(1)});
    faces.colours.insert(faces.colours.end(), 3, wash);
}

/// Bright parts keep their differences.
glm::vec3 toned(const glm::vec3& colour) {
    return 1.06F * colour / (1.0F + 0.22F * colour * colour);
}

/// A model of white card, with what `is_highlighted` in orange.
glm::vec3 card(const Lighting& lighting, const Lit& lit, bool is_highlighted) {
    if (lit.is_sky()) return glm::vec3(1);
    const float grey = glm::dot(lighting.albedo(lit), glm::vec3(0.30F, 0.59F, 0.11F));
    const glm::vec3 albedo = is_highlighted ? glm::vec3(1.0F, 0.50F, 0.10F) * (0.62F + 0.5F * grey)
                                            : glm::vec3(0.72F + 0.20F * grey);
    const glm::vec3 light = is_highlighted ? lit.light : glm::mix(glm::vec3(0.95F), lit.light, 0.62F);
    return toned(albedo * light);
}

std::vector<ObjectId> all_of(const Scene& scene) {
    std::vector<ObjectId> all(scene.objects.size());
    std::iota(all.begin(), all.end(), ObjectId{0});
    return all;
}

void save_view(Renderer& renderer, Lighting& lighting, const Frame& frame,
               const std::filesystem::path& file) {
    std::vector<ObjectId> drawn = frame.drawn;
    std::sort(drawn.begin(), drawn.end());
    const Passes passes = light(lighting, frame, {frame.view.modelview, frame.view.projection}, drawn);
    const auto colour = [&](const Lit& lit) {
        if (lit.is_sky()) return lit.light;
        const float haze = 1 - std::exp(-lit.distance / 900);
        return glm::mix(toned(lighting.albedo(lit) * lit.light), glm::vec3(0.80F, 0.87F, 0.94F), haze);
    };
    save(renderer, frame, passes, {}, file, colour, [] {});
}

void save_above(Renderer& renderer, const Lighting& lighting, const Frame& frame, const Passes& passes,
                const std::filesystem::path& file) {
    Renderer::Shapes lines;
    Renderer::Shapes faces;
    add_frustum(frame, lines, faces);
    const auto colour = [&](const Lit& lit) {
        return card(lighting, lit, !lit.is_sky() && frame.is_drawn[lit.object]);
    };
    save(renderer, frame, passes, {}, file, colour, [&] {
        renderer.draw_triangles(faces, true);
        renderer.draw_lines(lines, 2, true);
    });
}

void save_nodes(Renderer& renderer, const Lighting& lighting, const Frame& frame, const Passes& passes,
                const std::filesystem::path& file) {
    Renderer::Shapes lines;
    Renderer::Shapes faces;
    for (NodeId id = 0; id < frame.tree.nodes.size(); ++id) {
        const Node& node = frame.tree.nodes[id];
        const NodeClass c = frame.classes[id];
        if (c == NodeClass::kVisible && node.is_leaf)
            add_box(&lines, &faces, node.box, {0.50F, 0.20F, 0, 0.7F}, {1, 0.55F, 0.08F, 0.8F});
        if (c == NodeClass::kOccluded)
            add_box(&lines, &faces, node.box, {0.12F, 0.26F, 0.48F, 0.6F}, {0.35F, 0.55F, 0.85F, 0.11F});
        if (c == NodeClass::kOutside) add_box(&lines, nullptr, node.box, {0.35F, 0.35F, 0.35F, 0.22F}, {});
    }
    Renderer::Shapes frustum_lines;
    Renderer::Shapes frustum_faces;
    add_frustum(frame, frustum_lines, frustum_faces);
    save(
        renderer, frame, passes, all_of(frame.scene), file,
        [&](const Lit& lit) { return card(lighting, lit, false); },
        [&] {
            renderer.draw_triangles(frustum_faces, true);
            renderer.draw_triangles(faces, false);
            renderer.draw_lines(lines, 1, false);
            renderer.draw_lines(frustum_lines, 2, true);
        });
}

}  // namespace

void save_pictures(Renderer& renderer, const Frame& frame, const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    Lighting lighting(renderer, frame.scene, frame.tree);
    save_view(renderer, lighting, frame, folder / "view.png");
    const Passes above = light(lighting, frame, from_above(frame), all_of(frame.scene));
    save_above(renderer, lighting, frame, above, folder / "above.png");
    save_nodes(renderer, lighting, frame, above, folder / "nodes.png");
}

}  // namespace apps
