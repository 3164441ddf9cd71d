// SPDX-License-Identifier: MIT
// The front-to-back order of H. Hey, R. F. Tobler, W. Purgathofer, Real-Time Occlusion Culling With A Lazy
// Occlusion Grid, 2001, section 3 and figure 2. It never draws a thing that reaches behind the front of a box
// that is still to be tested: whatever is in the depth buffer when a box is tested lies before it, and a test
// need not compare depths. All methods that go by it, and answer exactly, draw the same.
#pragma once

#include "apps/culling/culler.h"
#include "apps/culling/screen_box.h"

namespace apps {

/// Answers for the boxes of one frame.
class OcclusionMap {
  public:
    virtual ~OcclusionMap() = default;

    /// Before anything is drawn: the depth buffer is clear.
    virtual void begin(const View& view) = 0;

    /// True where no sample of what is in the box could show. The box is known; what was drawn lies before
    /// it.
    virtual bool is_occluded(Frame& frame, const ScreenBox& box) = 0;

    /// What `box` encloses was drawn, and nothing else since the last call.
    virtual void was_drawn(Frame& frame, const ScreenBox& box) = 0;
};

/// Draws the frame. Beyond the paper: ties, and boxes whose ranges of depth come within a margin of each
/// other, are tested before they are drawn; the draw-list is drained when the test-list is empty; of two
/// equals the one that came first goes first; a box that is not known is visible.
/// The far end of a node in the draw-list is that of its objects: of a kD-tree they reach out of the node.
void draw_in_two_lists(Frame& frame, OcclusionMap& map);

/// The box of those of the node's objects that are not drawn yet, empty if there are none.
Box undrawn_extent(const Frame& frame, const Node& node);

extern const Statistic kBoxesTested;

}  // namespace apps
