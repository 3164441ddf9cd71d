// SPDX-License-Identifier: MIT
// View-frustum culling over the tree (VFC in the CHC paper): leaves that may be inside are drawn, front to
// back.
#include "apps/culling/traversal.h"

namespace apps {
namespace {

class Frustum final : public Culler {
  public:
    void draw(Frame& frame) override {
        traverse(frame.tree, frame.view.eye, [&](NodeId id) {
            const Node& node = frame.tree.nodes[id];
            const bool outside = is_outside(frame.view, node.box);
            frame.classes[id] = outside ? NodeClass::kOutside : NodeClass::kVisible;
            if (!outside) frame.draw(frame.tree.objects_of(node));
            return !outside;
        });
    }
};

}  // namespace

extern const CullerRecipe kFrustum;
const CullerRecipe kFrustum = {
    "frustum", true, Needs::kNothing, {}, [](const KnobValues&) -> std::unique_ptr<Culler> {
        return std::make_unique<Frustum>();
    }};

}  // namespace apps
