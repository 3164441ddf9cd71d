// SPDX-License-Identifier: MIT
// Frames, their time, and what they are compared with.
#include "apps/walkthrough/walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>

#include "apps/culling/traversal.h"
#include "apps/oracle/oracle_cache.h"
#include "apps/report/progress_bar.h"
#include "apps/scene/model.h"
#include "apps/scene/scenes.h"
#include "apps/walkthrough/pictures.h"

namespace apps {
namespace {

const glm::vec4 kSky{0.62F, 0.76F, 0.90F, 1};

const Statistic kMotionMicroseconds{"motion_us",
                                    "microseconds in which moving objects were placed and the tree refitted"};

/// The triangles that view-frustum culling over the same tree would draw.
std::uint64_t frustum_triangles(const World& world, const View& view) {
    std::vector<std::uint8_t> is_inside(world.scene.objects.size(), 0);
    traverse(world.tree, view.eye, [&](NodeId id) {
        const Node& node = world.tree.nodes[id];
        if (is_outside(view, node.box)) return false;
        for (const ObjectId object : world.tree.objects_of(node)) is_inside[object] = 1;
        return true;
    });
    std::uint64_t sum = 0;
    for (ObjectId id = 0; id < is_inside.size(); ++id)
        if (is_inside[id]) sum += world.scene.objects[id].triangle_count();
    return sum;
}

struct Step {
    int index;  // frame of the path
    bool is_reported;
};

/// The whole path; or its sections, evenly spread, each entered by frames that are not reported: a culler
/// that remembers goes into them as if it had walked there.
std::vector<Step> steps_of(const Options& options) {
    constexpr int kLeadIn = 3;
    std::vector<Step> steps;
    if (options.sections == 0)
        for (int index = 0; index < options.frames; ++index) steps.push_back({index, true});
    for (int section = 0; section < options.sections; ++section) {
        const auto middle = static_cast<int>((2LL * section + 1) * options.frames / (2LL * options.sections));
        const int first =
            std::clamp(middle - options.section_frames / 2, 0, options.frames - options.section_frames);
        for (int index = std::max(0, first - kLeadIn); index < first; ++index)
            steps.push_back({index, false});
        for (int k = 0; k < options.section_frames; ++k) steps.push_back({first + k, true});
    }
    return steps;
}

/// Throws BadUse where the machine has not what the culler needs.
void check_needs(const CullerRecipe& recipe, const Machine& machine, const Options& options,
                 const Platform& platform) {
    const auto refuse = [&](const std::string& what) {
        throw BadUse(fmt::format("{} needs {}, which {} {} has not", recipe.name, what, platform.renderer(),
                                 platform.version()));
    };
    const bool has_queries = machine.test && machine.test->has_queries();
    switch (recipe.needs) {
        case Needs::kNothing:
            return;
        case Needs::kTest:
            if (!machine.test)
                refuse(options.test.empty() ? "GL_ARB_occlusion_query, GL_NV_occlusion_query or "
                                              "GL_HP_occlusion_test"
                                            : options.test);
            return;
        case Needs::kCondition:
            if (!machine.conditions) refuse("GL_NV_conditional_render or GL_NVX_conditional_render");
            [[fallthrough]];
        case Needs::kQueries:
            if (!has_queries)
                refuse(options.test.empty()
                           ? "query objects (GL_ARB_occlusion_query or GL_NV_occlusion_query)"
                           : fmt::format("query objects by {}", options.test));
            return;
        case Needs::kDepths:
            if (!machine.regions) refuse(options.regions);
            return;
    }
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
    Scene scene =
        recipe ? recipe->build(options.scale, options.seed) : load_model(options.scene, options.split);
    if (options.unshared) scene = unshared(scene);
    const TreeKind own = recipe ? recipe->tree : TreeKind::kBvh;
    const TreeKind kind = options.tree == "bvh" || options.moving > 0 ? TreeKind::kBvh
                          : options.tree == "kd"                      ? TreeKind::kKdTree
                                                                      : own;
    const std::size_t leaves = recipe ? leaf_count(*recipe, scene) : scene.objects.size();
    return make_world(scene, kind, leaves);
}

Walk::Walk(World& world, const Options& options)
    : world_(world),
      options_(options),
      platform_(open_platform(options.platform, options.width, options.height)),
      device_clock_(*platform_) {
    const CullerRecipe& recipe = *find_culler(options.culler);
    machine_ = {choose_occlusion_test(*platform_, options.test), choose_conditional_render(*platform_),
                choose_depth_regions(*platform_, options.regions), &device_clock_};
    check_needs(recipe, machine_, options, *platform_);
    if (options.moving > 0) {
        motion_.emplace(world.scene, options.moving, options.seed);
        refitter_.emplace(world.tree, world.scene.objects.size());
    }
    renderer_ = std::make_unique<Renderer>(*platform_, world.scene);
    culler_ = recipe.make(options.knobs);
}

View Walk::view(int frame) const {
    return {world_.scene.path.frame(frame, options_.frames), options_.width, options_.height};
}

void Walk::place_all(int frame) {
    if (motion_) motion_->place(world_.scene, frame);
}

void Walk::place_and_refit(int frame) {
    place_all(frame);
    if (motion_) refitter_->refit(world_.tree, world_.scene, motion_->moving());
}

FrameRecord Walk::draw(int index) {
    const View v = view(index);
    GlCanvas canvas(*renderer_, machine_);
    Frame frame(index, world_.scene, world_.tree, v, canvas);

    const auto start = std::chrono::steady_clock::now();
    device_clock_.work(options_.work);
    place_and_refit(index);
    const auto placed = std::chrono::steady_clock::now();
    renderer_->set_matrices(v.modelview, v.projection, v.width, v.height);
    renderer_->clear(kSky);
    culler_->draw(frame);
    renderer_->finish();
    const auto end = std::chrono::steady_clock::now();
    culler_->settle(frame);

    if (motion_)
        frame.tally.add(kMotionMicroseconds,
                        static_cast<std::uint64_t>(
                            std::chrono::duration_cast<std::chrono::microseconds>(placed - start).count()));

    FrameRecord record;
    record.index = index;
    record.frame_ms = std::chrono::duration<double, std::milli>(end - start).count();
    record.counters = canvas.counters();
    record.drawn_triangles = triangles_of(world_.scene, frame.drawn);
    record.frustum_triangles = frustum_triangles(world_, v);
    record.tally = std::move(frame.tally);
    record.drawn = std::move(frame.drawn);
    return record;
}

std::vector<FrameRecord> Walk::run() {
    const std::vector<Step> steps = steps_of(options_);
    const auto count = static_cast<int>(steps.size());
    {
        ProgressBar bar("preparing", count);
        for (const Step& step : steps) {
            const View v = view(step.index);
            place_and_refit(step.index);
            renderer_->set_matrices(v.modelview, v.projection, v.width, v.height);
            renderer_->clear(kSky);
            GlCanvas canvas(*renderer_, machine_);
            Frame frame(step.index, world_.scene, world_.tree, v, canvas);
            culler_->prepare(frame);
            bar.step();
        }
        draw(steps.front().index);
        culler_->restart();
        platform_->swap_buffers();
        device_clock_.lap_ms();
    }
    std::vector<FrameRecord> frames;
    ProgressBar bar("walking", count);
    int swaps = 1;  // the warming up's
    for (const Step& step : steps) {
        FrameRecord record = draw(step.index);
        record.swap = swaps++;
        platform_->swap_buffers();
        record.device_ms = device_clock_.lap_ms();
        if (step.is_reported) frames.push_back(std::move(record));
        bar.step();
    }
    if (options_.oracle) judge(frames);
    return frames;
}

void Walk::judge(std::vector<FrameRecord>& frames) {
    Oracle oracle(*renderer_, world_.scene);
    place_all(0);  // the fingerprint is of the scene as it was
    const std::string key =
        fmt::format("{:x} {} {} {} {}x{} {}x{} {} {}", hash_of(world_.scene), options_.moving, options_.seed,
                    options_.frames, options_.sections, options_.section_frames, options_.width,
                    options_.height, platform_->renderer(), platform_->version());
    OracleCache cache(options_.oracle_cache, hash_bytes(std::as_bytes(std::span(key))), frames.size());
    ProgressBar bar("judging", static_cast<int>(frames.size()));
    for (std::size_t at = 0; at < frames.size(); ++at, bar.step()) {
        if (at % static_cast<std::size_t>(options_.judge_every) != 0) continue;
        const View v = view(frames[at].index);
        place_all(frames[at].index);
        std::optional<Truth> truth = cache.find(at);
        if (!truth) {
            truth = oracle.look(v);
            cache.keep(at, *truth);
        }
        frames[at].verdict = oracle.judge(v, *truth, frames[at].drawn);
    }
    if (!options_.oracle_cache.empty()) cache.save();
}

void Walk::save_images() {
    const View v = view(options_.image_frame);
    place_and_refit(options_.image_frame);
    culler_->restart();
    for (const bool is_second : {false, true}) {  // a culler that remembers shows how it is while it walks
        GlCanvas canvas(*renderer_, machine_);
        Frame frame(options_.image_frame, world_.scene, world_.tree, v, canvas);
        renderer_->set_matrices(v.modelview, v.projection, v.width, v.height);
        renderer_->clear(kSky);
        culler_->draw(frame);
        renderer_->finish();
        culler_->settle(frame);
        if (is_second) save_pictures(*renderer_, frame, options_.images);
    }
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
        {"unshared", options_.unshared},
        {"path_frames", options_.frames},
        {"mesa", mesa == std::string::npos ? nlohmann::ordered_json(nullptr)
                                           : nlohmann::ordered_json(version.substr(mesa + 5))},
        {"cpu", cpu_name()},
        {"platform", options_.platform},
        {"occlusion_test", machine_.test ? nlohmann::ordered_json(machine_.test->extension())
                                         : nlohmann::ordered_json(nullptr)},
        {"depth_regions", machine_.regions ? nlohmann::ordered_json(machine_.regions->extension())
                                           : nlohmann::ordered_json(nullptr)},
        {"buffer_objects", renderer_->has_buffer_objects()},
        {"scene_triangles", world_.scene.triangle_count()},
        {"scene_objects", world_.scene.objects.size()},
        {"tree_nodes", world_.tree.nodes.size()},
        {"moving_objects", motion_ ? motion_->moving().size() : 0},
        {"knobs", options_.knobs},
    };
    for (const auto& [name, value] : options_.labels) facts[name] = value;
    return facts;
}

}  // namespace apps
