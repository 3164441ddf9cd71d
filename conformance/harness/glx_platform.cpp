// SPDX-License-Identifier: MIT
// GLX on the display of $DISPLAY: mapped windows, direct contexts.
#include <GL/glx.h>
#include <GL/glxext.h>

#include <array>
#include <map>
#include <vector>

#include "harness/platform.h"

namespace conformance {

namespace {

// A refused context is an answer here, not the end of the process.
int ignore_error(Display*, XErrorEvent*) {
    return 0;
}

class GlxPlatform final : public Platform {
  public:
    explicit GlxPlatform(Display* display) : display_(display) { XSetErrorHandler(ignore_error); }

    ~GlxPlatform() override { XCloseDisplay(display_); }

    Handle create_context(const ContextWish& wish, Handle share) override {
        if (wish.api == Api::kEs2) return 0;  // judged on EGL
        GLXFBConfig config = choose({});
        auto* shared = reinterpret_cast<GLXContext>(share);
        const int flags = (wish.debug ? GLX_CONTEXT_DEBUG_BIT_ARB : 0) |
                          (wish.robust ? GLX_CONTEXT_ROBUST_ACCESS_BIT_ARB : 0);
        if (wish.major == 0 && flags == 0 && !wish.no_error) {
            return reinterpret_cast<Handle>(
                glXCreateNewContext(display_, config, GLX_RGBA_TYPE, shared, True));
        }
        const auto create = reinterpret_cast<PFNGLXCREATECONTEXTATTRIBSARBPROC>(
            get_proc_address("glXCreateContextAttribsARB"));
        const int profile = wish.api == Api::kCore ? GLX_CONTEXT_CORE_PROFILE_BIT_ARB
                                                   : GLX_CONTEXT_COMPATIBILITY_PROFILE_BIT_ARB;
        std::vector<int> attributes = {GLX_CONTEXT_FLAGS_ARB, flags};
        if (wish.major > 0) {
            attributes.insert(attributes.end(), {GLX_CONTEXT_MAJOR_VERSION_ARB, wish.major,
                                                 GLX_CONTEXT_MINOR_VERSION_ARB, wish.minor});
        }
        if (wish.no_error) attributes.insert(attributes.end(), {GLX_CONTEXT_OPENGL_NO_ERROR_ARB, True});
        if (wish.major * 10 + wish.minor >= 32) {
            attributes.push_back(GLX_CONTEXT_PROFILE_MASK_ARB);
            attributes.push_back(profile);
        }
        attributes.push_back(None);
        GLXContext context = create(display_, config, shared, True, attributes.data());
        XSync(display_, False);
        return reinterpret_cast<Handle>(context);
    }

    Handle create_surface(const SurfaceWish& wish) override {
        GLXFBConfig config = choose(wish);
        if (!config) return 0;
        XVisualInfo* visual = glXGetVisualFromFBConfig(display_, config);
        const Window root = RootWindow(display_, visual->screen);
        XSetWindowAttributes attributes{};
        attributes.colormap = XCreateColormap(display_, root, visual->visual, AllocNone);
        attributes.override_redirect = True;  // no window manager may move or resize it
        const Window window =
            XCreateWindow(display_, root, 0, 0, kSurfaceSize, kSurfaceSize, 0, visual->depth, InputOutput,
                          visual->visual, CWColormap | CWOverrideRedirect | CWBorderPixel, &attributes);
        XFree(visual);
        XMapWindow(display_, window);
        XSync(display_, False);
        const GLXWindow drawable = glXCreateWindow(display_, config, window, nullptr);
        windows_[drawable] = window;
        return drawable;
    }

    void destroy_context(Handle context) override {
        glXDestroyContext(display_, reinterpret_cast<GLXContext>(context));
    }

    void destroy_surface(Handle surface) override {
        glXDestroyWindow(display_, surface);
        XDestroyWindow(display_, windows_[surface]);
        windows_.erase(surface);
    }

    bool make_current(Handle surface, Handle context) override {
        return glXMakeContextCurrent(display_, surface, surface, reinterpret_cast<GLXContext>(context)) ==
               True;
    }

    void swap(Handle surface) override { glXSwapBuffers(display_, surface); }

    void* get_proc_address(const char* name) override {
        return reinterpret_cast<void*>(glXGetProcAddress(reinterpret_cast<const GLubyte*>(name)));
    }

  private:
    GLXFBConfig choose(const SurfaceWish& wish) const {
        const std::array<int, 19> wanted = {GLX_RENDER_TYPE,
                                            GLX_RGBA_BIT,
                                            GLX_DRAWABLE_TYPE,
                                            GLX_WINDOW_BIT,
                                            GLX_DOUBLEBUFFER,
                                            True,
                                            GLX_RED_SIZE,
                                            8,
                                            GLX_DEPTH_SIZE,
                                            wish.depth_bits,
                                            GLX_STENCIL_SIZE,
                                            wish.stencil_bits,
                                            GLX_ACCUM_RED_SIZE,
                                            wish.accumulation_bits,
                                            GLX_X_RENDERABLE,
                                            True,
                                            GLX_SAMPLES,
                                            0,
                                            None};
        int count = 0;
        GLXFBConfig* configs = glXChooseFBConfig(display_, DefaultScreen(display_), wanted.data(), &count);
        GLXFBConfig chosen = nullptr;
        for (int i = 0; i < count && !chosen; ++i) {
            int depth = -1;
            glXGetFBConfigAttrib(display_, configs[i], GLX_DEPTH_SIZE, &depth);
            if (depth == wish.depth_bits) chosen = configs[i];
        }
        if (configs) XFree(configs);
        return chosen;
    }

    Display* display_;
    std::map<GLXWindow, Window> windows_;
};

}  // namespace

std::unique_ptr<Platform> open_glx_platform() {
    Display* display = XOpenDisplay(nullptr);
    if (!display) return nullptr;
    return std::make_unique<GlxPlatform>(display);
}

}  // namespace conformance
