// SPDX-License-Identifier: MIT
// What only one window system has: EGL contexts without a surface and on windows, GLX contexts that are not
// direct (CTX-09, CTX-13).
#include "contexts/asking.h"
#include "harness/objects.h"

// After GoogleTest: Xlib's macros (None, Status) are words to it.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glx.h>

#include <array>

namespace conformance {
namespace {

class Egl : public ContextTest {
  protected:
    void SetUp() override {
        ContextTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        if (eglGetCurrentContext() == EGL_NO_CONTEXT) GTEST_SKIP() << "not on EGL";
    }
};

INSTANTIATE_TEST_SUITE_P(Each, Egl, every_way(), way_name);

// CTX-09. EGL_KHR_surfaceless_context: a context may be current without a surface, and draws into framebuffer
// objects.
TEST_P(Egl, a_context_without_surface_counts) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    ASSERT_TRUE(
        eglMakeCurrent(eglGetCurrentDisplay(), EGL_NO_SURFACE, EGL_NO_SURFACE, eglGetCurrentContext()));
    {
        const Framebuffer framebuffer({});
        draw_occluder();
        EXPECT_EQ(ask([] { draw_rect({0, 0, 4, 4}, kFar); }), 0u);
        EXPECT_EQ(ask([] { draw_rect({0, 0, 4, 4}, kNear); }), as_told(16));
        glDisable(GL_DEPTH_TEST);
    }
    come_back();
    EXPECT_EQ(ask([] { draw_rect({0, 0, 4, 4}, kNear); }), as_told(16)) << "with its surface again";
}

// CTX-09. EGL 1.5, 3.5: a pbuffer is a surface as any other.
TEST_P(Egl, a_context_on_a_pbuffer_counts) {
    EXPECT_EQ(ask([] { draw_rect({0, 0, 4, 4}, kNear); }), as_told(16));
    EXPECT_EQ(ask([] {}), 0u);
}

// CTX-09. EGL_KHR_platform_x11: a window of $DISPLAY.
TEST_P(Egl, a_context_on_a_window_counts) {
    Display* const x11 = XOpenDisplay(nullptr);
    if (!x11) GTEST_SKIP() << "no X display";
    const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_X11_KHR, x11, nullptr);
    ASSERT_TRUE(eglInitialize(display, nullptr, nullptr));
    const std::array<EGLint, 9> wanted = {
        EGL_SURFACE_TYPE,    EGL_WINDOW_BIT, EGL_RED_SIZE, 8, EGL_DEPTH_SIZE, 24,
        EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    ASSERT_TRUE(eglChooseConfig(display, wanted.data(), &config, 1, &count) && count == 1);
    const Window window =
        XCreateSimpleWindow(x11, DefaultRootWindow(x11), 0, 0, kSurfaceSize, kSurfaceSize, 0, 0, 0);
    XMapWindow(x11, window);
    XSync(x11, False);
    const EGLSurface surface =
        eglCreatePlatformWindowSurface(display, config, const_cast<Window*>(&window), nullptr);
    ASSERT_NE(surface, EGL_NO_SURFACE);
    eglBindAPI(EGL_OPENGL_API);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    ASSERT_NE(context, EGL_NO_CONTEXT);
    ASSERT_TRUE(eglMakeCurrent(display, surface, surface, context));

    use_pixel_coordinates();
    draw_occluder();
    EXPECT_EQ(ask([] { draw_rect({0, 0, 4, 4}, kFar); }), 0u);
    EXPECT_EQ(ask([] { draw_rect({0, 0, 4, 4}, kNear); }), as_told(16));
    eglSwapBuffers(display, surface);
    EXPECT_TRUE(no_error());

    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    eglDestroySurface(display, surface);
    XDestroyWindow(x11, window);
    come_back();
    eglTerminate(display);
    XCloseDisplay(x11);
}

class Glx : public GlTest {};

// CTX-13. GLX 1.4, 3.3.7: an indirect context draws through the server; its extensions are those of the
// server, and what a client-side library adds to direct contexts it cannot add here.
TEST_F(Glx, an_indirect_context_has_the_extensions_of_the_server) {
    if (!glXGetCurrentContext()) GTEST_SKIP() << "not on GLX";
    Display* const display = glXGetCurrentDisplay();
    const GLXDrawable drawable = glXGetCurrentDrawable();
    int config_id = 0;
    ASSERT_EQ(glXQueryContext(display, glXGetCurrentContext(), GLX_FBCONFIG_ID, &config_id), Success);
    const std::array<int, 3> wanted = {GLX_FBCONFIG_ID, config_id, None};
    int count = 0;
    GLXFBConfig* const configs = glXChooseFBConfig(display, DefaultScreen(display), wanted.data(), &count);
    ASSERT_EQ(count, 1);
    const GLXContext indirect = glXCreateNewContext(display, configs[0], GLX_RGBA_TYPE, nullptr, False);
    XSync(display, False);
    XFree(configs);
    if (!indirect) GTEST_SKIP() << "the server refuses indirect contexts";
    if (!glXMakeContextCurrent(display, drawable, drawable, indirect) || glXIsDirect(display, indirect)) {
        glXDestroyContext(display, indirect);
        come_back();
        GTEST_SKIP() << "the server refuses indirect contexts";
    }
    // Xvfb's own string is empty; a layer that added to it would show.
    EXPECT_FALSE(has_extension("GL_HP_occlusion_test"));
    EXPECT_FALSE(has_extension("GL_NV_occlusion_query"));
    come_back();
    glXDestroyContext(display, indirect);
}

}  // namespace
}  // namespace conformance
