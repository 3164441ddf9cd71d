// SPDX-License-Identifier: MIT
// Contexts of every kind: without errors, robust, for debugging (CTX-14 to CTX-16).
#include <string>

#include "contexts/asking.h"

namespace conformance {
namespace {

class Kinds : public ContextTest {
  protected:
    // Makes a context of a kind current, or says why there is none.
    static std::optional<std::string> make_current(const Context& context, const Surface& surface) {
        if (!context) return "no context of this kind";
        if (!context.make_current(surface)) return "it cannot be made current";
        use_pixel_coordinates();
        return GetParam().why_not();
    }

    void expect_working() const {
        draw_occluder();
        EXPECT_EQ(ask([] { draw_rect({0, 0, 4, 4}, kFar); }), 0u);
        EXPECT_EQ(ask([] { draw_rect({0, 0, 4, 4}, kNear); }), as_told(16));
        glDisable(GL_DEPTH_TEST);
    }
};

INSTANTIATE_TEST_SUITE_P(Each, Kinds, every_way(), way_name);

// CTX-14. KHR_no_error: what is valid works as ever; what is not is undefined, and not tested.
TEST_P(Kinds, a_context_without_errors_answers_what_is_valid) {
    const Context context({.major = 3, .minor = 0, .no_error = true});
    if (const auto why = make_current(context, surface())) GTEST_SKIP() << *why;
    GLint flags = get_integer(GL_CONTEXT_FLAGS);
    EXPECT_TRUE(flags & GL_CONTEXT_FLAG_NO_ERROR_BIT) << "it is not what was asked for";
    expect_working();
}

// CTX-15. KHR_robustness: GetGraphicsResetStatus returns NO_ERROR where the context has not been reset.
TEST_P(Kinds, a_robust_context_is_not_reset_by_queries) {
    const Context context({.robust = true});
    if (const auto why = make_current(context, surface())) GTEST_SKIP() << *why;
    const auto status = reinterpret_cast<PFNGLGETGRAPHICSRESETSTATUSPROC>(
        platform().get_proc_address(lacks(45) ? "glGetGraphicsResetStatusARB" : "glGetGraphicsResetStatus"));
    EXPECT_EQ(status(), static_cast<GLenum>(GL_NO_ERROR));
    expect_working();
    EXPECT_EQ(ask([&] { EXPECT_EQ(status(), static_cast<GLenum>(GL_NO_ERROR)); }), 0u);
    EXPECT_EQ(status(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_TRUE(no_error());
}

void APIENTRY take_message(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* text,
                           const void* taken) {
    *static_cast<std::string*>(const_cast<void*>(taken)) += std::to_string(type) + ": " + text + "\n";
}

// CTX-16. KHR_debug, 20: messages tell of the program's own calls.
TEST_P(Kinds, a_debug_context_has_nothing_to_say_of_valid_queries) {
    const Context context({.debug = true});
    if (const auto why = make_current(context, surface())) GTEST_SKIP() << *why;
    if (const auto why = lacks(43, "GL_KHR_debug")) GTEST_SKIP() << *why;
    expect_working();  // what the driver has to say of the drawing, it says the first time
    std::string messages;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
    glDebugMessageCallback(take_message, &messages);
    expect_working();
    EXPECT_EQ(messages, "");
    // The callback does work.
    glEnable(GL_NONE);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_NE(messages, "");
    glDebugMessageCallback(nullptr, nullptr);
}

}  // namespace
}  // namespace conformance
