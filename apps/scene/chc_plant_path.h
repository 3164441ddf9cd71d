// SPDX-License-Identifier: MIT
// The walk through the proxy of a power plant.
#pragma once

#include "apps/scene/camera.h"

namespace apps::plant {

inline constexpr float kAisleMetres = 2.2F;  // of each bay, along x, free of everything below kHeadMetres
inline constexpr float kHeadMetres = 3;
inline constexpr float kEyeMetres = 1.7F;

/// Through a plant of so many bays and floors, one corner of it in the origin.
CameraPath walk(const glm::ivec3& bays);

}  // namespace apps::plant
