// SPDX-License-Identifier: MIT
// Names and objects over their life (EXTB-01, EXTB-07, EXTB-08).
#include "ext_occlusion_query_boolean/es_query_test.h"

namespace conformance {
namespace {

class EsObjects : public EsQueryTest {};

INSTANTIATE_TEST_SUITE_P(In, EsObjects, ::testing::Values(2, 3), es_version);

// EXTB-01. The seven commands, each doing what it is for: an address alone proves nothing, GLVND has one for
// any name.
TEST_P(EsObjects, the_seven_commands_work_together) {
    for (const GLenum target : kTargets) {
        std::array<GLuint, 2> names = {0, 0};
        gen_queries(2, names.data());
        EXPECT_NE(names[0], 0u);
        EXPECT_NE(names[0], names[1]);
        EXPECT_FALSE(is_query(names[0])) << "no object is associated with a name before its first begin";
        EXPECT_EQ(current(target), 0);

        begin_query(target, names[0]);
        EXPECT_TRUE(is_query(names[0]));
        EXPECT_EQ(current(target), static_cast<GLint>(names[0]));
        draw_rect(kWhole, kMiddle);
        end_query(target);
        EXPECT_EQ(current(target), 0);
        EXPECT_EQ(get(names[0]), 1u);

        delete_queries(2, names.data());
        EXPECT_FALSE(is_query(names[0]));
        EXPECT_TRUE(no_error());
    }
}

// EXTB-01. "If <id> is zero, or if <id> is a non-zero value that is not the name of a query object,
// IsQueryEXT returns FALSE."
TEST_P(EsObjects, zero_and_unknown_names_are_no_queries) {
    EXPECT_FALSE(is_query(0));
    EXPECT_FALSE(is_query(0x7FFFFFFF));
    EXPECT_TRUE(no_error());
}

// EXTB-07. Issue 3: GenQueries and DeleteQueries while a query is active: "RESOLVED: no error".
TEST_P(EsObjects, names_are_generated_and_deleted_while_a_query_is_active) {
    const GLuint old = new_object();
    const GLuint active = new_name();
    begin_query(kAny, active);
    draw_rect(kWhole, kMiddle);
    const GLuint name = new_name();
    EXPECT_NE(name, 0u);
    delete_queries(1, &old);
    EXPECT_FALSE(is_query(old));
    EXPECT_TRUE(no_error());
    EXPECT_EQ(current(kAny), static_cast<GLint>(active));
    end_query(kAny);
    EXPECT_EQ(get(active), 1u);
}

// EXTB-07. "Unused names in <ids> are silently ignored, as is the value zero."
TEST_P(EsObjects, deleting_what_is_no_name_is_no_error) {
    const GLuint name = new_object();
    const std::array<GLuint, 4> names = {0, name, 0x7FFFFFFF, name};
    delete_queries(static_cast<GLsizei>(names.size()), names.data());
    EXPECT_FALSE(is_query(name));
    EXPECT_TRUE(no_error());
}

// EXTB-08. "If an active query object is deleted its name immediately becomes unused, but the underlying
// object is not deleted until it is no longer active".
TEST_P(EsObjects, deleting_the_active_object_leaves_it_active_until_its_end) {
    const GLuint name = new_name();
    begin_query(kAny, name);
    delete_queries(1, &name);
    EXPECT_FALSE(is_query(name));
    EXPECT_EQ(current(kAny), static_cast<GLint>(name));
    end_query(kAny);
    EXPECT_TRUE(no_error()) << "the query had ended with its name";
    EXPECT_EQ(get(name), kUntouched);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));

    const GLuint next = new_name();
    begin_query(kAny, next);
    end_query(kAny);
    EXPECT_EQ(get(next), 0u);
}

}  // namespace
}  // namespace conformance
