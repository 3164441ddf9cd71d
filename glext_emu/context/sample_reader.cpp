// SPDX-License-Identifier: MIT
#include "context/sample_reader.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <string>

#include "context/context.h"
#include "context/list_pause.h"
#include "context/saved_state.h"
#include "context/unit_stages.h"

// GL_MESA_framebuffer_flip_y; Debian's glext.h knows the name for ES only.
#ifndef GL_FRAMEBUFFER_FLIP_Y_MESA
#define GL_FRAMEBUFFER_FLIP_Y_MESA 0x8BBB
#endif

namespace glext_emu {
namespace {

constexpr const char* kSource = R"(#version 430
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2DMS depths;
uniform sampler2DMS marks;
uniform int width;
uniform int height;
uniform int samples;
uniform bool is_flipped;
layout(std430) buffer Marks { uvec2 found[]; };
void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= width || pixel.y >= height) return;
    ivec2 texel = is_flipped ? ivec2(pixel.x, height - 1 - pixel.y) : pixel;
    for (int i = 0; i < samples; ++i) {
        float depth = texelFetch(depths, texel, i).x;
        float mark = texelFetch(marks, texel, i).x;
        found[(pixel.y * width + pixel.x) * samples + i] = uvec2(floatBitsToUint(depth), uint(mark * 255.0 + 0.5));
    }
}
)";

struct Sample {
    float depth;
    std::uint32_t mark;
};

// What a framebuffer's samples are made of.
struct SampleShape {
    GLuint framebuffer = 0;
    GLint samples = 0;
    GLint depth_bits = 0;
    bool has_float_depth = false;
    GLint stencil_bits = 0;
    bool has_marks = false;
    bool has_alpha = false;   // they lie in RGBA8 instead of R8
    bool is_flipped = false;  // its rows run the other way: a blit to one that does not is no plain copy
};

GLuint program_of(Context& ctx) {
    DepthReader& reader = ctx.depth_reader;
    if (reader.sample_program == 0 && ctx.kind.version >= GlVersion{4, 3} && ctx.kind.has_named_buffers) {
        const RealGl& real = *ctx.real;
        const GLuint shader = real.glCreateShader(GL_COMPUTE_SHADER);
        const GLuint program = real.glCreateProgram();
        real.glShaderSource(shader, 1, &kSource, nullptr);
        real.glCompileShader(shader);
        real.glAttachShader(program, shader);
        real.glDeleteShader(shader);  // with the program
        real.glLinkProgram(program);
        GLint is_linked = GL_FALSE;
        real.glGetProgramiv(program, GL_LINK_STATUS, &is_linked);
        if (is_linked != GL_FALSE) reader.sample_program = program;
        if (is_linked == GL_FALSE) real.glDeleteProgram(program);
    }
    return reader.sample_program;
}

GLenum format_of(const SampleShape& shape) {
    const bool has_stencil = shape.stencil_bits != 0;
    if (shape.has_float_depth) return has_stencil ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F;
    if (shape.depth_bits == 16) return GL_DEPTH_COMPONENT16;
    if (shape.depth_bits == 32) return GL_DEPTH_COMPONENT32;
    return has_stencil ? GL_DEPTH24_STENCIL8 : GL_DEPTH_COMPONENT24;
}

// Textures of a rectangle's samples, for as long as they are read: a program of a compatibility context may
// bind any name of its own choice, so the layer keeps none.
class SampleCopy {
  public:
    SampleCopy(Context& ctx, const SampleShape& shape, const Rect& rect) : real_(*ctx.real) {
        real_.glCreateFramebuffers(1, &framebuffer_);
        GLbitfield buffers = 0;
        if (shape.depth_bits != 0) {
            const bool has_stencil = shape.stencil_bits != 0;
            attach(depths, has_stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, format_of(shape),
                   shape, rect);
            buffers |= GL_DEPTH_BUFFER_BIT | (has_stencil ? GL_STENCIL_BUFFER_BIT : 0u);
        }
        if (shape.has_marks) {
            attach(marks, GL_COLOR_ATTACHMENT0, shape.has_alpha ? GL_RGBA8 : GL_R8, shape, rect);
            buffers |= GL_COLOR_BUFFER_BIT;
        } else {
            real_.glNamedFramebufferDrawBuffer(framebuffer_, GL_NONE);
        }
        if (shape.is_flipped)
            real_.glNamedFramebufferParameteri(framebuffer_, GL_FRAMEBUFFER_FLIP_Y_MESA, GL_TRUE);
        real_.glBlitNamedFramebuffer(shape.framebuffer, framebuffer_, rect.x, rect.y, rect.x + rect.width,
                                     rect.y + rect.height, 0, 0, rect.width, rect.height, buffers,
                                     GL_NEAREST);
        is_made = real_.glGetError() == GL_NO_ERROR;
    }
    ~SampleCopy() {
        real_.glDeleteFramebuffers(1, &framebuffer_);
        const GLuint textures[] = {depths, marks};
        real_.glDeleteTextures(2, textures);
    }
    SampleCopy(const SampleCopy&) = delete;
    SampleCopy& operator=(const SampleCopy&) = delete;

    GLuint depths = 0;
    GLuint marks = 0;
    bool is_made = false;

  private:
    void attach(GLuint& texture, GLenum attachment, GLenum format, const SampleShape& shape,
                const Rect& rect) {
        real_.glCreateTextures(GL_TEXTURE_2D_MULTISAMPLE, 1, &texture);
        real_.glTextureStorage2DMultisample(texture, shape.samples, format, rect.width, rect.height, GL_TRUE);
        real_.glNamedFramebufferTexture(framebuffer_, attachment, texture, 0);
    }

    const RealGl& real_;
    GLuint framebuffer_ = 0;
};

// Two texture units, the last ones, while the shader runs.
class BoundTextures {
  public:
    BoundTextures(Context& ctx, GLuint program, const SampleCopy& copy) : real_(*ctx.real) {
        GLint units = 0;
        real_.glGetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units);
        real_.glGetIntegerv(GL_ACTIVE_TEXTURE, &active_);
        const GLuint textures[] = {copy.depths, copy.marks};
        for (int i = 0; i < 2; ++i) {
            unit_[i] = static_cast<GLenum>(units - 1 - i);
            real_.glActiveTexture(GL_TEXTURE0 + unit_[i]);
            real_.glGetIntegerv(GL_TEXTURE_BINDING_2D_MULTISAMPLE, &bound_[i]);
            real_.glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, textures[i]);
            real_.glProgramUniform1i(program,
                                     real_.glGetUniformLocation(program, i == 0 ? "depths" : "marks"),
                                     static_cast<GLint>(unit_[i]));
        }
    }
    ~BoundTextures() {
        for (int i = 0; i < 2; ++i) {
            real_.glActiveTexture(GL_TEXTURE0 + unit_[i]);
            real_.glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, static_cast<GLuint>(bound_[i]));
        }
        real_.glActiveTexture(static_cast<GLenum>(active_));
    }
    BoundTextures(const BoundTextures&) = delete;
    BoundTextures& operator=(const BoundTextures&) = delete;

  private:
    const RealGl& real_;
    GLint active_ = 0;
    GLenum unit_[2] = {};
    GLint bound_[2] = {};
};

// The samples as the shader sees them; nothing where the driver cannot tell.
std::optional<std::vector<Sample>> fetch(Context& ctx, const SampleShape& shape, const Rect& rect) {
    const OwnCalls own(ctx);
    const ListPause pause(ctx);
    const RealGl& real = *ctx.real;
    const GLuint program = program_of(ctx);
    if (program == 0) return std::nullopt;
    SavedState saved(ctx);
    saved.draw_unconditionally();
    const bool was_scissored = real.glIsEnabledi(GL_SCISSOR_TEST, 0) != GL_FALSE;
    if (was_scissored) real.glDisablei(GL_SCISSOR_TEST, 0);
    const SampleCopy copy(ctx, shape, rect);
    if (was_scissored) real.glEnablei(GL_SCISSOR_TEST, 0);
    if (!copy.is_made) return std::nullopt;

    const auto count = static_cast<std::size_t>(rect.area() * shape.samples);
    std::vector<Sample> samples(count);
    const auto bytes = static_cast<GLsizeiptr>(count * sizeof(Sample));
    ResultBuffers& buffers = unit_stages(ctx).results;
    const ResultBuffers::Buffer buffer = buffers.take(ctx, bytes);
    {
        const BoundTextures bound(ctx, program, copy);
        const auto set = [&](const char* name, GLint value) {
            real.glProgramUniform1i(program, real.glGetUniformLocation(program, name), value);
        };
        set("width", rect.width);
        set("height", rect.height);
        set("samples", shape.samples);
        set("is_flipped", shape.is_flipped ? 1 : 0);
        saved.use_program(program);
        ResultBinding binding;
        binding.bind(ctx, program, buffer.name);
        real.glDispatchCompute(static_cast<GLuint>(rect.width + 7) / 8,
                               static_cast<GLuint>(rect.height + 7) / 8, 1);
        binding.unbind(ctx);
    }
    real.glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    real.glFinish();  // without it Mesa may give what the buffer held before
    real.glGetNamedBufferSubData(buffer.name, 0, bytes, samples.data());
    buffers.give_back(buffer);
    return samples;
}

// A shader's texelFetch of 24 bits need not give the float that glReadPixels gives: llvmpipe multiplies with
// a rounded reciprocal, which is off by up to 1.25 steps of the buffer. It is one formula or the other, and
// the integer can be told from either, but for the last step before 1, which comes out as 1 itself: it is
// taken for the far end, so that nothing is called occluded that is not.
constexpr double kSteps24 = 16777215.0;

float multiplied(double integer) {
    return static_cast<float>(integer) * static_cast<float>(1.0 / kSteps24);
}

float as_read_pixels_has_it(float fetched) {
    const double middle = std::round(static_cast<double>(fetched) * kSteps24);
    for (double integer = middle + 2; integer >= middle - 2; --integer) {
        if (multiplied(integer) == fetched) return static_cast<float>(integer * (1.0 / kSteps24));
    }
    return fetched;
}

// Which of the two it is shows where they differ: four fifths, which the format holds however a clear rounds.
bool multiplies(Context& ctx) {
    DepthReader& reader = ctx.depth_reader;
    if (reader.fetch_is_known) return reader.fetch_multiplies;
    const OwnCalls own(ctx);
    const RealGl& real = *ctx.real;
    constexpr GLfloat kDepth = 0.8F;
    constexpr double kInteger = 13421772;
    GLuint framebuffer = 0;
    GLuint texture = 0;
    real.glCreateFramebuffers(1, &framebuffer);
    real.glCreateTextures(GL_TEXTURE_2D_MULTISAMPLE, 1, &texture);
    real.glTextureStorage2DMultisample(texture, 4, GL_DEPTH_COMPONENT24, 1, 1, GL_TRUE);
    real.glNamedFramebufferTexture(framebuffer, GL_DEPTH_ATTACHMENT, texture, 0);
    {
        const ListPause pause(ctx);
        SavedState saved(ctx);
        saved.draw_unconditionally();
        saved.depth_mask(true);
        saved.set(GL_SCISSOR_TEST, false);
        real.glClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &kDepth);
    }
    const auto found = fetch(ctx, {.framebuffer = framebuffer, .samples = 4, .depth_bits = 24}, {0, 0, 1, 1});
    real.glDeleteFramebuffers(1, &framebuffer);
    real.glDeleteTextures(1, &texture);
    reader.fetch_multiplies = found && found->front().depth == multiplied(kInteger);
    reader.fetch_is_known = true;
    return reader.fetch_multiplies;
}

}  // namespace

bool read_multisampled(Context& ctx, const FramebufferInfo& info, DepthEnd end, const Rect& all,
                       std::span<const Rect> rects, std::span<DepthBound> bounds) {
    const SampleShape shape{.framebuffer = info.name,
                            .samples = info.samples,
                            .depth_bits = info.depth_bits,
                            .has_float_depth = info.has_float_depth,
                            .stencil_bits = info.stencil_bits,
                            .has_marks = false,
                            .is_flipped = info.is_default};
    const auto samples = fetch(ctx, shape, all);
    if (!samples) return false;
    const bool is_24 = !info.has_float_depth && info.depth_bits == 24;
    const bool is_32 = !info.has_float_depth && info.depth_bits == 32;
    const bool must_correct = is_24 && multiplies(ctx);
    const auto per_pixel = static_cast<std::size_t>(info.samples);
    for (std::size_t i = 0; i < rects.size(); ++i) {
        const Rect& rect = rects[i];
        if (rect.is_empty()) continue;
        float bound = end == DepthEnd::kGreatest ? 0.0F : 1.0F;
        for (GLint y = rect.y - all.y; y < rect.y - all.y + rect.height; ++y) {
            const auto first =
                static_cast<std::size_t>(std::int64_t{y} * all.width + rect.x - all.x) * per_pixel;
            const auto count = static_cast<std::size_t>(rect.width) * per_pixel;
            for (const Sample& sample : std::span(*samples).subspan(first, count)) {
                bound = end == DepthEnd::kGreatest ? std::max(bound, sample.depth)
                                                   : std::min(bound, sample.depth);
            }
        }
        const bool is_at_end = end == DepthEnd::kGreatest ? bound >= 1.0F : bound <= 0.0F;
        if (must_correct) bound = as_read_pixels_has_it(bound);
        // Of 32 bits a fetch tells 24, and is off by up to two of them.
        for (int step = 0; is_32 && step < 2; ++step) {
            bound = std::nextafter(bound, end == DepthEnd::kGreatest ? 1.0F : 0.0F);
        }
        bounds[i] = {bound, is_at_end};
    }
    return true;
}

bool read_samples(Context& ctx, GLuint fbo, const Rect& rect, std::vector<float>& depths,
                  std::vector<std::uint8_t>& marks) {
    const OwnCalls own(ctx);
    const RealGl& real = *ctx.real;
    SampleShape shape{.framebuffer = fbo};
    const auto parameter = [&](GLenum name) {
        GLint value = 0;
        real.glGetNamedFramebufferParameteriv(fbo, name, &value);
        return value;
    };
    const auto attachment = [&](GLenum which, GLenum name) {
        GLint value = 0;
        real.glGetNamedFramebufferAttachmentParameteriv(fbo, which, name, &value);
        return value;
    };
    const auto is_there = [&](GLenum which) {
        return attachment(which, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE;
    };
    shape.samples = parameter(GL_SAMPLES);
    shape.is_flipped = parameter(GL_FRAMEBUFFER_FLIP_Y_MESA) != 0;
    shape.has_marks = is_there(GL_COLOR_ATTACHMENT0);
    shape.has_alpha =
        shape.has_marks && attachment(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE) != 0;
    if (is_there(GL_DEPTH_ATTACHMENT)) {
        shape.depth_bits = attachment(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
        shape.has_float_depth =
            attachment(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT;
    }
    if (shape.depth_bits != 0 && is_there(GL_STENCIL_ATTACHMENT)) {
        shape.stencil_bits = attachment(GL_STENCIL_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE);
    }
    const auto samples = fetch(ctx, shape, rect);
    if (!samples) return false;
    const bool must_correct = !shape.has_float_depth && shape.depth_bits == 24 && multiplies(ctx);
    depths.clear();
    marks.clear();
    for (const Sample& sample : *samples) {
        depths.push_back(must_correct ? as_read_pixels_has_it(sample.depth) : sample.depth);
        marks.push_back(static_cast<std::uint8_t>(sample.mark));
    }
    return true;
}

}  // namespace glext_emu
