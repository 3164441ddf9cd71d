// SPDX-License-Identifier: MIT
// A culler decides, frame by frame, what to ask and what to draw. It knows boxes and objects; what asks and
// draws, GL or a test, is its Canvas. A new culler: one file, one line in culler.cpp, one in CMakeLists.txt,
// one section of docs.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "apps/culling/view.h"
#include "apps/hierarchy/kd_tree.h"

namespace apps {

/// The machine as a culler sees it.
class Canvas {
  public:
    virtual ~Canvas() = default;

    virtual void draw(std::span<const ObjectId> objects) = 0;

    /// Draws `proxy`, unseen, inside an occlusion test, and waits for its answer: could any sample of it be
    /// seen?
    virtual bool is_visible(const Box& proxy) = 0;
};

enum class NodeClass : std::uint8_t { kUnvisited, kOutside, kOccluded, kVisible };

/// One frame's work and record.
struct Frame {
    Frame(int number, const Scene& the_scene, const KdTree& the_tree, const View& the_view,
          Canvas& the_canvas)
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
    const KdTree& tree;
    const View& view;
    Canvas& canvas;
    std::vector<ObjectId> drawn;         // in the order of drawing, each once
    std::vector<std::uint8_t> is_drawn;  // by object: the stamp
    std::vector<NodeClass> classes;      // by node, for pictures

  private:
    std::vector<ObjectId> batch_;
};

class Culler {
  public:
    virtual ~Culler() = default;

    /// Called for every frame before the first is timed; for what a method may know beforehand.
    virtual void prepare(Frame&) {}

    virtual void draw(Frame& frame) = 0;
};

struct Knob {
    std::string_view name;
    double value;  // where --set does not name it
    double low, high;
    std::string_view meaning;
};

using KnobValues = std::map<std::string, double, std::less<>>;  // every knob of the culler

struct CullerRecipe {
    std::string_view name;
    bool is_conservative;  // with its knobs as they stand: never leaves out an object that owns a sample
    bool asks;             // needs an occlusion test: GL_ARB_occlusion_query or GL_HP_occlusion_test
    std::span<const Knob> knobs;
    std::unique_ptr<Culler> (*make)(const KnobValues&);
};

std::span<const CullerRecipe> cullers();

/// nullptr where no culler has that name.
const CullerRecipe* find_culler(std::string_view name);

std::unique_ptr<Culler> make_none(const KnobValues&);
std::unique_ptr<Culler> make_frustum(const KnobValues&);
std::unique_ptr<Culler> make_stop_and_wait(const KnobValues&);
std::unique_ptr<Culler> make_ideal(const KnobValues&);

}  // namespace apps
