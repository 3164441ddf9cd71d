// SPDX-License-Identifier: MIT
#include "front/exports.h"

#include <dlfcn.h>
#include <elf.h>
#include <link.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "context/current.h"
#include "context/settings.h"
#include "entry/entry.h"
#include "front/dlhook.h"

extern "C" {
// The linker's names for where this library begins and ends.
extern const char __ehdr_start __attribute__((visibility("hidden")));
extern const char _end __attribute__((visibility("hidden")));
}

namespace glext_emu {

const char* const front_name = "exports";

namespace {

bool is_ours(const void* function) {
    return function >= &__ehdr_start && function < &_end;
}

// Every library of a platform has it.
const char* make_current_name(Platform platform) {
    constexpr std::array kNames = {"glXMakeCurrent", "eglMakeCurrent", "OSMesaMakeCurrent"};
    return kNames[static_cast<std::size_t>(platform)];
}

constexpr std::array<std::string_view, 4> kGetProcAddresses = {"glXGetProcAddressARB", "glXGetProcAddress",
                                                               "eglGetProcAddress", "OSMesaGetProcAddress"};

bool is_get_proc_address(std::string_view name) {
    return std::ranges::find(kGetProcAddresses, name) != kGetProcAddresses.end();
}

// Of a window-system function.
Platform platform_of(std::string_view name) {
    if (name.starts_with("glX")) return Platform::kGlx;
    return name.starts_with("egl") ? Platform::kEgl : Platform::kOsmesa;
}

// A library that is loaded already; not unloaded while this lives.
class LoadedLibrary {
  public:
    explicit LoadedLibrary(const char* path) : handle_(next_dlopen(path, RTLD_LAZY | RTLD_NOLOAD)) {
        if (handle_ == nullptr) dlerror();  // the program asks for errors of its own only
    }
    ~LoadedLibrary() {
        if (handle_ != nullptr) dlclose(handle_);
    }
    LoadedLibrary(const LoadedLibrary&) = delete;
    LoadedLibrary& operator=(const LoadedLibrary&) = delete;

    // Its own function or one of the libraries that it needs; never ours.
    void* find(const char* name) const {
        if (handle_ == nullptr) return nullptr;
        void* const found = libc_dlsym(handle_, name);
        if (found == nullptr) dlerror();
        return is_ours(found) ? nullptr : found;
    }

  private:
    void* handle_;
};

// Where <address> lies; its file's path is empty in the program itself.
Dl_info object_of(const void* address) {
    Dl_info info{};
    if (dladdr(address, &info) == 0) info.dli_fname = "";
    return info;
}

// A library that brings GL, a row for each driver.
struct Library {
    const char* path = nullptr;  // leaked on purpose
    GetProcAddress get_proc_address = nullptr;
};
constinit std::array<Library, kMostDrivers> libraries{};

Library& library_at(int driver) {
    return libraries[static_cast<std::size_t>(driver)];
}

// The library's own function. Its symbols tell better than its GetProcAddress, whose table may be bound by
// name and so to ours; but they name no more than what was there when it was built.
void* own_function(int driver, const char* name) {
    const Library& library = library_at(driver);
    const std::string_view view = name;
    const bool may_be_symbol =
        view.starts_with("gl") || view.starts_with("egl") || view.starts_with("OSMesa");
    void* found = may_be_symbol ? LoadedLibrary(library.path).find(name) : nullptr;
    if (found == nullptr && library.get_proc_address != nullptr) found = library.get_proc_address(name);
    return is_ours(found) ? nullptr : found;
}

// GetProcAddress has no room for a user pointer, so each library has functions of its own.
template <int kDriver>
struct Trampolines {
    static void* own(const char* name) { return own_function(kDriver, name); }
    static void* layered(const char* name) {
        return is_get_proc_address(name) ? reinterpret_cast<void*>(layered) : layered_function(kDriver, name);
    }
};
template <int... kDrivers>
constexpr auto make_own(std::integer_sequence<int, kDrivers...>) {
    return std::array{Trampolines<kDrivers>::own...};
}
template <int... kDrivers>
constexpr auto make_layered(std::integer_sequence<int, kDrivers...>) {
    return std::array{Trampolines<kDrivers>::layered...};
}
constexpr auto kOwn = make_own(std::make_integer_sequence<int, kMostDrivers>{});
constexpr auto kLayered = make_layered(std::make_integer_sequence<int, kMostDrivers>{});

// The driver that stands for the library in which <make_current> lies; -1 where there is none.
int driver_with(void* make_current, Platform platform) {
    static constinit std::mutex mutex;
    const std::lock_guard lock(mutex);
    const int driver = make_current == nullptr ? -1 : driver_place(make_current, platform);
    if (driver < 0 || is_driver_taken(driver)) return driver;
    Library& library = library_at(driver);
    library.path = strdup(object_of(make_current).dli_fname);
    const LoadedLibrary loaded(library.path);
    library.get_proc_address = nullptr;
    for (const std::string_view name : kGetProcAddresses) {
        if (library.get_proc_address != nullptr || platform_of(name) != platform) continue;
        library.get_proc_address = reinterpret_cast<GetProcAddress>(loaded.find(name.data()));
    }
    take_driver(driver, kOwn[static_cast<std::size_t>(driver)]);
    return driver;
}

void* hook(int driver, const char* name, void* real) {
    if (driver < 0 || real == nullptr) return real;
    if (is_get_proc_address(name)) return reinterpret_cast<void*>(kLayered[static_cast<std::size_t>(driver)]);
    return winsys_hook(driver, name, real);
}

// The first of the loaded libraries that has <name> itself: for what only a plugin's own scope has.
std::string library_with(const char* name) {
    std::vector<std::string> paths;
    dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t, void* out) {
            if (info->dlpi_name[0] != '\0')
                static_cast<std::vector<std::string>*>(out)->push_back(info->dlpi_name);
            return 0;
        },
        &paths);
    // The one that had it before, first: the others take a while, and a program swaps often.
    thread_local const char* last = nullptr;
    if (last != nullptr) paths.insert(paths.begin(), last);
    for (const std::string& path : paths) {
        void* const found = LoadedLibrary(path.c_str()).find(name);
        if (found == nullptr || object_of(found).dli_fname != path) continue;
        if (last == nullptr || path != last) last = strdup(path.c_str());  // leaked on purpose
        return path;
    }
    return "";
}

// True where the code at <caller> belongs to a library that has GL or a window system of its own.
bool is_gl_library(const void* caller) {
    thread_local const void* last_program = nullptr;
    if (caller == last_program) return false;
    const Dl_info object = object_of(caller);
    const LoadedLibrary library(object.dli_fname);
    for (const Platform platform : {Platform::kGlx, Platform::kEgl, Platform::kOsmesa}) {
        void* const found = library.find(make_current_name(platform));
        if (found != nullptr && object_of(found).dli_fbase == object.dli_fbase) return true;
    }
    last_program = caller;
    return false;
}

// Not the variable of somebody who keeps function pointers under GL's names.
bool is_function(void* address) {
    Dl_info info;
    const ElfW(Sym)* symbol = nullptr;
    if (dladdr1(address, &info, reinterpret_cast<void**>(const_cast<ElfW(Sym)**>(&symbol)), RTLD_DL_SYMENT) ==
            0 ||
        symbol == nullptr) {
        return false;
    }
    const auto type = ELF64_ST_TYPE(symbol->st_info);
    return type == STT_FUNC || type == STT_GNU_IFUNC;
}

}  // namespace

void* exported_winsys(Platform platform, const char* name, const void* caller) {
    find_next();
    void* make_current = libc_dlsym(RTLD_NEXT, make_current_name(platform));
    void* real = libc_dlsym(RTLD_NEXT, name);
    if (make_current == nullptr || real == nullptr) {
        dlerror();
        const LoadedLibrary library(library_with(make_current_name(platform)).c_str());
        make_current = library.find(make_current_name(platform));
        real = library.find(name);
    }
    return is_gl_library(caller) ? real : hook(driver_with(make_current, platform), name, real);
}

void* exported_gl(const char* name) {
    find_next();
    void* const found = current.real == &default_real ? libc_dlsym(RTLD_NEXT, name) : nullptr;
    if (found == nullptr) dlerror();
    return found;
}

void* exported_symbol(void* library, const char* name, const void* caller) {
    const std::string_view view = name;
    const bool is_gl = view.starts_with("gl") && !view.starts_with("glX");
    const Hook* const gl_hook = is_gl ? find_hook(name) : nullptr;
    if (is_gl && gl_hook == nullptr) return nullptr;
    void* const own = libc_dlsym(library, name);
    if (own == nullptr) dlerror();
    if (own == nullptr || is_ours(own) || !is_function(own) || is_gl_library(caller)) return nullptr;
    if (settings().steps_aside()) return nullptr;
    if (is_gl) return gl_hook->wrapper;
    const Platform platform = platform_of(view);
    void* const make_current = libc_dlsym(library, make_current_name(platform));
    if (make_current == nullptr) dlerror();
    // Another interposer's function, where there is one, stands between ours and the library's.
    void* const real = next_dlsym(library, name);
    void* const hooked = hook(driver_with(make_current, platform), name, real);
    return hooked == real ? nullptr : hooked;
}

}  // namespace glext_emu
