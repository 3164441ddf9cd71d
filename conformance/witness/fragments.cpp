// SPDX-License-Identifier: MIT
// Two ways, by what the target has.
//
// With stencil: every fragment increments, whatever becomes of it, and only the k-th passes, because only it
// meets k in the stencil buffer. So the depth buffer keeps the k-th fragment's depth, and the stencil buffer
// how many there were: Myers, Bavoil, "Stencil routed A-buffer", 2007. The draw is the scene's own, whatever
// it consists of. Without: triangle by triangle, over two cleared depths; where both runs leave the same
// depth, a fragment wrote it.
#include "witness/fragments.h"

#include <gtest/gtest.h>

#include "harness/query.h"
#include "witness/machine.h"

namespace conformance {

namespace {

constexpr std::uint8_t kMostFragments = 100;  // of a sample: no draw of a scene has so many

// The draw's own state but for depth and stencil, into cleared buffers.
template <typename Issue>
Buffers routed(Scene& scene, const Draw& draw, float cleared, GLint index, bool only_front, Issue issue) {
    scene.start();
    glClearDepth(static_cast<GLdouble>(cleared));
    glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    apply(draw.pipeline(), draw.settings());
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glDepthMask(GL_TRUE);
    if (scene.target().has_stencil()) {
        glEnable(GL_STENCIL_TEST);
        glStencilMask(0xFF);
        glStencilFuncSeparate(GL_FRONT, GL_EQUAL, index, 0xFF);
        glStencilFuncSeparate(GL_BACK, only_front ? GL_NEVER : GL_EQUAL, index, 0xFF);
        glStencilOp(GL_INCR, GL_INCR, GL_INCR);
    }
    // Softpipe interpolates depths of 16 bits another way while no query counts (sp_quad_depth_test.c).
    const Query query;
    query.begin();
    issue();
    query.end();
    return scene.target().read();
}

std::vector<FragmentLayer> by_stencil(Scene& scene, const Draw& draw) {
    std::vector<FragmentLayer> layers;
    const bool has_two_sides = draw.pipeline().tests_stencil;
    std::uint8_t most = 1;
    for (std::uint8_t k = 0; k < most; ++k) {
        const auto issue = [&] { draw.issue(); };
        const Buffers all = routed(scene, draw, 0.0f, k, false, issue);
        FragmentLayer layer{std::vector<std::uint8_t>(all.depth.size()),
                            std::vector<std::uint8_t>(all.depth.size(), 1), all.depth};
        for (std::size_t i = 0; i < all.depth.size(); ++i) {
            layer.is_there[i] = all.stencil[i] > k;
            most = std::max(most, all.stencil[i]);
        }
        if (has_two_sides) {
            // Of the k-th fragments only those that face front get through: both depths left are theirs.
            const Buffers low = routed(scene, draw, 0.0f, k, true, issue);
            const Buffers high = routed(scene, draw, 1.0f, k, true, issue);
            for (std::size_t i = 0; i < all.depth.size(); ++i)
                layer.is_front[i] = low.depth[i] == high.depth[i];
        }
        layers.push_back(std::move(layer));
        EXPECT_LT(most, kMostFragments);
        if (most >= kMostFragments) break;
    }
    return layers;
}

std::vector<FragmentLayer> by_triangle(Scene& scene, const Draw& draw) {
    std::vector<FragmentLayer> layers;
    for (int triangle = 0; triangle < draw.triangles(); ++triangle) {
        const auto issue = [&] { draw.issue_triangle(triangle); };
        const Buffers low = routed(scene, draw, 0.0f, 0, false, issue);
        const Buffers high = routed(scene, draw, 1.0f, 0, false, issue);
        FragmentLayer layer{std::vector<std::uint8_t>(low.depth.size()),
                            std::vector<std::uint8_t>(low.depth.size(), 1), low.depth};
        for (std::size_t i = 0; i < low.depth.size(); ++i) layer.is_there[i] = low.depth[i] == high.depth[i];
        layers.push_back(std::move(layer));
    }
    return layers;
}

}  // namespace

std::vector<FragmentLayer> fragments_of(Scene& scene, const Draw& draw) {
    return scene.target().has_stencil() ? by_stencil(scene, draw) : by_triangle(scene, draw);
}

}  // namespace conformance
