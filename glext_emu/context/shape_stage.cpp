// SPDX-License-Identifier: MIT
#include "context/shape_stage.h"

#include <algorithm>
#include <bit>
#include <string>

#include "context/context.h"
#include "context/saved_state.h"
#include "context/settings.h"

namespace glext_emu {
namespace {

using occlusion_unit::FarEnd;

// Words of a shape's header: visible hits, or a flag; hits that the second draw counts; the key of the
// nearest depth; one that nobody reads.
constexpr GLint kHeaderWords = 4;

// Shapes of a draw, so that 16 bits number the vertices; and words of a sheet, 64 MiB.
constexpr GLsizei kMostInDraw = 8192;
constexpr GLint kMostWords = 1 << 24;

// What a program notes, as its number in UnitStages.
constexpr unsigned kNotesFlag = 1;
constexpr unsigned kNotesHits = 2;
constexpr unsigned kNotesDepth = 4;
constexpr unsigned kNotesBox = 8;
constexpr unsigned kNotesHidden = 16;
constexpr unsigned kFarIsZero = 32;
constexpr unsigned kPerSample = 64;

constexpr const char* kVertexStage = R"(#version 330
layout(location = 0) in vec4 position;
layout(location = 1) in ivec3 vertex_place;
flat out ivec3 place;
void main() {
    gl_Position = position;
    place = vertex_place;
}
)";

// Fragments that are shaded together are mostly of one shape: one of them speaks for all that are of the
// first one's. Counting them so, and asking once for the depth that is known, is what makes the notes cheap.
constexpr const char* kSubGroup = R"(
    bool is_with_first = place.x == readFirstInvocationARB(place.x);
    uvec2 with_first = unpackUint2x32(ballotARB(is_with_first && !gl_HelperInvocation));
    bool speaks = gl_SubGroupInvocationARB == readFirstInvocationARB(gl_SubGroupInvocationARB);
    uint hits = speaks ? uint(bitCount(with_first.x) + bitCount(with_first.y)) : is_with_first ? 0u : 1u;
)";

std::string fragment_stage(unsigned what, bool has_sub_groups) {
    std::string text = has_sub_groups ? "#version 450\n"
                                        "#extension GL_ARB_shader_ballot : require\n"
                                        "#extension GL_ARB_gpu_shader_int64 : require\n"
                                      : "#version 330\n"
                                        "#extension GL_ARB_shader_storage_buffer_object : require\n"
                                        "#extension GL_ARB_shader_image_load_store : require\n";
    if ((what & kPerSample) != 0 && !has_sub_groups) text += "#extension GL_ARB_sample_shading : require\n";
    text +=
        "layout(early_fragment_tests) in;\n"
        "flat in ivec3 place;\n"
        "layout(std430) buffer Marks { uint marks[]; };\n"
        "void main() {\n";
    if ((what & kPerSample) != 0) text += "    marks[place.x + 3] = uint(gl_SampleID);\n";
    const bool counts = (what & (kNotesHits | kNotesHidden)) != 0;
    const bool speaks = has_sub_groups && (counts || (what & kNotesDepth) != 0);
    if (speaks) text += kSubGroup;
    if ((what & kNotesFlag) != 0) text += "    marks[place.x] = 1u;\n";
    if (counts) {
        const std::string word = (what & kNotesHidden) != 0 ? "marks[place.x + 1]" : "marks[place.x]";
        text += speaks ? "    if (hits != 0u) atomicAdd(" + word + ", hits);\n"
                       : "    atomicAdd(" + word + ", 1u);\n";
    }
    if ((what & kNotesDepth) != 0) {
        text += "    uint key = floatBitsToUint(abs(clamp(gl_FragCoord.z, 0.0, 1.0)));\n";
        if ((what & kFarIsZero) == 0) text += "    key = ~key;\n";
        text += speaks ? "    uint known = 0u;\n"
                         "    if (speaks) known = marks[place.x + 2];\n"
                         "    known = readFirstInvocationARB(known);\n"
                         "    if (key > known || !is_with_first) atomicMax(marks[place.x + 2], key);\n"
                       : "    if (key > marks[place.x + 2]) atomicMax(marks[place.x + 2], key);\n";
    }
    if ((what & kNotesBox) != 0) {
        text +=
            "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
            "    marks[place.y + pixel.x] = 1u;\n"
            "    marks[place.z + pixel.y] = 1u;\n";
    }
    return text + "}\n";
}

GLuint shape_program(Context& ctx, unsigned what) {
    UnitStages& stages = unit_stages(ctx);
    const auto [program, is_new] = stages.shape_programs.try_emplace(what, 0);
    if (is_new) {
        program->second = build_program(ctx, kVertexStage, fragment_stage(what, stages.has_sub_groups));
    }
    return program->second;
}

GLint get(Context& ctx, GLenum name) {
    GLint value = 0;
    ctx.real->glGetIntegerv(name, &value);
    return value;
}

WindowMap read_window(Context& ctx, const FramebufferInfo& framebuffer) {
    WindowMap window;
    ctx.real->glGetFloatv(GL_VIEWPORT, window.viewport.data());
    window.is_upside_down = ctx.kind.version >= GlVersion{4, 5} && get(ctx, GL_CLIP_ORIGIN) == GL_UPPER_LEFT;
    window.drawn = {0, 0, framebuffer.width, framebuffer.height};
    if (ctx.real->glIsEnabled(GL_SCISSOR_TEST) == GL_FALSE) return window;
    GLint box[4] = {};
    ctx.real->glGetIntegerv(GL_SCISSOR_BOX, box);
    const auto common = [](GLint first, GLint size, GLint whole, std::int32_t& at, std::int32_t& length) {
        const auto end = std::min(std::int64_t{first} + size, std::int64_t{whole});
        at = std::clamp(first, 0, whole);
        length = static_cast<std::int32_t>(std::max(end - at, std::int64_t{0}));
    };
    common(box[0], box[2], framebuffer.width, window.drawn.left, window.drawn.width);
    common(box[1], box[3], framebuffer.height, window.drawn.bottom, window.drawn.height);
    return window;
}

}  // namespace

GLuint shape_arrays(Context& ctx, GLenum kind, const std::vector<ShapeVertex>& vertices) {
    const RealGl& real = *ctx.real;
    UnitStages& stages = unit_stages(ctx);
    if (stages.shape_arrays == 0) {
        real.glCreateVertexArrays(1, &stages.shape_arrays);
        real.glCreateBuffers(1, &stages.shape_vertices);
        const GLuint arrays = stages.shape_arrays;
        real.glVertexArrayVertexBuffer(arrays, 0, stages.shape_vertices, 0, sizeof(ShapeVertex));
        real.glVertexArrayAttribFormat(arrays, 0, 4, GL_FLOAT, GL_FALSE, offsetof(ShapeVertex, clip));
        real.glVertexArrayAttribIFormat(arrays, 1, 3, GL_INT, offsetof(ShapeVertex, place));
        for (const GLuint attribute : {0u, 1u}) {
            real.glVertexArrayAttribBinding(arrays, attribute, 0);
            real.glEnableVertexArrayAttrib(arrays, attribute);
        }
    }
    const auto bytes = static_cast<GLsizeiptr>(vertices.size() * sizeof(ShapeVertex));
    real.glNamedBufferData(stages.shape_vertices, bytes, vertices.data(), GL_STREAM_DRAW);
    // Boxes have the indices of hexahedra.
    const GLenum indexed = kind == GL_QUAD_EMU ? GL_QUAD_EMU : GL_HEXAHEDRON_EMU;
    GLuint& indices = stages.shape_indices[indexed];
    if (indices == 0) {
        const std::vector<std::uint16_t> all = shape_indices(indexed, kMostInDraw);
        real.glCreateBuffers(1, &indices);
        real.glNamedBufferData(indices, static_cast<GLsizeiptr>(all.size() * sizeof all[0]), all.data(),
                               GL_STATIC_DRAW);
    }
    real.glVertexArrayElementBuffer(stages.shape_arrays, indices);
    return stages.shape_arrays;
}

GLuint plain_shape_program(Context& ctx) {
    const auto [program, is_new] = unit_stages(ctx).shape_programs.try_emplace(0, 0);
    if (is_new) program->second = build_program(ctx, kVertexStage, "#version 330\nvoid main() {}\n");
    return program->second;
}

bool ShapeRun::serves(Context& ctx, GLbitfield registers, const FramebufferInfo& framebuffer) {
    const UnitStages& stages = unit_stages(ctx);
    // softpipe, which has no sub-groups, runs early fragment stages for what fails the stencil test, too.
    if (!stages.has_sub_groups && ctx.real->glIsEnabled(GL_STENCIL_TEST) != GL_FALSE) return false;
    if (framebuffer.samples <= 1) return stages.can_mark;
    const bool needs_depth = framebuffer.depth_bits != 0 && (registers & GL_NEAREST_DEPTH_BIT_EMU) != 0;
    return stages.can_mark && stages.has_sample_stage && !needs_depth;
}

ShapeRun::ShapeRun(const Shapes& shapes)
    : registers_(shapes.registers),
      far_end_(shapes.far_end),
      records_(static_cast<std::size_t>(shapes.count),
               occlusion_unit::empty_record(occlusion_unit::kAllRegisters, shapes.far_end)) {
}

void ShapeRun::draw(Context& ctx, const Shapes& shapes, const FramebufferInfo& framebuffer) {
    const OwnCalls own(ctx);
    const FragmentTests tests = read_fragment_tests(ctx);
    const WindowMap window = read_window(ctx, framebuffer);
    const bool has_multisampling =
        framebuffer.samples > 1 && ctx.real->glIsEnabled(GL_MULTISAMPLE) != GL_FALSE;
    precision_ = {framebuffer.depth_bits, framebuffer.has_float_depth};
    if ((registers_ & GL_NEAREST_DEPTH_BIT_EMU) != 0) unit_stages(ctx).quantiser.prepare(ctx, precision_);
    is_per_sample_ = has_multisampling;
    // Without MULTISAMPLE a fragment stands for all samples of its pixel.
    if (framebuffer.samples > 1 && !has_multisampling) {
        samples_per_fragment_ = static_cast<GLuint>(framebuffer.samples);
    }
    if (ctx.real->glIsEnabled(GL_DEPTH_CLAMP) != GL_FALSE) {
        ctx.real->glGetFloatv(GL_DEPTH_RANGE, depth_range_.data());
        std::ranges::sort(depth_range_);
    }
    GLint culled = GL_BACK;
    ctx.real->glGetIntegerv(GL_CULL_FACE_MODE, &culled);
    sides_are_alike_ = shapes.kind != GL_QUAD_EMU && !tests.stencil_test && culled != GL_FRONT_AND_BACK &&
                       ctx.real->glIsEnabled(GL_CULL_FACE) == GL_FALSE;
    has_visible_ = !(tests.depth_test && tests.depth_func == GL_NEVER && framebuffer.depth_bits != 0);
    hits_tell_projected_ = !tests.depth_can_fail() || framebuffer.depth_bits == 0;

    SavedState state(ctx);
    state.draw_unconditionally();
    state.draw_plain_polygons();
    state.write_nothing();
    state.depth_func(tests.depth_test ? tests.depth_func : GL_LESS);
    state.bind_vertex_array(0);
    state.use_program(0);
    std::vector<ShapeVertex> vertices;
    for (GLsizei first = 0; first < shapes.count;) {
        // More than one sheet of the largest size is never in the driver's hands.
        if (!sheets_.empty() && sheets_.back().words > kMostWords / 2) {
            ctx.real->glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
            for (Sheet& sheet : sheets_) read(ctx, sheet);
            sheets_.clear();
        }
        first += lay_out(ctx, shapes, first, window, vertices);
        draw_sheet(ctx, shapes, vertices, tests);
    }
}

// Vertices of the shapes from <first> on, as many as a draw takes, and a sheet for them; how many they are.
GLsizei ShapeRun::lay_out(Context& ctx, const Shapes& shapes, GLsizei first, const WindowMap& window,
                          std::vector<ShapeVertex>& vertices) {
    const ShapeKind kind = kind_of_shape(shapes.kind);
    const GLsizei most = std::min(shapes.count - first, kMostInDraw);
    const bool has_box = (registers_ & GL_SCREEN_BOX_BIT_EMU) != 0;
    vertices.resize(static_cast<std::size_t>(most) * static_cast<std::size_t>(kind.vertices));
    Sheet sheet;
    sheet.first = first;
    sheet.words = kHeaderWords * most;
    for (; sheet.count < most; ++sheet.count) {
        ShapeVertex* const own = &vertices[static_cast<std::size_t>(sheet.count * kind.vertices)];
        const std::ptrdiff_t given = std::ptrdiff_t{first + sheet.count} * kind.floats;
        transform_shape(shapes.kind, shapes.vertices + given, shapes.matrix, own);
        const std::span<ShapeVertex> corners(own, static_cast<std::size_t>(kind.vertices));
        const PixelBounds bounds = bound_shape(window, corners);
        sheet.is_whole = sheet.is_whole && is_inside_volume(corners);
        const GLint columns = sheet.words;
        const GLint rows = columns + bounds.width;
        if (has_box) {
            const GLint words = rows + bounds.height;
            if (words > kMostWords && sheet.count != 0) break;
            sheet.words = words;
            sheet.places.push_back(columns);
            sheet.bounds.push_back(bounds);
        }
        for (ShapeVertex& corner : corners) {
            corner.place = {kHeaderWords * sheet.count, columns - bounds.left, rows - bounds.bottom};
        }
    }
    vertices.resize(static_cast<std::size_t>(sheet.count * kind.vertices));
    const auto bytes = GLsizeiptr{sheet.words} * GLsizeiptr{sizeof(GLuint)};
    sheet.buffer = unit_stages(ctx).results.take(ctx, bytes);
    ctx.real->glClearNamedBufferSubData(sheet.buffer.name, GL_R32UI, 0, bytes, GL_RED_INTEGER,
                                        GL_UNSIGNED_INT, nullptr);
    sheets_.push_back(std::move(sheet));
    return sheets_.back().count;
}

void ShapeRun::draw_sheet(Context& ctx, const Shapes& shapes, const std::vector<ShapeVertex>& vertices,
                          const FragmentTests& tests) {
    const RealGl& real = *ctx.real;
    Sheet& sheet = sheets_.back();
    const auto wants = [this](GLbitfield registers) { return (registers_ & registers) != 0; };
    const unsigned common = is_per_sample_ ? kPerSample : 0;
    const bool counts_hits = has_visible_ && (wants(GL_VISIBLE_HITS_BIT_EMU) ||
                                              (wants(GL_PROJECTED_HITS_BIT_EMU) && hits_tell_projected_));
    unsigned visible = 0;
    if (counts_hits) visible |= kNotesHits;
    if (wants(GL_VISIBLE_BIT_EMU) && !counts_hits) visible |= kNotesFlag;
    if (wants(GL_NEAREST_DEPTH_BIT_EMU)) visible |= kNotesDepth;
    if (wants(GL_SCREEN_BOX_BIT_EMU)) visible |= kNotesBox;

    real.glBindVertexArray(shape_arrays(ctx, shapes.kind, vertices));
    const auto indices = static_cast<GLsizei>(kind_of_shape(shapes.kind).triangles.size()) * sheet.count;
    ResultBinding binding;
    binding.bind(ctx, sheet.buffer.name);
    // The device draws them once, whatever is noted of it.
    if (ctx.time != nullptr)
        ctx.time->draw_apart(static_cast<std::uint64_t>(indices) / 3, true, VertexSource::kArrays);
    bool is_first = ctx.time != nullptr;
    const auto run = [&](unsigned what) {
        const GLuint program = shape_program(ctx, what);
        binding.attach(ctx, program);
        real.glUseProgram(program);
        if (is_first) ctx.time->count();
        real.glDrawElements(GL_TRIANGLES, indices, GL_UNSIGNED_SHORT, nullptr);
        if (std::exchange(is_first, false)) ctx.time->stop_counting();
    };
    if (visible != 0 && has_visible_) {
        if (far_end_ == FarEnd::kZero && (visible & kNotesDepth) != 0) visible |= kFarIsZero;
        run(visible | common);
    }
    if (wants(GL_PROJECTED_HITS_BIT_EMU) && !hits_tell_projected_) {
        // Of a closed shape that is not clipped, every sample has as many front faces before it as back
        // faces, since polygons with a common edge share no sample and leave none out (GL 4.6, 14.6.1). Else:
        // those that fail the depth test are those that pass the opposite one.
        sheet.has_halves = sides_are_alike_ && sheet.is_whole;
        sheet.counts_all = sheet.has_halves || !counts_hits;
        if (sheet.has_halves) real.glEnable(GL_CULL_FACE);
        real.glDepthFunc(sheet.counts_all ? GL_ALWAYS : opposite_depth_func(tests.depth_func));
        run(kNotesHidden | common);
        if (sheet.has_halves) real.glDisable(GL_CULL_FACE);
        real.glDepthFunc(tests.depth_func);
    }
    binding.unbind(ctx);
}

bool ShapeRun::is_ready(Context& ctx) {
    if (sheets_.empty()) return true;
    const OwnCalls own(ctx);
    if (fence_ == nullptr) fence_ = ctx.real->glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    const GLenum state = ctx.real->glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, 0);
    return state == GL_ALREADY_SIGNALED || state == GL_CONDITION_SATISFIED;
}

void ShapeRun::drain(Context& ctx, std::vector<occlusion_unit::Record>& records) {
    const OwnCalls own(ctx);
    if (!sheets_.empty()) ctx.real->glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    for (Sheet& sheet : sheets_) read(ctx, sheet);
    sheets_.clear();
    drop(ctx);
    for (occlusion_unit::Record& record : records_) {
        record.registers = registers_;
        record = narrowed(ctx, finished(record, far_end_), far_end_);
    }
    records.insert(records.end(), records_.begin(), records_.end());
}

void ShapeRun::read(Context& ctx, Sheet& sheet) {
    std::vector<GLuint> words(static_cast<std::size_t>(sheet.words));
    ctx.real->glGetNamedBufferSubData(sheet.buffer.name, 0,
                                      static_cast<GLsizeiptr>(words.size() * sizeof(GLuint)), words.data());
    unit_stages(ctx).results.give_back(sheet.buffer);
    const bool has_depth = precision_.bits != 0 && (registers_ & GL_NEAREST_DEPTH_BIT_EMU) != 0;
    std::vector<float> depths;  // of the shapes that have one, in their order
    for (GLsizei i = 0; i < sheet.count; ++i) {
        const GLuint* const header = &words[static_cast<std::size_t>(kHeaderWords * i)];
        occlusion_unit::Record& record = records_[static_cast<std::size_t>(sheet.first + i)];
        record.visible_hits = std::uint64_t{header[0]} * samples_per_fragment_;
        record.visible = header[0] != 0;
        record.projected_hits = std::uint64_t{header[1]} * samples_per_fragment_;
        if (sheet.has_halves) record.projected_hits *= 2;
        if (!sheet.counts_all) record.projected_hits += record.visible_hits;
        if (has_depth && header[2] != 0) {
            const auto depth = std::bit_cast<float>(far_end_ == FarEnd::kOne ? ~header[2] : header[2]);
            depths.push_back(std::clamp(depth, depth_range_[0], depth_range_[1]));
        }
        if (sheet.bounds.empty()) continue;
        const PixelBounds& bounds = sheet.bounds[static_cast<std::size_t>(i)];
        const GLuint* const columns = &words[0] + sheet.places[static_cast<std::size_t>(i)];
        const GLuint* const rows = columns + bounds.width;
        const auto is_marked = [](GLuint word) { return word != 0; };
        const auto first = std::find_if(columns, columns + bounds.width, is_marked) - columns;
        if (first == bounds.width) continue;
        const auto length = [&](const GLuint* marks, std::int32_t size) {
            while (size > 0 && marks[size - 1] == 0) --size;
            return size;
        };
        const auto lowest = std::find_if(rows, rows + bounds.height, is_marked) - rows;
        record.box = {
            bounds.left + static_cast<std::int32_t>(first), bounds.bottom + static_cast<std::int32_t>(lowest),
            bounds.left + length(columns, bounds.width) - 1, bounds.bottom + length(rows, bounds.height) - 1};
    }
    if (!unit_stages(ctx).quantiser.quantise(ctx, precision_, far_end_, depths)) {
        registers_ &= ~GLbitfield{GL_NEAREST_DEPTH_BIT_EMU};
    }
    auto depth = depths.begin();
    for (GLsizei i = 0; i < sheet.count && depth != depths.end(); ++i) {
        if (words[static_cast<std::size_t>(kHeaderWords * i + 2)] == 0) continue;
        records_[static_cast<std::size_t>(sheet.first + i)].nearest_depth = *depth++;
    }
}

void ShapeRun::drop(Context& ctx) {
    if (fence_ != nullptr) ctx.real->glDeleteSync(fence_);
    fence_ = nullptr;
    for (const Sheet& sheet : sheets_) unit_stages(ctx).results.give_back(sheet.buffer);
    sheets_.clear();
}

}  // namespace glext_emu
