// SPDX-License-Identifier: MIT
// How a scene is chosen and set up.
#include "witness/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "harness/draw.h"
#include "witness/machine.h"

namespace conformance {

namespace {

constexpr int kMostDraws = 4;

Target make_target(Random& random, int kind) {
    // Sizes that no tile of a rasteriser divides; the default framebuffer has its own.
    const int width = random.integer(48, 97);
    const int height = random.integer(40, 61);
    const TargetKind& chosen = kTargetKinds[static_cast<std::size_t>(kind)];
    if (chosen.depth_format == 0) return Target(chosen, kSurfaceSize, kSurfaceSize);
    return Target(chosen, width, height);
}

int random_kind(Random& random) {
    for (;;) {
        const int kind = random.below(static_cast<int>(kTargetKinds.size()));
        const bool is_layered = kTargetKinds[static_cast<std::size_t>(kind)].layers != 0;
        if (!is_layered || machine().layers_agree) return kind;
    }
}

}  // namespace

Scene::Scene(std::uint64_t seed)
    : random_(seed), kind_(random_kind(random_)), target_(make_target(random_, kind_)) {
    const bool is_reversed = random_.chance(20);
    far_end_ = is_reversed ? GL_ZERO : GL_ONE;
    cleared_depth_ = is_reversed ? 0.0f : 1.0f;
    if (random_.chance(10)) cleared_depth_ = 0.5f;
    add_background(random_);
    const std::vector<Pipeline>& palette = pipelines_of(kind_);
    const int count = random_.integer(1, kMostDraws);
    while (static_cast<int>(draws_.size()) < count) {
        const Pipeline& pipeline = palette[static_cast<std::size_t>(random_.below(kPipelinesPerTarget))];
        if (pipeline.is_reversed != is_reversed) continue;
        const TargetKind& target = kTargetKinds[static_cast<std::size_t>(kind_)];
        draws_.emplace_back(random_, target, target_.width(), target_.height(), pipeline);
    }
    for (Draw& draw : draws_) draw.prepare();
}

void Scene::add_background(Random& random) {
    const auto width = static_cast<float>(target_.width());
    const auto height = static_cast<float>(target_.height());
    const int count = random.integer(1, 4) * target_.layers();
    for (int i = 0; i < count; ++i) {
        const bool is_flat = random.chance(60);
        const float depth = 0.125f * static_cast<float>(random.integer(1, 7));
        Shape shape{{}, random.below(target_.layers()), random.below(4)};
        for (int corner = random.integer(3, 4); corner > 0; --corner) {
            const float x = random.real(-0.3f, 1.3f) * width;
            const float y = random.real(-0.3f, 1.3f) * height;
            const float z = is_flat ? depth : random.real(0.0f, 1.0f);
            shape.corners.push_back({{x, y, z, 1.0f}, {random.real(0.0f, 1.0f), 0.5f, 0.25f, 1.0f}});
        }
        background_.push_back(shape);
    }
}

void Scene::start() const {
    neutral();
    target_.bind();
    use_pixel_coordinates(target_.width(), target_.height());
    clear(cleared_depth_);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    for (const Shape& shape : background_) {
        target_.bind_layer(shape.layer);
        glStencilFunc(GL_ALWAYS, shape.stencil, 0xFF);
        glBegin(GL_TRIANGLE_FAN);
        for (const Vertex& corner : shape.corners) {
            glColor4fv(corner.colour.data());
            glVertex4fv(corner.position.data());
        }
        glEnd();
    }
    neutral();
    target_.bind();
}

void Scene::play(const Draw& draw) const {
    apply(draw.pipeline(), draw.settings());
    draw.issue();
}

// Softpipe blends in floats until it is flushed, as it is where the unit draws elsewhere in between: so
// everybody flushes, or colours would differ by a step.
void Scene::play_all() const {
    for (const Draw& draw : draws_) {
        glFlush();
        play(draw);
    }
}

bool Scene::may_leave_nearest_depth() const {
    return std::any_of(draws_.begin(), draws_.end(), [this](const Draw& draw) {
        return conformance::may_leave_nearest_depth(draw.pipeline(), target_.has_stencil(), far_end_);
    });
}

bool Scene::may_leave_projected_hits() const {
    return std::any_of(draws_.begin(), draws_.end(), [this](const Draw& draw) {
        return conformance::may_leave_projected_hits(draw.pipeline(), target_.has_stencil());
    });
}

bool Scene::may_leave_marks() const {
    const bool is_multisampled = kTargetKinds[static_cast<std::size_t>(kind_)].samples != 0;
    return is_multisampled && std::ranges::any_of(draws_, &Draw::is_of_pixels);
}

std::string Scene::description() const {
    std::string text = kTargetKinds[static_cast<std::size_t>(kind_)].name;
    text += " " + std::to_string(target_.width()) + "x" + std::to_string(target_.height());
    if (far_end_ == GL_ZERO) text += ", reversed";
    for (const Draw& draw : draws_) text += "\n  " + draw.description();
    return text;
}

void tell_recipe(const Scene& scene) {
    const ::testing::TestInfo& test = *::testing::UnitTest::GetInstance()->current_test_info();
    std::printf("--gtest_also_run_disabled_tests --gtest_filter=%s.%s plays on %s\n", test.test_suite_name(),
                test.name(), scene.description().c_str());
}

}  // namespace conformance
