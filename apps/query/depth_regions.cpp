// SPDX-License-Identifier: MIT
// The two ways to know of a rectangle's depths. Either gives the same answers: the extension's values are
// defined as those that glReadPixels returns.
#include "apps/query/depth_regions.h"

#include <GL/glext_emu.h>

#include <algorithm>

#include "apps/platform/gl.h"
#include "apps/query/query_objects.h"

namespace apps {
namespace {

class RegionQueries final : public DepthRegions {
  public:
    static constexpr std::string_view kExtension = "GL_EMU_depth_region_query";

    explicit RegionQueries(Platform& platform) {
        find_command(platform, get_, "glGetDepthRegionsfvEMU");
        GLint most = 1;
        glGetIntegerv(GL_MAX_DEPTH_REGIONS_EMU, &most);
        most_ = static_cast<std::size_t>(std::max(1, most));
    }

    std::string_view extension() const override { return kExtension; }

    std::vector<std::uint8_t> are_occluded(std::span<const Rectangle> regions) override {
        const std::vector<float> answers = ask(GL_REGION_OCCLUDED_EMU, regions);
        return {answers.begin(), answers.end()};
    }
    std::vector<float> furthest_depths(std::span<const Rectangle> regions) override {
        return ask(GL_FURTHEST_DEPTH_EMU, regions);
    }
    std::uint64_t waits_for(std::size_t regions) const override { return (regions + most_ - 1) / most_; }

  private:
    std::vector<float> ask(GLenum what, std::span<const Rectangle> regions) const {
        std::vector<float> answers(regions.size());
        std::vector<GLint> rectangles;
        rectangles.reserve(4 * regions.size());
        for (const Rectangle& r : regions) rectangles.insert(rectangles.end(), {r.x, r.y, r.width, r.height});
        for (std::size_t first = 0; first < regions.size(); first += most_) {
            const auto count = static_cast<GLsizei>(std::min(most_, regions.size() - first));
            get_(what, count, rectangles.data() + 4 * first, answers.data() + first);
        }
        return answers;
    }

    PFNGLGETDEPTHREGIONSFVEMUPROC get_ = nullptr;
    std::size_t most_ = 1;  // regions in one call
};

class ReadBack final : public DepthRegions {
  public:
    static constexpr std::string_view kExtension = "glReadPixels";

    std::string_view extension() const override { return kExtension; }

    std::vector<std::uint8_t> are_occluded(std::span<const Rectangle> regions) override {
        std::vector<std::uint8_t> answers;
        for (const Rectangle& region : regions) answers.push_back(furthest(region) < 1);
        return answers;
    }
    std::vector<float> furthest_depths(std::span<const Rectangle> regions) override {
        std::vector<float> answers;
        for (const Rectangle& region : regions) answers.push_back(furthest(region));
        return answers;
    }
    std::uint64_t waits_for(std::size_t regions) const override { return regions; }

  private:
    float furthest(const Rectangle& r) {
        depths_.assign(std::max<std::size_t>(1, r.pixels()), 0);
        glReadPixels(r.x, r.y, r.width, r.height, GL_DEPTH_COMPONENT, GL_FLOAT, depths_.data());
        return *std::max_element(depths_.begin(), depths_.end());
    }

    std::vector<float> depths_;
};

}  // namespace

std::unique_ptr<DepthRegions> choose_depth_regions(Platform& platform, std::string_view wanted) {
    if ((wanted.empty() || wanted == RegionQueries::kExtension) &&
        platform.has_extension(RegionQueries::kExtension))
        return std::make_unique<RegionQueries>(platform);
    if (wanted.empty() || wanted == ReadBack::kExtension) return std::make_unique<ReadBack>();
    return nullptr;
}

}  // namespace apps
