// SPDX-License-Identifier: MIT
// The one platform of the process, and the lifetimes of what it hands out.
#include "harness/platform.h"

namespace conformance {

namespace {

std::unique_ptr<Platform> the_platform;

}  // namespace

bool open_platform(const std::string& name) {
    if (name == "egl") the_platform = open_egl_platform();
    if (name == "glx") the_platform = open_glx_platform();
    if (name == "osmesa") the_platform = open_osmesa_platform();
    return the_platform != nullptr;
}

void close_platform() {
    the_platform.reset();
}

Platform& platform() {
    return *the_platform;
}

Surface::~Surface() {
    if (handle_) platform().destroy_surface(handle_);
}

Context::~Context() {
    if (handle_) platform().destroy_context(handle_);
}

}  // namespace conformance
