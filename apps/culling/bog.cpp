// SPDX-License-Identifier: MIT
// The busy occlusion grid that Hey et al. 2001 compare with (section 5): "the state version of the occlusion
// grid, but each tile is immediately updated after an object has been drawn into its image area if the tile
// has not already been marked as full". An object is what one node of the draw-list draws.
#include "apps/culling/occlusion_grid.h"
#include "apps/culling/two_lists.h"

namespace apps {
namespace {

class BusyMap final : public OcclusionMap {
  public:
    BusyMap(int tile_pixels, bool asks_together) : grid_(tile_pixels, asks_together) {}

    void begin(const View& view) override { grid_.clear(view); }
    bool is_occluded(Frame& frame, const ScreenBox& box) override { return grid_.is_occluded(frame, box); }
    void was_drawn(Frame& frame, const ScreenBox& box) override { grid_.update(frame, box); }

  private:
    StateGrid grid_;
};

class Bog final : public Culler {
  public:
    explicit Bog(const KnobValues& knobs)
        : map_(static_cast<int>(knobs.at("tile")), knobs.at("parallel") != 0) {}

    void draw(Frame& frame) override { draw_in_two_lists(frame, map_); }

  private:
    BusyMap map_;
};

constexpr Knob kKnobs[] = {kTileKnob, kParallelKnob};

}  // namespace

extern const CullerRecipe kBog;
const CullerRecipe kBog = {
    "bog", true, Needs::kDepths, kKnobs,
    [](const KnobValues& knobs) -> std::unique_ptr<Culler> { return std::make_unique<Bog>(knobs); }};

}  // namespace apps
