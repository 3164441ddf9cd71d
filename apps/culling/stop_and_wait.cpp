// SPDX-License-Identifier: MIT
// Hierarchical stop-and-wait: Bittner, Wimmer, Piringer, Purgathofer, Coherent Hierarchical Culling, 2004,
// section 3. "Once a kD-tree node passes view-frustum culling, it is tested for occlusion by issuing the
// occlusion query and waiting for its result. If the node is found visible, we continue by recursively
// testing its children in a front-to-back order. If the node is a leaf, we render its associated objects."
// Deviation: a box that a test may misjudge (proxy_of) is taken as visible and not asked about; the paper is
// silent.
#include "apps/culling/traversal.h"

namespace apps {
namespace {

class StopAndWait final : public Culler {
  public:
    explicit StopAndWait(float growth_pixels) : growth_pixels_(growth_pixels) {}

    void draw(Frame& frame) override {
        traverse(frame.tree, frame.view.eye, [&](NodeId id) {
            const Node& node = frame.tree.nodes[id];
            frame.classes[id] = classify(frame, node);
            if (frame.classes[id] != NodeClass::kVisible) return false;
            // Case 5: asked before it is drawn; the other order would test the box against what it encloses.
            frame.draw(frame.tree.objects_of(node));
            return true;
        });
    }

  private:
    NodeClass classify(Frame& frame, const Node& node) const {
        if (is_outside(frame.view, node.box)) return NodeClass::kOutside;
        const std::optional<Box> proxy = proxy_of(frame.view, node.box, growth_pixels_);
        return !proxy || frame.canvas.is_visible(*proxy) ? NodeClass::kVisible : NodeClass::kOccluded;
    }

    float growth_pixels_;
};

constexpr Knob kKnobs[] = {kProxyGrowthKnob};

}  // namespace

extern const CullerRecipe kStopAndWait;
const CullerRecipe kStopAndWait = {
    "stop-and-wait", true, Needs::kTest, kKnobs, [](const KnobValues& knobs) -> std::unique_ptr<Culler> {
        return std::make_unique<StopAndWait>(static_cast<float>(knobs.at("proxy_growth")));
    }};

}  // namespace apps
