// SPDX-License-Identifier: MIT
// The light of a scene: a sun and a sky. Baked into the colours that GL draws; traced again, with shadows, in
// pictures.
#pragma once

#include <algorithm>
#include <glm/glm.hpp>

namespace apps {

/// Towards the sun; unit length within float rounding.
inline const glm::vec3 kTowardsSun = glm::normalize(glm::vec3(0.48F, -0.62F, 0.72F));

inline glm::vec3 sunlight(const glm::vec3& normal) {
    return glm::vec3(0.92F, 0.84F, 0.68F) * std::max(0.0F, glm::dot(normal, kTowardsSun));
}

inline glm::vec3 skylight(const glm::vec3& normal) {
    return glm::vec3(0.58F, 0.63F, 0.71F) * (0.62F + 0.38F * normal.z);
}

/// Little sky is seen from deep in a street: 70 % of the light at the ground, all of it 14 m up.
inline float openness(const glm::vec3& position) {
    const float height = std::clamp(position.z / 14.0F, 0.0F, 1.0F);
    return 0.70F + 0.30F * height * (2 - height);
}

/// What albedo is multiplied by in the colours of a scene.
inline glm::vec3 baked_light(const glm::vec3& position, const glm::vec3& normal) {
    return (sunlight(normal) + skylight(normal)) * openness(position);
}

}  // namespace apps
