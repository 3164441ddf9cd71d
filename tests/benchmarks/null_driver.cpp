// SPDX-License-Identifier: MIT
// A GLVND vendor library that draws nothing: every GL and EGL function exists and does as good as nothing, at
// a cost of a few instructions that never vary. Under callgrind it shows what GLVND and the layer execute for
// a call, and nothing else.
#include <EGL/egl.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <glvnd/libeglabi.h>

#include <cstdint>
#include <cstring>

namespace {

constexpr char kDisplay = 0;
constexpr char kContext = 0;

// Stands for every function not named below. Under the calling conventions of x86-64 and aarch64 it may be
// called with any arguments; who expects a number or a pointer gets zero.
std::intptr_t nothing() {
    return 0;
}

const GLubyte* get_string(GLenum name) {
    const char* text = name == GL_VENDOR       ? "glext_emu tests"
                       : name == GL_RENDERER   ? "null"
                       : name == GL_VERSION    ? "4.5 (Compatibility Profile) null"
                       : name == GL_EXTENSIONS ? "GL_ARB_occlusion_query"
                                               : "4.50";
    return reinterpret_cast<const GLubyte*>(text);
}

const GLubyte* get_stringi(GLenum, GLuint index) {
    return index == 0 ? get_string(GL_EXTENSIONS) : nullptr;
}

void get_integerv(GLenum name, GLint* value) {
    switch (name) {
        case GL_NUM_EXTENSIONS:
            *value = 1;
            break;
        case GL_MAJOR_VERSION:
            *value = 4;
            break;
        case GL_MINOR_VERSION:
            *value = 5;
            break;
        case GL_CONTEXT_PROFILE_MASK:
            *value = GL_CONTEXT_COMPATIBILITY_PROFILE_BIT;
            break;
        case GL_MAX_ATTRIB_STACK_DEPTH:
            *value = 16;
            break;
        default:
            *value = 0;
            break;
    }
}

EGLBoolean initialize(EGLDisplay, EGLint* major, EGLint* minor) {
    if (major != nullptr) *major = 1;
    if (minor != nullptr) *minor = 5;
    return EGL_TRUE;
}

EGLContext create_context(EGLDisplay, EGLConfig, EGLContext, const EGLint*) {
    return const_cast<char*>(&kContext);
}

EGLBoolean make_current(EGLDisplay, EGLSurface, EGLSurface, EGLContext) {
    return EGL_TRUE;
}

EGLint get_error() {
    return EGL_SUCCESS;
}

struct Entry {
    const char* name;
    void* function;
};

template <typename Function>
void* address(Function* function) {
    return reinterpret_cast<void*>(function);
}

void* get_proc_address(const char* name) {
    static const Entry kEntries[] = {
        {"glGetString", address(get_string)},          {"glGetStringi", address(get_stringi)},
        {"glGetIntegerv", address(get_integerv)},      {"eglInitialize", address(initialize)},
        {"eglCreateContext", address(create_context)}, {"eglMakeCurrent", address(make_current)},
        {"eglGetError", address(get_error)},
    };
    for (const Entry& entry : kEntries) {
        if (std::strcmp(entry.name, name) == 0) return entry.function;
    }
    return address(nothing);
}

EGLDisplay get_platform_display(EGLenum, void*, const EGLAttrib*) {
    return const_cast<char*>(&kDisplay);
}

EGLBoolean supports_api(EGLenum) {
    return EGL_TRUE;
}

const char* vendor_string(int) {
    return "";
}

void* no_dispatch_address(const char*) {
    return nullptr;
}

void set_dispatch_index(const char*, int) {
}

}  // namespace

extern "C" __attribute__((visibility("default"))) EGLBoolean __egl_Main(std::uint32_t version,
                                                                        const __EGLapiExports*,
                                                                        __EGLvendorInfo*,
                                                                        __EGLapiImports* imports) {
    if (EGL_VENDOR_ABI_GET_MAJOR_VERSION(version) != EGL_VENDOR_ABI_MAJOR_VERSION) return EGL_FALSE;
    imports->getPlatformDisplay = get_platform_display;
    imports->getSupportsAPI = supports_api;
    imports->getVendorString = vendor_string;
    imports->getProcAddress = get_proc_address;
    imports->getDispatchAddress = no_dispatch_address;
    imports->setDispatchIndex = set_dispatch_index;
    return EGL_TRUE;
}
