// SPDX-License-Identifier: MIT
// Asks the machine which test it has. Only its own word counts: a name that GetProcAddress finds proves
// nothing.
#include "apps/query/occlusion_test_makers.h"

namespace apps {

std::unique_ptr<OcclusionTest> choose_occlusion_test(Platform& platform, std::string_view wanted) {
    const auto may_take = [&](std::string_view extension, bool is_core = false) {
        return (wanted.empty() || wanted == extension) && (is_core || platform.has_extension(extension));
    };
    if (may_take("GL_ARB_occlusion_query", platform.is_at_least(1, 5)))
        return make_arb_occlusion_query(platform);
    if (may_take("GL_NV_occlusion_query")) return make_nv_occlusion_query(platform);
    if (may_take("GL_HP_occlusion_test")) return make_hp_occlusion_test();
    return nullptr;
}

}  // namespace apps
