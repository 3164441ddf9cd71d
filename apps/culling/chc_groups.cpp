// SPDX-License-Identifier: MIT
// Level by level: the last whole level that is small enough is taken.
#include "apps/culling/chc_groups.h"

#include <cmath>

namespace apps {

double probability_to_stay_hidden(std::uint32_t frames) {
    return 0.99 - 0.7 * std::exp(-static_cast<double>(frames));
}

std::size_t best_group(std::span<const double> probabilities, double many_cost, double box_cost) {
    std::size_t best = 1;
    double best_value = 0;
    double all_stay = 1;
    for (std::size_t i = 0; i < probabilities.size(); ++i) {
        all_stay *= probabilities[i];
        const auto count = static_cast<double>(i + 1);
        const double asking = i == 0 ? 1 : many_cost + box_cost * count;
        // One that turns out visible needs no second question.
        const double value = count / (asking + (i == 0 ? 0 : (1 - all_stay) * count));
        if (value <= best_value) continue;
        best_value = value;
        best = i + 1;
    }
    return best;
}

std::vector<Box> tight_boxes(const Parts& parts, PartId part, int depth, double most_area) {
    std::vector<PartId> level{part};
    std::vector<Box> boxes{parts.box_of(part)};
    const double limit = most_area * boxes.front().surface_area();
    for (int i = 0; i < depth; ++i) {
        std::vector<PartId> next;
        for (const PartId each : level)
            if (parts.is_leaf(each))
                next.push_back(each);
            else
                parts.for_children(each, [&](PartId child) { next.push_back(child); });
        if (next.size() == level.size()) break;
        std::vector<Box> next_boxes;
        double area = 0;
        for (const PartId each : next) {
            const Box box = parts.box_of(each);
            if (box.is_empty()) continue;
            area += box.surface_area();
            next_boxes.push_back(box);
        }
        if (area > limit || next_boxes.empty()) break;
        level = std::move(next);
        boxes = std::move(next_boxes);
    }
    return boxes;
}

}  // namespace apps
