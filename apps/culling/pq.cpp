// SPDX-License-Identifier: MIT
// Pixel queries alone, as Hey et al. 2001 compare with (section 5): "occlusion culling solely with a
// pixel-level query per BBox that tests all pixels in the image area of the BBox". Beside the paper it counts
// what no method that finds the same boxes hidden can do without.
#include "apps/culling/two_lists.h"

namespace apps {
namespace {

const Statistic kHiddenPixels{
    "hidden_pixels", "pixels in boxes found hidden, each once: any exact method has to look at them"};

class PixelQueries final : public OcclusionMap {
  public:
    void begin(const View&) override { hidden_.clear(); }
    bool is_occluded(Frame& frame, const ScreenBox& box) override {
        const bool is_hidden =
            box.pixels.pixels() == 0 || frame.canvas.are_occluded({&box.pixels, 1}).front() != 0;
        if (is_hidden) hidden_.push_back(box.pixels);
        return is_hidden;
    }
    void was_drawn(Frame&, const ScreenBox&) override {}

    const std::vector<Rectangle>& hidden() const { return hidden_; }

  private:
    std::vector<Rectangle> hidden_;
};

class Pq final : public Culler {
  public:
    void draw(Frame& frame) override { draw_in_two_lists(frame, map_); }

    void settle(Frame& frame) override {
        std::vector<std::uint8_t> is_hidden(
            static_cast<std::size_t>(frame.view.width) * static_cast<std::size_t>(frame.view.height), 0);
        for (const Rectangle& r : map_.hidden())
            for (int y = r.y; y < r.y + r.height; ++y)
                std::fill_n(is_hidden.begin() + y * frame.view.width + r.x, r.width, std::uint8_t{1});
        frame.tally.add(kHiddenPixels,
                        static_cast<std::uint64_t>(std::count(is_hidden.begin(), is_hidden.end(), 1)));
    }

  private:
    PixelQueries map_;
};

}  // namespace

extern const CullerRecipe kPq;
const CullerRecipe kPq = {"pq", true, Needs::kDepths, {}, [](const KnobValues&) -> std::unique_ptr<Culler> {
                              return std::make_unique<Pq>();
                          }};

}  // namespace apps
