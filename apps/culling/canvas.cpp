// SPDX-License-Identifier: MIT
// A machine that can do nothing but draw.
#include "apps/culling/canvas.h"

#include <stdexcept>

namespace apps {
namespace {

[[noreturn]] void refuse(const char* what) {
    throw std::logic_error(std::string("a culler asked for what this machine has not: ") + what);
}

}  // namespace

QueryId Canvas::ask(std::span<const Box>) {
    refuse("an occlusion test");
}
bool Canvas::is_answered(QueryId) {
    refuse("query objects");
}
std::uint32_t Canvas::samples(QueryId) {
    refuse("an occlusion test");
}
void Canvas::draw_on_condition(QueryId, Condition, std::span<const ObjectId>) {
    refuse("conditional drawing");
}
std::vector<std::uint8_t> Canvas::are_occluded(std::span<const Rectangle>) {
    refuse("depth regions");
}
std::vector<float> Canvas::furthest_depths(std::span<const Rectangle>) {
    refuse("depth regions");
}
std::vector<float> Canvas::read_depths(const Rectangle&) {
    refuse("depths");
}

}  // namespace apps
