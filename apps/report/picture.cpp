// SPDX-License-Identifier: MIT
// Averages passes and hands the rows to libpng, top first.
#include "apps/report/picture.h"

#include <png.h>

#include <stdexcept>

namespace apps {

Picture::Picture(int width, int height)
    : width_(width),
      height_(height),
      sums_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
}

void Picture::add(const std::vector<std::uint32_t>& pixels) {
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        const std::uint32_t rgba = pixels[i];
        sums_[i] += glm::vec3(rgba & 255, rgba >> 8 & 255, rgba >> 16 & 255);
    }
    ++passes_;
}

void Picture::save(const std::filesystem::path& file) const {
    std::vector<glm::u8vec3> rows;
    rows.reserve(sums_.size());
    for (int y = height_ - 1; y >= 0; --y)
        for (int x = 0; x < width_; ++x) {
            const auto at =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
            rows.emplace_back(sums_[at] / static_cast<float>(passes_) + 0.5F);
        }
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width_);
    image.height = static_cast<png_uint_32>(height_);
    image.format = PNG_FORMAT_RGB;
    if (!png_image_write_to_file(&image, file.c_str(), 0, rows.data(), 0, nullptr))
        throw std::runtime_error("the picture " + file.string() + " cannot be written: " + image.message);
}

glm::mat4 shifted(const glm::mat4& projection, glm::vec2 pixels, int width, int height) {
    // Clip coordinates move by the same part of w everywhere: x' = x + 2 * pixels / width * w.
    const glm::vec2 part = 2.0F * pixels / glm::vec2(width, height);
    glm::mat4 result = projection;
    for (int column = 0; column < 4; ++column) {
        result[column][0] += part.x * projection[column][3];
        result[column][1] += part.y * projection[column][3];
    }
    return result;
}

}  // namespace apps
