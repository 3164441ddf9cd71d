// SPDX-License-Identifier: MIT
// The two forms of the extension list, in contexts of every API (DISC-03 to DISC-09). That a name is there
// which has to be is judged with its extension.
#include <algorithm>
#include <set>

#include "harness/gl_test.h"

namespace conformance {
namespace {

struct Kind {
    const char* name;
    ContextWish wish;
};

class Strings : public GlTest, public ::testing::WithParamInterface<Kind> {
  protected:
    ContextWish wish() const override { return GetParam().wish; }
    void prepare() override {}

    static bool has_string() { return glGetString(GL_EXTENSIONS) || (glGetError(), false); }
};

INSTANTIATE_TEST_SUITE_P(Of, Strings,
                         ::testing::Values(Kind{"compatibility", {}},
                                           Kind{"core", {.api = Api::kCore, .major = 3, .minor = 2}},
                                           Kind{"es", {.api = Api::kEs2}}),
                         [](const auto& kind) { return kind.param.name; });

// DISC-03. NV_occlusion_query, Dependencies: "Requires support for the HP_occlusion_test extension."
TEST_P(Strings, the_nv_query_is_never_named_without_the_hp_test) {
    EXPECT_TRUE(has_extension("GL_HP_occlusion_test") || !has_extension("GL_NV_occlusion_query"));
}

// DISC-04. GL: EXTENSIONS is "a space-separated list of extension names".
TEST_P(Strings, the_string_is_well_formed) {
    if (!has_string()) GTEST_SKIP() << "a core profile has no such string";
    const std::string text = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
    EXPECT_EQ(text.find("  "), std::string::npos) << "two spaces in a row";
    ASSERT_FALSE(text.empty());
    EXPECT_NE(text.front(), ' ');
    const auto names = extensions();
    for (const std::string& name : names) EXPECT_EQ(name.rfind("GL_", 0), 0u) << name;
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size()) << "a doubled name";
}

// DISC-05. GL 4.5, 22.2: GetStringi(EXTENSIONS, i) for i up to NUM_EXTENSIONS - 1; beyond it INVALID_VALUE.
TEST_P(Strings, the_indexed_list_ends_where_it_says) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const auto names = indexed_extensions();
    EXPECT_TRUE(no_error());
    EXPECT_EQ(std::count(names.begin(), names.end(), "(null)"), 0);
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size()) << "a doubled name";
    EXPECT_EQ(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(names.size())), nullptr);
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
}

// DISC-06. Two forms of one list.
TEST_P(Strings, the_indexed_list_holds_the_names_of_the_string) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    if (!has_string()) GTEST_SKIP() << "a core profile has no such string";
    const auto words = extensions();
    const auto names = indexed_extensions();
    EXPECT_EQ(std::set(words.begin(), words.end()), std::set(names.begin(), names.end()));
}

// DISC-07. GL 4.5, 22.2: GetString returns a pointer to a static string.
TEST_P(Strings, the_string_stays_where_and_as_it_is) {
    if (!has_string()) GTEST_SKIP() << "a core profile has no such string";
    const auto* first = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
    const std::string copy = first;
    {
        const Context other(wish());
        ASSERT_TRUE(other.make_current(surface()));
        EXPECT_EQ(copy, reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS)))
            << "in a context of the same kind";
    }
    come_back();
    EXPECT_EQ(copy, reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS)));
    EXPECT_EQ(copy, first) << "what the first call returned has changed";
}

// DISC-08, DISC-09. gl.xml: supported="gl" for the three; EXT_occlusion_query_boolean: "gles2".
TEST_P(Strings, an_extension_is_named_where_the_registry_has_it_only) {
    std::vector<const char*> strangers;
    if (GetParam().wish.api != Api::kEs2) strangers.push_back("GL_EXT_occlusion_query_boolean");
    if (GetParam().wish.api != Api::kCompatibility) {
        strangers.insert(strangers.end(),
                         {"GL_HP_occlusion_test", "GL_NV_occlusion_query", "GL_ARB_occlusion_query"});
    }
    if (GetParam().wish.api == Api::kEs2) {
        strangers.insert(strangers.end(), {"GL_ARB_occlusion_query2", "GL_ARB_conditional_render_inverted"});
    }
    for (const char* name : strangers) EXPECT_FALSE(has_extension(name)) << name;
}

// DISC-10. GL 4.5, 2.3.1: a token that is not defined generates INVALID_ENUM.
TEST_P(Strings, tokens_of_what_is_not_named_are_refused) {
    if (has_extension("GL_HP_occlusion_test")) GTEST_SKIP() << "has them";
    glEnable(GL_OCCLUSION_TEST_HP);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_FALSE(glIsEnabled(GL_OCCLUSION_TEST_HP));
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    GLboolean result = 0xAA;
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &result);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_EQ(result, 0xAA);
    if (has_extension("GL_NV_occlusion_query")) return;
    GLint value = -1;
    glGetIntegerv(GL_PIXEL_COUNTER_BITS_NV, &value);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_EQ(value, -1);
}

}  // namespace
}  // namespace conformance
