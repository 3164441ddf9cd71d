// SPDX-License-Identifier: MIT
// A context without a display server: EGL's surfaceless platform and a pbuffer, whose frames end in
// eglSwapBuffers.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "apps/platform/gl.h"
#include "apps/platform/platform.h"

namespace apps {
namespace {

class Egl final : public Platform {
  public:
    Egl(int width, int height) {
        const auto get_display =
            reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
        if (!get_display) throw PlatformError("EGL has no eglGetPlatformDisplayEXT");
        display_ = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (!display_ || !eglInitialize(display_, nullptr, nullptr))
            throw PlatformError("EGL has no surfaceless display here");
        const EGLint wanted[] = {EGL_SURFACE_TYPE,
                                 EGL_PBUFFER_BIT,
                                 EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT,
                                 EGL_RED_SIZE,
                                 8,
                                 EGL_GREEN_SIZE,
                                 8,
                                 EGL_BLUE_SIZE,
                                 8,
                                 EGL_ALPHA_SIZE,
                                 8,
                                 EGL_DEPTH_SIZE,
                                 24,
                                 EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(display_, wanted, &config, 1, &count) ||
            count == 0)
            throw PlatformError("EGL has no OpenGL pbuffer with RGBA8 and 24 bit depth");
        const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
        surface_ = eglCreatePbufferSurface(display_, config, size);
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
        if (!surface_ || !context_ || !eglMakeCurrent(display_, surface_, surface_, context_))
            throw PlatformError("EGL cannot make a context current");
        read_strings();
    }

    Egl(const Egl&) = delete;
    Egl& operator=(const Egl&) = delete;

    ~Egl() override {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
        eglDestroySurface(display_, surface_);
        eglTerminate(display_);
    }

    Function function(const char* name) override { return eglGetProcAddress(name); }
    void swap_buffers() override {
        eglSwapBuffers(display_, surface_);
        glFinish();  // what a swap leaves to do is no part of the next frame
    }

  private:
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLSurface surface_ = EGL_NO_SURFACE;
    EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Platform> open_egl(int width, int height) {
    return std::make_unique<Egl>(width, height);
}

}  // namespace apps
