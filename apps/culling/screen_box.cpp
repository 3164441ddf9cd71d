// SPDX-License-Identifier: MIT
// Corners through the camera in double, and how far off the driver's floats may be. Case numbers as in the
// project's list of hard cases.
#include "apps/culling/screen_box.h"

#include <cmath>

namespace apps {
namespace {

constexpr double kSnapPixels = 1.0 / 32;  // vertices snap to 1/16 of a pixel at the coarsest

/// Relative error of a sum of four products in float, of products with a rounded matrix.
constexpr double kFloatError = 0x1p-23;

/// One row of the matrix times a point: the sum, and the sum of what went into it.
struct Sum {
    double value, size;
};

Sum row_times(const glm::dmat4& matrix, int row, const glm::dvec3& point) {
    const double terms[] = {matrix[0][row] * point.x, matrix[1][row] * point.y, matrix[2][row] * point.z,
                            matrix[3][row]};
    Sum sum{0, 0};
    for (const double term : terms) {
        sum.value += term;
        sum.size += std::abs(term);
    }
    return sum;
}

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double value, double error) {
        low = std::min(low, value - error);
        high = std::max(high, value + error);
    }
};

/// Of x / w in [-1, 1] over `pixels`: first pixel and count, clipped.
void to_pixels(const Range& range, int pixels, int& first, int& count) {
    const double low = std::floor((range.low * 0.5 + 0.5) * pixels - kSnapPixels);
    const double high = std::ceil((range.high * 0.5 + 0.5) * pixels + kSnapPixels);
    first = static_cast<int>(std::clamp<double>(low, 0, pixels));
    count = static_cast<int>(std::clamp<double>(high, first, pixels)) - first;
}

DepthSteps to_step(double step) {
    return static_cast<DepthSteps>(std::clamp<double>(step, 0, kFarStep));
}

}  // namespace

ScreenBox screen_box(const View& view, const Box& box) {
    Range x, y, near_steps, far_steps;
    bool is_known = true;
    bool is_number = true;
    for (int index = 0; index < 8; ++index) {
        const glm::dvec3 corner(box.corner(index));
        const Sum w = row_times(view.clip, 3, corner);
        is_number = is_number && std::isfinite(w.size);
        // Case 1, cut by the near plane; case 3, no number: `!(w > near)` holds for NaN. A corner before the
        // near plane leaves no samples, so the others say how far the box reaches.
        if (!(w.value > view.near_metres * 1.001)) {
            is_known = false;
            continue;
        }
        const Sum sums[] = {row_times(view.clip, 0, corner), row_times(view.clip, 1, corner),
                            row_times(view.clip, 2, corner)};
        const auto quotient = [&](const Sum& sum) { return sum.value / w.value; };
        // Case 12, large coordinates: |d(a / w)| <= |da| / w + |a / w| |dw| / w.
        const auto error = [&](const Sum& sum) {
            return kFloatError * (sum.size + std::abs(quotient(sum)) * w.size) / w.value;
        };
        x.add(quotient(sums[0]), error(sums[0]));
        y.add(quotient(sums[1]), error(sums[1]));
        // Case 10: depth is that of the buffer, which no distance to the eye is.
        const double depth = (quotient(sums[2]) * 0.5 + 0.5) * kFarStep;
        const double margin = std::max<double>(kDepthMarginSteps, error(sums[2]) * 0.5 * kFarStep);
        near_steps.add(std::floor(depth), margin);
        far_steps.add(std::ceil(depth), margin);
        is_number = is_number && std::isfinite(x.high - x.low) && std::isfinite(y.high - y.low) &&
                    std::isfinite(far_steps.high - near_steps.low);
    }
    ScreenBox result;
    result.pixels = {0, 0, view.width, view.height};
    if (!is_number) return result;
    result.zfar = to_step(std::ceil(std::max<double>(0, far_steps.high)));
    if (!is_known) return result;
    result.is_known = true;
    result.znear = to_step(std::floor(near_steps.low));
    to_pixels(x, view.width, result.pixels.x, result.pixels.width);
    to_pixels(y, view.height, result.pixels.y, result.pixels.height);
    return result;
}

DepthSteps steps_of(float depth) {
    return depth < 1 ? to_step(std::round(static_cast<double>(depth) * kFarStep)) : kFarStep;
}

}  // namespace apps
