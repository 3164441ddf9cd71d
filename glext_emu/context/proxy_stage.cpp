// SPDX-License-Identifier: MIT
#include "context/proxy_stage.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string>

#include "context/context.h"
#include "context/framebuffer_info.h"

namespace glext_emu {
namespace {

using occlusion_unit::FarEnd;

// Words of a sheet: the key of the nearest depth, one that is not used, then for each i whether column i and
// row i have a visible pixel. Plain stores of the same word by whoever comes: twice as fast as atomic minima
// and maxima.
constexpr GLint kHeaderWords = 2;

// What a program marks, as its number in UnitStages.
constexpr unsigned kMarksDepth = 1;
constexpr unsigned kMarksBox = 2;
constexpr unsigned kFarIsZero = 4;

// The key of a depth grows towards the near end, and is never less than that of no depth, 0: the order of
// floats in [0, 1] is that of their bits.
std::string fragment_stage(unsigned what, bool has_sub_groups) {
    std::string text =
        "#version 330 compatibility\n"
        "#extension GL_ARB_shader_storage_buffer_object : require\n"
        "#extension GL_ARB_shader_image_load_store : require\n";
    if (has_sub_groups) text += "#extension GL_ARB_shader_ballot : require\n";
    text +=
        "layout(early_fragment_tests) in;\n"
        "layout(std430) buffer Marks { uint marks[]; };\n"
        "void main() {\n";
    if ((what & kMarksDepth) != 0) {
        text += "    uint key = floatBitsToUint(abs(clamp(gl_FragCoord.z, 0.0, 1.0)));\n";
        if ((what & kFarIsZero) == 0) text += "    key = ~key;\n";
        // One fragment of those that are shaded together asks for all.
        if (has_sub_groups) {
            text +=
                "    uint known = 0u;\n"
                "    if (gl_SubGroupInvocationARB == readFirstInvocationARB(gl_SubGroupInvocationARB))\n"
                "        known = marks[0];\n"
                "    known = readFirstInvocationARB(known);\n"
                "    if (key > known) atomicMax(marks[0], key);\n";
        } else {
            text += "    if (key > marks[0]) atomicMax(marks[0], key);\n";
        }
    }
    if ((what & kMarksBox) != 0) {
        text +=
            "    uvec2 pixel = uvec2(gl_FragCoord.xy);\n"
            "    marks[2u + 2u * pixel.x] = 1u;\n"
            "    marks[3u + 2u * pixel.y] = 1u;\n";
    }
    return text + "}\n";
}

unsigned marks_of(GLbitfield registers, FarEnd far_end) {
    unsigned what = far_end == FarEnd::kZero ? kFarIsZero : 0;
    if ((registers & GL_NEAREST_DEPTH_BIT_EMU) != 0) what |= kMarksDepth;
    if ((registers & GL_SCREEN_BOX_BIT_EMU) != 0) what |= kMarksBox;
    return what;
}

GLuint proxy_program(Context& ctx, unsigned what) {
    UnitStages& stages = unit_stages(ctx);
    if (!stages.can_mark) return 0;
    const auto [program, is_new] = stages.proxy_programs.try_emplace(what, 0);
    if (is_new) program->second = build_program(ctx, "", fragment_stage(what, stages.has_sub_groups));
    return program->second;
}

GLint get(Context& ctx, GLenum name) {
    GLint value = 0;
    ctx.real->glGetIntegerv(name, &value);
    return value;
}

// Replayed with writes off, each fragment meets the depths from before the draw. A pixel's nearest fragment
// passes if any does where the function asks for nearer ones; what passes in the draw itself is otherwise a
// matter of order.
bool is_free_of_order(GLbitfield registers, FarEnd far_end, const FragmentTests& tests) {
    if (tests.stencil_test) return false;  // softpipe's early tests leave it out
    // There softpipe runs the fragment stage for what fails, too.
    if (tests.depth_test && tests.depth_func == GL_NEVER) return false;
    const bool writes_depth = tests.depth_test && tests.depth_writes;
    if (!writes_depth || (registers & GL_NEAREST_DEPTH_BIT_EMU) == 0) return true;
    switch (tests.depth_func) {
        case GL_LESS:
        case GL_LEQUAL:
            return far_end == FarEnd::kOne;
        case GL_GREATER:
        case GL_GEQUAL:
            return far_end == FarEnd::kZero;
        case GL_NOTEQUAL:
            return false;
        default:
            return true;
    }
}

// The vertex stage is fixed function's, and no fragment is lost or made after the rasteriser but by the tests
// that a fragment stage can come after.
bool is_fixed_function(Context& ctx) {
    constexpr std::array kOthers = {GL_ALPHA_TEST,  GL_FRAGMENT_PROGRAM_ARB, GL_VERTEX_PROGRAM_ARB,
                                    GL_DEPTH_CLAMP, GL_POLYGON_STIPPLE,      GL_POLYGON_SMOOTH,
                                    GL_LINE_SMOOTH, GL_POINT_SMOOTH};
    if (get(ctx, GL_CURRENT_PROGRAM) != 0 || get(ctx, GL_RENDER_MODE) != GL_RENDER) return false;
    if (ctx.kind.version >= GlVersion{4, 1} && get(ctx, GL_PROGRAM_PIPELINE_BINDING) != 0) return false;
    if (unit_stages(ctx).has_ati_stage && ctx.real->glIsEnabled(GL_FRAGMENT_SHADER_ATI)) return false;
    return std::ranges::none_of(
        kOthers, [&](int cap) { return ctx.real->glIsEnabled(static_cast<GLenum>(cap)) != GL_FALSE; });
}

}  // namespace

ProxyMarks::ProxyMarks(GLbitfield registers, FarEnd far_end)
    : registers_(registers & (GL_NEAREST_DEPTH_BIT_EMU | GL_SCREEN_BOX_BIT_EMU)), far_end_(far_end) {
}

bool ProxyMarks::serves(Context& ctx, GLbitfield registers, FarEnd far_end, const FragmentTests& tests) {
    if (!ctx.kind.is_compatibility() || !unit_stages(ctx).can_mark) return false;
    if (!is_free_of_order(registers, far_end, tests)) return false;
    const OwnCalls own(ctx);
    return is_fixed_function(ctx) && get(ctx, GL_SAMPLE_BUFFERS) == 0 &&
           proxy_program(ctx, marks_of(registers, far_end)) != 0;
}

bool ProxyMarks::writes_nothing(Context& ctx, const FragmentTests& tests) {
    if ((tests.depth_test && tests.depth_writes) || tests.stencil_writes()) return false;
    std::array<GLboolean, 4> channels{};
    ctx.real->glGetBooleanv(GL_COLOR_WRITEMASK, channels.data());
    if (std::ranges::find(channels, GL_TRUE) != channels.end()) return false;
    for (GLint i = get(ctx, GL_MAX_DRAW_BUFFERS); i-- > 1;) {
        ctx.real->glGetBooleani_v(GL_COLOR_WRITEMASK, static_cast<GLuint>(i), channels.data());
        if (std::ranges::find(channels, GL_TRUE) != channels.end()) return false;
    }
    return true;
}

void ProxyMarks::aim(Context& ctx) {
    const OwnCalls own(ctx);
    const FramebufferInfo info = draw_framebuffer_info(ctx);
    const DepthPrecision precision{info.depth_bits, info.has_float_depth};
    const GLint size = std::max(info.width, info.height);
    const bool fits =
        !sheets_.empty() && sheets_.back().size >= size && sheets_.back().precision == precision;
    if (fits) return;
    if ((registers_ & GL_NEAREST_DEPTH_BIT_EMU) != 0) unit_stages(ctx).quantiser.prepare(ctx, precision);
    const auto bytes = static_cast<GLsizeiptr>(kHeaderWords + 2 * size) * GLsizeiptr{sizeof(GLuint)};
    const ResultBuffers::Buffer buffer = unit_stages(ctx).results.take(ctx, bytes);
    ctx.real->glClearNamedBufferSubData(buffer.name, GL_R32UI, 0, bytes, GL_RED_INTEGER, GL_UNSIGNED_INT,
                                        nullptr);
    sheets_.push_back({buffer, size, precision});
}

void ProxyMarks::begin_draw(Context& ctx) {
    const OwnCalls own(ctx);
    const GLuint program = proxy_program(ctx, marks_of(registers_, far_end_));
    binding_.bind(ctx, program, sheets_.back().buffer.name);
    ctx.real->glUseProgram(program);
}

void ProxyMarks::end_draw(Context& ctx) {
    const OwnCalls own(ctx);
    ctx.real->glUseProgram(0);
    binding_.unbind(ctx);
}

bool ProxyMarks::is_ready(Context& ctx) {
    if (sheets_.empty()) return true;
    const OwnCalls own(ctx);
    if (fence_ == nullptr) fence_ = ctx.real->glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    const GLenum state = ctx.real->glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, 0);
    return state == GL_ALREADY_SIGNALED || state == GL_CONDITION_SATISFIED;
}

occlusion_unit::Record ProxyMarks::drain(Context& ctx) {
    const OwnCalls own(ctx);
    occlusion_unit::Record marks = occlusion_unit::empty_record(occlusion_unit::kAllRegisters, far_end_);
    if (!sheets_.empty()) ctx.real->glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    for (const Sheet& sheet : sheets_) marks = occlusion_unit::merged(marks, read(ctx, sheet), far_end_);
    drop(ctx);
    return marks;
}

occlusion_unit::Record ProxyMarks::read(Context& ctx, const Sheet& sheet) const {
    std::vector<GLuint> words(static_cast<std::size_t>(kHeaderWords + 2 * sheet.size));
    ctx.real->glGetNamedBufferSubData(sheet.buffer.name, 0,
                                      static_cast<GLsizeiptr>(words.size() * sizeof(GLuint)), words.data());
    occlusion_unit::Record marks = occlusion_unit::empty_record(occlusion_unit::kAllRegisters, far_end_);
    if (words[0] != 0 && sheet.precision.bits != 0) {
        float depth = std::bit_cast<float>(far_end_ == FarEnd::kOne ? ~words[0] : words[0]);
        if (unit_stages(ctx).quantiser.quantise(ctx, sheet.precision, far_end_, {&depth, 1})) {
            marks.nearest_depth = depth;
        } else {
            marks.registers &= ~GLbitfield{GL_NEAREST_DEPTH_BIT_EMU};
        }
    }
    for (GLint i = 0; i < sheet.size; ++i) {
        const auto at = static_cast<std::size_t>(kHeaderWords + 2 * i);
        occlusion_unit::Box& box = marks.box;
        if (words[at] != 0) {
            if (box.right < 0) box.left = i;
            box.right = i;
        }
        if (words[at + 1] != 0) {
            if (box.top < 0) box.bottom = i;
            box.top = i;
        }
    }
    return marks;
}

void ProxyMarks::drop(Context& ctx) {
    if (fence_ != nullptr) ctx.real->glDeleteSync(fence_);
    fence_ = nullptr;
    for (const Sheet& sheet : sheets_) unit_stages(ctx).results.give_back(sheet.buffer);
    sheets_.clear();
}

}  // namespace glext_emu
