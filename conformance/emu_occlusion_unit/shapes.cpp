// SPDX-License-Identifier: MIT
// 17.3.5.3: shapes: what each holds, where it is drawn, one record for each.
#include <algorithm>
#include <random>

#include "emu_occlusion_unit/unit_test.h"

namespace conformance {
namespace {

class UnitShapes : public UnitTest {
  protected:
    static std::vector<Record> ask_shapes(GLbitfield registers, GLenum shape,
                                          const std::vector<GLfloat>& vertices, std::size_t count,
                                          const GLfloat* matrix = nullptr) {
        const Query query;
        unit_shapes(registers, shape, static_cast<GLsizei>(count), vertices.data(), matrix, query.name());
        EXPECT_EQ(get_unit(query.name(), GL_RECORD_COUNT_EMU), count);
        std::vector<Record> records(count);
        get_records(query.name(), 0, static_cast<GLsizei>(count), records.data());
        EXPECT_TRUE(no_error());
        return records;
    }
};

// The eight corners of a box: bit 0 of their number is x, bit 1 y, bit 2 z.
std::vector<GLfloat> corners_of(const std::array<GLfloat, 6>& box) {
    std::vector<GLfloat> corners;
    for (std::size_t k = 0; k < 8; ++k) {
        for (std::size_t axis = 0; axis < 3; ++axis) corners.push_back(box[axis + 3 * (k >> axis & 1)]);
    }
    return corners;
}

std::vector<GLfloat> quad_of(const Rect& rect, float depth) {
    const auto left = static_cast<GLfloat>(rect.x);
    const auto bottom = static_cast<GLfloat>(rect.y);
    const auto right = static_cast<GLfloat>(rect.x + rect.width);
    const auto top = static_cast<GLfloat>(rect.y + rect.height);
    return {left, bottom, depth, right, bottom, depth, right, top, depth, left, top, depth};
}

// A box seen straight on shows its two faces across the view: each pixel twice.
constexpr std::array<GLfloat, 6> kStraightBox = {8, 8, kFar, 56, 24, 0.875f};
const Seen kBothFaces = {
    .projected = 2 * 768, .visible = 2 * 384, .nearest = kFar, .box = {kHalf, 8, 55, 23}};

TEST_F(UnitShapes, a_quad_is_two_triangles) {
    draw_left_occluder();
    const auto records = ask_shapes(kAllRegisters, GL_QUAD_EMU, quad_of(kHalfHiddenRect, kFar), 1);
    expect_record(records[0], kAllRegisters, kHalfHidden);
}

TEST_F(UnitShapes, a_box_is_both_sides_of_six_faces) {
    draw_left_occluder();
    const std::vector<GLfloat> box(kStraightBox.begin(), kStraightBox.end());
    expect_record(ask_shapes(kAllRegisters, GL_BOX_EMU, box, 1)[0], kAllRegisters, kBothFaces);
}

TEST_F(UnitShapes, a_hexahedron_has_its_corners_by_bits) {
    draw_left_occluder();
    expect_record(ask_shapes(kAllRegisters, GL_HEXAHEDRON_EMU, corners_of(kStraightBox), 1)[0], kAllRegisters,
                  kBothFaces);
    // Corner 7 alone comes nearer: no other kind of shape tells it from the others.
    auto corners = corners_of(kStraightBox);
    corners[3 * 7 + 2] = kNear;
    const auto record = ask_shapes(kAllRegisters, GL_HEXAHEDRON_EMU, corners, 1)[0];
    EXPECT_LT(record.nearest_depth, kFar);
    EXPECT_GT(record.nearest_depth, kNear);
}

// "Record i is what a query ... holds after nothing but shape i was drawn in it": the face of a turned box.
TEST_F(UnitShapes, each_of_the_six_faces_is_there) {
    glEnable(GL_DEPTH_TEST);
    const std::array<GLfloat, 6> cube = {8, 8, 0.25f, 24, 24, 0.75f};
    for (int axis = 0; axis < 3; ++axis) {
        SCOPED_TRACE(axis);
        glLoadIdentity();
        // Turns <axis> into the line of sight, by exchanging it with z in units of 64 pixels.
        std::array<GLfloat, 16> turn = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
        if (axis != 2) {
            const auto a = static_cast<std::size_t>(axis);
            turn[5 * a] = 0;
            turn[10] = 0;
            turn[4 * a + 2] = 1.0f / 64.0f;
            turn[8 + a] = 64.0f;
        }
        glMultMatrixf(turn.data());
        const std::vector<GLfloat> box(cube.begin(), cube.end());
        const Record record = ask_shapes(kAllRegisters, GL_BOX_EMU, box, 1)[0];
        const int extent = axis == 2 ? 16 : 32;  // 0.25 to 0.75 is 16 to 48 pixels
        EXPECT_EQ(record.projected_hits, static_cast<GLuint64>(2 * 16 * extent));
        EXPECT_EQ(record.visible_hits, static_cast<GLuint64>(2 * 16 * extent)) << "depths are not written";
        EXPECT_NEAR(record.nearest_depth, axis == 2 ? 0.25f : 0.125f, kDepthStep24);
    }
    glLoadIdentity();
}

// "as two triangles, (a, b, c) and (a, c, d)": the fold of a quad that is not flat runs from a to c.
TEST_F(UnitShapes, a_quad_is_folded_from_its_first_corner_to_its_third) {
    draw_occluder();
    glEnable(GL_SCISSOR_TEST);
    glScissor(30, 30, 4, 4);
    auto corners = quad_of({16, 16, 32, 32}, kNear);
    corners[3 * 1 + 2] = kFar;
    corners[3 * 3 + 2] = kFar;
    EXPECT_EQ(ask_shapes(GL_VISIBLE_HITS_BIT_EMU, GL_QUAD_EMU, corners, 1)[0].visible_hits, 16u);
    corners = quad_of({16, 16, 32, 32}, kFar);
    corners[3 * 1 + 2] = kNear;
    corners[3 * 3 + 2] = kNear;
    EXPECT_EQ(ask_shapes(GL_VISIBLE_HITS_BIT_EMU, GL_QUAD_EMU, corners, 1)[0].visible_hits, 0u);
    glDisable(GL_SCISSOR_TEST);
}

// "puts as many records into <id>, in their order"; each starts from nothing, and sees no other's depth.
TEST_F(UnitShapes, each_shape_has_a_record_of_its_own_in_their_order) {
    draw_left_occluder();
    std::vector<GLfloat> vertices;
    std::vector<Seen> expected;
    for (int i = 0; i < 40; ++i) {
        const Rect rect = {i, i % 5, 8 + i % 7, 4};
        const float depth = i % 2 == 0 ? kNear : kFar;
        const auto quad = quad_of(rect, depth);
        vertices.insert(vertices.end(), quad.begin(), quad.end());
        const int left = depth < kMiddle ? rect.x : std::max(rect.x, kHalf);
        const int width = std::min(rect.x + rect.width, kSize) - left;
        const auto projected = static_cast<GLuint64>(4 * (std::min(rect.x + rect.width, kSize) - rect.x));
        expected.push_back(width > 0 ? seen(projected, {left, rect.y, width, 4}, depth) : hidden(projected));
    }
    const auto records = ask_shapes(kAllRegisters, GL_QUAD_EMU, vertices, expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        SCOPED_TRACE(i);
        expect_record(records[i], kAllRegisters, expected[i]);
    }
}

TEST_F(UnitShapes, registers_of_shapes_are_armed_one_by_one) {
    draw_left_occluder();
    const auto quad = quad_of(kHalfHiddenRect, kFar);
    for (GLbitfield armed = 1; armed <= kAllRegisters; ++armed) {
        SCOPED_TRACE(armed);
        expect_record(ask_shapes(armed, GL_QUAD_EMU, quad, 1)[0], armed, kHalfHidden);
    }
}

// Records are read in part, and the first by GetQueryObject.
TEST_F(UnitShapes, some_of_the_records_can_be_read) {
    draw_left_occluder();
    std::vector<GLfloat> vertices;
    for (int i = 0; i < 4; ++i) {
        const auto quad = quad_of({40, 8, 1 + i, 1}, kNear);
        vertices.insert(vertices.end(), quad.begin(), quad.end());
    }
    const Query query;
    unit_shapes(kAllRegisters, GL_QUAD_EMU, 4, vertices.data(), nullptr, query.name());
    std::array<Record, 3> records{};
    records[2].visible = kUntouched;
    get_records(query.name(), 2, 2, records.data());
    EXPECT_EQ(records[0].visible_hits, 3u);
    EXPECT_EQ(records[1].visible_hits, 4u);
    EXPECT_EQ(records[2].visible, kUntouched);
    EXPECT_EQ(get_unit(query.name(), GL_QUERY_RESULT), 1u);
    Record none = kUnwritten;
    get_records(query.name(), 3, 2, &none);
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    EXPECT_EQ(none.visible, kUntouched);
}

TEST_F(UnitShapes, no_shapes_make_no_records) {
    const Query query;
    unit_shapes(kAllRegisters, GL_BOX_EMU, 0, nullptr, nullptr, query.name());
    EXPECT_TRUE(no_error());
    EXPECT_EQ(get_unit(query.name(), GL_RECORD_COUNT_EMU), 0u);
    Record none{};
    get_records(query.name(), 0, 0, &none);
    EXPECT_TRUE(no_error());
    get_records(query.name(), 0, 1, &none);
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
}

// "<matrix> ... takes a point (x, y, z, 1) to clip coordinates. If it is NULL, the product of the current
// projection and modelview matrices is used."
TEST_F(UnitShapes, a_matrix_takes_the_place_of_the_current_ones) {
    draw_left_occluder();
    const std::vector<GLfloat> unit_square = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    // The square onto the rectangle of draw_half_hidden, at w = 2; a row of the result is every fourth
    // number.
    const std::array<GLfloat, 16> matrix = {3.0f, 0, 0, 0, 0,     1.0f,  0,    0,
                                            0,    0, 1, 0, -1.5f, -1.5f, 1.0f, 2.0f};
    expect_record(ask_shapes(kAllRegisters, GL_QUAD_EMU, unit_square, 1, matrix.data())[0], kAllRegisters,
                  kHalfHidden);
    glTranslatef(8.0f, 8.0f, kFar);
    glScalef(48.0f, 16.0f, 1.0f);
    expect_record(ask_shapes(kAllRegisters, GL_QUAD_EMU, unit_square, 1)[0], kAllRegisters, kHalfHidden);
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glLoadIdentity();
    expect_record(ask_shapes(kAllRegisters, GL_QUAD_EMU, unit_square, 1, matrix.data())[0], kAllRegisters,
                  kHalfHidden);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

// 17.3.5.3: records are those of queries of the unit. All numbers are sums of powers of two, so that both
// ways take the corners to the same places; how a face is cut in two is open, and so is the last step of a
// depth.
TEST_F(UnitShapes, records_are_those_of_queries_that_draw_the_same_boxes) {
    draw_left_occluder();
    draw_rect({40, 30, 20, 20}, 0.625f);
    glDepthMask(GL_FALSE);
    std::mt19937 random(4711);
    const auto between = [&](int low, int high) {
        return static_cast<GLfloat>(low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1)));
    };
    const std::array<GLfloat, 16> shear = {1, 0.25f, 0.00390625f, 0, -0.5f, 1, -0.001953125f, 0, 8, -4,
                                           1, 0,     0,           0, 0,     1};
    glLoadMatrixf(shear.data());
    constexpr std::size_t kBoxes = 24;
    std::vector<GLfloat> boxes;
    for (std::size_t i = 0; i < kBoxes; ++i) {
        // Inside the view volume: clipping makes corners that are no such sums.
        const std::array<GLfloat, 3> low = {between(28 * 4, 40 * 4) / 4, between(4 * 4, 32 * 4) / 4,
                                            between(32, 80) / 128};
        boxes.insert(boxes.end(), low.begin(), low.end());
        boxes.push_back(low[0] + between(4, 40) / 4);
        boxes.push_back(low[1] + between(4, 40) / 4);
        boxes.push_back(low[2] + between(1, 12) / 128);
    }
    const auto records = ask_shapes(kAllRegisters, GL_BOX_EMU, boxes, kBoxes);
    std::size_t visible = 0;
    for (std::size_t i = 0; i < kBoxes; ++i) {
        SCOPED_TRACE(i);
        std::array<GLfloat, 6> box{};
        std::copy_n(boxes.begin() + static_cast<std::ptrdiff_t>(6 * i), 6, box.begin());
        const auto corners = corners_of(box);
        const Record drawn = ask(kAllRegisters, [&] {
            glBegin(GL_QUADS);
            for (const std::size_t k :
                 {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5}) {
                glVertex3fv(corners.data() + 3 * k);
            }
            glEnd();
        });
        EXPECT_EQ(records[i].projected_hits, drawn.projected_hits);
        EXPECT_EQ(records[i].visible_hits, drawn.visible_hits);
        EXPECT_NEAR(records[i].nearest_depth, drawn.nearest_depth, kDepthStep24);
        EXPECT_TRUE(std::ranges::equal(records[i].box, drawn.box));
        EXPECT_GT(drawn.projected_hits, 0u);
        visible += drawn.visible;
    }
    EXPECT_GT(visible, 4u);
    glLoadIdentity();
    glDepthMask(GL_TRUE);
}

}  // namespace
}  // namespace conformance
