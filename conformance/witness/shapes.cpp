// SPDX-License-Identifier: MIT
// The parallel form against the sequential one: the same triangles, drawn one face at a time.
//
// Vertices and matrices are small binary fractions, so that every way to transform them gives the same
// positions, bit by bit. The text leaves it open which diagonal splits a face of a box: then each face is
// drawn with either, and what the unit says has to lie in what they give, which is one number except where
// the two round differently.
#include <algorithm>
#include <cstdint>

#include "witness/instances.h"
#include "witness/scene_test.h"

namespace conformance {
namespace {

using Point = std::array<GLfloat, 3>;
using Face = std::array<Point, 4>;
using Matrix = std::array<GLfloat, 16>;

constexpr std::array<GLenum, 3> kShapes = {GL_BOX_EMU, GL_HEXAHEDRON_EMU, GL_QUAD_EMU};
constexpr int kMostShapes = 6;

// Corners of a hexahedron: bit 0 is x, bit 1 y, bit 2 z. Counter-clockwise from outside.
constexpr std::array<std::array<std::size_t, 4>, 6> kFaces = {
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

GLfloat fraction(Random& random, int lowest, int highest) {
    return static_cast<GLfloat>(random.integer(lowest, highest)) / 64.0f;
}

Point random_point(Random& random) {
    Point point{};
    for (GLfloat& part : point) part = fraction(random, -80, 80);
    return point;
}

Matrix random_matrix(Random& random) {
    Matrix matrix{};
    for (std::size_t column = 0; column < 3; ++column) {
        for (std::size_t row = 0; row < 3; ++row) {
            matrix[4 * column + row] =
                row == column ? 0.75f : 0.25f * static_cast<GLfloat>(random.integer(-1, 1));
        }
        matrix[12 + column] = fraction(random, -16, 16);
    }
    if (random.chance(40)) matrix[11] = 0.25f;  // w grows with z
    matrix[15] = 1.0f + 0.25f * static_cast<GLfloat>(random.below(2));
    return matrix;
}

struct Shape {
    std::vector<GLfloat> vertices;  // as the command takes them
    std::vector<Face> faces;
};

Shape random_shape(Random& random, GLenum kind) {
    Shape shape;
    const auto put = [&](const Point& point) {
        shape.vertices.insert(shape.vertices.end(), point.begin(), point.end());
    };
    const Point origin = random_point(random);
    if (kind == GL_QUAD_EMU) {
        Face face{};
        for (Point& corner : face) put(corner = random_point(random));
        shape.faces = {face};
        return shape;
    }
    // A parallelepiped, whose faces are even; of a box, along the axes.
    std::array<Point, 3> edges{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t part = 0; part < 3; ++part) {
            const GLfloat sideways = kind == GL_BOX_EMU ? 0.0f : fraction(random, -16, 16);
            edges[axis][part] = part == axis ? fraction(random, 8, 64) : sideways;
        }
    }
    std::array<Point, 8> corners{};
    for (std::size_t corner = 0; corner < 8; ++corner) {
        corners[corner] = origin;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t part = 0; part < 3; ++part) {
                if (corner >> axis & 1) corners[corner][part] += edges[axis][part];
            }
        }
        if (kind == GL_HEXAHEDRON_EMU || corner == 0 || corner == 7) put(corners[corner]);
    }
    for (const auto& face : kFaces) {
        shape.faces.push_back({corners[face[0]], corners[face[1]], corners[face[2]], corners[face[3]]});
    }
    return shape;
}

// The range of what either diagonal of every face gives; bounds of hits are sums, of the box and depth
// extremes.
struct Bounds {
    std::array<std::uint64_t, 2> projected{};
    std::array<std::uint64_t, 2> visible{};
    std::array<float, 2> nearest{};  // the nearer, the less near
};

class ShapeScenes : public SceneTest {
  protected:
    void SetUp() override {
        if (!machine().has_unit) GTEST_SKIP() << "needs GL_EMU_occlusion_unit";
        make_scene(1'000'000);
    }

    // All of the first draw's state; or what of it applies to shapes, alone.
    void apply_whole() { apply(scene().draws()[0].pipeline(), scene().draws()[0].settings()); }
    void apply_what_counts() {
        Pipeline pipeline = scene().draws()[0].pipeline();
        pipeline.stages = Stages::kFixed;
        pipeline.writes_depth = false;
        pipeline.stencil_mask = 0;
        pipeline.writes_colour = false;
        pipeline.alpha_function = GL_ALWAYS;
        pipeline.polygon_mode = GL_FILL;
        pipeline.has_alpha_to_coverage = pipeline.is_clipped = pipeline.is_stippled = false;
        apply(pipeline, scene().draws()[0].settings());
    }

    // What is drawn lies in the unit's query.
    GLocclusionrecordEMU face_record(const Face& face, bool turned) {
        const std::size_t a = turned ? 1 : 0;
        const UnitQuery query;
        query.begin();
        glBegin(GL_TRIANGLES);
        for (const std::size_t corner : {a, a + 1, a + 2, a, a + 2, a + 3})
            glVertex3fv(face[corner % 4].data());
        glEnd();
        query.end();
        return query.records().front();
    }
};

bool is_empty(const std::array<int, 4>& box) {
    return box[2] < box[0];
}

std::array<int, 4> joined(const std::array<int, 4>& one, const std::array<int, 4>& other) {
    if (is_empty(one)) return other;
    if (is_empty(other)) return one;
    return {std::min(one[0], other[0]), std::min(one[1], other[1]), std::max(one[2], other[2]),
            std::max(one[3], other[3])};
}

// Record i of a call is the record of shape i drawn alone, its writes off.
TEST_P(ShapeScenes, records_of_one_call_are_those_of_the_faces_drawn) {
    Random random(static_cast<std::uint64_t>(GetParam()) + 2'000'000);
    const GLenum kind = random.one_of(kShapes);
    const Matrix matrix = random_matrix(random);
    const bool is_of_the_context = random.chance(30);
    std::vector<Shape> shapes;
    std::vector<GLfloat> vertices;
    for (int count = random.integer(1, kMostShapes); count > 0; --count) {
        shapes.push_back(random_shape(random, kind));
        vertices.insert(vertices.end(), shapes.back().vertices.begin(), shapes.back().vertices.end());
    }
    const auto load = [](const Matrix& loaded) {
        glMatrixMode(GL_PROJECTION);
        glLoadMatrixf(loaded.data());
        glMatrixMode(GL_MODELVIEW);
    };
    scene().start();
    set_far_end(scene().far_end());
    if (is_of_the_context) load(matrix);
    apply_whole();
    const UnitQuery query;
    query.ask_shapes(kind, static_cast<GLsizei>(shapes.size()), vertices.data(),
                     is_of_the_context ? nullptr : matrix.data());
    const auto records = query.records(static_cast<GLsizei>(shapes.size()));
    ASSERT_TRUE(no_error());

    load(matrix);
    const bool is_far_one = scene().far_end() == GL_ONE;
    const float far = is_far_one ? 1.0f : 0.0f;
    const auto nearer = [&](float a, float b) { return is_far_one ? std::min(a, b) : std::max(a, b); };
    const auto farther = [&](float a, float b) { return is_far_one ? std::max(a, b) : std::min(a, b); };
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        SCOPED_TRACE("shape " + std::to_string(i) + " of " + std::to_string(shapes.size()) + ", kind " +
                     std::to_string(kind));
        neutral();
        scene().target().bind();
        apply_what_counts();
        Bounds low_high;
        low_high.nearest = {far, far};
        GLbitfield determined = records[i].registers;
        std::array<int, 4> box = {0, 0, -1, -1};
        for (const Face& face : shapes[i].faces) {
            const GLocclusionrecordEMU one = face_record(face, false);
            // A quadrilateral's diagonal is stated.
            const GLocclusionrecordEMU other = kind == GL_QUAD_EMU ? one : face_record(face, true);
            determined &= one.registers;
            low_high.projected[0] += std::min(one.projected_hits, other.projected_hits);
            low_high.projected[1] += std::max(one.projected_hits, other.projected_hits);
            low_high.visible[0] += std::min(one.visible_hits, other.visible_hits);
            low_high.visible[1] += std::max(one.visible_hits, other.visible_hits);
            low_high.nearest[0] = nearer(low_high.nearest[0], nearer(one.nearest_depth, other.nearest_depth));
            low_high.nearest[1] =
                nearer(low_high.nearest[1], farther(one.nearest_depth, other.nearest_depth));
            box = joined(box, box_of(one));
        }
        const GLocclusionrecordEMU& record = records[i];
        EXPECT_GE(record.projected_hits, low_high.projected[0]);
        EXPECT_LE(record.projected_hits, low_high.projected[1]);
        EXPECT_GE(record.visible_hits, low_high.visible[0]);
        EXPECT_LE(record.visible_hits, low_high.visible[1]);
        EXPECT_EQ(record.visible, record.visible_hits != 0 ? 1u : 0u);
        if (determined & GL_SCREEN_BOX_BIT_EMU) {
            EXPECT_EQ(box_of(record), box);
        }
        if (determined & GL_NEAREST_DEPTH_BIT_EMU) {
            EXPECT_EQ(nearer(record.nearest_depth, low_high.nearest[0]), low_high.nearest[0]);
            EXPECT_EQ(farther(record.nearest_depth, low_high.nearest[1]), low_high.nearest[1]);
        }
    }
}

PLAY_ON_FOUR_MACHINES(ShapeScenes, 15, 150);

}  // namespace
}  // namespace conformance
