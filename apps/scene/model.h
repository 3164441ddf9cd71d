// SPDX-License-Identifier: MIT
// People's own models as scenes: any format that assimp reads.
#pragma once

#include <filesystem>

#include "apps/scene/scene.h"

namespace apps {

/// What becomes an object of a scene.
struct ModelSplit {
    enum class By : std::uint8_t {
        kSize,    // neighbouring triangles, whichever meshes they are of
        kObject,  // each mesh wherever the file shows it
    };
    By by = By::kSize;
    std::size_t most_triangles = kNeighbours;  // in an object; what has more is cut into neighbours

    static constexpr std::size_t kNeighbours = 64;
    static constexpr std::size_t kMostOfAMesh = 1500;  // the leaves of the LOG paper
};

/// The triangles of a model file, z up, its diagonal made 100 m and its lowest point 0; the path goes once
/// around it and over it. By object, a mesh that the file shows several times is stored once, unless it is
/// skewed or mirrored. Throws std::runtime_error, one sentence, where it cannot be read, has a corner that is
/// no finite number, or has no triangles.
Scene load_model(const std::filesystem::path& file, const ModelSplit& split = {});

}  // namespace apps
