// SPDX-License-Identifier: MIT
#include "front/driver.h"

#include <dlfcn.h>
#include <glvnd/libglxabi.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <string>
#include <utility>

#include "context/doctor.h"
#include "context/settings.h"
#include "entry/entry.h"
#include "real_gl/provider.h"

namespace glext_emu {

bool gl_was_loaded_ahead = false;

namespace {

struct Driver {
    void* real_main = nullptr;
    bool is_glx = false;
    GetProcAddress get_proc_address = nullptr;  // the driver's own
    RealGl real{};
};

constinit std::array<Driver, kMostDrivers> drivers{};
constinit std::mutex mutex;

// What GLVND takes for the driver's function <name>. A wrapper stands in for what the driver has, or what a
// device supplies.
void* get_proc_address(int index, const char* name) {
    const Driver& driver = drivers[static_cast<std::size_t>(index)];
    void* const real = driver.get_proc_address(name);
    if (name[0] == 'g' && name[1] == 'l' && name[2] != 'X') {
        const Hook* const hook = find_hook(name);
        if (hook == nullptr) return real;
        const bool is_there = real != nullptr || (hook->is_supplied && !settings().device.emulate.empty());
        return is_there ? hook->wrapper : nullptr;
    }
    if (real == nullptr) return nullptr;
    return driver.is_glx ? glx_hook(index, name, real) : egl_hook(index, name, real);
}

void take_driver(int index, GetProcAddress real) {
    Driver& driver = drivers[static_cast<std::size_t>(index)];
    driver.get_proc_address = real;
    load_real_gl(driver.real, real);
    default_real = driver.real;
    doctor_note((std::string(driver.is_glx ? "hooked GLX" : "hooked EGL") + ", " + front_name).c_str());
    if (gl_was_loaded_ahead) doctor_note("GL was loaded ahead of a library that asked for RTLD_DEEPBIND");
}

// The imports have callbacks without a user pointer, so each driver has functions of its own.
template <int kIndex>
struct Trampolines {
    static void* glx_get_proc_address(const GLubyte* name) {
        return get_proc_address(kIndex, reinterpret_cast<const char*>(name));
    }
    static void* egl_get_proc_address(const char* name) { return get_proc_address(kIndex, name); }

    static Bool glx_main(std::uint32_t version, const __GLXapiExports* exports, __GLXvendorInfo* vendor,
                         __GLXapiImports* imports) {
        const auto real = reinterpret_cast<__PFNGLXMAINPROC>(drivers[kIndex].real_main);
        if (!real(version, exports, vendor, imports)) return False;
        take_driver(kIndex, reinterpret_cast<GetProcAddress>(imports->getProcAddress));
        imports->getProcAddress = glx_get_proc_address;
        // A driver that patches GLVND's stubs would bypass the wrappers.
        imports->isPatchSupported = nullptr;
        imports->initiatePatch = nullptr;
        return True;
    }

    static EGLBoolean egl_main(std::uint32_t version, const __EGLapiExports* exports, __EGLvendorInfo* vendor,
                               __EGLapiImports* imports) {
        const auto real = reinterpret_cast<EglMain>(drivers[kIndex].real_main);
        if (!real(version, exports, vendor, imports)) return EGL_FALSE;
        take_driver(kIndex, imports->getProcAddress);
        imports->getProcAddress = egl_get_proc_address;
        imports->isPatchSupported = nullptr;
        imports->initiatePatch = nullptr;
        return EGL_TRUE;
    }
};

template <int... kIndices>
constexpr auto make_glx_mains(std::integer_sequence<int, kIndices...>) {
    return std::array{Trampolines<kIndices>::glx_main...};
}
template <int... kIndices>
constexpr auto make_egl_mains(std::integer_sequence<int, kIndices...>) {
    return std::array{Trampolines<kIndices>::egl_main...};
}
constexpr auto kGlxMains = make_glx_mains(std::make_integer_sequence<int, kMostDrivers>{});
constexpr auto kEglMains = make_egl_mains(std::make_integer_sequence<int, kMostDrivers>{});

// False once the library that <main> was found in has been closed.
bool is_loaded(void* main) {
    Dl_info info;
    return dladdr(main, &info) != 0 && info.dli_saddr == main;
}

// The place of a driver that is known already, or one that is free, or one whose driver is gone; -1 if there
// is none.
int place_for(void* real_main, bool is_glx) {
    const std::lock_guard lock(mutex);
    const auto is_it = [&](const Driver& d) { return d.real_main == real_main && d.is_glx == is_glx; };
    auto place = std::ranges::find_if(drivers, is_it);
    if (place == drivers.end()) {
        place = std::ranges::find_if(
            drivers, [](const Driver& d) { return d.real_main == nullptr || !is_loaded(d.real_main); });
    }
    if (place == drivers.end()) {
        doctor_note("a driver was left alone: too many are loaded at once");
        return -1;
    }
    place->real_main = real_main;
    place->is_glx = is_glx;
    return static_cast<int>(place - drivers.begin());
}

}  // namespace

const RealGl& real_gl_of(int driver) {
    return drivers[static_cast<std::size_t>(driver)].real;
}

void* driver_function(int driver, const char* name) {
    return drivers[static_cast<std::size_t>(driver)].get_proc_address(name);
}

void* wrap_glx_main(void* real) {
    if (settings().steps_aside()) return real;
    const int place = place_for(real, true);
    return place < 0 ? real : reinterpret_cast<void*>(kGlxMains[static_cast<std::size_t>(place)]);
}

void* wrap_egl_main(void* real) {
    if (settings().steps_aside()) return real;
    const int place = place_for(real, false);
    return place < 0 ? real : reinterpret_cast<void*>(kEglMains[static_cast<std::size_t>(place)]);
}

}  // namespace glext_emu
