// SPDX-License-Identifier: MIT
#include "chc_paper.h"

#include <cmath>
#include <deque>

#include "parts.h"

namespace papers {
namespace {

using occlusion_unit::Effects;
using occlusion_unit::Profile;
using occlusion_unit::ResultTime;
using occlusion_unit::Timeline;
using occlusion_unit::TimeSums;

constexpr ChcScene kTable[] = {
    {.name = "teapots",
     .frustum_triangles = 11'139'928,
     .visible_triangles = 2'617'801,
     .coherent_triangles = 2'852'514,
     .waited_queries = 4704,
     .coherent_queries = 2827,
     .sparse_queries = 1769,
     .mean_box = 500,
     .frustum = {310.42},
     .waiting = {154.95, 83.19},
     .coherent = {81.18, 1.31},
     .ideal = {72.19},
     .sparse = {86.31}},
    {.name = "city",
     .frustum_triangles = 156'521,
     .visible_triangles = 30'594,
     .coherent_triangles = 31'034,
     .waited_queries = 663,
     .coherent_queries = 345,
     .sparse_queries = 192,
     .mean_box = 31'500,
     .frustum = {19.79},
     .waiting = {19.9, 9.49},
     .coherent = {8.47, 0.18},
     .ideal = {4.55},
     .sparse = {6.70}},
    {.name = "plant",
     .frustum_triangles = 1'556'300,
     .visible_triangles = 392'962,
     .coherent_triangles = 397'920,
     .waited_queries = 485,
     .coherent_queries = 263,
     .sparse_queries = 126,
     .fits_video_memory = false,
     .mean_box = 102'000,
     .frustum = {138.76},
     .waiting = {52.29, 16.16},
     .coherent = {38.73, 0.70},
     .ideal = {36.34},
     .sparse = {31.17}},
};

std::uint64_t triangles_of(const ChcScene& scene, ChcMethod method) {
    if (method == ChcMethod::kFrustum) return scene.frustum_triangles;
    const bool is_coherent = method == ChcMethod::kCoherent || method == ChcMethod::kSparse;
    return is_coherent ? scene.coherent_triangles : scene.visible_triangles;
}

// Asked about in one of three frames, CHC's visible leaves save two thirds of their queries.
double visible_leaves(const ChcScene& scene) {
    return 1.5 * static_cast<double>(scene.coherent_queries - scene.sparse_queries);
}

// Section 4.2: the boxes of each level of the tree cover the same area, and of S&W's levels CHC asks about
// the last alone; as many levels as a complete tree of S&W's nodes has.
double coherent_box(const ChcScene& scene) {
    const auto nodes = static_cast<double>(scene.waited_queries);
    return scene.mean_box * nodes / std::log2(nodes + 1) / static_cast<double>(scene.coherent_queries);
}

// One frame's traversal.
class Traversal {
  public:
    Traversal(Timeline& timeline, const ChcScene& scene, ChcMethod method)
        : timeline_(timeline),
          scene_(scene),
          triangles_(triangles_of(scene, method)),
          leaves_(rounded(static_cast<double>(triangles_) * visible_leaves(scene) /
                          static_cast<double>(scene.coherent_triangles))) {}

    void draw_all() {
        while (drawn_ < leaves_) draw_leaf();
    }

    void stop_and_wait() {
        for (std::uint64_t query = 0; query < scene_.waited_queries; ++query) {
            timeline_.wait(ask(scene_.mean_box));
            for (std::uint64_t left = part(leaves_, query, scene_.waited_queries); left != 0; --left)
                draw_leaf();
        }
    }

    // <asked> of the visible leaves are asked about, and so many nodes that <queries> are made.
    void coherent(std::uint64_t asked, std::uint64_t queries) {
        const double box = coherent_box(scene_);
        const std::uint64_t invisible = queries > asked ? queries - asked : 0;
        for (std::uint64_t leaf = 0; leaf < leaves_; ++leaf) {
            fetch_what_has_come();
            if (part(asked, leaf, leaves_) != 0) queue_.push_back(ask(box));
            draw_leaf();
            for (std::uint64_t left = part(invisible, leaf, leaves_); left != 0; --left) {
                fetch_what_has_come();
                queue_.push_back(ask(box));
            }
        }
        for (const ResultTime& result : queue_) timeline_.wait(result);
    }

    std::uint64_t leaves() const { return leaves_; }

  private:
    ResultTime ask(double box) { return timeline_.query({.count = rounded(box), .is_depth_only = true}); }
    void draw_leaf() {
        const std::uint64_t triangles = part(triangles_, drawn_++, leaves_);
        timeline_.draw(
            {.triangles = triangles, .copied_triangles = scene_.fits_video_memory ? 0 : triangles});
    }
    void fetch_what_has_come() {
        while (!queue_.empty()) {
            timeline_.poll(queue_.front().query);
            if (!timeline_.has_come(queue_.front())) return;
            timeline_.wait(queue_.front());
            queue_.pop_front();
        }
    }

    Timeline& timeline_;
    const ChcScene& scene_;
    std::uint64_t triangles_;
    std::uint64_t leaves_;
    std::uint64_t drawn_ = 0;
    std::deque<ResultTime> queue_;
};

}  // namespace

std::span<const ChcScene> chc_table() {
    return kTable;
}

ChcTimes paper_times(const ChcScene& scene, ChcMethod method) {
    switch (method) {
        case ChcMethod::kFrustum:
            return scene.frustum;
        case ChcMethod::kStopAndWait:
            return scene.waiting;
        case ChcMethod::kCoherent:
            return scene.coherent;
        case ChcMethod::kIdeal:
            return scene.ideal;
        case ChcMethod::kSparse:
            return scene.sparse;
    }
    return {};
}

ChcTimes chc_times(const Profile& profile, Effects effects, const ChcScene& scene, ChcMethod method,
                   const ChcProgram& program) {
    Timeline timeline(profile, effects);
    timeline.clear(program.window_pixels);
    timeline.work(picoseconds(program.frame_ms));
    Traversal traversal(timeline, scene, method);
    switch (method) {
        case ChcMethod::kFrustum:
        case ChcMethod::kIdeal:
            traversal.draw_all();
            break;
        case ChcMethod::kStopAndWait:
            traversal.stop_and_wait();
            break;
        case ChcMethod::kCoherent:
            traversal.coherent(traversal.leaves(), scene.coherent_queries);
            break;
        case ChcMethod::kSparse:
            traversal.coherent(traversal.leaves() / 3, scene.sparse_queries);
            break;
    }
    const TimeSums frame = timeline.swap(program.window_pixels);
    return {milliseconds(frame.cpu), milliseconds(frame.result_stall)};
}

}  // namespace papers
