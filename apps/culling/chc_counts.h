// SPDX-License-Identifier: MIT
// What the methods of coherent hierarchical culling count alike, each once in the program.
#pragma once

#include "apps/culling/statistic.h"

namespace apps {

inline const Statistic kNodesVisited{"nodes_visited", "nodes taken from the traversal's stack or queue"};
inline const Statistic kVisibleQueries{"queries_of_visible",
                                       "queries of leaves that were visible a frame ago"};
inline const Statistic kHiddenQueries{"queries_of_hidden", "queries of nodes that were hidden a frame ago"};
inline const Statistic kAssumed{"assumed_visible", "visible leaves drawn without a query, for a while"};
inline const Statistic kUnaskable{"taken_as_visible", "nodes too near for a test, taken as visible"};
inline const Statistic kPullDowns{"pull_downs", "hidden nodes found visible and opened"};
inline const Statistic kLongestQueue{"longest_query_queue", "most queries in flight at once"};

}  // namespace apps
