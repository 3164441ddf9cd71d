// SPDX-License-Identifier: MIT
#include "context/depth_quantiser.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <random>

#include "context/context.h"
#include "context/depth_bounds.h"
#include "context/repetition.h"
#include "context/saved_state.h"
#include "context/unit_run.h"
#include "context/unit_stages.h"

namespace glext_emu {
namespace {

// Depths in a draw: a row of pixels, as long as every driver's renderbuffers may be.
constexpr std::size_t kRow = 4096;

std::uint64_t largest(int bits) {
    return (std::uint64_t{1} << bits) - 1;
}

// The product in floats, truncated: gallivm's lp_build_clamped_float_to_unsigned_norm for 24 bits.
std::uint32_t float_truncated(float depth, int bits) {
    return static_cast<std::uint32_t>(
        std::min(static_cast<double>(depth * static_cast<float>(largest(bits))), 4294967295.0));
}
// The same rounded to the nearest even: the conversion of x86's vector units.
std::uint32_t float_rounded_to_even(float depth, int bits) {
    return static_cast<std::uint32_t>(std::min(
        std::nearbyint(static_cast<double>(depth * static_cast<float>(largest(bits)))), 4294967295.0));
}
// The same for fewer bits: the value is added to a float whose last bits are the format's, and so is rounded.
std::uint32_t float_rounded_by_sum(float depth, int bits) {
    if (bits > 23) return ~0u;
    const auto scale =
        static_cast<float>(static_cast<double>(largest(bits)) / static_cast<double>(1u << bits));
    const auto bias = static_cast<float>(1u << (23 - bits));
    const float product = depth * scale;
    return std::bit_cast<std::uint32_t>(product + bias) & static_cast<std::uint32_t>(largest(bits));
}
// The same for more: the float's bits, repeated below.
std::uint32_t float_repeated(float depth, int bits) {
    const auto head = static_cast<std::uint32_t>(depth * static_cast<float>(1u << 24));
    return bits == 32 ? (head << 8) - (head >> 16) : ~0u;
}
std::uint32_t double_truncated(float depth, int bits) {
    return static_cast<std::uint32_t>(static_cast<double>(depth) * static_cast<double>(largest(bits)));
}
std::uint32_t double_rounded(float depth, int bits) {
    return static_cast<std::uint32_t>(
        std::floor(static_cast<double>(depth) * static_cast<double>(largest(bits)) + 0.5));
}
std::uint32_t double_rounded_to_even(float depth, int bits) {
    return static_cast<std::uint32_t>(
        std::nearbyint(static_cast<double>(depth) * static_cast<double>(largest(bits))));
}

constexpr std::array kFormulas = {float_truncated,       float_rounded_to_even, float_rounded_by_sum,
                                  float_repeated,        double_truncated,      double_rounded,
                                  double_rounded_to_even};

// Around and between what the format can hold, at any magnitude.
std::vector<float> probes(int bits) {
    std::vector<float> depths = {0, 1, 0.5F, std::nextafter(1.0F, 0.0F), 0x1p-24F, 0x1p-33F, 1e-20F};
    std::mt19937 random(1);
    const auto step = 1.0 / static_cast<double>(largest(bits));
    while (depths.size() < kRow) {
        const double share = static_cast<double>(random()) / 4294967296.0;
        const double held = std::floor(share * static_cast<double>(largest(bits))) * step;
        const std::array<double, 5> around = {share, share * share * share * share, held, held + step / 2,
                                              std::ldexp(share, -static_cast<int>(random() % 20))};
        for (const double at : around) {
            const auto depth = static_cast<float>(at);
            for (const float near : {std::nextafter(depth, 0.0F), depth, std::nextafter(depth, 1.0F)}) {
                depths.push_back(std::clamp(near, 0.0F, 1.0F));
            }
        }
    }
    depths.resize(kRow);
    return depths;
}

GLenum storage_of(const DepthPrecision& format) {
    if (format.is_float) return GL_DEPTH_COMPONENT32F;
    if (format.bits <= 16) return GL_DEPTH_COMPONENT16;
    return format.bits <= 24 ? GL_DEPTH_COMPONENT24 : GL_DEPTH_COMPONENT32;
}

DepthFormat depth_format(const DepthPrecision& format) {
    if (format.bits <= 16) return DepthFormat::kUnorm16;
    return format.bits <= 24 ? DepthFormat::kUnorm24 : DepthFormat::kUnorm32;
}

constexpr const char* kVertexStage = R"(#version 330
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";
constexpr const char* kFragmentStage = R"(#version 330
#extension GL_ARB_shader_storage_buffer_object : require
layout(std430) buffer Marks { float depths[]; };
void main() { gl_FragDepth = depths[int(gl_FragCoord.x)]; }
)";

// Inside this scope no query counts samples.
class Uncounted {
  public:
    explicit Uncounted(Context& ctx) : ctx_(ctx), has_segment_(ctx.slot.open_segment != 0) {
        if (ctx.proposed.run != nullptr) ctx.proposed.run->close_segment(ctx);
        pause_.emplace(ctx);
    }
    ~Uncounted() {
        pause_.reset();
        if (has_segment_) open_segment(ctx_);
    }
    Uncounted(const Uncounted&) = delete;
    Uncounted& operator=(const Uncounted&) = delete;

  private:
    Context& ctx_;
    bool has_segment_;
    std::optional<CountPause> pause_;
};

}  // namespace

void DepthQuantiser::prepare(Context& ctx, const DepthPrecision& format) {
    const bool is_known = format.is_float || format.bits == 0 || formulas_.contains(format);
    if (!is_known && !counts_draws(ctx)) learn(ctx, format);
}

bool DepthQuantiser::quantise(Context& ctx, const DepthPrecision& format, occlusion_unit::FarEnd far_end,
                              std::span<float> depths) {
    if (format.is_float || format.bits == 0 || depths.empty()) return true;
    prepare(ctx, format);
    const auto known = formulas_.find(format);
    if (known == formulas_.end()) return false;
    const Formula formula = known->second;
    const DepthEnd near = far_end == occlusion_unit::FarEnd::kOne ? DepthEnd::kLeast : DepthEnd::kGreatest;
    const auto as_float = [&](std::uint32_t held) {
        return depth_as_float(depth_format(format), near, held);
    };
    if (formula != nullptr) {
        for (float& depth : depths) depth = as_float(formula(depth, format.bits));
        return true;
    }
    if (counts_draws(ctx)) return false;
    for (std::size_t first = 0; first < depths.size(); first += kRow) {
        const std::span<float> row = depths.subspan(first, std::min(kRow, depths.size() - first));
        const std::vector<std::uint32_t> held = draw(ctx, format, row);
        for (std::size_t i = 0; i < row.size(); ++i) row[i] = as_float(held[i]);
    }
    return true;
}

void DepthQuantiser::learn(Context& ctx, const DepthPrecision& format) {
    const std::vector<float> depths = probes(format.bits);
    const std::vector<std::uint32_t> held = draw(ctx, format, depths);
    Formula& formula = formulas_[format];
    for (const Formula candidate : kFormulas) {
        const auto agrees = [&](float depth, std::uint32_t value) {
            return candidate(depth, format.bits) == value;
        };
        if (formula == nullptr && std::ranges::equal(depths, held, agrees)) formula = candidate;
    }
}

// The integers that a buffer of <format> holds after <depths>, at most kRow of them, were written to it.
std::vector<std::uint32_t> DepthQuantiser::draw(Context& ctx, const DepthPrecision& format,
                                                std::span<const float> depths) {
    const OwnCalls own(ctx);
    const RealGl& real = *ctx.real;
    const auto width = static_cast<GLsizei>(depths.size());
    const Uncounted uncounted(ctx);
    SavedState state(ctx);
    state.draw_unconditionally();
    state.draw_plain_polygons();
    for (const GLenum cap : {GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_DEPTH_CLAMP}) {
        state.set(cap, false);
    }
    state.set(GL_DEPTH_TEST, true);
    state.depth_func(GL_ALWAYS);
    state.depth_mask(true);
    state.read_plainly();
    if (program_ == 0) {
        program_ = build_program(ctx, kVertexStage, kFragmentStage);
        real.glCreateVertexArrays(1, &array_);
    }

    GLuint framebuffer = 0;
    GLuint image = 0;
    real.glCreateFramebuffers(1, &framebuffer);
    real.glCreateRenderbuffers(1, &image);
    real.glNamedRenderbufferStorage(image, storage_of(format), width, 1);
    real.glNamedFramebufferRenderbuffer(framebuffer, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, image);
    real.glNamedFramebufferDrawBuffer(framebuffer, GL_NONE);
    real.glNamedFramebufferReadBuffer(framebuffer, GL_NONE);
    ResultBuffers& buffers = unit_stages(ctx).results;
    const auto bytes = static_cast<GLsizeiptr>(depths.size_bytes());
    const ResultBuffers::Buffer source = buffers.take(ctx, bytes);
    real.glNamedBufferSubData(source.name, 0, bytes, depths.data());

    state.bind_framebuffer(framebuffer);
    state.viewport(width, 1);
    state.bind_vertex_array(array_);
    state.use_program(program_);
    ResultBinding binding;
    binding.bind(ctx, program_, source.name);
    real.glDrawArrays(GL_TRIANGLES, 0, 3);
    binding.unbind(ctx);
    std::vector<std::uint32_t> held(depths.size());
    real.glReadPixels(0, 0, width, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, held.data());
    buffers.give_back(source);
    real.glDeleteFramebuffers(1, &framebuffer);
    real.glDeleteRenderbuffers(1, &image);
    // GL widens to 32 bits by repeating the upper ones below.
    const int unused = 32 - (format.bits <= 16 ? 16 : format.bits <= 24 ? 24 : 32);
    for (std::uint32_t& value : held) value >>= unused;
    return held;
}

}  // namespace glext_emu
