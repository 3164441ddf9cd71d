// SPDX-License-Identifier: MIT
// How the extension shows itself: both forms of the extension list, in contexts of every API (DISC-01 to
// DISC-10, 18).
#include <algorithm>
#include <set>

#include "hp_occlusion_test/hp_test.h"

namespace conformance {
namespace {

constexpr const char* kHp = "GL_HP_occlusion_test";

class Discovery : public HpTest {};

// DISC-01. Khronos' registry rules: an extension that is supported has its name string in EXTENSIONS.
TEST_F(Discovery, the_string_names_the_extension_exactly_once) {
    const auto names = extensions();
    EXPECT_EQ(std::count(names.begin(), names.end(), kHp), 1);
}

// DISC-04. GL: EXTENSIONS is "a space-separated list of extension names".
TEST_F(Discovery, the_string_is_well_formed) {
    const std::string text = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
    EXPECT_EQ(text.find("  "), std::string::npos) << "two spaces in a row";
    EXPECT_NE(text.front(), ' ');
    for (const std::string& name : extensions()) EXPECT_EQ(name.rfind("GL_", 0), 0u) << name;
    const auto names = extensions();
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size()) << "a doubled name";
}

// DISC-05. GL 4.5, 22.2: GetStringi(EXTENSIONS, i) for i up to NUM_EXTENSIONS - 1; beyond it INVALID_VALUE.
TEST_F(Discovery, the_indexed_list_has_as_many_names_as_it_says) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const auto names = indexed_extensions();
    EXPECT_TRUE(no_error());
    EXPECT_EQ(std::count(names.begin(), names.end(), kHp), 1);
    EXPECT_EQ(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(names.size())), nullptr);
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));

    const auto count = static_cast<GLint>(names.size());
    GLfloat single = 0.0f;
    GLdouble twice = 0.0;
    GLboolean boolean = GL_FALSE;
    glGetFloatv(GL_NUM_EXTENSIONS, &single);
    glGetDoublev(GL_NUM_EXTENSIONS, &twice);
    glGetBooleanv(GL_NUM_EXTENSIONS, &boolean);
    EXPECT_EQ(single, static_cast<GLfloat>(count));
    EXPECT_EQ(twice, static_cast<GLdouble>(count));
    EXPECT_EQ(boolean, GL_TRUE);
    if (lacks(32)) return;
    GLint64 integer = 0;
    glGetInteger64v(GL_NUM_EXTENSIONS, &integer);
    EXPECT_EQ(integer, count);
}

// DISC-06. Two forms of one list.
TEST_F(Discovery, the_indexed_list_holds_the_names_of_the_string) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const auto words = extensions();
    const auto names = indexed_extensions();
    EXPECT_EQ(std::set(words.begin(), words.end()), std::set(names.begin(), names.end()));
}

// DISC-07. GL 4.5, 22.2: GetString returns a pointer to a static string.
TEST_F(Discovery, the_string_stays_where_and_as_it_is) {
    const auto* first = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
    const std::string copy = first;
    {
        const Context other;
        ASSERT_TRUE(other.make_current(surface()));
        EXPECT_TRUE(has_extension(kHp));
    }
    come_back();
    EXPECT_EQ(copy, reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS)));
    EXPECT_EQ(copy, first) << "what the first call returned has changed";
}

// DISC-18. One machine, one list, however the context was asked for.
TEST_F(Discovery, every_compatibility_context_names_the_extension) {
    const auto names = extensions();
    for (const auto& [major, minor] : {std::pair{2, 1}, std::pair{3, 0}, std::pair{4, 5}}) {
        const Context other({.major = major, .minor = minor});
        if (!other) continue;  // a machine of an older GL refuses
        SCOPED_TRACE(major * 10 + minor);
        ASSERT_TRUE(other.make_current(surface()));
        EXPECT_EQ(extensions(), names);
    }
    come_back();
}

class OtherApis : public HpTest {
  protected:
    static void expect_no_desktop_queries() {
        for (const char* name : {kHp, "GL_NV_occlusion_query", "GL_ARB_occlusion_query"}) {
            EXPECT_FALSE(has_extension(name)) << name;
        }
    }
};

// DISC-08, DISC-10. gl.xml: supported="gl" for HP_occlusion_test, NV_occlusion_query and ARB_occlusion_query,
// not "glcore"; GL 4.5, 2.3.1: a token that is not defined generates INVALID_ENUM.
TEST_F(OtherApis, a_core_profile_has_neither_name_nor_tokens) {
    const Context core({.api = Api::kCore, .major = 3, .minor = 2});
    if (!core) GTEST_SKIP() << "no core profile";
    ASSERT_TRUE(core.make_current(surface()));
    expect_no_desktop_queries();

    glEnable(GL_OCCLUSION_TEST_HP);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_FALSE(glIsEnabled(GL_OCCLUSION_TEST_HP));
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    GLboolean result = 0xAA;
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &result);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_EQ(result, 0xAA);
    come_back();
}

// DISC-09. The three are extensions of desktop GL; EXT_occlusion_query_boolean is one of OpenGL ES.
TEST_F(OtherApis, an_es_context_has_neither_name_nor_tokens) {
    EXPECT_FALSE(has_extension("GL_EXT_occlusion_query_boolean")) << "in a desktop context";
    const Context es({.api = Api::kEs2});
    if (!es) GTEST_SKIP() << "no ES context";
    ASSERT_TRUE(es.make_current(surface()));
    expect_no_desktop_queries();

    glEnable(GL_OCCLUSION_TEST_HP);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    GLboolean result = 0xAA;
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &result);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_EQ(result, 0xAA);
    come_back();
}

}  // namespace
}  // namespace conformance
