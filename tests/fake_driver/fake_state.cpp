// SPDX-License-Identifier: MIT
// What the fake driver answers: the state that was set, names that nobody has, success. The commands that are
// named nowhere here return zero and write nothing.
#include <EGL/egl.h>

#include <cstring>
#include <map>
#include <set>
#include <unordered_map>

#include "fake_driver.h"

namespace fake_driver {
namespace {

// Of each occlusion query that has ended.
constexpr GLuint64 kSamples = 7;
constexpr GLint kDrawBuffers = 2;
// Those that the layer looks for before it looks at fragments by a stage of its own.
constexpr const char* kExtensions[] = {
    "GL_ARB_occlusion_query",
    "GL_ARB_shader_storage_buffer_object",
    "GL_ARB_shader_image_load_store",
    "GL_ARB_clear_buffer_object",
    "GL_ARB_multi_bind",
    "GL_ARB_direct_state_access",
};

struct State {
    std::set<GLenum> enabled{GL_DITHER, GL_MULTISAMPLE};
    std::map<GLenum, std::array<GLint64, 4>> values{
        {GL_MAJOR_VERSION, {4}},
        {GL_MINOR_VERSION, {5}},
        {GL_CONTEXT_PROFILE_MASK, {GL_CONTEXT_COMPATIBILITY_PROFILE_BIT}},
        {GL_NUM_EXTENSIONS, {std::size(kExtensions)}},
        {GL_RENDER_MODE, {GL_RENDER}},
        {GL_MAX_ATTRIB_STACK_DEPTH, {16}},
        {GL_MAX_LIST_NESTING, {64}},
        {GL_VIEWPORT, {0, 0, 64, 64}},
        {GL_SCISSOR_BOX, {0, 0, 64, 64}},
        {GL_DEPTH_RANGE, {0, 1}},
        {GL_DEPTH_FUNC, {GL_LESS}},
        {GL_DEPTH_WRITEMASK, {1}},
        {GL_DEPTH_BITS, {24}},
        {GL_STENCIL_BITS, {8}},
        {GL_COLOR_WRITEMASK, {1, 1, 1, 1}},
        {GL_MAX_DRAW_BUFFERS, {kDrawBuffers}},
        {GL_STENCIL_WRITEMASK, {0xFFFFFFFF}},
        {GL_STENCIL_BACK_WRITEMASK, {0xFFFFFFFF}},
        {GL_STENCIL_FUNC, {GL_ALWAYS}},
        {GL_STENCIL_BACK_FUNC, {GL_ALWAYS}},
        {GL_STENCIL_FAIL, {GL_KEEP}},
        {GL_STENCIL_PASS_DEPTH_FAIL, {GL_KEEP}},
        {GL_STENCIL_PASS_DEPTH_PASS, {GL_KEEP}},
        {GL_STENCIL_BACK_FAIL, {GL_KEEP}},
        {GL_STENCIL_BACK_PASS_DEPTH_FAIL, {GL_KEEP}},
        {GL_STENCIL_BACK_PASS_DEPTH_PASS, {GL_KEEP}},
        {GL_ALPHA_TEST_FUNC, {GL_ALWAYS}},
        {GL_POLYGON_MODE, {GL_FILL, GL_FILL}},
        {GL_DRAW_BUFFER, {GL_BACK}},
        {GL_DRAW_BUFFER0, {GL_BACK}},
        {GL_READ_BUFFER, {GL_BACK}},
        {GL_MATRIX_MODE, {GL_MODELVIEW}},
        {GL_ACTIVE_TEXTURE, {GL_TEXTURE0}},
        {GL_PACK_ALIGNMENT, {4}},
        {GL_UNPACK_ALIGNMENT, {4}},
        {GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, {16}},
        {GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, {16}},
        {GL_MAX_COMBINED_SHADER_STORAGE_BLOCKS, {16}},
        {GL_MAX_SHADER_STORAGE_BLOCK_SIZE, {1 << 27}},
        {GL_MAX_TEXTURE_SIZE, {16384}},
        {GL_MAX_VERTEX_ATTRIBS, {16}},
    };
    std::map<GLuint, bool> queries;     // name: has ended
    std::map<GLenum, GLuint> counting;  // target: active query
    GLuint last_name = 0;
    bool is_between_begin_and_end = false;
    std::array<std::byte, 1 << 20> memory{};  // of whatever buffer is mapped
};
State state;

GLenum enumerant(std::intptr_t argument) {
    return static_cast<GLenum>(argument);
}
GLuint name(std::intptr_t argument) {
    return static_cast<GLuint>(argument);
}

template <typename Value>
Value* pointer(std::intptr_t argument) {
    return reinterpret_cast<Value*>(argument);
}

std::size_t size_of(GLenum pname) {
    switch (pname) {
        case GL_VIEWPORT:
        case GL_SCISSOR_BOX:
        case GL_COLOR_WRITEMASK:
            return 4;
        case GL_DEPTH_RANGE:
        case GL_POLYGON_MODE:
            return 2;
        default:
            return 1;
    }
}

template <typename Value>
std::intptr_t get(const Arguments& a) {
    // GL 4.5 compatibility, 10.8.2: a Get between Begin and End is in error, and writes nothing.
    if (state.is_between_begin_and_end) return 0;
    const GLenum pname = enumerant(a[0]);
    const auto found = state.values.find(pname);
    for (std::size_t i = 0; i < size_of(pname); ++i) {
        const GLint64 value = found != state.values.end() ? found->second[i] : state.enabled.count(pname);
        pointer<Value>(a[1])[i] = static_cast<Value>(value);
    }
    return 0;
}

// A command whose only argument is the value of <kName>.
template <GLenum kName>
std::intptr_t set(const Arguments& a) {
    state.values[kName] = {enumerant(a[0])};
    return 0;
}

template <GLenum kName>
std::intptr_t set_four(const Arguments& a) {
    for (std::size_t i = 0; i < 4; ++i) state.values[kName][i] = static_cast<GLint>(a[i]);
    return 0;
}

std::intptr_t color_mask(const Arguments& a) {
    for (std::size_t i = 0; i < 4; ++i) state.values[GL_COLOR_WRITEMASK][i] = static_cast<GLboolean>(a[i]);
    return 0;
}

std::intptr_t get_boolean_of_buffer(const Arguments& a) {
    if (enumerant(a[0]) != GL_COLOR_WRITEMASK) return 0;
    for (std::size_t i = 0; i < 4; ++i) {
        pointer<GLboolean>(a[2])[i] = static_cast<GLboolean>(state.values[GL_COLOR_WRITEMASK][i]);
    }
    return 0;
}

// All buffers have the mask of the last call: nothing here sets them apart.
std::intptr_t color_mask_of_buffer(const Arguments& a) {
    return color_mask({a[1], a[2], a[3], a[4]});
}

std::intptr_t depth_mask(const Arguments& a) {
    state.values[GL_DEPTH_WRITEMASK] = {static_cast<GLboolean>(a[0])};
    return 0;
}

std::intptr_t bind_framebuffer(const Arguments& a) {
    if (enumerant(a[0]) != GL_READ_FRAMEBUFFER) state.values[GL_DRAW_FRAMEBUFFER_BINDING] = {name(a[1])};
    if (enumerant(a[0]) != GL_DRAW_FRAMEBUFFER) state.values[GL_READ_FRAMEBUFFER_BINDING] = {name(a[1])};
    return 0;
}

std::intptr_t bind_buffer(const Arguments& a) {
    static const std::map<GLenum, GLenum> kBindings{
        {GL_ARRAY_BUFFER, GL_ARRAY_BUFFER_BINDING},
        {GL_SHADER_STORAGE_BUFFER, GL_SHADER_STORAGE_BUFFER_BINDING},
        {GL_PIXEL_PACK_BUFFER, GL_PIXEL_PACK_BUFFER_BINDING},
        {GL_QUERY_BUFFER, GL_QUERY_BUFFER_BINDING},
    };
    const auto found = kBindings.find(enumerant(a[0]));
    if (found != kBindings.end()) state.values[found->second] = {name(a[1])};
    return 0;
}

// (n, names) and (target, n, names).
std::intptr_t make_names(const Arguments& a) {
    for (GLsizei i = 0; i < static_cast<GLsizei>(a[0]); ++i) pointer<GLuint>(a[1])[i] = ++state.last_name;
    return 0;
}
std::intptr_t make_names_of_target(const Arguments& a) {
    return make_names({a[1], a[2]});
}
std::intptr_t make_name(const Arguments&) {
    return ++state.last_name;
}

std::intptr_t begin_query(const Arguments& a) {
    state.counting[enumerant(a[0])] = name(a[1]);
    state.queries[name(a[1])] = false;
    return 0;
}
std::intptr_t end_query(const Arguments& a) {
    state.queries[state.counting[enumerant(a[0])]] = true;
    state.counting.erase(enumerant(a[0]));
    return 0;
}
std::intptr_t get_query(const Arguments& a) {
    const auto active = state.counting.find(enumerant(a[0]));
    const GLint current = active == state.counting.end() ? 0 : static_cast<GLint>(active->second);
    *pointer<GLint>(a[2]) = enumerant(a[1]) == GL_CURRENT_QUERY ? current : 64;
    return 0;
}
template <typename Value>
std::intptr_t get_query_object(const Arguments& a) {
    const bool asks_count = enumerant(a[1]) != GL_QUERY_RESULT_AVAILABLE;
    *pointer<Value>(a[2]) = static_cast<Value>(asks_count ? kSamples : GLuint64{1});
    return 0;
}
std::intptr_t delete_queries(const Arguments& a) {
    for (GLsizei i = 0; i < static_cast<GLsizei>(a[0]); ++i) state.queries.erase(pointer<GLuint>(a[1])[i]);
    return 0;
}

std::intptr_t get_string(const Arguments& a) {
    const GLenum asked = enumerant(a[0]);
    const char* const text = asked == GL_VENDOR       ? "glext_emu tests"
                             : asked == GL_RENDERER   ? "fake"
                             : asked == GL_VERSION    ? "4.5 (Compatibility Profile) fake"
                             : asked == GL_EXTENSIONS ? "GL_ARB_occlusion_query"
                                                      : "4.50";
    return reinterpret_cast<std::intptr_t>(text);
}
std::intptr_t get_stringi(const Arguments& a) {
    const GLuint index = name(a[1]);
    return index < std::size(kExtensions) ? reinterpret_cast<std::intptr_t>(kExtensions[index]) : 0;
}

// A shader that compiled, a program that linked, each without a log.
std::intptr_t get_shader(const Arguments& a) {
    *pointer<GLint>(a[2]) = enumerant(a[1]) == GL_INFO_LOG_LENGTH ? 0 : 1;
    return 0;
}

// Of the default framebuffer, or whatever stands in for it: 24 bits of depth, 8 of stencil.
std::intptr_t get_attachment(const Arguments& a) {
    switch (enumerant(a[2])) {
        case GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE:
            *pointer<GLint>(a[3]) = GL_FRAMEBUFFER_DEFAULT;
            break;
        case GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE:
            *pointer<GLint>(a[3]) = GL_UNSIGNED_NORMALIZED;
            break;
        case GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE:
            *pointer<GLint>(a[3]) = 24;
            break;
        case GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE:
            *pointer<GLint>(a[3]) = 8;
            break;
        default:
            *pointer<GLint>(a[3]) = 0;
            break;
    }
    return 0;
}

template <std::intptr_t kValue>
std::intptr_t constant(const Arguments&) {
    return kValue;
}

std::intptr_t mapped(const Arguments&) {
    return reinterpret_cast<std::intptr_t>(state.memory.data());
}

const std::unordered_map<std::string_view, Answer>& answers() {
    static const std::unordered_map<std::string_view, Answer> all{
        {"glEnable",
         [](const Arguments& a) -> std::intptr_t { return state.enabled.insert(enumerant(a[0])), 0; }},
        {"glDisable",
         [](const Arguments& a) -> std::intptr_t { return state.enabled.erase(enumerant(a[0])), 0; }},
        {"glIsEnabled",
         [](const Arguments& a) -> std::intptr_t { return state.enabled.count(enumerant(a[0])) != 0; }},
        {"glBegin",
         [](const Arguments&) -> std::intptr_t { return state.is_between_begin_and_end = true, 0; }},
        {"glEnd",
         [](const Arguments&) -> std::intptr_t { return state.is_between_begin_and_end = false, 0; }},
        {"glGetBooleanv", get<GLboolean>},
        {"glGetIntegerv", get<GLint>},
        {"glGetInteger64v", get<GLint64>},
        {"glGetFloatv", get<GLfloat>},
        {"glGetDoublev", get<GLdouble>},
        {"glDepthFunc", set<GL_DEPTH_FUNC>},
        {"glUseProgram", set<GL_CURRENT_PROGRAM>},
        {"glBindVertexArray", set<GL_VERTEX_ARRAY_BINDING>},
        {"glBindProgramPipeline", set<GL_PROGRAM_PIPELINE_BINDING>},
        {"glStencilMask", set<GL_STENCIL_WRITEMASK>},
        {"glActiveTexture", set<GL_ACTIVE_TEXTURE>},
        {"glViewport", set_four<GL_VIEWPORT>},
        {"glScissor", set_four<GL_SCISSOR_BOX>},
        {"glColorMask", color_mask},
        {"glColorMaski", color_mask_of_buffer},
        {"glGetBooleani_v", get_boolean_of_buffer},
        {"glDepthMask", depth_mask},
        {"glBindFramebuffer", bind_framebuffer},
        {"glBindBuffer", bind_buffer},
        {"glGenQueries", make_names},
        {"glGenBuffers", make_names},
        {"glGenTextures", make_names},
        {"glGenFramebuffers", make_names},
        {"glGenRenderbuffers", make_names},
        {"glGenVertexArrays", make_names},
        {"glCreateBuffers", make_names},
        {"glCreateFramebuffers", make_names},
        {"glCreateRenderbuffers", make_names},
        {"glCreateVertexArrays", make_names},
        {"glCreateTextures", make_names_of_target},
        {"glCreateQueries", make_names_of_target},
        {"glCreateShader", make_name},
        {"glCreateProgram", make_name},
        {"glCreateShaderProgramv", make_name},
        {"glGenLists", make_name},
        {"glBeginQuery", begin_query},
        {"glEndQuery", end_query},
        {"glDeleteQueries", delete_queries},
        {"glIsQuery",
         [](const Arguments& a) -> std::intptr_t { return state.queries.count(name(a[0])) != 0; }},
        {"glGetQueryiv", get_query},
        {"glGetQueryObjectiv", get_query_object<GLint>},
        {"glGetQueryObjectuiv", get_query_object<GLuint>},
        {"glGetQueryObjecti64v", get_query_object<GLint64>},
        {"glGetQueryObjectui64v", get_query_object<GLuint64>},
        {"glGetString", get_string},
        {"glGetStringi", get_stringi},
        {"glGetShaderiv", get_shader},
        {"glGetProgramiv", get_shader},
        {"glGetFramebufferAttachmentParameteriv", get_attachment},
        {"glGetNamedFramebufferAttachmentParameteriv", get_attachment},
        {"glCheckFramebufferStatus", constant<GL_FRAMEBUFFER_COMPLETE>},
        {"glCheckNamedFramebufferStatus", constant<GL_FRAMEBUFFER_COMPLETE>},
        {"glFenceSync", constant<1>},
        {"glClientWaitSync", constant<GL_ALREADY_SIGNALED>},
        {"glMapBuffer", mapped},
        {"glMapBufferRange", mapped},
        {"glMapNamedBuffer", mapped},
        {"glMapNamedBufferRange", mapped},
        {"glUnmapBuffer", constant<GL_TRUE>},
        {"glUnmapNamedBuffer", constant<GL_TRUE>},
    };
    return all;
}

}  // namespace

void reset_state() {
    const GLuint last_name = state.last_name;
    state = State{};
    state.last_name = last_name;
}

Answer answer_of(std::string_view command) {
    const auto found = answers().find(command);
    return found == answers().end() ? nullptr : found->second;
}

}  // namespace fake_driver
