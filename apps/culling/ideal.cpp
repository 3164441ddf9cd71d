// SPDX-License-Identifier: MIT
// The ideal of the CHC paper, section 6.2: "renders the visible objects found by the S&W algorithm without
// performing any visibility tests". Each frame's set and order is recorded beforehand and replayed; in runs,
// what the paper's ideal is not, it makes as few calls of it as a method does that draws visible leaves
// together.
#include "apps/culling/chc_parts.h"

namespace apps {
namespace {

class Ideal final : public Culler {
  public:
    Ideal(std::unique_ptr<Culler> finder, bool is_in_runs)
        : finder_(std::move(finder)), is_in_runs_(is_in_runs) {}

    void prepare(Frame& frame) override {
        finder_->draw(frame);
        recorded_[frame.index] = {is_in_runs_ ? in_runs(frame.drawn) : frame.drawn, frame.classes};
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
    bool is_in_runs_;
    std::map<int, Record> recorded_;
};

constexpr Knob kKnobs[] = {
    {"in_runs", 0, 0, 1, "1: drawn in runs of neighbours, fewer calls, instead of in stop-and-wait's order"},
    kProxyGrowthKnob,
};

}  // namespace

extern const CullerRecipe kIdeal;
const CullerRecipe kIdeal = {
    "ideal", true, Needs::kTest, kKnobs, [](const KnobValues& knobs) -> std::unique_ptr<Culler> {
        return std::make_unique<Ideal>(make_culler("stop-and-wait", knobs), knobs.at("in_runs") >= 1);
    }};

}  // namespace apps
