// SPDX-License-Identifier: MIT
// Frames, their time, and what they are compared with.
#include "apps/walkthrough/walk.h"

#include <fmt/format.h>

#include <chrono>
#include <fstream>

#include "apps/oracle/oracle_cache.h"
#include "apps/report/progress_bar.h"
#include "apps/scene/model.h"
#include "apps/scene/scenes.h"
#include "apps/walkthrough/pictures.h"

namespace apps {
namespace {

const glm::vec4 kSky{0.62F, 0.76F, 0.90F, 1};

/// Counts what is drawn and draws nothing.
class CountingCanvas final : public Canvas {
  public:
    void draw(std::span<const ObjectId>) override {}
    bool is_visible(const Box&) override { return true; }
};

std::uint64_t frustum_triangles(const World& world, const View& view, int index) {
    CountingCanvas canvas;
    Frame frame(index, world.scene, world.tree, view, canvas);
    make_frustum({})->draw(frame);
    return triangles_of(world.scene, frame.drawn);
}

std::string cpu_name() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
}

}  // namespace

World build_world(const Options& options) {
    const SceneRecipe* recipe = find_scene(options.scene);
    const Scene scene = recipe ? recipe->build(options.scale, options.seed) : load_model(options.scene);
    World world;
    world.tree = build_kd_tree(scene, paper_leaf_count(scene.triangle_count()));
    world.scene = in_leaf_order(scene, world.tree);
    return world;
}

Walk::Walk(const World& world, const Options& options)
    : world_(world),
      options_(options),
      platform_(open_platform(options.platform, options.width, options.height)),
      device_clock_(*platform_) {
    const CullerRecipe& recipe = *find_culler(options.culler);
    test_ = choose_occlusion_test(*platform_);
    if (recipe.asks && !test_)
        throw BadUse(
            fmt::format("{} needs GL_ARB_occlusion_query or GL_HP_occlusion_test, and {} {} has neither",
                        recipe.name, platform_->renderer(), platform_->version()));
    renderer_ = std::make_unique<Renderer>(*platform_, world.scene);
    culler_ = recipe.make(options.knobs);
}

View Walk::view(int frame) const {
    return {world_.scene.path.frame(frame, options_.frames), options_.width, options_.height};
}

FrameRecord Walk::draw(int index) {
    const View v = view(index);
    GlCanvas canvas(*renderer_, test_.get());
    Frame frame(index, world_.scene, world_.tree, v, canvas);

    const auto start = std::chrono::steady_clock::now();
    device_clock_.work(options_.work);
    renderer_->set_matrices(v.modelview, v.projection, v.width, v.height);
    renderer_->clear(kSky);
    culler_->draw(frame);
    renderer_->finish();
    const auto end = std::chrono::steady_clock::now();

    FrameRecord record;
    record.frame_ms = std::chrono::duration<double, std::milli>(end - start).count();
    record.counters = canvas.counters();
    record.drawn_triangles = triangles_of(world_.scene, frame.drawn);
    record.frustum_triangles = frustum_triangles(world_, v, index);
    record.drawn = std::move(frame.drawn);
    return record;
}

std::vector<FrameRecord> Walk::run() {
    {
        ProgressBar bar("preparing", options_.frames);
        for (int index = 0; index < options_.frames; ++index, bar.step()) {
            const View v = view(index);
            renderer_->set_matrices(v.modelview, v.projection, v.width, v.height);
            renderer_->clear(kSky);
            GlCanvas canvas(*renderer_, test_.get());
            Frame frame(index, world_.scene, world_.tree, v, canvas);
            culler_->prepare(frame);
        }
        draw(0);
        platform_->swap_buffers();
        device_clock_.lap_ms();
    }
    std::vector<FrameRecord> frames;
    ProgressBar bar("walking", options_.frames);
    for (int index = 0; index < options_.frames; ++index, bar.step()) {
        frames.push_back(draw(index));
        platform_->swap_buffers();
        frames.back().device_ms = device_clock_.lap_ms();
    }
    if (options_.oracle) judge(frames);
    return frames;
}

void Walk::judge(std::vector<FrameRecord>& frames) {
    Oracle oracle(*renderer_, world_.scene);
    const std::string key =
        fmt::format("{:x} {} {}x{} {} {}", hash_of(world_.scene), frames.size(), options_.width,
                    options_.height, platform_->renderer(), platform_->version());
    OracleCache cache(options_.oracle_cache, hash_bytes(std::as_bytes(std::span(key))), frames.size());
    ProgressBar bar("judging", options_.frames);
    for (std::size_t index = 0; index < frames.size(); ++index, bar.step()) {
        const View v = view(static_cast<int>(index));
        std::optional<Truth> truth = cache.find(index);
        if (!truth) {
            truth = oracle.look(v);
            cache.keep(index, *truth);
        }
        frames[index].verdict = oracle.judge(v, *truth, frames[index].drawn);
    }
    if (!options_.oracle_cache.empty()) cache.save();
}

void Walk::save_images() {
    const View v = view(options_.image_frame);
    GlCanvas canvas(*renderer_, test_.get());
    Frame frame(options_.image_frame, world_.scene, world_.tree, v, canvas);
    renderer_->set_matrices(v.modelview, v.projection, v.width, v.height);
    renderer_->clear(kSky);
    culler_->draw(frame);
    save_pictures(*renderer_, frame, options_.images);
}

nlohmann::ordered_json Walk::facts() const {
    const std::string& version = platform_->version();
    const std::size_t mesa = version.find("Mesa ");
    nlohmann::ordered_json facts{
        {"scene", options_.scene},
        {"culler", options_.culler},
        {"device", platform_->renderer() + ", GL " + version},
        {"clock", nullptr},
        {"size", fmt::format("{}x{}", options_.width, options_.height)},
        {"scale", options_.scale},
        {"seed", options_.seed},
        {"mesa", mesa == std::string::npos ? nlohmann::ordered_json(nullptr)
                                           : nlohmann::ordered_json(version.substr(mesa + 5))},
        {"cpu", cpu_name()},
        {"platform", options_.platform},
        {"occlusion_test",
         test_ ? nlohmann::ordered_json(test_->extension()) : nlohmann::ordered_json(nullptr)},
        {"buffer_objects", renderer_->has_buffer_objects()},
        {"scene_triangles", world_.scene.triangle_count()},
        {"scene_objects", world_.scene.objects.size()},
        {"tree_nodes", world_.tree.nodes.size()},
        {"knobs", options_.knobs},
    };
    for (const auto& [name, value] : options_.labels) facts[name] = value;
    return facts;
}

}  // namespace apps
