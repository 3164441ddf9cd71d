// SPDX-License-Identifier: MIT
// Random sequences of every command of the overlapped tests and queries, also in display lists, beside the
// model of the texts: each command's error, each result and the state after it agree (MIX-23).
#include <functional>
#include <random>

#include "overlap/model.h"

namespace conformance {
namespace {

constexpr GLuint kNames = 6;  // begun by hand: 1 to 6; 0 among them now and then
constexpr int kSteps = 60;

class RandomSequences : public HpTest, public ::testing::WithParamInterface<unsigned> {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(HpTest::SetUp());
        if (IsSkipped()) return;
        for (const Way& way : kWays) {
            if (!way.missing()) ways_.push_back(way);
        }
        if (ways_.empty()) GTEST_SKIP() << "needs a query";
        model_ = Model(lacks(30).has_value());
        has_blocks_ = !lacks(30);
        random_.seed(GetParam());
    }

    GLuint below(unsigned limit) { return static_cast<GLuint>(random_() % limit); }
    Way any_way() { return ways_[below(static_cast<unsigned>(ways_.size()))]; }

    Command any_command() {
        const GLuint name = below(8) == 0 ? 0 : 1 + below(kNames);
        switch (below(22)) {
            case 0:
            case 1:
            case 2:
            case 3:
                return {Verb::kBegin, any_way(), name};
            case 4:
            case 5:
            case 6:
                return {Verb::kEnd, any_way(), 0};
            case 7:
                return {Verb::kEnable};
            case 8:
                return {Verb::kDisable};
            case 9:
                return {Verb::kPush};
            case 10:
                return {Verb::kPop};
            case 11:
            case 18:
                return {Verb::kReadFlag, kWays[0], below(2)};
            case 12:
            case 13:
                return {Verb::kReadResult, any_way(), name};
            case 14:
                return {Verb::kDelete, any_way(), name};
            case 15:
                return has_blocks_ ? Command{Verb::kCondition, kWays[0], name} : Command{Verb::kDraw};
            case 16:
                return has_blocks_ ? Command{Verb::kUncondition} : Command{Verb::kDraw};
            case 17:
                if (!model_.lists.empty()) return {Verb::kCall, kWays[0], 1 + below(list_count())};
                [[fallthrough]];
            default:
                return {Verb::kDraw, kWays[0], below(4)};
        }
    }
    unsigned list_count() const { return static_cast<unsigned>(model_.lists.size()); }

    // What the command returns, as Model::returned.
    static GLuint execute(const Command& command) {
        switch (command.verb) {
            case Verb::kDraw:
                draw_columns(static_cast<int>(command.number));
                glEnable(GL_SCISSOR_TEST);  // of no area
                draw_columns(static_cast<int>(command.number));
                glDisable(GL_SCISSOR_TEST);
                break;
            case Verb::kBegin:
                begin(command.way, command.number);
                break;
            case Verb::kEnd:
                end(command.way);
                break;
            case Verb::kEnable:
                glEnable(GL_OCCLUSION_TEST_HP);
                break;
            case Verb::kDisable:
                glDisable(GL_OCCLUSION_TEST_HP);
                break;
            case Verb::kPush:
                glPushAttrib(GL_ENABLE_BIT);
                break;
            case Verb::kPop:
                glPopAttrib();
                break;
            case Verb::kCall:
                glCallList(command.number);
                break;
            case Verb::kReadFlag:
                return command.number % 2 ? static_cast<GLuint>(get_integer(GL_OCCLUSION_TEST_RESULT_HP))
                                          : GLuint{read_result()};
            case Verb::kReadResult:
                return get(command.way, command.number, GL_QUERY_RESULT);
            case Verb::kDelete:
                delete_query(command.way, command.number);
                break;
            case Verb::kCondition:
                glBeginConditionalRender(command.number, GL_QUERY_WAIT);
                break;
            case Verb::kUncondition:
                glEndConditionalRender();
                break;
        }
        return kUntouched;
    }

    void expect_same(const Command& command) {
        history_ += describe(command);
        const GLuint returned = execute(command);
        EXPECT_TRUE(error_is(model_.execute(command)));
        EXPECT_EQ(returned, model_.returned);
    }

    // Commands that compile do so, and are executed too in one of the modes; the others are executed at once.
    void compile_list() {
        const bool executes = below(2) == 0;
        const GLuint list = list_count() + 1;
        history_ += executes ? "{+ " : "{ ";
        std::vector<Command> commands;
        glNewList(list, executes ? GL_COMPILE_AND_EXECUTE : GL_COMPILE);
        for (GLuint i = 0; i < 6; ++i) {
            const Command command = any_command();
            // Conditional rendering compiles as well; it has tests of its own.
            if (command.verb == Verb::kCondition || command.verb == Verb::kUncondition) continue;
            if (command.compiles()) commands.push_back(command);
            if (executes || !command.compiles()) {
                expect_same(command);
            } else {
                history_ += describe(command);
                execute(command);
                EXPECT_TRUE(no_error());
            }
        }
        glEndList();
        history_ += "} ";
        model_.lists[list] = commands;
    }

    void expect_same_state() const {
        EXPECT_EQ(test_enabled(), model_.test_enabled());
        for (const Way& way : ways_) {
            const GLenum slot = way.target ? way.target : GL_SAMPLES_PASSED;
            EXPECT_EQ(active_name(way), static_cast<GLint>(model_.current(slot))) << way.name;
            for (GLuint name = 1; name <= kNames; ++name) {
                EXPECT_EQ(is_query(way, name), model_.is_object(name)) << way.name << " " << name;
            }
        }
        EXPECT_TRUE(no_error());
    }

    std::vector<Way> ways_;
    bool has_blocks_ = false;
    std::mt19937 random_;
    Model model_;
    std::string history_;
};

TEST_P(RandomSequences, are_answered_as_by_the_model) {
    glScissor(0, 0, 0, 0);
    for (int step = 0; step < kSteps && !HasFailure(); ++step) {
        if (below(12) == 0) {
            compile_list();
        } else {
            expect_same(any_command());
        }
        expect_same_state();
    }
    if (HasFailure()) ADD_FAILURE() << "after: " << history_;
    glFinish();  // Mesa 22.3 frees an active query while its rasteriser still counts into it
}

INSTANTIATE_TEST_SUITE_P(Seed, RandomSequences, ::testing::Range(0u, 60u));

}  // namespace
}  // namespace conformance
