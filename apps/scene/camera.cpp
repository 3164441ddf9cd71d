// SPDX-License-Identifier: MIT
// Cameras and camera paths: interpolation between keys, and the two matrices that GL is given.
#include "apps/scene/camera.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

namespace apps {

glm::mat4 Camera::view_matrix() const {
    return glm::lookAt(eye, eye + forward, glm::vec3(0, 0, 1));
}

glm::mat4 Camera::projection_matrix(int width, int height) const {
    return glm::perspective(glm::radians(lens.vertical_angle_degrees),
                            static_cast<float>(width) / static_cast<float>(height), lens.near_metres,
                            lens.far_metres);
}

Camera CameraPath::camera(float at) const {
    const auto after =
        std::find_if(keys_.begin(), keys_.end(), [at](const CameraKey& k) { return k.at > at; });
    const CameraKey& last = after == keys_.begin() ? *after : *(after - 1);
    const CameraKey& next = after == keys_.end() ? last : *after;
    const float span = next.at - last.at;
    const float blend = span > 0 ? std::clamp((at - last.at) / span, 0.0F, 1.0F) : 0;
    const glm::vec3 eye = glm::mix(last.eye, next.eye, blend);
    return {eye, glm::normalize(glm::mix(last.look_at, next.look_at, blend) - eye), lens_};
}

Camera CameraPath::frame(int index, int count) const {
    return camera((static_cast<float>(index) + 0.5F) / static_cast<float>(count));
}

}  // namespace apps
