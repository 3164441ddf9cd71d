// SPDX-License-Identifier: MIT
// Availability under a clock: late enough, in order, and for good, over a hundred queries of every kind at
// once.
#include <memory>
#include <vector>

#include "latency.h"
#include "old_commands.h"

namespace clock_tests {
namespace {

using conformance::lacks;

// One of the hundred: of NV or of a target of core GL.
class AnyQuery {
  public:
    AnyQuery(const NvCommands* nv, GLenum target) : nv_(nv), target_(target) {
        if (nv_) {
            nv_->generate(1, &name_);
        } else {
            glGenQueries(1, &name_);
        }
    }
    ~AnyQuery() { glDeleteQueries(1, &name_); }
    AnyQuery(const AnyQuery&) = delete;
    AnyQuery& operator=(const AnyQuery&) = delete;

    void run(int samples) const {
        if (nv_) {
            nv_->begin(name_);
        } else {
            glBeginQuery(target_, name_);
        }
        conformance::draw_rect({0, 0, samples, 1}, conformance::kNear);
        if (nv_) {
            nv_->end();
        } else {
            glEndQuery(target_);
        }
    }

    bool is_available() const {
        GLuint available = 0xAA;
        if (nv_) {
            nv_->get_unsigned(name_, GL_PIXEL_COUNT_AVAILABLE_NV, &available);
        } else {
            glGetQueryObjectuiv(name_, GL_QUERY_RESULT_AVAILABLE, &available);
        }
        EXPECT_TRUE(available == GL_TRUE || available == GL_FALSE) << available;
        return available == GL_TRUE;
    }

    // What run(samples) has to give.
    GLuint expected(int samples) const {
        const auto count = static_cast<GLuint>(samples);
        return nv_ || target_ == GL_SAMPLES_PASSED ? count : GLuint{count != 0};
    }

    GLuint result() const {
        GLuint value = conformance::kUntouched;
        if (nv_) {
            nv_->get_unsigned(name_, GL_PIXEL_COUNT_NV, &value);
        } else {
            glGetQueryObjectuiv(name_, GL_QUERY_RESULT, &value);
        }
        return value;
    }

  private:
    const NvCommands* nv_;
    GLenum target_;
    GLuint name_ = 0;
};

class Order : public ClockTest {
  protected:
    static constexpr int kQueries = 100;

    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(ClockTest::SetUp());
        if (!lacks("GL_NV_occlusion_query")) nv_ = std::make_unique<NvCommands>();
        targets_ = {GL_SAMPLES_PASSED};
        if (!lacks(33, "GL_ARB_occlusion_query2")) targets_.push_back(GL_ANY_SAMPLES_PASSED);
        if (!lacks(43, "GL_ARB_ES3_compatibility")) targets_.push_back(GL_ANY_SAMPLES_PASSED_CONSERVATIVE);
        draw_visible();  // compiles
        glFinish();
        for (int i = 0; i < kQueries; ++i) {
            const bool is_nv = nv_ && i % 4 == 3;
            const auto kind = static_cast<std::size_t>(i) % targets_.size();
            queries_.push_back(std::make_unique<AnyQuery>(is_nv ? nv_.get() : nullptr, targets_[kind]));
        }
    }

    void TearDown() override {
        queries_.clear();
        ClockTest::TearDown();
    }

    static int samples_of(int query) { return query % 5; }

    // The moment before the first of them.
    Moment run_all() const {
        const Moment begin = now();
        for (int i = 0; i < kQueries; ++i) query(i).run(samples_of(i));
        return begin;
    }
    const AnyQuery& query(int i) const { return *queries_[static_cast<std::size_t>(i)]; }

    void expect_results() const {
        for (int i = 0; i < kQueries; ++i) {
            EXPECT_EQ(query(i).result(), query(i).expected(samples_of(i))) << "query " << i;
        }
    }

  private:
    std::unique_ptr<NvCommands> nv_;
    std::vector<GLenum> targets_;
    std::vector<std::unique_ptr<AnyQuery>> queries_;
};

// ARB_occlusion_query, 6.1.13: "if any query's result is available, all queries issued before it are"; a
// result once available stays so. Asked from the last to the first, what is seen of the later holds for the
// earlier.
TEST_F(Order, results_become_available_in_order_and_stay) {
    run_all();
    std::vector<bool> was_available(kQueries, false);
    const auto deadline = now() + std::chrono::seconds(60);
    for (int round = 0; !was_available.back() || !was_available.front(); ++round) {
        ASSERT_LT(now(), deadline);
        bool is_later_available = false;
        for (int i = kQueries - 1; i >= 0; --i) {
            const bool is_available = query(i).is_available();
            EXPECT_TRUE(is_available || !is_later_available) << "query " << i << " comes late";
            EXPECT_TRUE(is_available || !was_available[static_cast<std::size_t>(i)])
                << "query " << i << " went";
            is_later_available = is_available;
            was_available[static_cast<std::size_t>(i)] = is_available;
        }
        if (round % 4 == 0) surface().swap();
    }
    expect_results();
}

TEST_F(Order, nothing_is_available_before_it_is_due) {
    if (!latency().can_be_seen()) GTEST_SKIP() << "needs a latency to see something pending in";
    // The first poll of all is the one that a latency of few calls allows.
    while_pending([&](bool& is_as_expected) {
        run_all();
        const Moment end = now();
        query(kQueries - 1).run(samples_of(kQueries - 1));
        let_driver_finish();
        is_as_expected = !query(kQueries - 1).is_available();
        return end;
    });
    expect_results();
}

TEST_F(Order, waiting_for_the_last_brings_all_others) {
    run_all();
    EXPECT_EQ(query(kQueries - 1).result(), query(kQueries - 1).expected(samples_of(kQueries - 1)));
    for (int i = 0; i < kQueries; ++i) EXPECT_TRUE(query(i).is_available()) << "query " << i;
    expect_results();
}

TEST_F(Order, waiting_for_the_first_leaves_the_last_pending) {
    if (!latency().can_be_seen() || latency().kind == Latency::kFrames)
        GTEST_SKIP() << "needs a latency between the two";
    while_pending([&](bool& is_as_expected) {
        query(0).run(3);
        EXPECT_EQ(query(0).result(), 3u);
        const Moment end = now();
        query(1).run(1);
        let_driver_finish();
        is_as_expected = !query(1).is_available();
        return end;
    });
}

}  // namespace
}  // namespace clock_tests
