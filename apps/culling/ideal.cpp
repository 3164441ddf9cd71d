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
        recorded_[frame.index] = frame.drawn;
    }

    void draw(Frame& frame) override { frame.draw(recorded_.at(frame.index)); }

  private:
    std::unique_ptr<Culler> finder_;
    std::map<int, std::vector<ObjectId>> recorded_;
};

}  // namespace

std::unique_ptr<Culler> make_ideal(const KnobValues& knobs) {
    return std::make_unique<Ideal>(make_stop_and_wait(knobs));
}

}  // namespace apps
