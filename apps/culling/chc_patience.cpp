// SPDX-License-Identifier: MIT
// Deterministic: random numbers are hashes of part and frame.
#include "apps/culling/chc_patience.h"

#include <algorithm>
#include <cmath>

#include "apps/scene/random.h"

namespace apps {

void Patience::start_frame(const View& view) {
    step_metres_ = has_eye_ ? glm::distance(view.eye, eye_) : 0;
    eye_ = view.eye;
    has_eye_ = true;
    pixel_slope_ = view.pixel_slope;
}

std::uint32_t Patience::frames(PartId part, const Box& box, std::uint32_t visible_answers,
                               std::uint32_t frame) const {
    Random random((std::uint64_t{part} << 32) + frame);
    const auto any_to = [&](std::uint32_t most) {
        return static_cast<std::uint32_t>(random.below(static_cast<int>(most) + 1));
    };
    constexpr std::uint32_t kMostDoublings = 16;
    const std::uint32_t doubled = 1U << std::min(std::max(visible_answers, 1U) - 1, kMostDoublings);
    switch (rule_) {
        case PatienceRule::kConstant:
            return frames_;
        case PatienceRule::kRandom:
            return visible_answers > 1 ? frames_ : any_to(frames_);
        case PatienceRule::kHistory:
            return std::min(frames_, doubled - 1);
        case PatienceRule::kRandomHistory:
            return std::min(frames_, doubled - 1 + any_to(doubled - 1));
        case PatienceRule::kSpeed: {
            const double metres =
                kParallaxPixels * pixel_slope_ * std::sqrt(static_cast<double>(squared_distance(box, eye_)));
            // Not moved: 0 / 0 for what touches the eye, which is taken as far too.
            const double frames = step_metres_ > 0 ? metres / static_cast<double>(step_metres_) : frames_;
            return static_cast<std::uint32_t>(std::min(frames, static_cast<double>(frames_)));
        }
    }
    return 0;
}

}  // namespace apps
