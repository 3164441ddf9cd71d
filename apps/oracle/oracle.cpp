// SPDX-License-Identifier: MIT
// Item buffers and their comparison. A pixel holds id + 1 as 32 bits of RGBA8; 0 is the background.
#include "apps/oracle/oracle.h"

#include <algorithm>

namespace apps {
namespace {

/// Objects that may own a sample: those with a corner inside of each clip plane. Written apart from the
/// cullers' own frustum test, so that a fault there is seen here.
std::vector<ObjectId> candidates(const Scene& scene, const View& view) {
    std::vector<ObjectId> result;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        int inside[6] = {};
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec4 clip = view.clip * glm::dvec4(scene.objects[id].box.corner(corner), 1);
            const double limit = clip.w + 1e-3 * (1 + std::abs(clip.w));
            for (int axis = 0; axis < 3; ++axis) {
                inside[2 * axis] += clip[axis] <= limit;
                inside[2 * axis + 1] += -clip[axis] <= limit;
            }
        }
        if (std::all_of(std::begin(inside), std::end(inside), [](int count) { return count > 0; }))
            result.push_back(id);
    }
    return result;
}

}  // namespace

Oracle::Oracle(Renderer& renderer, const Scene& scene)
    : renderer_(renderer), scene_(scene), ids_(renderer.add_owner_paint()) {
}

void Oracle::begin(const View& view) {
    renderer_.use_paint(ids_, true);
    renderer_.set_matrices(view.modelview, view.projection, view.width, view.height);
    renderer_.clear(glm::vec4(0));
}

Oracle::Images Oracle::draw_all(const View& view) {
    const std::vector<ObjectId> all = candidates(scene_, view);
    Images images;
    begin(view);
    renderer_.draw(all);
    images.forwards = renderer_.read_pixels();
    begin(view);
    renderer_.draw_backwards(all);
    images.backwards = renderer_.read_pixels();
    renderer_.use_paint(Renderer::kBaked, false);
    return images;
}

Truth Oracle::look(const View& view) {
    const Images images = draw_all(view);
    Truth truth;
    truth.image_hash = hash_bytes(std::as_bytes(std::span(images.forwards)));
    std::vector<std::uint8_t> owns(scene_.objects.size(), 0);
    for (std::size_t pixel = 0; pixel < images.forwards.size(); ++pixel) {
        const std::uint32_t owner = images.forwards[pixel];
        if (owner != images.backwards[pixel])
            ++truth.contested_pixels;
        else if (owner != 0)
            owns.at(owner - 1) = 1;
    }
    for (ObjectId id = 0; id < owns.size(); ++id)
        if (owns[id]) truth.visible.push_back(id);
    return truth;
}

Verdict Oracle::judge(const View& view, const Truth& truth, std::span<const ObjectId> drawn) {
    Verdict verdict;
    verdict.visible_objects = static_cast<std::uint32_t>(truth.visible.size());
    verdict.contested_pixels = truth.contested_pixels;
    std::vector<ObjectId> sorted(drawn.begin(), drawn.end());
    std::sort(sorted.begin(), sorted.end());
    std::vector<ObjectId> missing;
    std::set_difference(truth.visible.begin(), truth.visible.end(), sorted.begin(), sorted.end(),
                        std::back_inserter(missing));
    verdict.false_culls = static_cast<std::uint32_t>(missing.size());

    // Ascending, as the full picture was drawn: a tie falls the same way in both.
    begin(view);
    renderer_.draw(sorted);
    const std::vector<std::uint32_t> image = renderer_.read_pixels();
    renderer_.use_paint(Renderer::kBaked, false);
    if (hash_bytes(std::as_bytes(std::span(image))) == truth.image_hash) return verdict;
    const Images full = draw_all(view);
    for (std::size_t pixel = 0; pixel < image.size(); ++pixel) {
        const bool contested = full.forwards[pixel] != full.backwards[pixel];
        verdict.wrong_pixels += !contested && image[pixel] != full.forwards[pixel];
    }
    return verdict;
}

}  // namespace apps
