// SPDX-License-Identifier: MIT
// How the extension shows itself: its name, and its seven commands by every way to their addresses (DISC-02,
// DISC-03, DISC-11 to DISC-15).
#include <dlfcn.h>

#include <algorithm>
#include <array>

#include "nv_occlusion_query/nv_test.h"

namespace conformance {
namespace {

constexpr const char* kNv = "GL_NV_occlusion_query";

// The address of a command, as an application may come by it.
using Finder = void* (*)(const char* name);

void* by_platform(const char* name) {
    return platform().get_proc_address(name);  // eglGetProcAddress or glXGetProcAddress
}

void* by_dlsym_default(const char* name) {
    return dlsym(RTLD_DEFAULT, name);
}

void* by_dlopen(const char* name) {
    static void* const library = dlopen("libGL.so.1", RTLD_NOW | RTLD_LOCAL);
    return library ? dlsym(library, name) : nullptr;
}

// Without the GLX and EGL headers, and for both whatever the platform of the run is: GLVND's addresses serve
// every window system.
template <const char* const& get_name>
void* by_get_proc_address(const char* name) {
    using Get = void* (*)(const GLubyte*);
    const auto get = reinterpret_cast<Get>(dlsym(RTLD_DEFAULT, get_name));
    return get ? get(reinterpret_cast<const GLubyte*>(name)) : nullptr;
}

const char* const kGlx = "glXGetProcAddress";
const char* const kGlxArb = "glXGetProcAddressARB";
const char* const kEgl = "eglGetProcAddress";

struct Way {
    const char* name;
    Finder find;
};

constexpr std::array<Way, 6> kWays = {{
    {"the_platform", by_platform},
    {"dlsym_of_all_libraries", by_dlsym_default},
    {"dlsym_of_libGL", by_dlopen},
    {"glXGetProcAddress", by_get_proc_address<kGlx>},
    {"glXGetProcAddressARB", by_get_proc_address<kGlxArb>},
    {"eglGetProcAddress", by_get_proc_address<kEgl>},
}};

template <typename Function>
void find(Finder finder, const char* name, Function& function) {
    function = reinterpret_cast<Function>(finder(name));
}

struct Commands {
    explicit Commands(Finder finder) {
        find(finder, "glGenOcclusionQueriesNV", gen);
        find(finder, "glDeleteOcclusionQueriesNV", remove);
        find(finder, "glIsOcclusionQueryNV", is);
        find(finder, "glBeginOcclusionQueryNV", begin);
        find(finder, "glEndOcclusionQueryNV", end);
        find(finder, "glGetOcclusionQueryivNV", get_signed);
        find(finder, "glGetOcclusionQueryuivNV", get_unsigned);
    }
    bool complete() const { return gen && remove && is && begin && end && get_signed && get_unsigned; }

    PFNGLGENOCCLUSIONQUERIESNVPROC gen = nullptr;
    PFNGLDELETEOCCLUSIONQUERIESNVPROC remove = nullptr;
    PFNGLISOCCLUSIONQUERYNVPROC is = nullptr;
    PFNGLBEGINOCCLUSIONQUERYNVPROC begin = nullptr;
    PFNGLENDOCCLUSIONQUERYNVPROC end = nullptr;
    PFNGLGETOCCLUSIONQUERYIVNVPROC get_signed = nullptr;
    PFNGLGETOCCLUSIONQUERYUIVNVPROC get_unsigned = nullptr;
};

// GLVND gives an address for any name at all: that the calls take effect is the proof. What one way's
// commands made, the commands that the program is linked with see.
void expect_working(const Commands& nv) {
    ASSERT_TRUE(nv.complete());
    GLuint name = 0;
    nv.gen(1, &name);
    ASSERT_NE(name, 0u);
    nv.begin(name);
    EXPECT_EQ(active_nv(), name);
    draw_samples(42);
    nv.end();
    EXPECT_EQ(active_nv(), 0u);
    GLuint count = kUntouched;
    GLint signed_count = -1;
    nv.get_unsigned(name, GL_PIXEL_COUNT_NV, &count);
    nv.get_signed(name, GL_PIXEL_COUNT_NV, &signed_count);
    EXPECT_EQ(count, 42u);
    EXPECT_EQ(signed_count, 42);
    EXPECT_EQ(get_nv(name, GL_PIXEL_COUNT_NV), 42u);
    EXPECT_TRUE(nv.is(name));
    EXPECT_TRUE(glIsOcclusionQueryNV(name));
    nv.remove(1, &name);
    EXPECT_FALSE(nv.is(name));
    EXPECT_FALSE(glIsOcclusionQueryNV(name));
    EXPECT_TRUE(no_error());
}

class NvDiscovery : public NvTest {};

// DISC-02. Khronos' registry rules: an extension that is supported has its name string in EXTENSIONS.
TEST_F(NvDiscovery, the_string_names_the_extension_exactly_once) {
    const auto names = extensions();
    EXPECT_EQ(std::count(names.begin(), names.end(), kNv), 1);
    if (lacks(30)) return;
    const auto indexed = indexed_extensions();
    EXPECT_EQ(std::count(indexed.begin(), indexed.end(), kNv), 1);
}

// DISC-03. NV, Dependencies: "Requires support for the HP_occlusion_test extension."
TEST_F(NvDiscovery, the_extension_comes_with_the_occlusion_test) {
    EXPECT_TRUE(has_extension("GL_HP_occlusion_test"));
    glEnable(GL_OCCLUSION_TEST_HP);
    glDisable(GL_OCCLUSION_TEST_HP);
    EXPECT_TRUE(no_error());
}

// gl.xml: supported="gl", not "glcore" and none of OpenGL ES.
TEST_F(NvDiscovery, a_core_profile_and_an_es_context_have_not_the_extension) {
    for (const ContextWish& wish :
         {ContextWish{.api = Api::kCore, .major = 3, .minor = 2}, ContextWish{.api = Api::kEs2}}) {
        const Context other(wish);
        if (!other) continue;  // a machine of an older GL, a platform without ES
        ASSERT_TRUE(other.make_current(surface()));
        EXPECT_FALSE(has_extension(kNv));
        GLint value = -1;
        glGetIntegerv(GL_PIXEL_COUNTER_BITS_NV, &value);
        EXPECT_TRUE(error_is(GL_INVALID_ENUM));
        EXPECT_EQ(value, -1);
    }
    come_back();
}

class NvAddresses : public NvTest, public ::testing::WithParamInterface<Way> {};

// DISC-11 to DISC-13. GLX_ARB_get_proc_address, EGL 3.12, and the symbols that GLVND's libGL exports.
TEST_P(NvAddresses, the_commands_work) {
    expect_working(Commands(GetParam().find));
}

// DISC-14. The address does not depend on a current context.
TEST_P(NvAddresses, the_commands_found_before_any_context_was_current_work) {
    Context::release_current();
    const Commands early(GetParam().find);
    come_back();
    expect_working(early);
}

// DISC-15. As above.
TEST_P(NvAddresses, the_commands_found_in_one_context_work_in_another) {
    const Commands here(GetParam().find);
    expect_working(here);
    const Context other;
    ASSERT_TRUE(other.make_current(surface()));
    use_pixel_coordinates();
    expect_working(here);
    come_back();
}

INSTANTIATE_TEST_SUITE_P(By, NvAddresses, ::testing::ValuesIn(kWays),
                         [](const auto& way) { return way.param.name; });

}  // namespace
}  // namespace conformance
