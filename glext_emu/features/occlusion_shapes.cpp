// SPDX-License-Identifier: MIT
// GL_EMU_occlusion_unit, the parallel form: many shapes in one call, each with a record of its own.
#include <array>
#include <cstddef>

#include "context/list_pause.h"
#include "context/repetition.h"
#include "context/saved_state.h"
#include "context/shape_stage.h"
#include "features/features.h"

namespace glext_emu::features {
namespace {

using Matrix = std::array<GLfloat, 16>;

// The product of the current matrices, rounded as the driver rounds it for fixed function.
Matrix current_matrix(Context& ctx) {
    Matrix projection{}, modelview{}, product{};
    ctx.real->glGetFloatv(GL_PROJECTION_MATRIX, projection.data());
    ctx.real->glGetFloatv(GL_MODELVIEW_MATRIX, modelview.data());
    for (std::size_t column = 0; column < 4; ++column) {
        for (std::size_t row = 0; row < 4; ++row) {
            for (std::size_t k = 0; k < 4; ++k) {
                product[4 * column + row] += projection[4 * k + row] * modelview[4 * column + k];
            }
        }
    }
    return product;
}

// Each shape in a query of the unit of its own, its record awaited: where no shader can note what it sees.
void draw_one_by_one(Context& ctx, const Shapes& shapes, std::vector<occlusion_unit::Record>& records) {
    const ShapeKind kind = kind_of_shape(shapes.kind);
    const OwnCalls own(ctx);
    SavedState state(ctx);
    state.draw_unconditionally();
    state.draw_plain_polygons();
    state.write_nothing();
    state.bind_vertex_array(0);
    state.use_program(plain_shape_program(ctx));
    std::vector<ShapeVertex> vertices(static_cast<std::size_t>(kind.vertices));
    for (GLsizei i = 0; i < shapes.count; ++i) {
        transform_shape(shapes.kind, shapes.vertices + std::ptrdiff_t{i} * kind.floats, shapes.matrix,
                        vertices.data());
        hide_if_not_finite(vertices);
        ctx.real->glBindVertexArray(shape_arrays(ctx, shapes.kind, vertices));
        ctx.proposed.run = std::make_unique<UnitRun>(shapes.registers, shapes.far_end, VisibleHitsBy::kUnit);
        draw_watched(ctx, {kind.triangles.size() / 3}, [&] {
            ctx.real->glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(kind.triangles.size()),
                                     GL_UNSIGNED_SHORT, nullptr);
        });
        const std::unique_ptr<UnitRun> run = std::move(ctx.proposed.run);
        run->close_segment(ctx);
        run->drain(ctx, records);
    }
}

bool draws_fragments(Context& ctx) {
    if (!ctx.kind.is_compatibility()) return true;
    GLint mode = GL_RENDER;
    ctx.real->glGetIntegerv(GL_RENDER_MODE, &mode);
    return mode == GL_RENDER;
}

}  // namespace

void occlusion_unit_shapes_emu(Context& ctx, GLbitfield registers, GLenum shape, GLsizei count,
                               const GLfloat* vertices, const GLfloat* matrix, GLuint id) {
    if (refuses_unit_query(ctx, registers, id)) return;
    if (shape != GL_BOX_EMU && shape != GL_HEXAHEDRON_EMU && shape != GL_QUAD_EMU) {
        return ctx.raise(GL_INVALID_ENUM);
    }
    const bool has_matrix = matrix != nullptr || ctx.kind.is_compatibility();
    if (count < 0 || count > max_occlusion_shapes() || !has_matrix) return ctx.raise(GL_INVALID_VALUE);
    const FramebufferInfo framebuffer = draw_framebuffer_info(ctx);
    if (!framebuffer.is_complete) return ctx.raise(GL_INVALID_FRAMEBUFFER_OPERATION);

    need_pixels("a query of the Occlusion Unit");
    ProposedQuery& query = renew_proposed_query(ctx, id, GL_OCCLUSION_UNIT_EMU);
    query.armed = registers;
    query.record_count = count;
    query.has_ended = true;
    ctx.frame.queries_begun++;

    const ListPause pause(ctx);
    if (ctx.time != nullptr) ctx.time->begin_query();
    Matrix current{};
    if (matrix == nullptr) {
        current = current_matrix(ctx);
        matrix = current.data();
    }
    // No command of GL draws past such a query, so there the shapes stay undetermined.
    const bool is_seen = counts_draws(ctx);
    const Shapes shapes{is_seen ? 0 : registers, shape, count, vertices, matrix, ctx.proposed.unit_far_end()};
    const bool draws = !is_seen && draws_fragments(ctx);
    if (draws && !ShapeRun::serves(ctx, registers, framebuffer)) {
        draw_one_by_one(ctx, shapes, query.records);
    } else {
        auto run = std::make_unique<ShapeRun>(shapes);
        if (draws) run->draw(ctx, shapes, framebuffer);
        query.pending = std::move(run);
    }
    if (ctx.time != nullptr) ctx.time->ask_about_shapes(static_cast<std::uint64_t>(count));
    query.due = ctx.clock.due();
}

}  // namespace glext_emu::features
