// SPDX-License-Identifier: MIT
// Occlusion queries of two kinds: one may be active, and each is right after the other (MIX-18, MIX-22).
#include <tuple>

#include "overlap/overlap_test.h"

namespace conformance {
namespace {

class TwoWays : public GlTest, public ::testing::WithParamInterface<std::tuple<Way, Way>> {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
        for (const Way* way : {&first(), &second()}) {
            if (const auto why = way->missing()) GTEST_SKIP() << *why;
        }
    }
    static const Way& first() { return std::get<0>(GetParam()); }
    static const Way& second() { return std::get<1>(GetParam()); }
    // NV's queries are those of SAMPLES_PASSED.
    static bool same_slot() {
        const auto slot = [](const Way& way) { return way.target ? way.target : GL_SAMPLES_PASSED; };
        return slot(first()) == slot(second());
    }
};

// MIX-18. NV, Errors: Begin "when an occlusion query is already active". GL 4.5, 4.2: BeginQuery of any of
// the three occlusion targets while one of them is active. No text has both extensions; decided: there is one
// counter, hence INVALID_OPERATION both ways.
TEST_P(TwoWays, a_second_begin_is_refused_and_the_first_goes_on) {
    const AnyQuery active(first());
    const AnyQuery other(second());
    EXPECT_EQ(active.count([&] {
        draw_columns(4);
        other.begin();
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
        EXPECT_EQ(active_name(first()), static_cast<GLint>(active.name()));
        if (!same_slot()) {
            EXPECT_EQ(active_name(second()), 0);
        }
        draw_columns(4);
    }),
              first().of(64));
    EXPECT_FALSE(other.exists()) << "the refused Begin made an object";
    EXPECT_EQ(other.count([] { draw_columns(2); }), second().of(16));
}

// MIX-18. GL 4.5, 4.2: EndQuery of a target that has no active query is INVALID_OPERATION.
// EndOcclusionQueryNV ends "the active occlusion query", and for it SAMPLES_PASSED's is one: see NV-17.
TEST_P(TwoWays, ending_the_other_kind_is_refused) {
    if (same_slot()) GTEST_SKIP() << "the two have one active query";
    const AnyQuery active(first());
    EXPECT_EQ(active.count([] {
        draw_columns(4);
        end(second());
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
        draw_columns(4);
    }),
              first().of(64));
}

// MIX-18. One after the other there is nothing to refuse, and no count passes from one to the other.
TEST_P(TwoWays, one_after_the_other_is_right) {
    const AnyQuery one(first());
    const AnyQuery other(second());
    for (int round = 0; round < 3; ++round) {
        one.begin();
        draw_columns(8);
        one.end();
        draw_columns(16);
        other.begin();
        draw_columns(2);
        other.end();
        other.begin();
        other.end();
        EXPECT_TRUE(no_error());
        EXPECT_EQ(other.result(), 0u);
        EXPECT_EQ(one.result(), first().of(64));
    }
}

// MIX-22. GL, 2.1: state belongs to the context: one of each kind is active, in two contexts.
TEST_P(TwoWays, queries_of_two_contexts_do_not_mix) {
    const AnyQuery here(first());
    const Context context_there;
    ASSERT_TRUE(context_there);
    EXPECT_EQ(here.count([&] {
        draw_columns(4);
        ASSERT_TRUE(context_there.make_current(surface()));
        use_pixel_coordinates();
        EXPECT_EQ(active_name(first()), 0);
        {
            const AnyQuery there(second());
            EXPECT_EQ(there.count([&] {
                draw_columns(2);
                come_back();
                EXPECT_EQ(active_name(first()), static_cast<GLint>(here.name()));
                draw_columns(4);
                ASSERT_TRUE(context_there.make_current(surface()));
            }),
                      second().of(16));
        }
        EXPECT_TRUE(no_error());
        come_back();
    }),
              first().of(64));
}

INSTANTIATE_TEST_SUITE_P(Of, TwoWays,
                         ::testing::Combine(::testing::ValuesIn(kWays), ::testing::ValuesIn(kWays)),
                         [](const auto& test) {
                             return std::string(std::get<0>(test.param).name) + "_then_" +
                                    std::get<1>(test.param).name;
                         });

}  // namespace
}  // namespace conformance
