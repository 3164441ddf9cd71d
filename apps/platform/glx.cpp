// SPDX-License-Identifier: MIT
// A window on the X display that DISPLAY names.
#include <GL/glx.h>
#include <X11/Xlib.h>

#include "apps/platform/gl.h"
#include "apps/platform/platform.h"

namespace apps {
namespace {

class Glx final : public Platform {
  public:
    Glx(int width, int height) {
        display_ = XOpenDisplay(nullptr);
        if (!display_) throw PlatformError("there is no X display to open a window on: is DISPLAY set?");
        const int wanted[] = {GLX_X_RENDERABLE,
                              True,
                              GLX_DOUBLEBUFFER,
                              True,
                              GLX_RED_SIZE,
                              8,
                              GLX_GREEN_SIZE,
                              8,
                              GLX_BLUE_SIZE,
                              8,
                              GLX_ALPHA_SIZE,
                              8,
                              GLX_DEPTH_SIZE,
                              24,
                              GLX_SAMPLE_BUFFERS,
                              0,
                              None};
        int count = 0;
        GLXFBConfig* configs = glXChooseFBConfig(display_, DefaultScreen(display_), wanted, &count);
        if (!configs || count == 0) throw PlatformError("GLX has no window with RGBA8 and 24 bit depth");
        const GLXFBConfig config = configs[0];
        XFree(configs);
        XVisualInfo* visual = glXGetVisualFromFBConfig(display_, config);
        const Window root = RootWindow(display_, visual->screen);
        XSetWindowAttributes attributes{};
        attributes.colormap = XCreateColormap(display_, root, visual->visual, AllocNone);
        attributes.event_mask = StructureNotifyMask;
        window_ = XCreateWindow(display_, root, 0, 0, static_cast<unsigned>(width),
                                static_cast<unsigned>(height), 0, visual->depth, InputOutput, visual->visual,
                                CWColormap | CWEventMask | CWBorderPixel, &attributes);
        XFree(visual);
        XStoreName(display_, window_, "walkthrough");
        XMapWindow(display_, window_);
        XEvent event;
        do XNextEvent(display_, &event);
        while (event.type != MapNotify);
        context_ = glXCreateNewContext(display_, config, GLX_RGBA_TYPE, nullptr, True);
        if (!context_ || !glXMakeCurrent(display_, window_, context_))
            throw PlatformError("GLX cannot make a context current");
        read_strings();
    }

    Glx(const Glx&) = delete;
    Glx& operator=(const Glx&) = delete;

    ~Glx() override {
        glXMakeCurrent(display_, None, nullptr);
        glXDestroyContext(display_, context_);
        XDestroyWindow(display_, window_);
        XCloseDisplay(display_);
    }

    Function function(const char* name) override {
        return glXGetProcAddress(reinterpret_cast<const GLubyte*>(name));
    }
    void swap_buffers() override {
        glXSwapBuffers(display_, window_);
        glFinish();  // what a swap leaves to do is no part of the next frame
    }

  private:
    Display* display_ = nullptr;
    Window window_ = 0;
    GLXContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<Platform> open_glx(int width, int height) {
    return std::make_unique<Glx>(width, height);
}

}  // namespace apps
