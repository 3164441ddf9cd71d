// SPDX-License-Identifier: MIT
// Pictures as PNG files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

namespace apps {

/// Linear sum of passes; rows from the bottom, as GL reads them.
class Picture {
  public:
    Picture(int width, int height);

    /// Adds one pass of RGBA8 pixels; the saved picture is the mean of all.
    void add(const std::vector<std::uint32_t>& pixels);

    /// RGB8. Throws std::runtime_error where the file cannot be written.
    void save(const std::filesystem::path& file) const;

    int width() const { return width_; }
    int height() const { return height_; }

  private:
    int width_;
    int height_;
    int passes_ = 0;
    std::vector<glm::vec3> sums_;
};

/// The projection moved by a part of a pixel, in -0.5..0.5: passes over a grid of these smooth edges.
glm::mat4 shifted(const glm::mat4& projection, glm::vec2 pixels, int width, int height);

}  // namespace apps
