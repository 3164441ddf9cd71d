// SPDX-License-Identifier: MIT
// A context, a small scene of hand-made objects, and the machine that draws and asks: what the GL tests
// share.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "apps/culling/culler.h"
#include "apps/oracle/oracle.h"
#include "apps/render/gl_canvas.h"
#include "apps/scene/mesh_builder.h"

namespace apps_test {

/// One scene in one context.
struct Stage {
    Stage(apps::Scene the_scene, int width, int height)
        : scene(std::move(the_scene)),
          platform(apps::open_egl(width, height)),
          machine{apps::choose_occlusion_test(*platform), apps::choose_conditional_render(*platform),
                  apps::choose_depth_regions(*platform), nullptr},
          renderer(*platform, scene),
          oracle(renderer, scene),
          canvas(renderer, machine) {}

    void start(const apps::View& view) {
        renderer.set_matrices(view.modelview, view.projection, view.width, view.height);
        renderer.clear({0, 0, 0, 0});
    }

    apps::Scene scene;
    std::unique_ptr<apps::Platform> platform;
    apps::Machine machine;
    apps::Renderer renderer;
    apps::Oracle oracle;
    apps::GlCanvas canvas;
};

/// A tree of two leaves that is always traversed in the order of the objects: the first hides, the second is
/// hidden.
inline apps::Tree two_leaves(const apps::Scene& scene) {
    apps::Tree tree;
    tree.nodes.resize(3);
    tree.objects = {0, 1};
    for (std::uint32_t leaf : {0U, 1U}) {
        tree.nodes[leaf + 1].box = scene.objects[leaf].box;
        tree.nodes[leaf + 1].first = leaf;
        tree.nodes[leaf + 1].count = 1;
        tree.nodes[0].box.add(scene.objects[leaf].box);
    }
    tree.nodes[0].is_leaf = false;
    tree.nodes[0].axis = 0;
    tree.nodes[0].split = 1e9F;  // the eye is below it
    tree.nodes[0].upper = 2;
    tree.link_parents();
    return tree;
}

/// Adds a quad across the x axis as one object.
inline void add_screen(apps::MeshBuilder& mesh, float x, float half_width, float half_height) {
    mesh.quad({x, -half_width, -half_height}, {x, half_width, -half_height}, {x, half_width, half_height},
              {x, -half_width, half_height}, {0.5F, 0.5F, 0.5F});
    mesh.finish();
}

}  // namespace apps_test
