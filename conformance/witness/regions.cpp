// SPDX-License-Identifier: MIT
// Region queries of random scenes against the depths of every sample, read back.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "witness/instances.h"
#include "witness/scene_test.h"

namespace conformance {
namespace {

constexpr int kRectangles = 12;
constexpr GLfloat kLastStep24 = 1.0f - 0x1p-24f;
constexpr std::array<GLenum, 3> kQuestions = {GL_REGION_OCCLUDED_EMU, GL_FURTHEST_DEPTH_EMU,
                                              GL_NEAREST_DEPTH_EMU};

using Rectangle = std::array<GLint, 4>;

class RegionScenes : public SceneTest {
  protected:
    void SetUp() override {
        if (!machine().has_regions) GTEST_SKIP() << "needs GL_EMU_depth_region_query";
        make_scene(3'000'000);
        scene().start();
        scene().play_all();
        depths_ = scene().target().read().depth;
        set_far_end(scene().far_end());
    }

    // Inside, across an edge, beyond, and without any pixel.
    Rectangle random_rectangle(Random& random) {
        const int width = scene().target().width();
        const int height = scene().target().height();
        Rectangle rectangle{};
        rectangle[0] = random.integer(-width / 2, width + 4);
        rectangle[1] = random.integer(-height / 2, height + 4);
        rectangle[2] = random.integer(0, random.chance(50) ? 8 : 2 * width);
        rectangle[3] = random.integer(0, random.chance(50) ? 8 : 2 * height);
        return rectangle;
    }

    // Calls <see> with every depth of the rectangle's pixels that there are; gives their number of pixels.
    template <typename See>
    std::int64_t each_depth(const Rectangle& rectangle, See see) {
        const Target& target = scene().target();
        std::int64_t pixels = 0;
        for (int y = std::max(rectangle[1], 0); y < std::min(rectangle[1] + rectangle[3], target.height());
             ++y) {
            for (int x = std::max(rectangle[0], 0); x < std::min(rectangle[0] + rectangle[2], target.width());
                 ++x) {
                ++pixels;
                const int first = (y * target.width() + x) * target.samples();
                for (int i = first; i < first + target.samples(); ++i)
                    see(depths_[static_cast<std::size_t>(i)]);
            }
        }
        return pixels;
    }

    float expected(GLenum question, const Rectangle& rectangle) {
        const bool is_far_one = scene().far_end() == GL_ONE;
        const float far = is_far_one ? 1.0f : 0.0f;
        float lowest = 1.0f;
        float highest = 0.0f;
        bool is_occluded = true;
        each_depth(rectangle, [&](float depth) {
            lowest = std::min(lowest, depth);
            highest = std::max(highest, depth);
            is_occluded = is_occluded && depth != far;
        });
        if (question == GL_REGION_OCCLUDED_EMU) return is_occluded ? 1.0f : 0.0f;
        // Of no pixel at all: the near value is the furthest, the far value the nearest.
        return (question == GL_FURTHEST_DEPTH_EMU) == is_far_one ? highest : lowest;
    }

    static std::int64_t pixels_read() {
        GLint64 pixels = 0;
        glGetInteger64v(GL_DEPTH_REGION_PIXELS_READ_EMU, &pixels);
        return pixels;
    }

  private:
    std::vector<float> depths_;
};

// One by one, many in one call, in query objects: always what the samples of the depth buffer say.
TEST_P(RegionScenes, answers_are_what_the_samples_hold) {
    Random random(static_cast<std::uint64_t>(GetParam()) + 4'000'000);
    std::vector<Rectangle> rectangles;
    for (int i = 0; i < kRectangles; ++i) rectangles.push_back(random_rectangle(random));
    std::int64_t pixels = 0;
    for (const Rectangle& rectangle : rectangles) pixels += each_depth(rectangle, [](float) {});

    for (const GLenum question : kQuestions) {
        SCOPED_TRACE(question);
        const std::int64_t before = pixels_read();
        std::array<GLfloat, kRectangles> values{};
        command<PFNGLGETDEPTHREGIONSFVEMUPROC>("glGetDepthRegionsfvEMU")(question, kRectangles,
                                                                         rectangles[0].data(), values.data());
        EXPECT_EQ(pixels_read() - before, pixels);
        std::array<GLuint, kRectangles> queries{};
        glGenQueries(kRectangles, queries.data());
        command<PFNGLQUERYDEPTHREGIONSEMUPROC>("glQueryDepthRegionsEMU")(
            question, kRectangles, rectangles[0].data(), queries.data());
        for (std::size_t i = 0; i < kRectangles; ++i) {
            const Rectangle& at = rectangles[i];
            SCOPED_TRACE(::testing::PrintToString(at));
            GLfloat right = expected(question, at);
            // The last step before 1 and 1 itself cannot be told apart by a fetch of 24-bit samples.
            const bool is_last =
                question != GL_REGION_OCCLUDED_EMU && right == 1.0f && values[i] == kLastStep24;
            if (is_last && scene().target().samples() > 1 && !scene().target().has_float_depth())
                right = values[i];
            EXPECT_EQ(values[i], right);
            GLfloat alone = -1.0f;
            command<PFNGLGETDEPTHREGIONFVEMUPROC>("glGetDepthRegionfvEMU")(question, at[0], at[1], at[2],
                                                                           at[3], &alone);
            EXPECT_EQ(alone, right);
            GLuint word = 0xDEADBEEF;
            glGetQueryObjectuiv(queries[i], GL_QUERY_RESULT, &word);
            const bool is_depth = question != GL_REGION_OCCLUDED_EMU;
            EXPECT_EQ(word, is_depth ? std::bit_cast<GLuint>(right) : static_cast<GLuint>(right));
        }
        glDeleteQueries(kRectangles, queries.data());
    }
    EXPECT_TRUE(no_error());
}

PLAY_ON_FOUR_MACHINES(RegionScenes, 15, 150);

}  // namespace
}  // namespace conformance
