// SPDX-License-Identifier: MIT
// A scene without its order: triangles, each in a place of its own, whichever objects share a mesh.
#pragma once

#include <vector>

#include "apps/scene/scene.h"

namespace apps {

/// Three corners in world metres.
struct SoupTriangle {
    glm::vec3 corners[3];
};

/// The triangles of all objects, in their order, placed in the world: 36 bytes each.
std::vector<SoupTriangle> flattened(const Scene& scene);

}  // namespace apps
