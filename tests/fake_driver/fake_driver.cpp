// SPDX-License-Identifier: MIT
#include "fake_driver.h"

#include <EGL/egl.h>
#include <dlfcn.h>
#include <glvnd/libeglabi.h>

#include <deque>
#include <map>
#include <unordered_map>
#include <utility>

namespace fake_driver {
namespace {

constexpr Command kCommands[] = {
#define COMMAND(name, hooked_as, has_driver) {#name, hooked_as, has_driver},
#include "commands.inc"
#undef COMMAND
};
constexpr std::size_t kCount = std::size(kCommands);

std::vector<std::string> calls;
std::array<Answer, kCount> answers{};

// Under the calling conventions of x86-64 and aarch64 a function may be called with fewer arguments than it
// takes.
template <std::size_t kIndex>
std::intptr_t stub(std::intptr_t a, std::intptr_t b, std::intptr_t c, std::intptr_t d, std::intptr_t e,
                   std::intptr_t f) {
    calls.emplace_back(kCommands[kIndex].name);
    return answers[kIndex] == nullptr ? 0 : answers[kIndex]({a, b, c, d, e, f});
}

using Stub = std::intptr_t (*)(std::intptr_t, std::intptr_t, std::intptr_t, std::intptr_t, std::intptr_t,
                               std::intptr_t);

template <std::size_t... kIndices>
constexpr std::array<Stub, kCount> make_stubs(std::index_sequence<kIndices...>) {
    return {stub<kIndices>...};
}
constexpr std::array<Stub, kCount> kStubs = make_stubs(std::make_index_sequence<kCount>{});

constexpr char kDisplay = 0;
constexpr char kSurface = 0;
constexpr EGLint kSurfaceSize = 64;

EGLBoolean initialize(EGLDisplay, EGLint* major, EGLint* minor) {
    if (major != nullptr) *major = 1;
    if (minor != nullptr) *minor = 5;
    return EGL_TRUE;
}
EGLenum query_api() {
    return EGL_OPENGL_API;
}
EGLContext create_context(EGLDisplay, EGLConfig, EGLContext, const EGLint*) {
    static std::deque<char> contexts;  // each its own address
    return &contexts.emplace_back();
}
EGLBoolean make_current(EGLDisplay, EGLSurface, EGLSurface, EGLContext) {
    return EGL_TRUE;
}
EGLSurface current_surface(EGLint) {
    return const_cast<char*>(&kSurface);
}
EGLBoolean query_surface(EGLDisplay, EGLSurface, EGLint attribute, EGLint* value) {
    if (attribute == EGL_WIDTH || attribute == EGL_HEIGHT) *value = kSurfaceSize;
    return EGL_TRUE;
}
EGLBoolean swap_buffers(EGLDisplay, EGLSurface) {
    return EGL_TRUE;
}
EGLint get_error() {
    return EGL_SUCCESS;
}

template <typename Function>
void* address(Function* function) {
    return reinterpret_cast<void*>(function);
}

void* get_proc_address(const char* name) {
    return own_function(name);
}

// As libEGL does it: once for the process.
void* (*layered_get_proc_address())(const char*) {
    static const auto get = []() -> void* (*)(const char*) {
        using EglMain =
            EGLBoolean (*)(std::uint32_t, const __EGLapiExports*, __EGLvendorInfo*, __EGLapiImports*);
        void* const self = dlopen(nullptr, RTLD_LAZY);
        const auto main = reinterpret_cast<EglMain>(dlsym(self, "__egl_Main"));
        __EGLapiImports imports{};
        if (main == nullptr || !main(EGL_VENDOR_ABI_VERSION, nullptr, nullptr, &imports)) return nullptr;
        return imports.getProcAddress;
    }();
    return get;
}

}  // namespace

const std::vector<Command>& commands() {
    static const std::vector<Command> all(std::begin(kCommands), std::end(kCommands));
    return all;
}

const std::vector<std::string>& log() {
    return calls;
}

void clear_log() {
    calls.clear();
}

void* own_function(std::string_view name) {
    static const std::unordered_map<std::string_view, void*> functions = [] {
        std::unordered_map<std::string_view, void*> made{
            {"eglInitialize", address(initialize)},
            {"eglQueryAPI", address(query_api)},
            {"eglCreateContext", address(create_context)},
            {"eglMakeCurrent", address(make_current)},
            {"eglGetCurrentSurface", address(current_surface)},
            {"eglQuerySurface", address(query_surface)},
            {"eglSwapBuffers", address(swap_buffers)},
            {"eglGetError", address(get_error)},
        };
        for (std::size_t i = 0; i < kCount; ++i) {
            if (!kCommands[i].has_driver) continue;
            made[kCommands[i].name] = reinterpret_cast<void*>(kStubs[i]);
            answers[i] = answer_of(kCommands[i].name);
        }
        return made;
    }();
    const auto found = functions.find(name);
    return found == functions.end() ? nullptr : found->second;
}

void* function(const char* name) {
    const auto get = layered_get_proc_address();
    return get == nullptr ? nullptr : get(name);
}

void* make_context() {
    const auto create = find<decltype(&eglCreateContext)>("eglCreateContext");
    const auto current = find<decltype(&eglMakeCurrent)>("eglMakeCurrent");
    if (create == nullptr || current == nullptr) return nullptr;
    reset_state();
    void* const display = const_cast<char*>(&kDisplay);
    void* const surface = const_cast<char*>(&kSurface);
    void* const context = create(display, nullptr, nullptr, nullptr);
    return current(display, surface, surface, context) ? context : nullptr;
}

std::vector<std::string> counted(const std::vector<std::string>& log) {
    std::map<std::string, int> times;
    for (const std::string& name : log) ++times[name];
    std::vector<std::string> out;
    for (const auto& [name, count] : times) {
        out.push_back(count == 1 ? name : name + " x" + std::to_string(count));
    }
    return out;
}

}  // namespace fake_driver

// The driver's door, as GLVND knows it; by a name that the layer finds in the dynamic symbols.
extern "C" __attribute__((visibility("default"))) EGLBoolean __egl_Main(std::uint32_t version,
                                                                        const __EGLapiExports*,
                                                                        __EGLvendorInfo*,
                                                                        __EGLapiImports* imports) {
    if (EGL_VENDOR_ABI_GET_MAJOR_VERSION(version) != EGL_VENDOR_ABI_MAJOR_VERSION) return EGL_FALSE;
    imports->getProcAddress = fake_driver::get_proc_address;
    return EGL_TRUE;
}
