// SPDX-License-Identifier: MIT
// A bounding volume hierarchy keeps its shape while objects move about; its boxes follow them.
#pragma once

#include <span>

#include "apps/hierarchy/tree.h"

namespace apps {

/// Makes all boxes of a bounding volume hierarchy fit where the objects are now; which node holds what stays.
void refit(Tree& tree, const Scene& scene);

/// The same for the few that move: knows where each object hangs.
class Refitter {
  public:
    /// `tree` is a bounding volume hierarchy over `objects` objects; its shape must not change from here on.
    Refitter(const Tree& tree, std::size_t objects);

    /// Makes the boxes above `moved` fit; of objects that are not named nothing has changed.
    void refit(Tree& tree, const Scene& scene, std::span<const ObjectId> moved);

  private:
    std::vector<NodeId> node_of_;           // by object
    std::vector<std::uint8_t> is_touched_;  // by node; all 0 between calls
};

}  // namespace apps
