// SPDX-License-Identifier: MIT
// Query buffers under a clock: what is written before a result is due, and that QUERY_RESULT waits for it.
#include <array>
#include <functional>
#include <vector>

#include "latency.h"

namespace clock_tests {
namespace {

using conformance::lacks;
using conformance::Query;

constexpr GLuint kPoison = 0xABABABAB;

// A way of writing a parameter of a query into the buffer's first bytes.
struct Way {
    const char* name;
    std::function<void(GLuint query, GLuint buffer, GLenum parameter)> write;
};

class QueryBuffers : public ClockTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(ClockTest::SetUp());
        if (const auto why = lacks(44, "GL_ARB_query_buffer_object")) GTEST_SKIP() << *why;
        glGenBuffers(1, &buffer_);
        poison();
        draw_visible();  // compiles
        glFinish();
    }

    void TearDown() override {
        glDeleteBuffers(1, &buffer_);
        ClockTest::TearDown();
    }

    static std::vector<Way> ways() {
        const auto bound = [](auto get) {
            return [get](GLuint query, GLuint buffer, GLenum parameter) {
                glBindBuffer(GL_QUERY_BUFFER, buffer);
                get(query, parameter, nullptr);
                glBindBuffer(GL_QUERY_BUFFER, 0);
            };
        };
        const auto named = [](auto get) {
            return [get](GLuint query, GLuint buffer, GLenum parameter) { get(query, buffer, parameter, 0); };
        };
        std::vector<Way> all = {{"iv", bound(glGetQueryObjectiv)},
                                {"uiv", bound(glGetQueryObjectuiv)},
                                {"i64v", bound(glGetQueryObjecti64v)},
                                {"ui64v", bound(glGetQueryObjectui64v)}};
        if (!lacks(45, "GL_ARB_direct_state_access")) {
            all.push_back({"buffer iv", named(glGetQueryBufferObjectiv)});
            all.push_back({"buffer uiv", named(glGetQueryBufferObjectuiv)});
            all.push_back({"buffer i64v", named(glGetQueryBufferObjecti64v)});
            all.push_back({"buffer ui64v", named(glGetQueryBufferObjectui64v)});
        }
        return all;
    }

    void poison() const {
        const std::array<GLuint, 2> poison = {kPoison, kPoison};
        glBindBuffer(GL_COPY_WRITE_BUFFER, buffer_);
        glBufferData(GL_COPY_WRITE_BUFFER, sizeof poison, poison.data(), GL_DYNAMIC_COPY);
    }

    GLuint written() const {
        GLuint value = 0;
        glBindBuffer(GL_COPY_READ_BUFFER, buffer_);
        glGetBufferSubData(GL_COPY_READ_BUFFER, 0, sizeof value, &value);
        return value;
    }

    static Moment ask(const Query& query) {
        query.begin();
        draw_visible();
        const Moment end = now();
        query.end();
        return end;
    }

    GLuint buffer() const { return buffer_; }

  private:
    GLuint buffer_ = 0;
};

TEST_F(QueryBuffers, a_result_is_written_when_it_is_due) {
    for (const Way& way : ways()) {
        poison();
        const Query query;
        const Moment end = ask(query);
        way.write(query.name(), buffer(), GL_QUERY_RESULT);
        const GLuint value = written();
        EXPECT_TRUE(is_not_early(end, now())) << way.name;
        EXPECT_EQ(value, 64u) << way.name;
    }
}

TEST_F(QueryBuffers, without_wait_nothing_is_written_before_it_is_due) {
    for (const Way& way : ways()) {
        if (latency().can_be_seen()) {
            while_pending([&](bool& is_as_expected) {
                poison();
                const Query query;
                const Moment end = ask(query);
                let_driver_finish();
                way.write(query.name(), buffer(), GL_QUERY_RESULT_NO_WAIT);
                const Moment done = now();
                is_as_expected = written() == kPoison;
                return end + (now() - done);
            });
        }
        poison();
        const Query query;
        ask(query);
        let_pass();
        glFinish();
        way.write(query.name(), buffer(), GL_QUERY_RESULT_NO_WAIT);
        EXPECT_EQ(written(), 64u) << way.name;
    }
}

TEST_F(QueryBuffers, availability_is_written_as_zero_before_it_is_due_and_as_one_after) {
    for (const Way& way : ways()) {
        if (latency().can_be_seen()) {
            while_pending([&](bool& is_as_expected) {
                poison();
                const Query query;
                const Moment end = ask(query);
                let_driver_finish();
                way.write(query.name(), buffer(), GL_QUERY_RESULT_AVAILABLE);
                const Moment done = now();
                is_as_expected = written() == GL_FALSE;
                return end + (now() - done);
            });
        }
        poison();
        const Query query;
        ask(query);
        let_pass();
        glFinish();
        way.write(query.name(), buffer(), GL_QUERY_RESULT_AVAILABLE);
        EXPECT_EQ(written(), GLuint{GL_TRUE}) << way.name;
    }
}

TEST_F(QueryBuffers, without_wait_memory_is_not_written_before_it_is_due) {
    GLuint value = 0;
    if (latency().can_be_seen()) {
        while_pending([&](bool& is_as_expected) {
            const Query query;
            const Moment end = ask(query);
            let_driver_finish();
            value = kPoison;
            glGetQueryObjectuiv(query.name(), GL_QUERY_RESULT_NO_WAIT, &value);
            is_as_expected = value == kPoison;
            return end;
        });
    }
    const Query query;
    ask(query);
    let_pass();
    glFinish();
    glGetQueryObjectuiv(query.name(), GL_QUERY_RESULT_NO_WAIT, &value);
    EXPECT_EQ(value, 64u);
}

}  // namespace
}  // namespace clock_tests
