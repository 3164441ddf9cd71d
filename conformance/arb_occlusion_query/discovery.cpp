// SPDX-License-Identifier: MIT
// Where the commands come from: pointers, suffixes and the other APIs (DISC-08, DISC-09, DISC-14 to DISC-17).
#include "arb_occlusion_query/arb_test.h"

namespace conformance {
namespace {

template <typename Function>
Function address_of(const char* name) {
    return reinterpret_cast<Function>(platform().get_proc_address(name));
}

// The commands under one suffix, as an application that loads them sees them.
struct Commands {
    explicit Commands(const std::string& suffix)
        : gen(address_of<PFNGLGENQUERIESPROC>(("glGenQueries" + suffix).c_str())),
          remove(address_of<PFNGLDELETEQUERIESPROC>(("glDeleteQueries" + suffix).c_str())),
          is(address_of<PFNGLISQUERYPROC>(("glIsQuery" + suffix).c_str())),
          begin(address_of<PFNGLBEGINQUERYPROC>(("glBeginQuery" + suffix).c_str())),
          end(address_of<PFNGLENDQUERYPROC>(("glEndQuery" + suffix).c_str())),
          get(address_of<PFNGLGETQUERYIVPROC>(("glGetQueryiv" + suffix).c_str())),
          get_signed(address_of<PFNGLGETQUERYOBJECTIVPROC>(("glGetQueryObjectiv" + suffix).c_str())),
          get_unsigned(address_of<PFNGLGETQUERYOBJECTUIVPROC>(("glGetQueryObjectuiv" + suffix).c_str())) {}

    PFNGLGENQUERIESPROC gen;
    PFNGLDELETEQUERIESPROC remove;
    PFNGLISQUERYPROC is;
    PFNGLBEGINQUERYPROC begin;
    PFNGLENDQUERYPROC end;
    PFNGLGETQUERYIVPROC get;
    PFNGLGETQUERYOBJECTIVPROC get_signed;
    PFNGLGETQUERYOBJECTUIVPROC get_unsigned;
};

void expect_working(const Commands& one, const Commands& other) {
    GLuint name = 0;
    one.gen(1, &name);
    other.begin(GL_SAMPLES_PASSED, name);
    GLint current = -1;
    one.get(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &current);
    EXPECT_EQ(current, static_cast<GLint>(name));
    draw_samples(42);
    one.end(GL_SAMPLES_PASSED);
    GLuint count = kUntouched;
    GLint signed_count = -1;
    other.get_unsigned(name, GL_QUERY_RESULT, &count);
    one.get_signed(name, GL_QUERY_RESULT, &signed_count);
    EXPECT_EQ(count, 42u);
    EXPECT_EQ(signed_count, 42);
    EXPECT_TRUE(other.is(name));
    other.remove(1, &name);
    EXPECT_FALSE(one.is(name));
    EXPECT_TRUE(no_error());
}

class QueryDiscovery : public ArbTest {};

// DISC-16. gl.xml: glGenQueriesARB and its seven fellows are aliases of the core commands.
TEST_F(QueryDiscovery, the_suffixed_and_the_core_names_are_the_same_commands) {
    if (const auto why = lacks(15)) GTEST_SKIP() << *why;
    const Commands core("");
    const Commands arb("ARB");
    expect_working(core, core);
    expect_working(arb, arb);
    expect_working(core, arb);
    expect_working(arb, core);
}

// DISC-14. GLX and EGL_KHR_get_all_proc_addresses: the address does not depend on a current context.
TEST_F(QueryDiscovery, an_address_from_before_any_context_was_current_works) {
    Context::release_current();
    const Commands early("ARB");
    come_back();
    expect_working(early, early);
}

// DISC-15. As above.
TEST_F(QueryDiscovery, an_address_from_one_context_works_in_another) {
    const Commands here("ARB");
    expect_working(here, here);
    const Context other;
    ASSERT_TRUE(other.make_current(surface()));
    use_pixel_coordinates();
    expect_working(here, here);
    come_back();
}

// DISC-17. gl.xml: glBeginConditionalRenderNV is an alias of the core command, as are both forms of End.
TEST_F(QueryDiscovery, the_names_of_conditional_rendering_are_the_same_commands) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const auto begin_nv = address_of<PFNGLBEGINCONDITIONALRENDERNVPROC>("glBeginConditionalRenderNV");
    const auto end_nv = address_of<PFNGLENDCONDITIONALRENDERNVPROC>("glEndConditionalRenderNV");
    const Query query;
    EXPECT_EQ(query.count([] {}), 0u);
    begin_nv(query.name(), GL_QUERY_WAIT);
    draw_rect(kWhole, kMiddle);
    glEndConditionalRender();
    EXPECT_EQ(drawn_pixels(), 0);
    glBeginConditionalRender(query.name(), GL_QUERY_WAIT);
    draw_rect(kWhole, kMiddle);
    end_nv();
    EXPECT_EQ(drawn_pixels(), 0);
    draw_rect(kWhole, kMiddle);
    EXPECT_EQ(drawn_pixels(), kWhole.area());
    EXPECT_TRUE(no_error());
}

// DISC-08. gl.xml: ARB_occlusion_query is supported="gl", not "glcore": a core profile has its commands by
// version.
TEST_F(QueryDiscovery, a_core_profile_has_the_commands_but_not_the_name) {
    const Context core({.api = Api::kCore, .major = 3, .minor = 2});
    if (!core) GTEST_SKIP() << "no core profile";
    ASSERT_TRUE(core.make_current(surface()));
    EXPECT_FALSE(has_extension("GL_ARB_occlusion_query"));
    const Query query;
    EXPECT_EQ(query.count([] {}), 0u);
    EXPECT_TRUE(no_error());
    come_back();
}

// DISC-09.
TEST_F(QueryDiscovery, an_es_context_has_not_the_name) {
    const Context es({.api = Api::kEs2});
    if (!es) GTEST_SKIP() << "no ES context";
    ASSERT_TRUE(es.make_current(surface()));
    EXPECT_FALSE(has_extension("GL_ARB_occlusion_query"));
    come_back();
}

}  // namespace
}  // namespace conformance
