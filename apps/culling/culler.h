// SPDX-License-Identifier: MIT
// A culler decides, frame by frame, what to ask and what to draw. It knows boxes and objects; what asks and
// draws, GL or a test, is its Canvas. A new culler: one file with its recipe, two lines in culler.cpp, one in
// CMakeLists.txt, one section of docs.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "apps/culling/canvas.h"
#include "apps/culling/statistic.h"
#include "apps/culling/view.h"
#include "apps/hierarchy/tree.h"

namespace apps {

enum class NodeClass : std::uint8_t { kUnvisited, kOutside, kOccluded, kVisible };

/// One frame's work and record.
struct Frame {
    Frame(int number, const Scene& the_scene, const Tree& the_tree, const View& the_view, Canvas& the_canvas)
        : index(number),
          scene(the_scene),
          tree(the_tree),
          view(the_view),
          canvas(the_canvas),
          is_drawn(the_scene.objects.size(), 0),
          classes(the_tree.nodes.size(), NodeClass::kUnvisited) {}

    /// Draws those of `objects` that this frame has not drawn yet.
    void draw(std::span<const ObjectId> objects);

    int index;
    const Scene& scene;
    const Tree& tree;
    const View& view;
    Canvas& canvas;
    std::vector<ObjectId> drawn;         // in the order of drawing, each once
    std::vector<std::uint8_t> is_drawn;  // by object: the stamp
    std::vector<NodeClass> classes;      // by node, for pictures
    Tally tally;

  private:
    std::vector<ObjectId> batch_;
};

class Culler {
  public:
    virtual ~Culler() = default;

    /// Called for every frame before the first is timed; for what a method may know beforehand.
    virtual void prepare(Frame&) {}

    /// Forgets earlier frames: the next is the first. Called on the context that they were drawn in.
    virtual void restart() {}

    virtual void draw(Frame& frame) = 0;

    /// Called after the time of a frame was taken, with no other frame between: for what can be known only
    /// then, such as what the GPU decided to draw.
    virtual void settle(Frame&) {}
};

struct Knob {
    std::string_view name;
    double value;  // where --set does not name it
    double low, high;
    std::string_view meaning;
    bool trades_image = false;  // any value but the default may leave out visible samples
};

using KnobValues = std::map<std::string, double, std::less<>>;  // every knob of the culler

enum class Needs : std::uint8_t {
    kNothing,
    kTest,       // some occlusion test, if only one at a time
    kQueries,    // query objects, many in flight
    kCondition,  // query objects, and draws that depend on them
    kDepths,     // of the depth buffer: by depth region queries, else read back
};

struct CullerRecipe {
    std::string_view name;
    bool is_conservative;  // with its knobs at their defaults: never leaves out an object that owns a sample
    Needs needs;
    std::span<const Knob> knobs;
    std::unique_ptr<Culler> (*make)(const KnobValues&);

    /// Its knobs at their defaults, but those of `settings`.
    KnobValues knob_values(const KnobValues& settings = {}) const;

    /// False where a knob that trades the image is set.
    bool is_conservative_with(const KnobValues& values) const;
};

std::span<const CullerRecipe* const> cullers();

/// nullptr where no culler has that name.
const CullerRecipe* find_culler(std::string_view name);

/// One of the list, its knobs at their defaults but those of `settings`.
std::unique_ptr<Culler> make_culler(std::string_view name, const KnobValues& settings = {});

/// The knob of all cullers that draw boxes in tests.
inline constexpr Knob kProxyGrowthKnob = {"proxy_growth", kSafeGrowthPixels, kSafeGrowthPixels, 8,
                                          "pixels by which the box of a test is grown"};

}  // namespace apps
