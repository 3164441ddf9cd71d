// SPDX-License-Identifier: MIT
// Flattens a scene.
#include "apps/hierarchy/soup.h"

#include <tbb/parallel_for.h>

namespace apps {

std::vector<SoupTriangle> flattened(const Scene& scene) {
    std::vector<std::size_t> starts;
    std::size_t count = 0;
    for (const Object& object : scene.objects) {
        starts.push_back(count);
        count += object.triangle_count();
    }
    std::vector<SoupTriangle> soup(count);
    tbb::parallel_for(std::size_t{0}, scene.objects.size(), [&](std::size_t id) {
        const Object& object = scene.objects[id];
        const glm::mat4& placement = scene.placements[object.placement];
        for (std::uint32_t i = 0; i < object.index_count; ++i)
            soup[starts[id] + i / 3].corners[i % 3] =
                glm::vec3(placement * glm::vec4(scene.positions[scene.indices[object.first_index + i]], 1));
    });
    return soup;
}

}  // namespace apps
