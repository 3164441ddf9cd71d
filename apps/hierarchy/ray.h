// SPDX-License-Identifier: MIT
// Rays through a tree, for the shadows in pictures.
#pragma once

#include "apps/hierarchy/tree.h"

namespace apps {

/// True where a triangle crosses the ray between 0 and `reach` metres; `direction` has unit length.
bool is_blocked(const Scene& scene, const Tree& tree, const glm::vec3& origin, const glm::vec3& direction,
                float reach);

}  // namespace apps
