// SPDX-License-Identifier: MIT
// The vendor front end: GLVND itself loads the layer as if it were a driver, no preload needed:
//
//   __GLX_VENDOR_LIBRARY_NAME=glextemu             libGLX then opens libGLX_glextemu.so.0
//   __EGL_VENDOR_LIBRARY_FILENAMES=50_glextemu.json  libEGL then opens libEGL_glextemu.so.0
//
// Both are this file, which opens the real driver's library (the setting driver=) and stands before it as the
// seam does.
#include <dlfcn.h>
#include <glvnd/libeglabi.h>
#include <glvnd/libglxabi.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <mutex>
#include <string>

#include "context/settings.h"
#include "front/driver.h"

#define EXPORT __attribute__((visibility("default")))

extern "C" {
// A seam that is preloaded beside us finds this name and leaves the driver to us.
EXPORT extern const char glext_emu_vendor;
const char glext_emu_vendor = 1;

EXPORT Bool __glx_Main(std::uint32_t version, const __GLXapiExports* exports, __GLXvendorInfo* vendor,
                       __GLXapiImports* imports);
EXPORT EGLBoolean __egl_Main(std::uint32_t version, const __EGLapiExports* exports, __EGLvendorInfo* vendor,
                             __EGLapiImports* imports);
}

namespace glext_emu {

const char* const front_name = "vendor library";

namespace {

// The libraries that this front end has opened. They are closed with it: Mesa fills GLVND's tables at its
// first start only, so that a driver that stayed would be of no use to a GLVND that is opened anew.
struct Opened {
    std::mutex mutex;
    void* glx = nullptr;
    void* egl = nullptr;
};
constinit Opened opened{};

__attribute__((destructor)) void close_drivers() {
    for (void* library : {opened.glx, opened.egl}) {
        if (library != nullptr) dlclose(library);
    }
}

// By libc's own dlsym: that of a seam that is preloaded would put a second layer before the driver.
void* libc_dlsym(void* library, const char* name) {
    void* const libc = dlopen("libc.so.6", RTLD_LAZY | RTLD_NOLOAD);
    void* const found = libc == nullptr ? nullptr : dlvsym(libc, "dlsym", "GLIBC_2.34");
    if (libc != nullptr) dlclose(libc);
    return (found == nullptr ? dlsym : reinterpret_cast<void* (*)(void*, const char*)>(found))(library, name);
}

void* driver_main(void*& library, const char* prefix, const char* name) {
    const std::string driver = settings().driver.empty() ? "mesa" : settings().driver;
    const std::string file = prefix + driver + ".so.0";
    const std::lock_guard lock(opened.mutex);
    if (library == nullptr) library = dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL);
    void* const main = library == nullptr ? nullptr : libc_dlsym(library, name);
    if (main == nullptr) {
        const char* const why = library == nullptr ? dlerror() : "it is no driver for GLVND";
        std::fprintf(stderr, "glext_emu: the driver `%s` cannot be loaded: %s.\n", driver.c_str(), why);
        _exit(2);
    }
    return main;
}

// The exports, preloaded, stand above GLVND: then the layer is there already.
bool exports_are_loaded() {
    void* const exports = dlopen(kExportsLibrary, RTLD_LAZY | RTLD_NOLOAD);
    if (exports != nullptr) dlclose(exports);
    return exports != nullptr;
}

}  // namespace
}  // namespace glext_emu

Bool __glx_Main(std::uint32_t version, const __GLXapiExports* exports, __GLXvendorInfo* vendor,
                __GLXapiImports* imports) {
    using namespace glext_emu;
    void* const real = driver_main(opened.glx, "libGLX_", "__glx_Main");
    void* const main = exports_are_loaded() ? real : wrap_glx_main(real);
    return reinterpret_cast<__PFNGLXMAINPROC>(main)(version, exports, vendor, imports);
}

EGLBoolean __egl_Main(std::uint32_t version, const __EGLapiExports* exports, __EGLvendorInfo* vendor,
                      __EGLapiImports* imports) {
    using namespace glext_emu;
    void* const real = driver_main(opened.egl, "libEGL_", "__egl_Main");
    void* const main = exports_are_loaded() ? real : wrap_egl_main(real);
    return reinterpret_cast<EglMain>(main)(version, exports, vendor, imports);
}
