// SPDX-License-Identifier: MIT
// The walk through the city, and the few measures of its plan that the walk depends on.
#pragma once

#include "apps/scene/camera.h"

namespace apps::city {

inline constexpr int kSideBlocks = 9;           // of the city at scale 1
inline constexpr float kPitchMetres = 72;       // from street to street: street k runs along k * kPitchMetres
inline constexpr float kEyeMetres = 1.7F;       // above the street
inline constexpr float kRoofShareFrom = 0.52F;  // of the path: where the viewer starts to rise
inline constexpr float kRoofShareTo = 0.82F;    // of the path: where the viewer is back in the street

/// A walk in a city of `side` x `side` blocks: in the streets, with a section above the roofs in the second
/// half.
CameraPath walk(int side);

}  // namespace apps::city
