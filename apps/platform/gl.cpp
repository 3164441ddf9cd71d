// SPDX-License-Identifier: MIT
// The pointers, filled from one library.
#include "apps/platform/gl.h"

#include "apps/platform/platform.h"

namespace apps {

#define DEFINE(name) decltype(&::name) name = nullptr;
APPS_GL_COMMANDS(DEFINE)
#undef DEFINE

void load_gl(Platform& platform) {
#define LOAD(name)                                                        \
    name = reinterpret_cast<decltype(&::name)>(platform.function(#name)); \
    if (name == nullptr) throw PlatformError("this GL library has no " #name);
    APPS_GL_COMMANDS(LOAD)
#undef LOAD
}

}  // namespace apps
