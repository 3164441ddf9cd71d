// SPDX-License-Identifier: MIT
// Where the viewer stands and looks, and the path that a walkthrough follows. World: metres, z up.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace apps {

/// The lens of a scene; the horizontal angle follows from the picture's shape.
struct Lens {
    float vertical_angle_degrees = 45;
    float near_metres = 0.3F;
    float far_metres = 2000;
};

struct Camera {
    glm::vec3 eye{0};
    glm::vec3 forward{1, 0, 0};  // unit length, never straight up or down
    Lens lens;

    glm::mat4 view_matrix() const;
    glm::mat4 projection_matrix(int width, int height) const;
};

/// A path as data: eye and look-at points, with `at` in [0, 1], strictly rising; at least one key.
struct CameraKey {
    float at;
    glm::vec3 eye;
    glm::vec3 look_at;
};

class CameraPath {
  public:
    CameraPath() = default;
    CameraPath(std::vector<CameraKey> keys, Lens lens) : keys_(std::move(keys)), lens_(lens) {}

    /// The camera at `at`, linear between keys, held outside the first and the last.
    Camera camera(float at) const;

    /// Frame `index` of `count`, in the middle of its share of the path, so that means do not depend on its
    /// ends.
    Camera frame(int index, int count) const;

    const std::vector<CameraKey>& keys() const { return keys_; }

  private:
    std::vector<CameraKey> keys_;
    Lens lens_;
};

}  // namespace apps
