// SPDX-License-Identifier: MIT
// GL_NVX_conditional_render, the extension before the extension (NVX-01 to NVX-03).
#include <dlfcn.h>

#include "nv_conditional_render/conditional_test.h"

namespace conformance {
namespace {

class Nvx : public ConditionalTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(ConditionalTest::SetUp());
        if (IsSkipped()) return;
        if (const auto why = lacks("GL_NVX_conditional_render")) GTEST_SKIP() << *why;
        begin_ = reinterpret_cast<Begin>(platform().get_proc_address("glBeginConditionalRenderNVX"));
        end_ = reinterpret_cast<End>(platform().get_proc_address("glEndConditionalRenderNVX"));
        ASSERT_NE(begin_, nullptr);
        ASSERT_NE(end_, nullptr);
    }

    void begin(const Query& query) const { begin_(query.name()); }
    void begin(GLuint name) const { begin_(name); }
    void end() const { end_(); }

    using Begin = void (*)(GLuint);
    using End = void (*)();

  private:
    Begin begin_ = nullptr;
    End end_ = nullptr;
};

// NVX-01. NV_conditional_render, Dependencies on NVX_conditional_render: "glBeginConditionalRenderNVX(id);
// glEndConditionalRenderNVX(); are equivalent to [...] glBeginConditionalRenderNV(id, QUERY_WAIT_NV);
// glEndConditionalRenderNV();"
TEST_F(Nvx, both_commands_do_as_their_successors_with_wait) {
    for (const auto outcome : {Answered::kHidden, Answered::kVisible}) {
        const int all = outcome == Answered::kVisible ? kWhole.area() : 0;
        const Query query;
        query.begin();
        Answered::draw(outcome);
        query.end();
        clear();
        begin(query);
        draw_rect(kWhole, kNear);
        end();
        EXPECT_EQ(drawn_pixels(), all);

        clear();
        begin(query);
        draw_rect(kWhole, kNear);
        glEndConditionalRender();
        EXPECT_EQ(drawn_pixels(), all) << "ended by the successor";

        clear();
        glBeginConditionalRender(query.name(), GL_QUERY_WAIT);
        draw_rect(kWhole, kNear);
        end();
        EXPECT_EQ(drawn_pixels(), all) << "begun by the successor";
        EXPECT_TRUE(no_error());
    }
    draw_rect(kWhole, kNear);
    EXPECT_EQ(drawn_pixels(), kWhole.area());
}

// NVX-02. The errors of NV_conditional_render, whose text is the later one.
TEST_F(Nvx, the_errors_are_those_of_the_successors) {
    const Answered hidden(Answered::kHidden);
    const Query generated;
    end();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "no block";
    for (const GLuint name : {GLuint{0}, GLuint{0x7000}, generated.name()}) {
        begin(name);
        EXPECT_TRUE(error_is(GL_INVALID_VALUE)) << name;
    }
    const Query primitives(GL_PRIMITIVES_GENERATED);
    primitives.count([] {});
    begin(primitives);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "of another target";
    const Query active;
    active.begin();
    begin(active);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "active";
    active.end();
    begin(hidden);
    begin(hidden);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "two at once";
    end();
    EXPECT_TRUE(no_error());
}

// NVX-02. NV_conditional_render: any occlusion target; NVX knew SAMPLES_PASSED alone.
TEST_F(Nvx, boolean_queries_are_accepted_as_by_the_successor) {
    if (const auto why = lacks(33, "GL_ARB_occlusion_query2")) GTEST_SKIP() << *why;
    const Answered visible(Answered::kVisible, GL_ANY_SAMPLES_PASSED);
    const Query nothing(GL_ANY_SAMPLES_PASSED);
    EXPECT_EQ(nothing.count([] {}), 0u);
    begin(nothing);
    draw_rect({0, 0, 10, 10}, kNear);
    end();
    EXPECT_EQ(drawn_pixels(), 0);
    begin(visible);
    draw_rect({0, 0, 10, 10}, kNear);
    end();
    EXPECT_EQ(drawn_pixels(), 100);
}

// NVX-03. glvnd's libGL exports both names, and they lead to the same commands.
TEST_F(Nvx, both_names_are_exported_by_libgl) {
    void* const library = dlopen("libGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!library) GTEST_SKIP() << "no libGL.so.1";
    const auto exported_begin = reinterpret_cast<Begin>(dlsym(library, "glBeginConditionalRenderNVX"));
    const auto exported_end = reinterpret_cast<End>(dlsym(library, "glEndConditionalRenderNVX"));
    ASSERT_NE(exported_begin, nullptr);
    ASSERT_NE(exported_end, nullptr);
    const Answered hidden(Answered::kHidden);
    exported_begin(hidden.name());
    draw_rect(kWhole, kNear);
    exported_end();
    EXPECT_TRUE(no_error());
    EXPECT_EQ(drawn_pixels(), 0);
    dlclose(library);
}

}  // namespace
}  // namespace conformance
