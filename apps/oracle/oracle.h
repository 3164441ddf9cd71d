// SPDX-License-Identifier: MIT
// The exact visible set, by an item buffer: every object in a colour that is its id, every triangle drawn,
// and each pixel says whose it is. Drawn twice, in opposite orders: a pixel whose owner changes is a tie in
// depth, contested, and counts neither for nor against anyone. Same vertices, matrices, depth buffer and GL
// state as the culled frame.
#pragma once

#include <optional>

#include "apps/culling/view.h"
#include "apps/render/renderer.h"

namespace apps {

/// What is true of a view, whatever a culler does.
struct Truth {
    std::vector<ObjectId> visible;  // owners of at least one uncontested pixel, ascending
    std::uint32_t contested_pixels = 0;
    std::uint64_t image_hash = 0;  // of the item buffer drawn in ascending order
};

/// How a culler's drawn set compares with it.
struct Verdict {
    std::uint32_t visible_objects = 0;
    std::uint32_t false_culls = 0;   // visible objects that were not drawn
    std::uint32_t wrong_pixels = 0;  // uncontested pixels of another owner than in the full picture
    std::uint32_t contested_pixels = 0;
};

class Oracle {
  public:
    Oracle(Renderer& renderer, const Scene& scene);

    Truth look(const View& view);
    Verdict judge(const View& view, const Truth& truth, std::span<const ObjectId> drawn);

  private:
    struct Images {
        std::vector<std::uint32_t> forwards, backwards;
    };
    Images draw_all(const View& view);
    void begin(const View& view);

    Renderer& renderer_;
    const Scene& scene_;
    Renderer::Paint ids_;
};

}  // namespace apps
