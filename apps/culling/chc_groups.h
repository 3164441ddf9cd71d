// SPDX-License-Identifier: MIT
// Two ways of CHC++ to ask with fewer or smaller boxes: many hidden nodes in one query, and many tight boxes
// in place of a node's one.
//
// O. Mattausch, J. Bittner, M. Wimmer, CHC++: Coherent Hierarchical Culling Revisited, Eurographics 2008,
// sections 5.1 and 5.4.
#pragma once

#include "apps/culling/chc_parts.h"

namespace apps {

/// The paper's estimate that a node stays hidden which has been so for `frames` frames, fitted to measured
/// walks.
double probability_to_stay_hidden(std::uint32_t frames);

/// How many of the nodes, given by their probabilities to stay hidden, highest first, are to share the next
/// query: the number that saves most for what it costs. The cost of n is one query, and n more with the
/// probability that one of them is visible; of several it is `many_cost` in place of one, with `box_cost`
/// more for each box (the paper: 1 and 0). At least 1; `probabilities` is not empty.
std::size_t best_group(std::span<const double> probabilities, double many_cost, double box_cost);

/// Boxes of parts below `part` that together enclose all that it has: as deep as `depth` levels, while their
/// surface is at most `most_area` times its own.
std::vector<Box> tight_boxes(const Parts& parts, PartId part, int depth, double most_area);

}  // namespace apps
