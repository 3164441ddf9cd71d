// SPDX-License-Identifier: MIT
// Things that move through a scene: chosen by a seed, along closed curves that return to where the scene has
// them, turning about a vertical axis. Both papers of hierarchical culling claim scenes that change; this is
// what changes them.
#pragma once

#include "apps/scene/scene.h"

namespace apps {

class Motion {
  public:
    /// Moves `share`, in 0..1, of the objects that are no larger than twice the median; the ground and other
    /// large ones stay. Which move, and how, depends on the seed, their boxes and triangles, not on their
    /// order, and whatever moves at a smaller share moves at a larger one. Each gets a placement of its own
    /// in `scene`, and Scene::bounds grows by where they get.
    Motion(Scene& scene, double share, std::uint64_t seed);

    /// Puts them where they are in a frame, 0 or later: placements and boxes. Frame 0 is the scene as it was.
    /// A box encloses its object and, for it is a turned box's, some air.
    void place(Scene& scene, int frame) const;

    /// Ascending.
    const std::vector<ObjectId>& moving() const { return moving_; }

  private:
    /// An ellipse that starts at the object's own place.
    struct Curve {
        glm::mat4 home;    // the placement that the scene has
        Box box;           // the box there
        glm::vec2 along;   // metres, half axis of the ellipse through the start
        glm::vec2 across;  // metres, the other
        float rise;        // metres, at the far end
        int period_frames;
        int turns;  // about the middle of the box, in a period
    };

    std::vector<ObjectId> moving_;
    std::vector<Curve> curves_;  // of moving_
};

}  // namespace apps
