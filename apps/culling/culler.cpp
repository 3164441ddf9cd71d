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

extern const CullerRecipe kLogState, kLogZfar, kLogCoherent, kBog, kHzb, kPq;
extern const CullerRecipe kNone, kFrustum, kStopAndWait, kIdeal, kChc, kChcPlus, kConditional;

std::span<const CullerRecipe* const> cullers() {
    static constexpr const CullerRecipe* kCullers[] = {
        &kNone,     &kFrustum, &kStopAndWait, &kIdeal, &kChc, &kChcPlus, &kConditional,
        &kLogState, &kLogZfar, &kLogCoherent, &kBog,   &kHzb, &kPq,
    };
    return kCullers;
}

const CullerRecipe* find_culler(std::string_view name) {
    const auto all = cullers();
    const auto it =
        std::find_if(all.begin(), all.end(), [&](const CullerRecipe* c) { return c->name == name; });
    return it == all.end() ? nullptr : *it;
}

std::unique_ptr<Culler> make_culler(std::string_view name, const KnobValues& settings) {
    const CullerRecipe& recipe = *find_culler(name);
    return recipe.make(recipe.knob_values(settings));
}

KnobValues CullerRecipe::knob_values(const KnobValues& settings) const {
    KnobValues values;
    for (const Knob& knob : knobs) {
        const auto set = settings.find(knob.name);
        values[std::string(knob.name)] = set == settings.end() ? knob.value : set->second;
    }
    return values;
}

bool CullerRecipe::is_conservative_with(const KnobValues& values) const {
    return is_conservative && std::all_of(knobs.begin(), knobs.end(), [&](const Knob& knob) {
               return !knob.trades_image || values.find(knob.name)->second == knob.value;
           });
}

}  // namespace apps
