// SPDX-License-Identifier: MIT
// Not hooked means not touched. A stand-in for GLVND: it asks Mesa's vendor library for its getProcAddress as
// libEGL and libGLX do, by dlsym, which the layer answers, and once more by libc's own dlsym, which it does
// not see. For every command of gl.xml the two have to give the same pointer, unless hooks.list wires the
// command: then the first is the layer's.
//
//   driver_pointers COMMANDS.txt     lines of `hooked NAME` or `left NAME`
//
// In the environment: DRIVER_POINTERS_EXPECT=bare where the program runs without the layer and nothing may
// differ.
#include <gtest/gtest.h>  // before Xlib, whose macros it would not survive

#include <EGL/egl.h>
#include <dlfcn.h>
#include <glvnd/libeglabi.h>
#include <glvnd/libglxabi.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace {

using Lookup = void* (*)(void* handle, const char* name);
using GetProcAddress = std::function<void*(const char* name)>;
using EglMain = EGLBoolean (*)(std::uint32_t, const __EGLapiExports*, __EGLvendorInfo*, __EGLapiImports*);

struct Command {
    std::string name;
    bool hooked;
};

std::vector<Command> commands;

bool layer_expected() {
    const char* expect = std::getenv("DRIVER_POINTERS_EXPECT");
    return expect == nullptr || std::strcmp(expect, "bare") != 0;
}

// The layer exports dlsym with libc's version nodes, but it does not stand in libc's own scope.
Lookup libc_dlsym() {
    void* libc = dlopen("libc.so.6", RTLD_LAZY | RTLD_NOLOAD);
    void* found = dlvsym(libc, "dlsym", "GLIBC_2.34");
    if (found == nullptr) found = dlvsym(libc, "dlsym", "GLIBC_2.2.5");
    return reinterpret_cast<Lookup>(found);
}

// The file that holds the code at <address>.
std::string library_of(const void* address) {
    Dl_info info{};
    return dladdr(address, &info) != 0 ? info.dli_fname : "";
}

GetProcAddress egl_driver(Lookup lookup) {
    void* vendor = dlopen("libEGL_mesa.so.0", RTLD_LAZY | RTLD_LOCAL);
    const auto main = reinterpret_cast<EglMain>(vendor == nullptr ? nullptr : lookup(vendor, "__egl_Main"));
    __EGLapiImports imports{};
    if (main == nullptr || !main(EGL_VENDOR_ABI_VERSION, nullptr, nullptr, &imports)) return nullptr;
    return imports.getProcAddress;
}

GetProcAddress glx_driver(Lookup lookup) {
    void* vendor = dlopen("libGLX_mesa.so.0", RTLD_LAZY | RTLD_LOCAL);
    const auto main =
        reinterpret_cast<__PFNGLXMAINPROC>(vendor == nullptr ? nullptr : lookup(vendor, "__glx_Main"));
    __GLXapiImports imports{};
    if (main == nullptr || !main(GLX_VENDOR_ABI_VERSION, nullptr, nullptr, &imports)) return nullptr;
    return [get = imports.getProcAddress](const char* name) {
        return get(reinterpret_cast<const GLubyte*>(name));
    };
}

// <own_library>: the name of a library whose functions are the driver's own as well, or null.
void every_command_is_the_drivers_unless_hooked(const GetProcAddress& glvnd_gets,
                                                const GetProcAddress& driver, const char* own_library) {
    ASSERT_TRUE(glvnd_gets && driver) << dlerror();
    for (const Command& command : commands) {
        void* got = glvnd_gets(command.name.c_str());
        void* drivers = driver(command.name.c_str());
        const std::string library = library_of(got);
        if (command.hooked && layer_expected()) {
            EXPECT_NE(library.find("libglext_emu.so"), std::string::npos)
                << command.name << " is in " << library;
        } else if (own_library == nullptr || library.find(own_library) == std::string::npos) {
            EXPECT_EQ(got, drivers) << command.name << " is in " << library;
        }
    }
}

TEST(driver_pointers, the_command_list_holds_all_of_gl_xml_and_the_layers_hooks) {
    EXPECT_GT(commands.size(), 3000u);
    const auto hooked =
        std::count_if(commands.begin(), commands.end(), [](const Command& c) { return c.hooked; });
    EXPECT_GT(hooked, 100);
    EXPECT_LT(hooked, 400);
}

TEST(driver_pointers, what_egl_gets_is_the_drivers_own_pointer_unless_hooked) {
    every_command_is_the_drivers_unless_hooked(egl_driver(dlsym), egl_driver(libc_dlsym()), nullptr);
}

TEST(driver_pointers, what_glx_gets_is_the_drivers_own_pointer_unless_hooked) {
    // Mesa's GLX side fills its table in the first call of __glx_Main only. Its EGL side serves the same GL
    // functions, but for four that GLX has to itself (glGenTexturesEXT and its sisters, of indirect
    // rendering).
    every_command_is_the_drivers_unless_hooked(glx_driver(dlsym), egl_driver(libc_dlsym()), "libGLX_mesa.so");
}

TEST(driver_pointers, the_two_ways_of_asking_differ_only_under_the_layer) {
    EXPECT_EQ(
        library_of(reinterpret_cast<void*>(&dlsym)) != library_of(reinterpret_cast<void*>(libc_dlsym())),
        layer_expected());
}

}  // namespace

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    std::ifstream list(argc == 2 ? argv[1] : "");
    for (std::string kind, name; list >> kind >> name;) commands.push_back({name, kind == "hooked"});
    return RUN_ALL_TESTS();
}
