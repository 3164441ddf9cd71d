// SPDX-License-Identifier: MIT
// Names of queries that the application picks by hand, as a compatibility context allows: an implementation
// that keeps objects of its own for the occlusion test may not be met there (MIX-23).
#include "overlap/overlap_test.h"

namespace conformance {
namespace {

constexpr GLuint kFirstNames = 16;  // where an implementation's own objects would lie

class NamesByHand : public OverlapTest {
  protected:
    // A test with one draw enabled still, so that whatever the implementation keeps for it is in use.
    static void start_test() {
        glEnable(GL_OCCLUSION_TEST_HP);
        draw_point(0, 0, 0.0f);
    }
};

// MIX-23. ARB 6.1.13: IsQuery "returns TRUE if <id> is the name of a query object", and the application has
// made none.
TEST_P(NamesByHand, no_name_is_a_query_before_the_application_begins_one) {
    start_test();
    for (GLuint name = 1; name < kFirstNames; ++name) {
        EXPECT_FALSE(is_query(way(), name)) << name;
        EXPECT_TRUE(no_error());
        EXPECT_EQ(get(way(), name, GL_QUERY_RESULT), kUntouched);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << name;
    }
    EXPECT_TRUE(read_result());
}

// MIX-23. NV 4.1.6A and ARB 4.1.6A: Begin of an unused name marks it "as used and associated with a new"
// object.
TEST_P(NamesByHand, any_name_can_be_begun_under_the_test) {
    start_test();
    for (GLuint name = 1; name < kFirstNames; ++name) {
        draw_point(0, 0, 0.0f);
        begin(way(), name);
        EXPECT_TRUE(no_error()) << name;
        draw_rect({0, 0, static_cast<int>(name), 1}, 0.0f);
        end(way());
    }
    EXPECT_TRUE(read_result());
    for (GLuint name = 1; name < kFirstNames; ++name) {
        EXPECT_EQ(get(way(), name, GL_QUERY_RESULT), way().of(name));
        EXPECT_TRUE(is_query(way(), name));
    }
    EXPECT_TRUE(no_error());
}

// MIX-23. As above: "Unused names in ids are silently ignored."
TEST_P(NamesByHand, deleting_unused_names_does_not_end_the_test) {
    start_test();
    for (GLuint name = 1; name < kFirstNames; ++name) delete_query(way(), name);
    EXPECT_TRUE(no_error());
    EXPECT_TRUE(read_result());
    draw_point(0, 0, 0.0f);
    glDisable(GL_OCCLUSION_TEST_HP);
    EXPECT_TRUE(read_result());
    EXPECT_TRUE(no_error());
}

// MIX-23. NV and ARB, Errors: End when no query is active.
TEST_P(NamesByHand, the_test_is_no_query_that_could_be_ended) {
    start_test();
    EXPECT_EQ(active_name(way()), 0);
    end(way());
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glDisable(GL_OCCLUSION_TEST_HP);
    EXPECT_TRUE(read_result()) << "an End of the application's ended the test";
}

// MIX-23. GL 4.5, 2.3.1: the flag keeps the first error, whoever in the implementation found it.
TEST_P(NamesByHand, errors_of_queries_under_the_test_keep_their_order) {
    start_test();
    end(way());          // INVALID_OPERATION: the application has none active
    glLineWidth(-1.0f);  // INVALID_VALUE
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_TRUE(no_error());

    glLineWidth(-1.0f);
    end(way());
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    EXPECT_TRUE(no_error());
}

// MIX-23. The names that an implementation uses are found and taken by the application, one by one, while the
// test is in use: it gives way, and loses nothing that it has counted.
TEST_P(NamesByHand, the_test_goes_on_while_the_application_takes_every_name) {
    glEnable(GL_OCCLUSION_TEST_HP);
    for (GLuint name = 1; name < kFirstNames; ++name) {
        begin(way(), name);
        end(way());
        draw_point(0, 0, 0.0f);
        EXPECT_TRUE(is_query(way(), name));
        EXPECT_TRUE(read_result()) << name;
        EXPECT_EQ(get(way(), name, GL_QUERY_RESULT), 0u) << "the test counted into the application's object";
    }
    for (GLuint name = 1; name < kFirstNames; ++name) {
        draw_point(0, 0, 0.0f);
        delete_query(way(), name);
        EXPECT_FALSE(is_query(way(), name));
        EXPECT_TRUE(read_result()) << name;
    }
    EXPECT_TRUE(no_error());
}

INSTANTIATE_TEST_SUITE_P(Of, NamesByHand, ::testing::ValuesIn(kWays), way_name);

}  // namespace
}  // namespace conformance
