// SPDX-License-Identifier: MIT
// Where the client draws: a pbuffer of EGL's surfaceless platform, or a framebuffer object with samples. And
// its picture, which Mesa is asked for directly, since reading pixels takes time on a device.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace effects {

[[noreturn]] inline void fail(const std::string& what) {
    std::fprintf(stderr, "effect_client: %s\n", what.c_str());
    std::exit(1);
}

// A compatibility context, current until the program ends.
class Window {
  public:
    Window(int width, int height)
        : display_(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)) {
        const EGLint wanted[] = {EGL_SURFACE_TYPE,
                                 EGL_PBUFFER_BIT,
                                 EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT,
                                 EGL_RED_SIZE,
                                 8,
                                 EGL_DEPTH_SIZE,
                                 24,
                                 EGL_NONE};
        const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (eglInitialize(display_, nullptr, nullptr) == EGL_FALSE) fail("EGL does not work");
        eglBindAPI(EGL_OPENGL_API);
        if (eglChooseConfig(display_, wanted, &config, 1, &count) == EGL_FALSE || count == 0)
            fail("no EGL config has a pbuffer, OpenGL and depth");
        surface_ = eglCreatePbufferSurface(display_, config, size);
        const EGLContext context = eglCreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
        if (eglMakeCurrent(display_, surface_, surface_, context) == EGL_FALSE) fail("no context");
        glViewport(0, 0, width, height);
    }
    void swap() const { eglSwapBuffers(display_, surface_); }

  private:
    EGLDisplay display_;
    EGLSurface surface_ = EGL_NO_SURFACE;
};

// Draws that follow go to a framebuffer object of <samples> samples a pixel.
inline void draw_to_samples(int width, int height, int samples) {
    GLuint framebuffer = 0;
    GLuint images[2] = {};
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glGenRenderbuffers(2, images);
    const GLenum formats[] = {GL_RGBA8, GL_DEPTH_COMPONENT24};
    const GLenum attachments[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
    for (int i = 0; i < 2; ++i) {
        glBindRenderbuffer(GL_RENDERBUFFER, images[i]);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, formats[i], width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachments[i], GL_RENDERBUFFER, images[i]);
    }
    GLint found = 0;
    glGetIntegerv(GL_SAMPLES, &found);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE || found != samples)
        fail("no framebuffer has " + std::to_string(samples) + " samples");
}

// Mesa's own function: its dispatch table lies below the layer.
template <typename Function>
Function function_of_mesa(const char* name) {
    using Find = void (*(*)(const char*))();
    void* const library = dlopen("libglapi.so.0", RTLD_NOW | RTLD_NOLOAD);
    const auto find =
        library == nullptr ? nullptr : reinterpret_cast<Find>(dlsym(library, "_glapi_get_proc_address"));
    if (find == nullptr) fail("this GL is not of Mesa, or has no libglapi.so.0");
    return reinterpret_cast<Function>(find(name));
}

// As RGBA bytes from below; several samples of a pixel become one by a blit.
inline void save_picture(const std::string& path, int width, int height) {
    GLint samples = 0;
    glGetIntegerv(GL_SAMPLES, &samples);
    if (samples > 1) {
        const auto blit = function_of_mesa<PFNGLBLITFRAMEBUFFERPROC>("glBlitFramebuffer");
        const auto bind = function_of_mesa<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer");
        bind(GL_DRAW_FRAMEBUFFER, 0);
        blit(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        bind(GL_READ_FRAMEBUFFER, 0);
    }
    std::vector<GLubyte> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    const auto read = function_of_mesa<decltype(&glReadPixels)>("glReadPixels");
    read(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    std::FILE* const file = std::fopen(path.c_str(), "wb");
    if (file == nullptr || std::fwrite(pixels.data(), 1, pixels.size(), file) != pixels.size())
        fail("cannot write " + path);
    std::fclose(file);
}

}  // namespace effects
