// SPDX-License-Identifier: MIT
// The walk itself: a scene with its tree, a context, one culler, and the frames along the path.
#pragma once

#include "apps/hierarchy/refit.h"
#include "apps/hierarchy/world.h"
#include "apps/platform/device_clock.h"
#include "apps/report/frame_report.h"
#include "apps/scene/motion.h"
#include "apps/walkthrough/options.h"

namespace apps {

/// The scene and the tree that the options name.
World build_world(const Options& options);

class Walk {
  public:
    /// Throws PlatformError or BadUse. What moves by the options moves in `world`.
    Walk(World& world, const Options& options);

    /// Three passes, so that nothing but the frame itself is in its time: preparation and warming up; the
    /// timed frames, each ended by glFinish and a swap; the oracle. A monitor under GL sees warming up as the
    /// first frame, and frame k as k + 1: on the device's clock a frame lasts from one swap to the next, so
    /// that frames add up.
    std::vector<FrameRecord> run();

    View view(int frame) const;

    /// Draws the frame of --image-frame once more and writes its pictures into --images.
    void save_images();

    /// The scene, the machine and the settings, for the summary.
    nlohmann::ordered_json facts() const;

  private:
    FrameRecord draw(int index);
    void judge(std::vector<FrameRecord>& frames);
    void place_all(int frame);
    void place_and_refit(int frame);

    World& world_;
    const Options& options_;
    std::optional<Motion> motion_;
    std::optional<Refitter> refitter_;
    std::unique_ptr<Platform> platform_;
    DeviceClock device_clock_;
    std::unique_ptr<Renderer> renderer_;
    Machine machine_;
    std::unique_ptr<Culler> culler_;
};

}  // namespace apps
