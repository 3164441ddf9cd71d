// SPDX-License-Identifier: MIT
// The palette, and how a pipeline becomes GL's state.
#include "witness/pipelines.h"

#include "witness/machine.h"

namespace conformance {

namespace {

constexpr std::array<GLenum, 8> kStencilOps = {GL_KEEP, GL_KEEP, GL_KEEP,      GL_REPLACE,
                                               GL_INCR, GL_DECR, GL_INCR_WRAP, GL_INVERT};
constexpr std::array<GLenum, 6> kStencilFunctions = {GL_ALWAYS,   GL_ALWAYS, GL_EQUAL,
                                                     GL_NOTEQUAL, GL_LESS,   GL_GEQUAL};
// The functions of a far end 1; a reversed pipeline takes the opposite.
constexpr std::array<GLenum, 8> kDepthFunctions = {GL_LESS,  GL_LESS,   GL_LEQUAL, GL_LEQUAL,
                                                   GL_EQUAL, GL_ALWAYS, GL_LESS,   GL_NEVER};
constexpr std::array<Stages, 12> kStages = {Stages::kFixed,    Stages::kFixed,        Stages::kFixed,
                                            Stages::kGlsl,     Stages::kDiscard,      Stages::kFragmentDepth,
                                            Stages::kGeometry, Stages::kSeparable,    Stages::kAssembly,
                                            Stages::kFixed,    Stages::kAssemblyKill, Stages::kAssemblyDepth};

GLenum opposite(GLenum function) {
    switch (function) {
        case GL_LESS:
            return GL_GREATER;
        case GL_LEQUAL:
            return GL_GEQUAL;
        case GL_GREATER:
            return GL_LESS;
        case GL_GEQUAL:
            return GL_LEQUAL;
        default:
            return function;
    }
}

StencilFace random_face(Random& random) {
    StencilFace face{};
    face.function = random.one_of(kStencilFunctions);
    face.fails = random.one_of(kStencilOps);
    face.depth_fails = random.one_of(kStencilOps);
    face.passes = random.one_of(kStencilOps);
    return face;
}

constexpr StencilFace kReading = {GL_EQUAL, GL_KEEP, GL_KEEP, GL_KEEP};
constexpr StencilFace kWriting = {GL_ALWAYS, GL_KEEP, GL_INCR, GL_REPLACE};

void choose_stencil(Random& random, Pipeline& pipeline) {
    pipeline.tests_stencil = random.chance(50);
    const int kind = random.below(8);
    if (kind < 3) {
        pipeline.faces = {kReading, kReading};
        pipeline.faces[0].function = random.chance(50) ? GL_EQUAL : GL_GEQUAL;
        pipeline.faces[1] = pipeline.faces[0];
    } else if (kind < 5) {
        pipeline.faces = {kWriting, kWriting};
    } else if (kind < 7) {
        pipeline.faces[0] = random_face(random);
        pipeline.faces[1] = pipeline.faces[0];
    } else {
        pipeline.faces[0] = random_face(random);
        pipeline.faces[1] = random_face(random);
    }
    constexpr std::array<GLuint, 4> kMasks = {0xFF, 0xFF, 0x03, 0x00};
    pipeline.stencil_mask = random.one_of(kMasks);
    pipeline.compare_mask = random.chance(75) ? 0xFF : 0x01;
}

Pipeline random_pipeline(Random& random, const TargetKind& target, int index) {
    Pipeline pipeline;
    pipeline.stages = kStages[static_cast<std::size_t>(index) % kStages.size()];
    // A target without stencil is told apart by primitives, and two triangles of one make two fragments of
    // one.
    if (pipeline.stages == Stages::kGeometry && !target.has_stencil) pipeline.stages = Stages::kGlsl;
    if (target.layers > 0 && index % 2 == 0) pipeline.stages = Stages::kGeometry;
    pipeline.is_reversed = index % 5 == 4;
    pipeline.tests_depth = !random.chance(8);
    pipeline.depth_function = random.chance(3) ? GL_NOTEQUAL : random.one_of(kDepthFunctions);
    if (pipeline.is_reversed != random.chance(3)) pipeline.depth_function = opposite(pipeline.depth_function);
    pipeline.writes_depth = random.chance(65);
    if (target.has_stencil) choose_stencil(random, pipeline);
    if (random.chance(25)) {
        constexpr std::array<GLenum, 3> kAlphaFunctions = {GL_GREATER, GL_LESS, GL_GEQUAL};
        pipeline.alpha_function = random.one_of(kAlphaFunctions);
    }
    pipeline.blends = random.chance(20);
    pipeline.has_logic_op = !pipeline.blends && random.chance(15);
    pipeline.writes_colour = random.chance(60);
    if (target.has_stencil && random.chance(12))
        pipeline.polygon_mode = random.chance(70) ? GL_LINE : GL_POINT;
    // Which edges of a geometry stage's triangles are outlined is not the same each time in Mesa 22.3.
    if (pipeline.stages == Stages::kGeometry) pipeline.polygon_mode = GL_FILL;
    pipeline.has_alpha_to_coverage = target.samples > 0 && random.chance(15);
    pipeline.is_clipped = random.chance(12) && pipeline.stages != Stages::kGeometry;
    // A program's output would have to say what it is clipped by.
    if (pipeline.stages == Stages::kSeparable) pipeline.is_clipped = false;
    pipeline.is_stippled = random.chance(6);
    return pipeline;
}

std::string hexadecimal(GLenum value) {
    constexpr const char* kDigits = "0123456789ABCDEF";
    std::string text = "0x";
    for (int shift = 12; shift >= 0; shift -= 4) text += kDigits[value >> shift & 15];
    return text;
}

}  // namespace

bool Pipeline::writes_stencil() const {
    if (!tests_stencil || stencil_mask == 0) return false;
    for (const StencilFace& face : faces) {
        if (face.fails != GL_KEEP || face.depth_fails != GL_KEEP || face.passes != GL_KEEP) return true;
    }
    return false;
}

const std::vector<Pipeline>& pipelines_of(int kind) {
    static const auto palette = [] {
        std::array<std::vector<Pipeline>, kTargetKinds.size()> all;
        for (std::size_t target = 0; target < all.size(); ++target) {
            Random random(1999 + target);
            for (int i = 0; i < kPipelinesPerTarget; ++i) {
                all[target].push_back(random_pipeline(random, kTargetKinds[target], i));
            }
        }
        return all;
    }();
    return palette[static_cast<std::size_t>(kind)];
}

Settings random_settings(Random& random, const Pipeline& pipeline, int width, int height) {
    Settings settings;
    for (GLint& reference : settings.references) reference = random.below(4);
    settings.has_scissor = random.chance(25);
    settings.scissor = {random.below(width / 2), random.below(height / 2), random.integer(1, width),
                        random.integer(1, height)};
    if (random.chance(20)) {
        settings.depth_range[0] = static_cast<double>(random.real(0.0f, 0.4f));
        settings.depth_range[1] = static_cast<double>(random.real(0.6f, 1.0f));
        if (random.chance(20)) std::swap(settings.depth_range[0], settings.depth_range[1]);
    }
    if (random.chance(25)) settings.culled = random.chance(80) ? GL_BACK : GL_FRONT;
    settings.front = random.chance(80) ? GL_CCW : GL_CW;
    settings.has_offset = random.chance(20);
    settings.offset_factor = static_cast<GLfloat>(random.integer(-2, 2));
    settings.offset_units = static_cast<GLfloat>(random.integer(-8, 8));
    settings.clamps_depth = random.chance(8);
    settings.has_coverage = random.chance(12);
    settings.coverage = 0.25f * static_cast<GLfloat>(random.below(5));
    const double angle_x = static_cast<double>(random.real(-1.0f, 1.0f));
    const double angle_y = static_cast<double>(random.real(-1.0f, 1.0f));
    // Through a point near the middle.
    const double x = width * static_cast<double>(random.real(0.3f, 0.7f));
    const double y = height * static_cast<double>(random.real(0.3f, 0.7f));
    if (pipeline.is_clipped) settings.plane = {angle_x, angle_y, 0.0, -(angle_x * x + angle_y * y)};
    settings.line_width = static_cast<GLfloat>(random.integer(1, 3));
    settings.point_size = static_cast<GLfloat>(random.integer(1, 6));
    return settings;
}

void apply(const Pipeline& pipeline, const Settings& settings) {
    const auto turn = [](GLenum name, bool is_on) { (is_on ? glEnable : glDisable)(name); };
    turn(GL_DEPTH_TEST, pipeline.tests_depth);
    glDepthFunc(pipeline.depth_function);
    glDepthMask(pipeline.writes_depth ? GL_TRUE : GL_FALSE);
    turn(GL_STENCIL_TEST, pipeline.tests_stencil);
    if (pipeline.tests_stencil) {
        for (std::size_t i = 0; i < 2; ++i) {
            const GLenum side = i == 0 ? GL_FRONT : GL_BACK;
            const StencilFace& face = pipeline.faces[i];
            glStencilFuncSeparate(side, face.function, settings.references[i], pipeline.compare_mask);
            glStencilOpSeparate(side, face.fails, face.depth_fails, face.passes);
        }
        glStencilMask(pipeline.stencil_mask);
    }
    turn(GL_ALPHA_TEST, pipeline.alpha_function != GL_ALWAYS);
    glAlphaFunc(pipeline.alpha_function, 0.5f);
    turn(GL_BLEND, pipeline.blends);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    turn(GL_COLOR_LOGIC_OP, pipeline.has_logic_op);
    glLogicOp(GL_XOR);
    const GLboolean writes = pipeline.writes_colour ? GL_TRUE : GL_FALSE;
    glColorMask(writes, writes, writes, writes);
    glPolygonMode(GL_FRONT_AND_BACK, machine().repeats_lines ? pipeline.polygon_mode : GL_FILL);
    turn(GL_SAMPLE_ALPHA_TO_COVERAGE, pipeline.has_alpha_to_coverage);
    turn(GL_CLIP_PLANE0, pipeline.is_clipped);
    glClipPlane(GL_CLIP_PLANE0, settings.plane.data());
    turn(GL_POLYGON_STIPPLE, pipeline.is_stippled);
    turn(GL_SCISSOR_TEST, settings.has_scissor);
    glScissor(settings.scissor.x, settings.scissor.y, settings.scissor.width, settings.scissor.height);
    glDepthRange(settings.depth_range[0], settings.depth_range[1]);
    turn(GL_CULL_FACE, settings.culled != GL_NONE);
    if (settings.culled != GL_NONE) glCullFace(settings.culled);
    glFrontFace(settings.front);
    for (const GLenum mode : {GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT}) {
        turn(mode, settings.has_offset);
    }
    glPolygonOffset(settings.offset_factor, settings.offset_units);
    turn(GL_DEPTH_CLAMP, settings.clamps_depth);
    turn(GL_SAMPLE_COVERAGE, settings.has_coverage);
    glSampleCoverage(settings.coverage, GL_FALSE);
    glLineWidth(settings.line_width);
    glPointSize(settings.point_size);
    use(pipeline.stages);
}

std::string description(const Pipeline& pipeline) {
    std::string text = name_of(pipeline.stages);
    text +=
        pipeline.tests_depth ? ", depth function " + hexadecimal(pipeline.depth_function) : ", no depth test";
    if (!pipeline.writes_depth) text += ", depth mask off";
    if (pipeline.tests_stencil) {
        text += ", stencil mask " + hexadecimal(pipeline.stencil_mask);
        for (const StencilFace& face : pipeline.faces) {
            text += " (" + hexadecimal(face.function) + ": " + hexadecimal(face.fails) + " " +
                    hexadecimal(face.depth_fails) + " " + hexadecimal(face.passes) + ")";
        }
    }
    if (pipeline.alpha_function != GL_ALWAYS)
        text += ", alpha function " + hexadecimal(pipeline.alpha_function);
    if (pipeline.blends) text += ", blending";
    if (pipeline.has_logic_op) text += ", logic op";
    if (!pipeline.writes_colour) text += ", colour mask off";
    if (pipeline.polygon_mode != GL_FILL) text += ", polygon mode " + hexadecimal(pipeline.polygon_mode);
    if (pipeline.has_alpha_to_coverage) text += ", alpha to coverage";
    if (pipeline.is_clipped) text += ", clip plane";
    if (pipeline.is_stippled) text += ", stipple";
    return text;
}

// 17.3.5.2: "the depth test is enabled and its function is NOTEQUAL, GREATER or GEQUAL with FAR_DEPTH_EMU
// ONE, or LESS or LEQUAL with FAR_DEPTH_EMU ZERO", or "the depth mask is FALSE and the stencil test is
// enabled, writes, and its function is not ALWAYS".
bool may_leave_nearest_depth(const Pipeline& pipeline, bool has_stencil, GLenum far_end) {
    const GLenum function = pipeline.tests_depth ? pipeline.depth_function : GL_ALWAYS;
    if (function == GL_NOTEQUAL) return true;
    if (far_end == GL_ONE && (function == GL_GREATER || function == GL_GEQUAL)) return true;
    if (far_end == GL_ZERO && (function == GL_LESS || function == GL_LEQUAL)) return true;
    if (pipeline.writes_depth || !has_stencil || !pipeline.writes_stencil()) return false;
    return pipeline.faces[0].function != GL_ALWAYS || pipeline.faces[1].function != GL_ALWAYS;
}

// "The stencil test is enabled and writes, its function is neither ALWAYS nor NEVER, and the depth test is
// enabled": here only where a function other than ALWAYS can fail.
bool may_leave_projected_hits(const Pipeline& pipeline, bool has_stencil) {
    if (!has_stencil || !pipeline.writes_stencil()) return false;
    if (!pipeline.tests_depth || pipeline.depth_function == GL_ALWAYS) return false;
    for (const StencilFace& face : pipeline.faces) {
        if (face.function != GL_ALWAYS && face.function != GL_NEVER) return true;
    }
    return false;
}

}  // namespace conformance
