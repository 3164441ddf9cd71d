// SPDX-License-Identifier: MIT
// The visibility classification between frames.
#include "apps/culling/chc_memory.h"

namespace apps {
namespace {

const Statistic kPullUps{"pull_ups", "interior nodes found visible by way of a child"};

}  // namespace

bool Memory::start_frame(const Parts& parts) {
    const bool is_new = states_.size() != parts.size();
    if (is_new) {
        states_.assign(parts.size(), {});
        frame_ = 1;
    }
    ++frame_;
    return is_new;
}

bool Memory::visit(PartId part) {
    State& state = states_[part];
    const bool is_known = state.visited + 1 == frame_;
    const bool was_visible = state.is_visible && is_known;
    if (!is_known) state.hidden = 0;
    if (!was_visible) {
        state.visible_answers = 0;
        state.ask_in = 0;
    }
    state.is_visible = false;
    state.visited = frame_;
    return was_visible;
}

void Memory::pull_up(const Parts& parts, PartId part, Tally& tally) {
    for (const PartId first = part; part != kNoNode && !states_[part].is_visible;
         part = parts.parent_of(part)) {
        states_[part].is_visible = true;
        states_[part].hidden = 0;
        if (part != first) tally.add(kPullUps);
    }
}

void Memory::pull_down(const Parts& parts, PartId leaf) {
    states_[leaf].visible_answers = 0;
    for (PartId part = leaf; part != kNoNode; part = parts.parent_of(part)) {
        bool has_visible_child = false;
        if (part != leaf)
            parts.for_children(part, [&](PartId child) {
                has_visible_child |= is_visible(child) && was_visited_before(child);
            });
        if (has_visible_child) return;
        states_[part].is_visible = false;
    }
}

void Memory::found_visible(PartId part, std::uint32_t skip) {
    ++states_[part].visible_answers;
    states_[part].ask_in = frame_ + 1 + skip;
}

}  // namespace apps
