// SPDX-License-Identifier: MIT
#include "context/unit_stages.h"

#include <bit>
#include <cstring>

#include "context/context.h"
#include "context/saved_state.h"

namespace glext_emu {
namespace {

// So many of a size lie between two uses of a buffer; of large ones fewer.
constexpr std::size_t kTurns = 16;
constexpr std::size_t kLargeTurns = 3;
constexpr GLsizeiptr kLarge = 1 << 20;
constexpr GLsizeiptr kSmallest = 1 << 13;

GLint get(Context& ctx, GLenum name) {
    GLint value = 0;
    ctx.real->glGetIntegerv(name, &value);
    return value;
}

bool driver_has(Context& ctx, const char* extension) {
    for (GLint i = get(ctx, GL_NUM_EXTENSIONS); i-- > 0;) {
        const GLubyte* name = ctx.real->glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
        if (name != nullptr && std::strcmp(reinterpret_cast<const char*>(name), extension) == 0) return true;
    }
    return false;
}

void learn_features(Context& ctx, UnitStages& stages) {
    const OwnCalls own(ctx);
    stages.is_known = true;
    const bool has_shaders = ctx.kind.version >= GlVersion{3, 3} && !ctx.kind.is_es;
    stages.can_mark = has_shaders && driver_has(ctx, "GL_ARB_shader_storage_buffer_object") &&
                      driver_has(ctx, "GL_ARB_shader_image_load_store") &&
                      driver_has(ctx, "GL_ARB_clear_buffer_object") && driver_has(ctx, "GL_ARB_multi_bind") &&
                      driver_has(ctx, "GL_ARB_direct_state_access");
    if (!stages.can_mark) return;
    stages.has_sub_groups = ctx.kind.version >= GlVersion{4, 5} && driver_has(ctx, "GL_ARB_shader_ballot") &&
                            driver_has(ctx, "GL_ARB_shader_group_vote") &&
                            driver_has(ctx, "GL_ARB_gpu_shader_int64") &&
                            driver_has(ctx, "GL_ARB_gpu_shader5");
    stages.has_ati_stage = ctx.kind.is_compatibility() && driver_has(ctx, "GL_ATI_fragment_shader");
    stages.has_sample_stage = driver_has(ctx, "GL_ARB_sample_shading");
    stages.binding_count = get(ctx, GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS);
    GLint blocks = 0;
    ctx.real->glGetIntegerv(GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, &blocks);
    stages.can_mark = blocks > 0 && stages.binding_count > 0;
}

GLuint compile(Context& ctx, GLenum stage, const std::string& source) {
    const RealGl& real = *ctx.real;
    const GLuint shader = real.glCreateShader(stage);
    const GLchar* text = source.c_str();
    real.glShaderSource(shader, 1, &text, nullptr);
    real.glCompileShader(shader);
    return shader;
}

}  // namespace

UnitStages& unit_stages(Context& ctx) {
    if (ctx.unit_stages == nullptr) ctx.unit_stages = std::make_shared<UnitStages>();
    if (!ctx.unit_stages->is_known) learn_features(ctx, *ctx.unit_stages);
    return *ctx.unit_stages;
}

ResultBuffers::Buffer ResultBuffers::take(Context& ctx, GLsizeiptr bytes) {
    const auto size = static_cast<GLsizeiptr>(
        std::bit_ceil(static_cast<std::size_t>(bytes < kSmallest ? kSmallest : bytes)));
    std::deque<GLuint>& free = free_[size];
    if (free.size() >= (size < kLarge ? kTurns : kLargeTurns)) {
        const GLuint name = free.front();
        free.pop_front();
        return {name, size};
    }
    GLuint name = 0;
    ctx.real->glCreateBuffers(1, &name);
    ctx.real->glNamedBufferData(name, size, nullptr, GL_DYNAMIC_READ);
    return {name, size};
}

GLuint build_program(Context& ctx, const std::string& vertex, const std::string& fragment) {
    const RealGl& real = *ctx.real;
    const GLuint program = real.glCreateProgram();
    const auto attach = [&](GLenum stage, const std::string& source) {
        if (source.empty()) return;
        const GLuint shader = compile(ctx, stage, source);
        real.glAttachShader(program, shader);
        real.glDeleteShader(shader);  // with the program
    };
    attach(GL_VERTEX_SHADER, vertex);
    attach(GL_FRAGMENT_SHADER, fragment);
    real.glLinkProgram(program);
    GLint is_linked = GL_FALSE;
    real.glGetProgramiv(program, GL_LINK_STATUS, &is_linked);
    if (is_linked != GL_FALSE) return program;
    real.glDeleteProgram(program);
    return 0;
}

// ARB_multi_bind: the indexed binding alone, while BindBufferBase changes the general one too.
void ResultBinding::bind(Context& ctx, GLuint buffer) {
    const RealGl& real = *ctx.real;
    const auto top = static_cast<GLuint>(unit_stages(ctx).binding_count - 1);
    index_ = top;
    buffer_ = 0;
    for (GLuint index = top + 1; index-- > 0;) {
        real.glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, index, &buffer_);
        if (buffer_ != 0) continue;
        index_ = index;
        break;
    }
    if (buffer_ != 0) {  // the program's, all of them; the last one seen is not the top one
        real.glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, index_, &buffer_);
        real.glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, index_, &start_);
        real.glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, index_, &size_);
    }
    real.glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, index_, 1, &buffer);
}

void ResultBinding::attach(Context& ctx, GLuint program) const {
    ctx.real->glShaderStorageBlockBinding(program, 0, index_);
}

void ResultBinding::unbind(Context& ctx) {
    const auto buffer = static_cast<GLuint>(buffer_);
    if (buffer == 0 || size_ == 0) {
        return ctx.real->glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, index_, 1, &buffer);
    }
    const auto start = static_cast<GLintptr>(start_);
    const auto size = static_cast<GLsizeiptr>(size_);
    ctx.real->glBindBuffersRange(GL_SHADER_STORAGE_BUFFER, index_, 1, &buffer, &start, &size);
}

}  // namespace glext_emu
