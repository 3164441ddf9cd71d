// SPDX-License-Identifier: MIT
// What a coherent culler remembers of each part of the tree from frame to frame: whether it was visible, when
// it was visited, for how long it has been hidden, and when a visible leaf is to be asked about again.
//
// J. Bittner, M. Wimmer, H. Piringer, W. Purgathofer, Coherent Hierarchical Culling, 2004, Figure 2 (visible,
// lastVisited, PullUpVisibility) and section 5.1. Frames are counted as they are drawn, not by their number
// on a path: what the last frame did not visit, after a cut or out of the frustum, is as if never seen.
#pragma once

#include "apps/culling/chc_parts.h"

namespace apps {

class Memory {
  public:
    /// True where the number of parts is not what it was, and all is forgotten.
    bool start_frame(const Parts& parts);
    void forget() { states_.clear(); }
    std::uint32_t frame() const { return frame_; }

    /// Lines 21 to 27: true where the part was visible in the last frame, whose visit this one follows; it is
    /// hidden until something is found.
    bool visit(PartId part);

    /// Lines 44 to 46, which walk past the root as printed: the part and all above it are visible.
    void pull_up(const Parts& parts, PartId part, Tally& tally);

    /// Takes back what pull_up said of a leaf: it is hidden, and so is each part above of which no child is
    /// visible that was visited in this frame, or was in the last and may be yet.
    void pull_down(const Parts& parts, PartId leaf);

    bool is_visible(PartId part) const { return states_[part].is_visible; }
    bool was_visited(PartId part) const { return states_[part].visited == frame_; }
    bool was_visited_before(PartId part) const { return states_[part].visited + 1 >= frame_; }

    /// Frames in a row, this one not counted, in which a part that is not visible has been found hidden.
    std::uint32_t hidden_frames(PartId part) const { return states_[part].hidden; }
    void found_hidden(PartId part) { ++states_[part].hidden; }

    /// How often in a row a leaf was asked about and found visible.
    std::uint32_t visible_answers(PartId part) const { return states_[part].visible_answers; }

    /// Notes the answer about a leaf: visible; asked about again when `skip` frames have passed unasked.
    void found_visible(PartId part, std::uint32_t skip);

    /// The leaf is not to be asked about again before its answer has come.
    void await_answer(PartId part) { states_[part].ask_in = ~std::uint32_t{0}; }

    /// False while a leaf's last answer, or the look without one, still stands.
    bool is_to_ask(PartId part) const { return states_[part].ask_in <= frame_; }

  private:
    struct State {
        std::uint32_t visited = 0;  // a frame; the first is 2, so that this was never and not just before
        std::uint32_t ask_in = 0;   // a frame
        std::uint32_t hidden = 0;
        std::uint32_t visible_answers = 0;
        bool is_visible = false;
    };
    std::vector<State> states_;
    std::uint32_t frame_ = 1;
};

}  // namespace apps
