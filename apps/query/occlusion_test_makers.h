// SPDX-License-Identifier: MIT
// The ways to ask, one file each; choose_occlusion_test picks.
#pragma once

#include "apps/query/occlusion_test.h"

namespace apps {

std::unique_ptr<OcclusionTest> make_arb_occlusion_query(Platform& platform);
std::unique_ptr<OcclusionTest> make_nv_occlusion_query(Platform& platform);
std::unique_ptr<OcclusionTest> make_hp_occlusion_test();

}  // namespace apps
