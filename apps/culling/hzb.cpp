// SPDX-License-Identifier: MIT
// The hierarchical z-buffer in software, as Hey et al. 2001 compare with (section 5): "After an object has
// been drawn the conventional z-buffer in the image area of the BBox is read to update the HZB." An object is
// what one node of the draw-list draws. Boxes are compared with the pyramid down to pixels, so that it
// answers exactly what a query of the box's pixels would; no pixel is read for a test.
#include <cmath>

#include "apps/culling/hzb_pyramid.h"
#include "apps/culling/two_lists.h"

namespace apps {
namespace {

class PyramidMap final : public OcclusionMap {
  public:
    explicit PyramidMap(double pyramid_ns) : pyramid_ns_(pyramid_ns) {}

    void begin(const View& view) override { pyramid_.clear(view.width, view.height); }
    bool is_occluded(Frame&, const ScreenBox& box) override { return pyramid_.is_hidden(box); }
    void was_drawn(Frame& frame, const ScreenBox& box) override {
        const std::uint64_t pixels = box.pixels.pixels();
        if (pixels == 0) return;
        pyramid_.put(box.pixels, frame.canvas.read_depths(box.pixels));
        if (pyramid_ns_ > 0)
            frame.canvas.work(
                std::chrono::nanoseconds(std::llround(pyramid_ns_ * static_cast<double>(pixels))));
    }

  private:
    double pyramid_ns_;
    DepthPyramid pyramid_;
};

class Hzb final : public Culler {
  public:
    explicit Hzb(double pyramid_ns) : map_(pyramid_ns) {}

    void draw(Frame& frame) override { draw_in_two_lists(frame, map_); }

  private:
    PyramidMap map_;
};

constexpr Knob kKnobs[] = {{"pyramid_ns", 0, 0, 1000,
                            "the CPU's work on the pyramid, nanoseconds a pixel read, on a device's clock"}};

}  // namespace

extern const CullerRecipe kHzb;
const CullerRecipe kHzb = {"hzb", true, Needs::kDepths, kKnobs,
                           [](const KnobValues& knobs) -> std::unique_ptr<Culler> {
                               return std::make_unique<Hzb>(knobs.at("pyramid_ns"));
                           }};

}  // namespace apps
