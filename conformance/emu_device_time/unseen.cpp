// SPDX-License-Identifier: MIT
// What is counted for the clocks is nobody's affair: the program's own counters, names, errors and lists are
// as without (DEVT-18 to DEVT-21).
#include <array>
#include <vector>

#include "emu_device_time/device_time_test.h"

namespace conformance {
namespace {

class DeviceUnseen : public DeviceTimeTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(DeviceTimeTest::SetUp());
        if (IsSkipped()) return;
        if (const auto why = lacks(15)) GTEST_SKIP() << *why;
    }

    // The targets of what may be counted for the clocks, where the machine has them.
    static std::vector<GLenum> statistics() {
        std::vector<GLenum> targets;
        if (!lacks(30)) targets.push_back(GL_PRIMITIVES_GENERATED);
        if (lacks(46, "GL_ARB_pipeline_statistics_query")) return targets;
        targets.insert(targets.end(), {GL_VERTICES_SUBMITTED, GL_PRIMITIVES_SUBMITTED,
                                       GL_VERTEX_SHADER_INVOCATIONS, GL_FRAGMENT_SHADER_INVOCATIONS,
                                       GL_CLIPPING_INPUT_PRIMITIVES, GL_CLIPPING_OUTPUT_PRIMITIVES});
        return targets;
    }
};

// Two triangles, of which one is drawn before the program looks at the clock.
void draw_and_look() {
    draw_triangle(kNear);
    cpu_time();
    draw_triangle(kNear);
}

// DEVT-18. GL 4.5, 4.2: CURRENT_QUERY is "the name of the currently active query object"; EndQuery is in
// error "if the active query object name for target is zero".
TEST_F(DeviceUnseen, no_query_is_active_but_the_programs) {
    const std::vector<GLenum> targets = statistics();
    if (targets.empty()) GTEST_SKIP() << "needs queries that count";
    draw_triangle(kNear);
    for (const GLenum target : targets) {
        EXPECT_EQ(current_query(target), 0) << target;
        glEndQuery(target);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << target;
        draw_triangle(kNear);
    }
    const Query samples;
    samples.begin();
    draw_triangle(kNear);
    for (const GLenum target : targets) EXPECT_EQ(current_query(target), 0) << target;
    samples.end();
}

// DEVT-18. The program's counter counts what is drawn while it is active, and that alone.
TEST_F(DeviceUnseen, the_programs_counters_count_what_they_would) {
    const std::vector<GLenum> targets = statistics();
    if (targets.empty()) GTEST_SKIP() << "needs queries that count";
    const auto is_of_primitives = [](GLenum target) {
        return target == GL_PRIMITIVES_GENERATED || target == GL_PRIMITIVES_SUBMITTED ||
               target == GL_CLIPPING_INPUT_PRIMITIVES;
    };
    for (const GLenum target : targets) {
        draw_triangle(kNear);
        const Query counter(target);
        counter.begin();
        EXPECT_TRUE(no_error()) << target;
        EXPECT_EQ(current_query(target), static_cast<GLint>(counter.name()));
        draw_and_look();
        counter.end();
        draw_triangle(kNear);
        const GLuint count = counter.result();
        const GLuint alone = Query(target).count([] { draw_triangle(kNear); });
        EXPECT_EQ(count, 2 * alone) << target;
        EXPECT_GT(count, 0u) << target;
        if (is_of_primitives(target)) {
            EXPECT_EQ(count, 2u) << target;
        }
    }
}

// DEVT-18. All of them at once, around a query of samples.
TEST_F(DeviceUnseen, the_programs_counters_may_all_be_active_at_once) {
    const std::vector<GLenum> targets = statistics();
    if (targets.empty()) GTEST_SKIP() << "needs queries that count";
    std::vector<GLuint> names(targets.size());
    glGenQueries(static_cast<GLsizei>(names.size()), names.data());
    for (std::size_t i = 0; i < targets.size(); ++i) {
        draw_triangle(kNear);
        glBeginQuery(targets[i], names[i]);
    }
    const Query samples;
    const GLuint count = samples.count(draw_and_look);
    for (std::size_t i = 0; i < targets.size(); ++i) {
        EXPECT_EQ(current_query(targets[i]), static_cast<GLint>(names[i])) << targets[i];
        glEndQuery(targets[i]);
        draw_triangle(kNear);
    }
    EXPECT_GT(count, 0u);
    EXPECT_TRUE(no_error());
    glDeleteQueries(static_cast<GLsizei>(names.size()), names.data());
}

// DEVT-19. GL 4.5, 4.2: IsQuery of a name that is no query object's is FALSE. In the compatibility profile
// BeginQuery takes a name that was never generated.
TEST_F(DeviceUnseen, no_name_is_taken) {
    constexpr GLuint kNames = 100;
    draw_and_look();
    draw_rect(kWhole, kNear);
    for (GLuint name = 1; name <= kNames; ++name) EXPECT_FALSE(glIsQuery(name)) << name;
    for (GLuint name = 1; name <= kNames; ++name) {
        draw_and_look();
        glBeginQuery(GL_SAMPLES_PASSED, name);
        EXPECT_TRUE(no_error()) << name;
        draw_rect({0, 0, 4, 4}, kNear);
        // A time in the midst of the query, and one after a draw that follows it.
        if (name % 2 == 0) cpu_time();
        glEndQuery(GL_SAMPLES_PASSED);
        EXPECT_TRUE(glIsQuery(name)) << name;
    }
    for (GLuint name = 1; name <= kNames; ++name) {
        GLuint count = kUntouched;
        glGetQueryObjectuiv(name, GL_QUERY_RESULT, &count);
        EXPECT_EQ(count, 16u) << name;
        glDeleteQueries(1, &name);
        EXPECT_FALSE(glIsQuery(name)) << name;
    }
}

// DEVT-20. GL 4.5, 2.3.1: an error stays until GetError takes it.
TEST_F(DeviceUnseen, errors_stay_and_none_is_added) {
    const Query query;
    glEnable(0xFFFF);
    draw_and_look();
    query.begin();
    draw_and_look();
    query.end();
    device_work(10);
    is_there(query);
    glFinish();
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_TRUE(no_error());
}

// DEVT-21. GL 4.5 compatibility, 21.4: what is compiled is the program's commands, whatever was asked
// meanwhile.
TEST_F(DeviceUnseen, a_list_holds_the_programs_commands_alone) {
    for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE}) {
        const GLuint list = glGenLists(2);
        const Query before;
        before.begin();
        draw_rect({0, 0, 2, 2}, kNear);
        before.end();
        draw_triangle(kNear);
        glNewList(list, GL_COMPILE);
        draw_rect({0, 0, 3, 1}, kNear);
        glEndList();
        draw_triangle(kNear);
        glNewList(list + 1, mode);
        draw_rect({0, 0, 4, 4}, kNear);
        cpu_time();
        is_there(before);
        glCallList(list);
        draw_rect({0, 0, 5, 1}, kNear);
        EXPECT_EQ(before.result(), 4u);
        glEndList();
        EXPECT_TRUE(no_error());
        const Query counter;
        for (int call = 0; call < 3; ++call) {
            draw_triangle(kNear);
            EXPECT_EQ(counter.count([list] { glCallList(list + 1); }), 16u + 3u + 5u) << mode;
            EXPECT_TRUE(no_error()) << mode;
        }
        glDeleteLists(list, 2);
    }
}

}  // namespace
}  // namespace conformance
