// SPDX-License-Identifier: MIT
// People's own models as scenes: any format that assimp reads.
#pragma once

#include <filesystem>

#include "apps/scene/scene.h"

namespace apps {

/// The triangles of a model file in objects of at most 64 neighbours, z up, its diagonal made 100 m and its
/// lowest point 0; the path goes once around it and over it. Throws std::runtime_error, one sentence, where
/// it cannot be read.
Scene load_model(const std::filesystem::path& file);

}  // namespace apps
