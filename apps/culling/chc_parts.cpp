// SPDX-License-Identifier: MIT
// Boxes of what hangs in interior nodes, and the two orders of visiting.
#include "apps/culling/chc_parts.h"

#include <algorithm>

namespace apps {

Box Parts::box_of(PartId part) const {
    if (!is_own(part)) return tree_.nodes[part].box;
    Box box;
    for (const ObjectId id : objects_of(part)) box.add(scene_.objects[id].box);
    return intersection(box, tree_.nodes[node_of(part)].box);
}

std::vector<ObjectId> in_runs(std::span<const ObjectId> objects) {
    struct Place {
        ObjectId id;
        std::size_t turn;
    };
    std::vector<Place> places;
    for (std::size_t i = 0; i < objects.size(); ++i) places.push_back({objects[i], i});
    std::sort(places.begin(), places.end(),
              [](const Place& a, const Place& b) { return a.id != b.id ? a.id < b.id : a.turn < b.turn; });
    struct Run {
        ObjectId first;
        ObjectId end;
        std::size_t turn;
    };
    std::vector<Run> runs;
    for (const Place& place : places) {
        if (runs.empty() || place.id > runs.back().end) runs.push_back({place.id, place.id, place.turn});
        runs.back().end = place.id + 1;
        runs.back().turn = std::min(runs.back().turn, place.turn);
    }
    std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.turn < b.turn; });
    std::vector<ObjectId> ordered;
    for (const Run& run : runs)
        for (ObjectId id = run.first; id < run.end; ++id) ordered.push_back(id);
    return ordered;
}

void Frontier::push(PartId part) {
    if (is_by_distance_)
        heap_.push({squared_distance(parts_.box_of(part), eye_), turn_++, part});
    else
        stack_.push_back(part);
}

void Frontier::push_children(PartId part) {
    std::array<PartId, 3> children{};
    std::size_t count = 0;
    parts_.for_children_by_depth(part, eye_, [&](PartId child) { children[count++] = child; });
    if (is_by_distance_)
        for (std::size_t i = 0; i < count; ++i) push(children[i]);
    else
        while (count != 0) push(children[--count]);
}

PartId Frontier::pop() {
    if (is_by_distance_) {
        const PartId part = heap_.top().part;
        heap_.pop();
        return part;
    }
    const PartId part = stack_.back();
    stack_.pop_back();
    return part;
}

}  // namespace apps
