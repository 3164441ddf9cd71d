// SPDX-License-Identifier: MIT
// Labels, groups and messages of KHR_debug, while the HP test runs (XPAR-09).
#include <array>
#include <string>

#include "transparency/transparency_test.h"

namespace conformance {
namespace {

class Debugging : public TransparencyTest {
  protected:
    void SetUp() override {
        TransparencyTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        if (const auto why = lacks(43, "GL_KHR_debug")) GTEST_SKIP() << *why;
    }

    // Work of every kind that the implementation does for the test.
    static void use_the_test() {
        draw_rect({0, 0, 4, 4}, kMiddle);
        EXPECT_TRUE(visible());
        glDisable(GL_OCCLUSION_TEST_HP);
        glEnable(GL_OCCLUSION_TEST_HP);
        draw_rect({0, 0, 4, 4}, kMiddle);
        EXPECT_TRUE(visible());
    }
};

// XPAR-09. KHR_debug, 20.7: a label is the object's until it is deleted.
TEST_F(Debugging, labels_of_the_programs_queries_stay) {
    const Query query;
    EXPECT_EQ(query.count([] {}), 0u);
    glObjectLabel(GL_QUERY, query.name(), -1, "mine");
    use_the_test();
    std::array<GLchar, 16> label{};
    glGetObjectLabel(GL_QUERY, query.name(), static_cast<GLsizei>(label.size()), nullptr, label.data());
    EXPECT_STREQ(label.data(), "mine");
}

// XPAR-09. KHR_debug, 20.6: groups are pushed and popped by the program.
TEST_F(Debugging, groups_are_left_as_they_are) {
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 1, -1, "outer");
    EXPECT_EQ(get_integer(GL_DEBUG_GROUP_STACK_DEPTH), 2);
    use_the_test();
    EXPECT_EQ(get_integer(GL_DEBUG_GROUP_STACK_DEPTH), 2);
    glPopDebugGroup();
    EXPECT_EQ(get_integer(GL_DEBUG_GROUP_STACK_DEPTH), 1);
}

// XPAR-09. KHR_debug, 20.5: the log holds the messages that were generated, in order.
TEST_F(Debugging, the_log_holds_the_programs_messages_only) {
    use_the_test();  // what the driver has to say of the drawing, it says the first time
    glEnable(GL_DEBUG_OUTPUT);
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
    while (glGetDebugMessageLog(1, 0, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr) == 1) {
    }
    const auto say = [](const char* text) {
        glDebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_MARKER, 1, GL_DEBUG_SEVERITY_HIGH, -1,
                             text);
    };
    say("before");
    use_the_test();
    say("after");
    EXPECT_EQ(get_integer(GL_DEBUG_LOGGED_MESSAGES), 2);
    for (const std::string expected : {"before", "after"}) {
        std::array<GLchar, 256> text{};
        EXPECT_EQ(glGetDebugMessageLog(1, static_cast<GLsizei>(text.size()), nullptr, nullptr, nullptr,
                                       nullptr, nullptr, text.data()),
                  1u);
        EXPECT_EQ(expected, text.data());
    }
}

}  // namespace
}  // namespace conformance
