// SPDX-License-Identifier: MIT
// AOQ2-15: all 31 ways to hide something, after dEQP-GLES3.functional.occlusion_query. Occluders are any of:
// a scissor rectangle, depth drawn, depth cleared in a rectangle, stencil drawn, stencil cleared in a
// rectangle. The colour that a target leaves, and the geometry, say what the query has to.
#include <random>

#include "arb_occlusion_query2/any_test.h"

namespace conformance {
namespace {

enum Occluder : unsigned {
    kScissor = 1,
    kDepthWrite = 2,
    kDepthClear = 4,
    kStencilWrite = 8,
    kStencilClear = 16,
};
constexpr unsigned kCombinations = 32;
constexpr int kRandomScenes = 8;  // for each combination

struct Scene {
    Target target;
    unsigned occluders;
};

std::vector<Scene> all_scenes() {
    std::vector<Scene> scenes;
    for (const Target& target : kBooleanTargets) {
        for (unsigned occluders = 1; occluders < kCombinations; ++occluders)
            scenes.push_back({target, occluders});
    }
    return scenes;
}

std::string name_of(const Scene& scene) {
    std::string name = scene.target.name;
    const unsigned occluders = scene.occluders;
    if (occluders & kScissor) name += "_scissor";
    if (occluders & kDepthWrite) name += "_depth_write";
    if (occluders & kDepthClear) name += "_depth_clear";
    if (occluders & kStencilWrite) name += "_stencil_write";
    if (occluders & kStencilClear) name += "_stencil_clear";
    return name;
}

std::string scene_name(const ::testing::TestParamInfo<Scene>& info) {
    return name_of(info.param);
}

std::ostream& operator<<(std::ostream& out, const Scene& scene) {
    return out << name_of(scene);
}

// Of rectangles that each occluder covers (the scissor rectangle: leaves open) and a target, what is visible.
struct Layout {
    Rect target;
    Rect open;                    // the scissor rectangle
    std::array<Rect, 4> covered;  // depth write, depth clear, stencil write, stencil clear

    bool shows(unsigned occluders, int x, int y) const {
        const auto contains = [=](const Rect& rect) {
            return x >= rect.x && x < rect.x + rect.width && y >= rect.y && y < rect.y + rect.height;
        };
        if (!contains(target) || ((occluders & kScissor) && !contains(open))) return false;
        for (std::size_t i = 0; i < covered.size(); ++i) {
            if ((occluders & (kDepthWrite << i)) && contains(covered[i])) return false;
        }
        return true;
    }
    int visible_pixels(unsigned occluders) const {
        int count = 0;
        for (int i = 0; i < kWhole.area(); ++i) {
            count += shows(occluders, i % kSurfaceSize, i / kSurfaceSize) ? 1 : 0;
        }
        return count;
    }
};

void scissor(const Rect& rect) {
    glScissor(rect.x, rect.y, rect.width, rect.height);
}

void clear_in(const Rect& rect, GLbitfield buffers) {
    glEnable(GL_SCISSOR_TEST);
    scissor(rect);
    glClearDepth(0.0);
    glClearStencil(1);
    glClear(buffers);
    glDisable(GL_SCISSOR_TEST);
}

// Leaves the tests set for the target.
void draw_occluders(const Layout& layout, unsigned occluders) {
    clear();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 1, 0xFF);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    if (occluders & kDepthWrite) draw_rect(layout.covered[0], kNear);
    if (occluders & kDepthClear) clear_in(layout.covered[1], GL_DEPTH_BUFFER_BIT);
    glStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
    glDepthMask(GL_FALSE);
    if (occluders & kStencilWrite) draw_rect(layout.covered[2], kNear);
    if (occluders & kStencilClear) clear_in(layout.covered[3], GL_STENCIL_BUFFER_BIT);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glStencilFunc(GL_EQUAL, 0, 0xFF);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    if (occluders & kScissor) glEnable(GL_SCISSOR_TEST);
    scissor(layout.open);
}

class OccluderScene : public AnyTest, public ::testing::WithParamInterface<Scene> {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(AnyTest::SetUp());
        if (IsSkipped() || GetParam().target.value == GL_ANY_SAMPLES_PASSED) return;
        if (const auto why = lacks_conservative()) GTEST_SKIP() << *why;
    }

    static void expect_right_result(const Layout& layout) {
        const auto [target, occluders] = GetParam();
        const int visible = layout.visible_pixels(occluders);
        draw_occluders(layout, occluders);
        const Query query(target.value);
        const GLuint result = query.count([&] { draw_rect(layout.target, kFar); });
        glDisable(GL_SCISSOR_TEST);
        EXPECT_EQ(drawn_pixels(), visible);
        if (visible > 0 || target.value == GL_ANY_SAMPLES_PASSED) {
            EXPECT_EQ(result, visible > 0 ? 1u : 0u);
        } else {
            EXPECT_LE(result, 1u);
        }
    }
};

INSTANTIATE_TEST_SUITE_P(, OccluderScene, ::testing::ValuesIn(all_scenes()), scene_name);

constexpr Rect kTarget = {20, 24, 16, 12};
constexpr Rect kElsewhere = {0, 0, 8, 8};

// AOQ2-15. ARB_occlusion_query2, 4.1.6: TRUE "if any fragment or sample passes the depth test", which comes
// after the scissor and stencil tests. One occluder of those that there are covers the target, the others are
// beside it.
TEST_P(OccluderScene, any_one_of_the_occluders_hides_the_target) {
    const Layout open = {kTarget, kWhole, {kElsewhere, kElsewhere, kElsewhere, kElsewhere}};
    {
        SCOPED_TRACE("nothing covers it");
        expect_right_result(open);
    }
    if (GetParam().occluders & kScissor) {
        SCOPED_TRACE("beside the scissor rectangle");
        Layout layout = open;
        layout.open = kElsewhere;
        expect_right_result(layout);
    }
    for (std::size_t i = 0; i < open.covered.size(); ++i) {
        if (!(GetParam().occluders & (kDepthWrite << i))) continue;
        SCOPED_TRACE("covered by occluder " + std::to_string(i));
        Layout layout = open;
        layout.covered[i] = kWhole;
        expect_right_result(layout);
        // All but the last pixel of the last row.
        layout.covered[i] = {0, 0, kSurfaceSize, kTarget.y + kTarget.height - 1};
        expect_right_result(layout);
    }
}

// AOQ2-15. The same of rectangles anywhere.
TEST_P(OccluderScene, rectangles_anywhere_hide_what_they_cover) {
    std::mt19937 random(GetParam().occluders);
    const auto rectangle = [&](int largest) {
        const auto below = [&](int limit) {
            return static_cast<int>(random() % static_cast<unsigned>(limit));
        };
        const int width = 1 + below(largest);
        const int height = 1 + below(largest);
        return Rect{below(kSurfaceSize - width + 1), below(kSurfaceSize - height + 1), width, height};
    };
    for (int i = 0; i < kRandomScenes; ++i) {
        const Rect target = rectangle(10);
        const Rect open = rectangle(kSurfaceSize);
        const std::array<Rect, 4> covered = {rectangle(60), rectangle(60), rectangle(60), rectangle(60)};
        SCOPED_TRACE(i);
        expect_right_result({target, open, covered});
    }
}

}  // namespace
}  // namespace conformance
