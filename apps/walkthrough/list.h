// SPDX-License-Identifier: MIT
// walkthrough --list: what can be walked through, and how.
#pragma once

#include <nlohmann/json.hpp>

namespace apps {

/// {"scenes": [{name, triangles, objects, paper}], "cullers": [{name, conservative, needs, knobs}],
/// "statistics": [{name, meaning}]}
nlohmann::ordered_json list_all();

}  // namespace apps
