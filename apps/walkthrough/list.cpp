// SPDX-License-Identifier: MIT
// The lists of scenes and cullers as JSON. "needs": one extension of each inner list.
#include "apps/walkthrough/list.h"

#include "apps/culling/culler.h"
#include "apps/scene/scenes.h"

namespace apps {

nlohmann::ordered_json list_all() {
    using Json = nlohmann::ordered_json;
    Json scene_list = Json::array();
    for (const SceneRecipe& scene : scenes())
        scene_list.push_back({{"name", scene.name},
                              {"triangles", scene.triangles},
                              {"objects", scene.build(1, 1).objects.size()},
                              {"paper", scene.paper},
                              {"smallest_scale", scene.smallest_scale}});
    Json culler_list = Json::array();
    for (const CullerRecipe& culler : cullers()) {
        Json knobs = Json::array();
        for (const Knob& knob : culler.knobs)
            knobs.push_back({{"name", knob.name},
                             {"default", knob.value},
                             {"range", {knob.low, knob.high}},
                             {"meaning", knob.meaning}});
        Json needs = Json::array();
        if (culler.asks) needs.push_back({"GL_ARB_occlusion_query", "GL_HP_occlusion_test"});
        culler_list.push_back({{"name", culler.name},
                               {"conservative", culler.is_conservative},
                               {"needs", needs},
                               {"knobs", knobs}});
    }
    return {{"scenes", scene_list}, {"cullers", culler_list}};
}

}  // namespace apps
