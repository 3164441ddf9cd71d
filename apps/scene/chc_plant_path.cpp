// SPDX-License-Identifier: MIT
// The walk: what Bittner et al. say of theirs in section 6.2. "Several viewpoints from which a large part of
// the model is visible": at the start and the end, from the yard. "Viewpoints along the border of the model
// directed outwards": between two aisles. "Viewpoints inside with high depth complexity": along the aisles.
#include "apps/scene/chc_plant_path.h"

#include "apps/scene/chc_plant_parts.h"

namespace apps::plant {
namespace {

/// Keys with the time that each takes to reach, in any unit.
class Walk {
  public:
    void go(float time, const glm::vec3& eye, const glm::vec3& look_at) {
        sum_ += keys_.empty() ? 0 : time;
        keys_.push_back({sum_, eye, look_at});
    }

    CameraPath path() const {
        std::vector<CameraKey> keys = keys_;
        for (CameraKey& key : keys) key.at /= sum_;
        return {std::move(keys), Lens{45, 0.1F, 600}};
    }

  private:
    float sum_ = 0;
    std::vector<CameraKey> keys_;
};

}  // namespace

CameraPath walk(const glm::ivec3& bays) {
    const glm::vec3 size = kBayMetres * glm::vec3(bays);
    const glm::vec3 middle = 0.5F * size;
    const auto aisle = [&](float row_share, float floor_share) {
        const glm::ivec2 cell(static_cast<int>(row_share * static_cast<float>(bays.y)),
                              static_cast<int>(floor_share * static_cast<float>(bays.z)));
        return glm::vec3(0, kBayMetres * static_cast<float>(cell.x) + kAisleMetres / 2,
                         kFloorMetres * static_cast<float>(cell.y) + kEyeMetres);
    };
    const glm::vec3 first = aisle(0.3F, 0.15F);
    const glm::vec3 second = aisle(0.55F, 0.5F);
    const glm::vec3 third = aisle(0.8F, 0.75F);
    const auto x = [](float metres) { return glm::vec3(metres, 0, 0); };
    const float beyond = size.x + 2;
    Walk walk;
    // In the aisles the gaze goes ahead and to the side, towards the nearer wall of the building.
    walk.go(0, {-0.75F * size.x, -0.35F * size.x, 0.7F * size.z}, middle);
    walk.go(7, {-0.5F * size.x, first.y - 6, 0.4F * size.z}, middle);
    walk.go(2, first + x(-3), first + glm::vec3(12, -7, 0));
    walk.go(30, first + x(size.x - 2), first + glm::vec3(size.x + 12, -5, 0));
    walk.go(2, first + x(beyond), first + x(beyond + 15));
    walk.go(12, second + x(beyond), second + x(beyond + 15));
    walk.go(1, second + x(beyond), second + glm::vec3(beyond, 15, 0));
    walk.go(2, second + x(beyond - 4), second + glm::vec3(beyond - 14, 10, 0));
    walk.go(30, second + x(2), second + glm::vec3(-12, 8, 0));
    walk.go(2, second + x(-2), second + x(-17));
    walk.go(12, third + x(-2), third + x(-17));
    walk.go(1, third + x(-2), third + glm::vec3(-2, 15, 0));
    walk.go(1, third + x(2), third + glm::vec3(15, 8, 0));
    walk.go(20, third + x(0.6F * size.x), third + glm::vec3(0.6F * size.x + 15, 8, 0));
    return walk.path();
}

}  // namespace apps::plant
