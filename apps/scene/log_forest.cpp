// SPDX-License-Identifier: MIT
// log-forest: the forest of H. Hey, R. F. Tobler, W. Purgathofer, Real-Time Occlusion Culling with a Lazy
// Occlusion Grid, 2001, section 5: 1,694,426 triangles, "each tree is an object with an own bounding box".
// The paper tells no more of it; the kinds of trees, how dense they stand and the walk are ours, chosen for
// the paper's shares of triangles in the frustum and drawn. Five meshes are placed some thousand times.
#include <algorithm>
#include <cmath>

#include "apps/scene/mesh_builder.h"
#include "apps/scene/random.h"
#include "apps/scene/scenes.h"

namespace apps {
namespace {

constexpr float kPitchMetres = 3.2F;     // between trees, before they are moved at random
constexpr float kClearingMetres = 2.4F;  // between the walk and the middle of a tree, at least
constexpr float kEyeMetres = 1.7F;
constexpr float kLookAheadMetres = 4;
// With it, and with the part of the forest that the walk is in, about the mean shares of the paper.
constexpr float kViewDegrees = 48.0F;
constexpr float kMeanderMetres = 30;  // length of one bend and its counterpart
constexpr float kSwingMetres = 7;     // to either side
constexpr int kGroundChunks = 8;      // on a side
constexpr int kGroundCells = 6;       // on a side of a chunk, at scale 1
constexpr float kWalkFrom = 0.03F;    // shares of the forest's side, 0 in its middle
constexpr float kWalkTo = 0.43F;
constexpr int kKeys = 1200;

/// Point `side` of `sides` on a circle, by the rational parametrisation, a quarter at a time: no sine.
glm::vec2 on_circle(int side, int sides) {
    const float turn = 4 * static_cast<float>(side % sides) / static_cast<float>(sides);
    const auto quarter = static_cast<int>(turn);
    const float t = turn - static_cast<float>(quarter);
    const glm::vec2 point = glm::vec2(1 - t * t, 2 * t) / (1 + t * t);
    const glm::vec2 turned[] = {point, {-point.y, point.x}, -point, {point.y, -point.x}};
    return turned[quarter];
}

/// What grows: a stem, and whorls of branches, each branch a drooping quad that meets its neighbours, with
/// loose twigs over them.
struct Kind {
    float height;  // metres
    float radius;  // of the lowest whorl
    int whorls;
    int branches;  // to a whorl
    int twigs;     // triangles
    float waist;   // share of the height where the crown is widest: conifers 0, broad-leaved trees more
    Albedo leaf;
};

constexpr Kind kKinds[] = {
    {5.4F, 1.6F, 7, 9, 60, 0.25F, {0.16F, 0.32F, 0.14F}},
    {5.2F, 1.7F, 8, 9, 60, 0.35F, {0.13F, 0.28F, 0.16F}},
    {4.8F, 1.7F, 6, 10, 80, 0.45F, {0.30F, 0.42F, 0.13F}},
    {5.0F, 1.8F, 6, 10, 90, 0.50F, {0.40F, 0.44F, 0.16F}},
};
constexpr Albedo kBark{0.33F, 0.25F, 0.18F};
constexpr Albedo kEarth{0.31F, 0.28F, 0.18F};
constexpr int kStemTriangles = 8;

constexpr std::uint32_t triangles_of(const Kind& kind) {
    return static_cast<std::uint32_t>(kStemTriangles + 2 * kind.whorls * kind.branches + kind.twigs);
}

/// The mean of the kinds, which are planted in equal numbers.
constexpr double mean_triangles() {
    double sum = 0;
    for (const Kind& kind : kKinds) sum += triangles_of(kind);
    return sum / std::size(kKinds);
}

/// Radius of the crown at a share of its height.
float crown(const Kind& kind, float share) {
    if (share < kind.waist) return kind.radius * (0.82F + 0.18F * share / kind.waist);
    const float above = (share - kind.waist) / (1 - kind.waist);
    return kind.radius * (1 - above * (kind.waist > 0 ? above : 1)) + 0.04F;
}

void add_stem(MeshBuilder& mesh, float height) {
    constexpr float kHalf = 0.16F;
    for (int side = 0; side < 4; ++side) {
        const glm::vec2 a = on_circle(side, 4) * kHalf;
        const glm::vec2 b = on_circle(side + 1, 4) * kHalf;
        mesh.quad({a, 0}, {b, 0}, {b * 0.3F, height}, {a * 0.3F, height}, kBark);
    }
}

/// One object, its stem at the origin, with `twigs` in place of the kind's.
void add_tree(MeshBuilder& mesh, const Kind& kind, int twigs, Random random) {
    add_stem(mesh, kind.height * 0.9F);
    for (int whorl = 0; whorl < kind.whorls; ++whorl) {
        const float low = static_cast<float>(whorl) / static_cast<float>(kind.whorls);
        const float high = std::min(1.0F, low + 1.7F / static_cast<float>(kind.whorls));
        const float outer = crown(kind, low);
        const float inner = crown(kind, high) * 0.55F;
        const float shade = random.between(0.82F, 1.12F);
        std::vector<glm::vec3> tips;
        for (int branch = 0; branch < kind.branches; ++branch) {
            const float reach = outer * random.between(0.90F, 1.06F);
            const float droop = kind.height * low * random.between(0.92F, 1.0F);
            tips.emplace_back(on_circle(branch, kind.branches) * reach, droop);
        }
        for (int branch = 0; branch < kind.branches; ++branch) {
            const int next = (branch + 1) % kind.branches;
            const float top = kind.height * high;
            mesh.quad(tips[static_cast<std::size_t>(branch)], tips[static_cast<std::size_t>(next)],
                      {on_circle(next, kind.branches) * inner, top},
                      {on_circle(branch, kind.branches) * inner, top},
                      kind.leaf * shade * (branch % 2 == 0 ? 1.0F : 0.86F));
        }
    }
    for (int twig = 0; twig < twigs; ++twig) {
        const float share = random.unit() * 0.95F;
        const glm::vec2 way = on_circle(random.below(64), 64);
        const float reach = crown(kind, share) * random.between(0.80F, 1.0F);
        const glm::vec3 at(way * reach, kind.height * share);
        const glm::vec3 along(-way.y, way.x, 0);
        const float size = random.between(0.12F, 0.34F);
        mesh.triangle(at - along * size, at + along * size + glm::vec3(0, 0, size * 0.6F),
                      at + glm::vec3(way * size, -size), kind.leaf * random.between(0.9F, 1.35F));
    }
    mesh.finish();
}

/// Across the walk's way: bends to one side and the other, made of parabolas.
float swing(float x) {
    const float turn = x / kMeanderMetres - std::floor(x / kMeanderMetres);
    const float half = turn < 0.5F ? 4 * turn - 1 : 3 - 4 * turn;  // in [-1, 1]
    return kSwingMetres * half * (1.5F - 0.5F * half * half);
}

/// Along x through the middle of a forest of `side` metres, over the part that has trees ahead.
CameraPath walk(float side) {
    std::vector<CameraKey> keys;
    for (int key = 0; key < kKeys; ++key) {
        const float at = static_cast<float>(key) / (kKeys - 1);
        const float x = side * (kWalkFrom + (kWalkTo - kWalkFrom) * at);
        keys.push_back({at,
                        {x, swing(x), kEyeMetres},
                        {x + kLookAheadMetres, swing(x + kLookAheadMetres), kEyeMetres + 0.2F}});
    }
    return {std::move(keys), Lens{kViewDegrees, 0.1F, 1000}};
}

void add_ground(MeshBuilder& mesh, float side, int cells) {
    const int total = kGroundChunks * cells;
    const auto at = [&](int i) { return side * (static_cast<float>(i) / static_cast<float>(total) - 0.5F); };
    for (int chunk = 0; chunk < kGroundChunks * kGroundChunks; ++chunk) {
        const int x = chunk % kGroundChunks * cells;
        const int y = chunk / kGroundChunks * cells;
        for (int cell = 0; cell < cells * cells; ++cell) {
            const int i = x + cell % cells;
            const int j = y + cell / cells;
            mesh.quad({at(i), at(j), 0}, {at(i + 1), at(j), 0}, {at(i + 1), at(j + 1), 0},
                      {at(i), at(j + 1), 0}, kEarth * ((i + j) % 2 == 0 ? 1.0F : 0.92F));
        }
        mesh.finish();
    }
}

/// Quarter turns about the stem.
glm::mat4 planted(const glm::vec2& at, int quarters) {
    constexpr glm::vec2 kTurns[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const glm::vec2 turn = kTurns[quarters];
    return {{turn.x, turn.y, 0, 0}, {-turn.y, turn.x, 0, 0}, {0, 0, 1, 0}, {at, 0, 1}};
}

/// Where trees stand: a grid moved at random, without what is too near to the walk, nearest to the middle
/// first.
std::vector<glm::vec2> plant(std::size_t count, Random& random) {
    const int reach = static_cast<int>(std::sqrt(static_cast<double>(count)) * 0.5) + 12;
    struct Place {
        float rank;
        glm::vec2 at;
    };
    std::vector<Place> places;
    for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i) {
            const glm::vec2 cell = kPitchMetres * glm::vec2(i, j);
            const glm::vec2 at =
                cell + kPitchMetres * glm::vec2(random.between(-0.28F, 0.28F), random.between(-0.28F, 0.28F));
            float nearest = 1e9F;
            for (float step = -kClearingMetres; step <= kClearingMetres; step += 0.25F)
                nearest = std::min(nearest, glm::distance(at, glm::vec2(at.x + step, swing(at.x + step))));
            if (nearest >= kClearingMetres)
                places.push_back({std::max(std::abs(cell.x), std::abs(cell.y)), at});
        }
    std::stable_sort(places.begin(), places.end(),
                     [](const Place& a, const Place& b) { return a.rank < b.rank; });
    std::vector<glm::vec2> chosen;
    for (std::size_t i = 0; i < count; ++i) chosen.push_back(places.at(i).at);
    return chosen;
}

}  // namespace

Scene build_log_forest(double scale, std::uint64_t seed) {
    Scene scene;
    scene.name = "log-forest";
    const auto total = static_cast<std::uint32_t>(std::lround(scale * kLogForestTriangles));
    const int cells = scale >= 0.25 ? kGroundCells : 2;
    const auto ground = static_cast<std::uint32_t>(2 * kGroundChunks * kGroundChunks * cells * cells);
    const std::uint32_t of_trees = total - ground;
    const auto round_robin = static_cast<std::uint32_t>(mean_triangles() * std::size(kKinds));
    // Whole rounds of the kinds, then one tree that is padded with twigs to the exact total.
    const std::uint32_t rounds = (of_trees - triangles_of(kKinds[0])) / round_robin;
    const std::uint32_t rest = of_trees - rounds * round_robin;

    Random random(seed);
    MeshBuilder mesh(scene);
    const std::size_t trees = rounds * std::size(kKinds) + 1;
    const float side = kPitchMetres * (static_cast<float>(std::sqrt(static_cast<double>(trees))) + 8);
    add_ground(mesh, side, cells);
    const std::size_t grounds = scene.objects.size();
    for (const Kind& kind : kKinds) add_tree(mesh, kind, kind.twigs, random.split());
    add_tree(mesh, kKinds[0], kKinds[0].twigs + static_cast<int>(rest - triangles_of(kKinds[0])),
             random.split());
    const std::vector<Object> kinds(scene.objects.begin() + static_cast<std::ptrdiff_t>(grounds),
                                    scene.objects.end());
    scene.objects.resize(grounds);
    scene.bounds = {};
    for (const Object& object : scene.objects) scene.bounds.add(object.box);

    const std::vector<glm::vec2> places = plant(trees, random);
    for (std::size_t i = 0; i < trees; ++i) {
        Object tree = i + 1 == trees ? kinds.back() : kinds[i % std::size(kKinds)];
        tree.placement = static_cast<std::uint32_t>(scene.placements.size());
        scene.placements.push_back(planted(places[i], random.below(4)));
        tree.box = placed_box(scene, tree, scene.placements.back());
        scene.bounds.add(tree.box);
        scene.objects.push_back(tree);
    }
    scene.path = walk(side);
    return scene;
}

}  // namespace apps
