// SPDX-License-Identifier: MIT
// What a context says of itself: version and extensions, read once. GL 1.1 names them in one string.
#include "apps/platform/platform.h"

#include <cstdlib>

#include "apps/platform/gl.h"

namespace apps {
namespace {

std::string string_of(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text ? reinterpret_cast<const char*>(text) : "";
}

}  // namespace

void Platform::read_strings() {
    load_gl(*this);
    describe(string_of(GL_RENDERER), string_of(GL_VERSION), string_of(GL_EXTENSIONS));
}

void Platform::describe(std::string renderer, std::string version, const std::string& extensions) {
    renderer_ = std::move(renderer);
    version_ = std::move(version);
    extensions_ = ' ' + extensions + ' ';
}

bool Platform::has_extension(std::string_view name) const {
    return extensions_.find(' ' + std::string(name) + ' ') != std::string::npos;
}

bool Platform::is_at_least(int major, int minor) const {
    // "The GL_VERSION string is laid out as: <version number><space><vendor-specific information>",
    // major.minor first.
    char* rest = nullptr;
    const long has_major = std::strtol(version_.c_str(), &rest, 10);
    const long has_minor = *rest == '.' ? std::strtol(rest + 1, nullptr, 10) : 0;
    return has_major > major || (has_major == major && has_minor >= minor);
}

std::unique_ptr<Platform> open_platform(std::string_view name, int width, int height) {
    if (name == "egl") return open_egl(width, height);
    if (name == "glx") return open_glx(width, height);
    if (name == "osmesa") return open_osmesa(width, height);
    throw PlatformError("no platform is called " + std::string(name) + ": egl, glx and osmesa are");
}

}  // namespace apps
