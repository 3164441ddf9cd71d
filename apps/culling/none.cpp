// SPDX-License-Identifier: MIT
// No culling: everything is drawn, in the order of ids.
#include <numeric>

#include "apps/culling/culler.h"

namespace apps {
namespace {

class None final : public Culler {
  public:
    void draw(Frame& frame) override {
        std::vector<ObjectId> all(frame.scene.objects.size());
        std::iota(all.begin(), all.end(), ObjectId{0});
        frame.draw(all);
    }
};

}  // namespace

extern const CullerRecipe kNone;
const CullerRecipe kNone = {
    "none", true, Needs::kNothing, {}, [](const KnobValues&) -> std::unique_ptr<Culler> {
        return std::make_unique<None>();
    }};

}  // namespace apps
