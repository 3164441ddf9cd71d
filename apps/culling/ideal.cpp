// SPDX-License-Identifier: MIT
// The ideal of the CHC paper, section 6.2: "renders the visible objects found by the S&W algorithm without
// performing any visibility tests". Each frame's set and order is recorded beforehand and replayed.
#include "apps/culling/culler.h"

namespace apps {
namespace {

class Ideal final : public Culler {
  public:
    explicit Ideal(std::unique_ptr<Culler> finder) : finder_(std::move(finder)) {}

    void prepare(Frame& frame) override {
        finder_->draw(frame);
        recorded_[frame.index] = {frame.drawn, frame.classes};
    }

    void draw(Frame& frame) override {
        const Record& record = recorded_.at(frame.index);
        frame.classes = record.classes;
        frame.draw(record.drawn);
    }

  private:
    struct Record {
        std::vector<ObjectId> drawn;
        std::vector<NodeClass> classes;
    };
    std::unique_ptr<Culler> finder_;
    std::map<int, Record> recorded_;
};

constexpr Knob kKnobs[] = {kProxyGrowthKnob};

}  // namespace

extern const CullerRecipe kIdeal;
const CullerRecipe kIdeal = {"ideal", true, Needs::kTest, kKnobs,
                             [](const KnobValues& knobs) -> std::unique_ptr<Culler> {
                                 return std::make_unique<Ideal>(make_culler("stop-and-wait", knobs));
                             }};

}  // namespace apps
