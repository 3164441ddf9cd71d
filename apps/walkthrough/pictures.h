// SPDX-License-Identifier: MIT
// Three pictures of one frame: what the camera sees, what was drawn, and how the nodes were judged.
#pragma once

#include <filesystem>

#include "apps/culling/culler.h"
#include "apps/render/renderer.h"

namespace apps {

/// Writes view.png, above.png and nodes.png into `folder`, which is made if need be. Throws
/// std::runtime_error. `frame` has been drawn. The pictures are as large as its view.
void save_pictures(Renderer& renderer, const Frame& frame, const std::filesystem::path& folder);

}  // namespace apps
