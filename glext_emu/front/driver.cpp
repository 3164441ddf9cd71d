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

namespace glext_emu {

bool gl_was_loaded_ahead = false;

namespace {

struct Driver {
    void* key = nullptr;
    Platform platform = Platform::kGlx;
    GetProcAddress get_proc_address = nullptr;  // the driver's own
    RealGl real{};
};

constinit std::array<Driver, kMostDrivers> drivers{};
constinit std::mutex mutex;

Driver& driver_at(int index) {
    return drivers[static_cast<std::size_t>(index)];
}

// The imports have callbacks without a user pointer, so each driver has functions of its own.
template <int kIndex>
struct Trampolines {
    static void* glx_get_proc_address(const GLubyte* name) {
        return layered_function(kIndex, reinterpret_cast<const char*>(name));
    }
    static void* egl_get_proc_address(const char* name) { return layered_function(kIndex, name); }

    static Bool glx_main(std::uint32_t version, const __GLXapiExports* exports, __GLXvendorInfo* vendor,
                         __GLXapiImports* imports) {
        const auto real = reinterpret_cast<__PFNGLXMAINPROC>(drivers[kIndex].key);
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
        const auto real = reinterpret_cast<EglMain>(drivers[kIndex].key);
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

// False once the library that <key> was found in has been closed.
bool is_loaded(void* key) {
    Dl_info info;
    return dladdr(key, &info) != 0 && info.dli_saddr == key;
}

}  // namespace

int driver_place(void* key, Platform platform) {
    const std::lock_guard lock(mutex);
    const auto is_it = [&](const Driver& d) { return d.key == key && d.platform == platform; };
    auto place = std::ranges::find_if(drivers, is_it);
    if (place == drivers.end()) {
        place = std::ranges::find_if(drivers,
                                     [](const Driver& d) { return d.key == nullptr || !is_loaded(d.key); });
        if (place == drivers.end()) {
            doctor_note("a driver was left alone: too many are loaded at once");
            return -1;
        }
        place->key = key;
        place->platform = platform;
        place->get_proc_address = nullptr;
    }
    return static_cast<int>(place - drivers.begin());
}

bool is_driver_taken(int driver) {
    return driver_at(driver).get_proc_address != nullptr;
}

void take_driver(int index, GetProcAddress own) {
    Driver& driver = driver_at(index);
    load_real_gl(driver.real, own);
    if (driver.platform == Platform::kOsmesa) {
        driver.real.glFinish = end_osmesa_frames(index, driver.real.glFinish);
    }
    driver.get_proc_address = own;
    default_real = driver.real;
    constexpr std::array kNotes = {"hooked GLX, by the ", "hooked EGL, by the ", "hooked OSMesa, by the "};
    doctor_note((kNotes[static_cast<std::size_t>(driver.platform)] + std::string(front_name)).c_str());
    if (gl_was_loaded_ahead) doctor_note("GL was loaded ahead of a library that asked for RTLD_DEEPBIND");
}

void* layered_function(int index, const char* name) {
    void* const real = driver_at(index).get_proc_address(name);
    if (name[0] == 'g' && name[1] == 'l' && name[2] != 'X') {
        if (const Hook* const hook = find_hook(name)) {
            const bool is_there =
                real != nullptr || (hook->is_supplied && !settings().device.emulate.empty());
            return is_there ? hook->wrapper : nullptr;
        }
    }
    return real == nullptr ? nullptr : winsys_hook(index, name, real);
}

void* winsys_hook(int index, const char* name, void* real) {
    switch (driver_at(index).platform) {
        case Platform::kGlx:
            return glx_hook(index, name, real);
        case Platform::kEgl:
            return egl_hook(index, name, real);
        case Platform::kOsmesa:
            return osmesa_hook(index, name, real);
    }
    return real;
}

const RealGl& real_gl_of(int driver) {
    return driver_at(driver).real;
}

int driver_of(const RealGl* real) {
    const auto found = std::ranges::find_if(drivers, [real](const Driver& d) { return &d.real == real; });
    return found == drivers.end() ? -1 : static_cast<int>(found - drivers.begin());
}

void* driver_function(int driver, const char* name) {
    return driver_at(driver).get_proc_address(name);
}

void* wrap_glx_main(void* real) {
    if (settings().steps_aside()) return real;
    const int place = driver_place(real, Platform::kGlx);
    return place < 0 ? real : reinterpret_cast<void*>(kGlxMains[static_cast<std::size_t>(place)]);
}

void* wrap_egl_main(void* real) {
    if (settings().steps_aside()) return real;
    const int place = driver_place(real, Platform::kEgl);
    return place < 0 ? real : reinterpret_cast<void*>(kEglMains[static_cast<std::size_t>(place)]);
}

}  // namespace glext_emu
