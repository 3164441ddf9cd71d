// SPDX-License-Identifier: MIT
// Pixel queries alone, as Hey et al. 2001 compare with (section 5): "occlusion culling solely with a
// pixel-level query per BBox that tests all pixels in the image area of the BBox".
#include "apps/culling/two_lists.h"

namespace apps {
namespace {

class PixelQueries final : public OcclusionMap {
  public:
    void begin(const View&) override {}
    bool is_occluded(Frame& frame, const ScreenBox& box) override {
        return box.pixels.pixels() == 0 || frame.canvas.are_occluded({&box.pixels, 1}).front() != 0;
    }
    void was_drawn(Frame&, const ScreenBox&) override {}
};

class Pq final : public Culler {
  public:
    void draw(Frame& frame) override {
        PixelQueries map;
        draw_in_two_lists(frame, map);
    }
};

}  // namespace

extern const CullerRecipe kPq;
const CullerRecipe kPq = {"pq", true, Needs::kDepths, {}, [](const KnobValues&) -> std::unique_ptr<Culler> {
                              return std::make_unique<Pq>();
                          }};

}  // namespace apps
