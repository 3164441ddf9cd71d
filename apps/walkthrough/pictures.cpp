// SPDX-License-Identifier: MIT
// The pictures of a frame. Edges are smoothed by averaging passes that are shifted by parts of a pixel.
#include "apps/walkthrough/pictures.h"

#include <glm/gtc/matrix_transform.hpp>
#include <numeric>

#include "apps/report/picture.h"

namespace apps {
namespace {

constexpr int kGrid = 4;  // passes per axis

/// Edges of a box: pairs of corner numbers that differ in one bit.
constexpr int kEdges[12][2] = {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3},
                               {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
constexpr int kFaces[6][4] = {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4},
                              {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}};

struct Eye {
    glm::mat4 modelview;
    glm::mat4 projection;
};

template <class Draw>
void save(Renderer& renderer, const Frame& frame, const Eye& eye, const std::filesystem::path& file,
          Draw&& draw) {
    const int width = frame.view.width;
    const int height = frame.view.height;
    Picture picture(width, height);
    for (int pass = 0; pass < kGrid * kGrid; ++pass) {
        const glm::vec2 cell(pass % kGrid, pass / kGrid);
        const glm::vec2 shift = (cell + 0.5F) / static_cast<float>(kGrid) - 0.5F;
        renderer.set_matrices(eye.modelview, shifted(eye.projection, shift, width, height), width, height);
        draw();
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

/// From above and behind the south, over everything but what is as wide as the scene itself.
Eye from_above(const Frame& frame) {
    const glm::vec3 size = frame.scene.bounds.max - frame.scene.bounds.min;
    Box part;
    for (const Object& object : frame.scene.objects) {
        const glm::vec3 extent = object.box.max - object.box.min;
        if (std::max(extent.x, extent.y) < 0.25F * std::max(size.x, size.y)) part.add(object.box);
    }
    const glm::vec3 towards = glm::normalize(glm::vec3(-0.35F, 0.62F, -0.80F));
    const glm::mat4 modelview =
        glm::lookAt(part.centre() - 3000.0F * towards, part.centre(), glm::vec3(0, 0, 1));
    Box seen;
    for (int corner = 0; corner < 8; ++corner)
        seen.add(glm::vec3(modelview * glm::vec4(part.corner(corner), 1)));
    const glm::vec3 half = (seen.max - seen.min) * 0.5F;
    const float aspect = static_cast<float>(frame.view.width) / static_cast<float>(frame.view.height);
    const float half_height = 1.03F * std::max(half.y, half.x / aspect);
    const glm::vec3 c = seen.centre();
    return {modelview, glm::ortho(c.x - half_height * aspect, c.x + half_height * aspect, c.y - half_height,
                                  c.y + half_height, 100.0F, 6000.0F)};
}

/// The camera's frustum on the ground, as far as the scene reaches.
void add_frustum(const Frame& frame, Renderer::Shapes& lines, Renderer::Shapes& faces) {
    const glm::mat4 to_world = glm::inverse(frame.view.projection * frame.view.modelview);
    const auto along = [&](float x, float y) {
        const glm::vec4 p = to_world * glm::vec4(x, y, 0, 1);
        return glm::normalize(glm::vec3(p) / p.w - frame.view.eye);
    };
    const float reach = 0.55F * glm::length(frame.scene.bounds.max - frame.scene.bounds.min);
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

/// The baked colours, taken towards `tint` by `amount` and thinned towards white by `fade`.
std::vector<glm::u8vec4> tinted(const Scene& scene, const std::vector<std::uint8_t>* highlighted) {
    std::vector<glm::u8vec4> colours = scene.colours;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const bool is_highlighted = highlighted && (*highlighted)[id];
        for (std::uint32_t v = 0; v < scene.objects[id].vertex_count; ++v) {
            glm::u8vec4& colour = colours[scene.objects[id].first_vertex + v];
            const glm::vec3 c = glm::vec3(colour) / 255.0F;
            const float light = glm::dot(c, glm::vec3(0.30F, 0.59F, 0.11F));
            const glm::vec3 shown = is_highlighted
                                        ? glm::vec3(1.0F, 0.52F, 0.12F) * (0.35F + 0.95F * light)
                                        : glm::mix(glm::vec3(light), glm::vec3(0.93F, 0.94F, 0.95F), 0.62F);
            colour = {glm::u8vec3(glm::min(shown, 1.0F) * 255.0F + 0.5F), 255};
        }
    }
    return colours;
}

std::vector<ObjectId> all_of(const Scene& scene) {
    std::vector<ObjectId> all(scene.objects.size());
    std::iota(all.begin(), all.end(), ObjectId{0});
    return all;
}

void save_view(Renderer& renderer, const Frame& frame, const std::filesystem::path& file) {
    std::vector<ObjectId> drawn = frame.drawn;
    std::sort(drawn.begin(), drawn.end());
    save(renderer, frame, {frame.view.modelview, frame.view.projection}, file, [&] {
        renderer.clear({0.66F, 0.80F, 0.94F, 1});
        renderer.draw(drawn);
    });
}

void save_above(Renderer& renderer, const Frame& frame, const std::filesystem::path& file) {
    const auto all = all_of(frame.scene);
    Renderer::Shapes lines;
    Renderer::Shapes faces;
    add_frustum(frame, lines, faces);
    const Renderer::Paint paint = renderer.add_paint(tinted(frame.scene, &frame.is_drawn));
    renderer.use_paint(paint, false);
    save(renderer, frame, from_above(frame), file, [&] {
        renderer.clear({1, 1, 1, 1});
        renderer.draw(all);
        renderer.draw_triangles(faces, true);
        renderer.draw_lines(lines, 2, true);
    });
    renderer.use_paint(Renderer::kBaked, false);
}

void save_nodes(Renderer& renderer, const Frame& frame, const std::filesystem::path& file) {
    const auto all = all_of(frame.scene);
    Renderer::Shapes lines;
    Renderer::Shapes faces;
    for (NodeId id = 0; id < frame.tree.nodes.size(); ++id) {
        const KdNode& node = frame.tree.nodes[id];
        const NodeClass c = frame.classes[id];
        if (c == NodeClass::kVisible && node.is_leaf)
            add_box(&lines, &faces, node.box, {0.55F, 0.24F, 0, 0.8F}, {1, 0.58F, 0.10F, 0.9F});
        if (c == NodeClass::kOccluded)
            add_box(&lines, &faces, node.box, {0.20F, 0.32F, 0.50F, 0.45F}, {0.45F, 0.60F, 0.80F, 0.10F});
        if (c == NodeClass::kOutside) add_box(&lines, nullptr, node.box, {0.5F, 0.5F, 0.5F, 0.16F}, {});
    }
    Renderer::Shapes frustum_lines;
    Renderer::Shapes frustum_faces;
    add_frustum(frame, frustum_lines, frustum_faces);
    const Renderer::Paint paint = renderer.add_paint(tinted(frame.scene, nullptr));
    renderer.use_paint(paint, false);
    save(renderer, frame, from_above(frame), file, [&] {
        renderer.clear({1, 1, 1, 1});
        renderer.draw(all);
        renderer.draw_triangles(frustum_faces, true);
        renderer.draw_triangles(faces, false);
        renderer.draw_lines(lines, 1, false);
        renderer.draw_lines(frustum_lines, 2, true);
    });
    renderer.use_paint(Renderer::kBaked, false);
}

}  // namespace

void save_pictures(Renderer& renderer, const Frame& frame, const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    save_view(renderer, frame, folder / "view.png");
    save_above(renderer, frame, folder / "above.png");
    save_nodes(renderer, frame, folder / "nodes.png");
}

}  // namespace apps
