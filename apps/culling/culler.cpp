// SPDX-License-Identifier: MIT
// The one list of cullers, and the stamp that lets an object be drawn once a frame.
#include "apps/culling/culler.h"

#include <algorithm>

namespace apps {

void Frame::draw(std::span<const ObjectId> objects) {
    batch_.clear();
    for (const ObjectId id : objects) {
        if (is_drawn[id]) continue;
        is_drawn[id] = 1;
        batch_.push_back(id);
    }
    if (batch_.empty()) return;
    drawn.insert(drawn.end(), batch_.begin(), batch_.end());
    canvas.draw(batch_);
}

std::span<const CullerRecipe> cullers() {
    static constexpr Knob kProxyKnobs[] = {
        {"proxy_growth", kSafeGrowthPixels, kSafeGrowthPixels, 8,
         "pixels by which the box of a test is grown"},
    };
    static constexpr CullerRecipe kCullers[] = {
        {"none", true, false, {}, make_none},
        {"frustum", true, false, {}, make_frustum},
        {"stop-and-wait", true, true, kProxyKnobs, make_stop_and_wait},
        {"ideal", true, true, kProxyKnobs, make_ideal},
    };
    return kCullers;
}

const CullerRecipe* find_culler(std::string_view name) {
    const auto all = cullers();
    const auto it =
        std::find_if(all.begin(), all.end(), [&](const CullerRecipe& c) { return c.name == name; });
    return it == all.end() ? nullptr : &*it;
}

}  // namespace apps
