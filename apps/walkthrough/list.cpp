// SPDX-License-Identifier: MIT
// The lists of scenes and cullers as JSON. "needs": one extension of each inner list.
#include "apps/walkthrough/list.h"

#include "apps/culling/culler.h"
#include "apps/scene/scenes.h"

namespace apps {
namespace {

/// One extension of each inner list.
nlohmann::ordered_json extensions_of(Needs needs) {
    using Json = nlohmann::ordered_json;
    const Json queries{"GL_ARB_occlusion_query", "GL_NV_occlusion_query"};
    Json list = Json::array();
    switch (needs) {
        case Needs::kNothing:
        case Needs::kDepths:
            break;  // glReadPixels will do
        case Needs::kTest:
            list.push_back(queries);
            list.back().push_back("GL_HP_occlusion_test");
            break;
        case Needs::kCondition:
            list.push_back({"GL_NV_conditional_render", "GL_NVX_conditional_render"});
            [[fallthrough]];
        case Needs::kQueries:
            list.push_back(queries);
            break;
    }
    return list;
}

}  // namespace

nlohmann::ordered_json list_all() {
    using Json = nlohmann::ordered_json;
    Json scene_list = Json::array();
    for (const SceneRecipe& scene : scenes())
        scene_list.push_back({{"name", scene.name},
                              {"triangles", scene.triangles},
                              {"objects", scene.objects},
                              {"paper", scene.paper},
                              {"smallest_scale", scene.smallest_scale}});
    Json culler_list = Json::array();
    for (const CullerRecipe* culler : cullers()) {
        Json knobs = Json::array();
        for (const Knob& knob : culler->knobs)
            knobs.push_back({{"name", knob.name},
                             {"default", knob.value},
                             {"range", {knob.low, knob.high}},
                             {"meaning", knob.meaning},
                             {"trades_image", knob.trades_image}});
        culler_list.push_back({{"name", culler->name},
                               {"conservative", culler->is_conservative},
                               {"needs", extensions_of(culler->needs)},
                               {"knobs", knobs}});
    }
    Json statistic_list = Json::array();
    for (const Statistic* statistic : Statistic::all())
        statistic_list.push_back({{"name", statistic->name()}, {"meaning", statistic->meaning()}});
    return {{"scenes", scene_list}, {"cullers", culler_list}, {"statistics", statistic_list}};
}

}  // namespace apps
