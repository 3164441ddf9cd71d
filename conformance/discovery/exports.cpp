// SPDX-License-Identifier: MIT
// What the libraries of GLVND export, whatever lies beneath them (DISC-13). That the commands take effect is
// judged with their extensions: an exported name says nothing of that.
#include <dlfcn.h>

#include "harness/gl_test.h"

namespace conformance {
namespace {

constexpr const char* kNvCommands[] = {
    "glGenOcclusionQueriesNV",  "glDeleteOcclusionQueriesNV", "glIsOcclusionQueryNV",
    "glBeginOcclusionQueryNV",  "glEndOcclusionQueryNV",      "glGetOcclusionQueryivNV",
    "glGetOcclusionQueryuivNV",
};
constexpr const char* kOtherCommands[] = {
    "glBeginConditionalRender", "glBeginConditionalRenderNV", "glBeginConditionalRenderNVX",
    "glEndConditionalRender",   "glEndConditionalRenderNV",   "glEndConditionalRenderNVX",
    "glGetInstrumentsSGIX",     "glInstrumentsBufferSGIX",    "glPollInstrumentsSGIX",
    "glReadInstrumentsSGIX",    "glStartInstrumentsSGIX",     "glStopInstrumentsSGIX",
};

// DISC-13. GLVND 1.6 has a stub for every command of gl.xml in libGL.
TEST(Exports, libGL_has_the_commands_of_all_extensions) {
    void* const library = dlopen("libGL.so.1", RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(library, nullptr) << dlerror();
    for (const char* name : kNvCommands) EXPECT_NE(dlsym(library, name), nullptr) << name;
    for (const char* name : kOtherCommands) EXPECT_NE(dlsym(library, name), nullptr) << name;
    dlclose(library);
}

// DISC-13. libOpenGL has the commands of core GL 4.5 only.
TEST(Exports, libOpenGL_has_the_commands_of_core_gl_only) {
    void* const library = dlopen("libOpenGL.so.0", RTLD_NOW | RTLD_LOCAL);
    if (!library) GTEST_SKIP() << dlerror();
    EXPECT_NE(dlsym(library, "glBeginQuery"), nullptr);
    for (const char* name : kNvCommands) EXPECT_EQ(dlsym(library, name), nullptr) << name;
    EXPECT_EQ(dlsym(library, "glBeginQueryARB"), nullptr);
    dlclose(library);
}

}  // namespace
}  // namespace conformance
