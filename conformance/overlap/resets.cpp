// SPDX-License-Identifier: MIT
// What resets the one counter: a read of HP's result inside a query does, a refused Begin does not (MIX-09 to
// MIX-12, MIX-17).
#include <functional>

#include "overlap/overlap_test.h"

namespace conformance {
namespace {

class OverlapResets : public OverlapTest {
  protected:
    // Each form of Get, as a function that tells whether the result was TRUE.
    static std::vector<std::function<bool()>> gets() {
        std::vector<std::function<bool()>> all = {
            [] { return read_result(); },
            [] { return get_integer(GL_OCCLUSION_TEST_RESULT_HP) == 1; },
            [] {
                GLfloat value = -1.0f;
                glGetFloatv(GL_OCCLUSION_TEST_RESULT_HP, &value);
                return value == 1.0f;
            },
            [] {
                GLdouble value = -1.0;
                glGetDoublev(GL_OCCLUSION_TEST_RESULT_HP, &value);
                return value == 1.0;
            },
        };
        if (!lacks(32, "GL_ARB_sync")) {
            all.emplace_back([] {
                GLint64 value = -1;
                glGetInteger64v(GL_OCCLUSION_TEST_RESULT_HP, &value);
                return value == 1;
            });
        }
        return all;
    }
};

// MIX-09, MIX-10. NV 6.1.13, of all four Gets: "Whenever such a query is performed, the occlusion test result
// is reset to FALSE and the pixel counter is reset to zero as a side effect." ARB, Dependencies, names
// GetIntegerv alone; decided: every Get.
TEST_P(OverlapResets, reading_the_result_inside_a_query_resets_its_count) {
    const AnyQuery query(way());
    for (const auto& get : gets()) {
        EXPECT_EQ(query.count([&] {
            draw_columns(8);
            EXPECT_TRUE(get());
            draw_columns(2);
        }),
                  way().of(16));
        EXPECT_TRUE(read_result());
    }
}

// MIX-09, MIX-10. Nothing is drawn after the read: nothing is left of the count.
TEST_P(OverlapResets, a_query_whose_count_was_reset_at_its_end_has_counted_nothing) {
    const AnyQuery query(way());
    for (const auto& get : gets()) {
        EXPECT_EQ(query.count([&] {
            draw_columns(8);
            EXPECT_TRUE(get());
        }),
                  0u);
        EXPECT_FALSE(read_result());
    }
}

// MIX-09. Again and again, with the test enabled and disabled.
TEST_P(OverlapResets, only_what_follows_the_last_read_is_in_the_count) {
    const AnyQuery query(way());
    EXPECT_EQ(query.count([] {
        for (int width = 1; width <= 8; ++width) {
            if (width == 4) glEnable(GL_OCCLUSION_TEST_HP);
            if (width == 6) glDisable(GL_OCCLUSION_TEST_HP);
            draw_columns(width);
            EXPECT_TRUE(read_result());
            EXPECT_FALSE(read_result());
        }
        draw_columns(3);
        draw_columns(4);
    }),
              way().of(8 * (3 + 4)));
}

// MIX-11. As above; there was nothing to reset.
TEST_P(OverlapResets, reading_a_false_result_inside_a_query_does_no_harm) {
    const AnyQuery query(way());
    EXPECT_EQ(query.count([] {
        EXPECT_FALSE(read_result());
        draw_columns(8);
    }),
              way().of(64));
    EXPECT_TRUE(read_result());
}

// MIX-12. NV 4.1.6A: at End the counter "is copied into the active occlusion query object's pixel count
// result"; what becomes of the counter is no matter afterwards.
TEST_P(OverlapResets, reading_the_result_after_end_does_not_alter_the_query) {
    const AnyQuery query(way());
    query.begin();
    draw_columns(8);
    query.end();
    EXPECT_TRUE(read_result());
    EXPECT_FALSE(read_result());
    EXPECT_EQ(query.result(), way().of(64));
}

// MIX-17. GL 4.5, 2.3.1: a command that generates an error has no other effect.
TEST_P(OverlapResets, a_refused_begin_resets_neither_count_nor_result) {
    const AnyQuery query(way());
    const AnyQuery other(way());
    EXPECT_EQ(query.count([&] {
        draw_columns(8);
        other.begin();
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
        query.begin();
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
        EXPECT_EQ(active_name(way()), static_cast<GLint>(query.name()));
    }),
              way().of(64));
    EXPECT_TRUE(read_result());

    pass_one_fragment();
    begin(way(), 0);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_TRUE(read_result()) << "a Begin of id 0 reset the result";
}

INSTANTIATE_TEST_SUITE_P(Of, OverlapResets, ::testing::ValuesIn(kWays), way_name);

}  // namespace
}  // namespace conformance
