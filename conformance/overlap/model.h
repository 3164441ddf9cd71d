// SPDX-License-Identifier: MIT
// The texts as a machine of a few variables: one counter, one active query, the objects, HP's enable and its
// stack, and one conditional block. What GL should answer to any sequence of the commands in Command.
//
// NV_occlusion_query 4.1.6A and 6.1.13, ARB_occlusion_query 4.1.6A and "Dependencies on HP_occlusion_test",
// GL 4.5 4.2, 5.1.3, 10.9 and 21.4; where they are silent, as decided in the plans (MIX-03, MIX-10, MIX-18,
// NV-17, ARB-10, ARB-11).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "overlap/overlap_test.h"

namespace conformance {

enum class Verb {
    kDraw,        // <number> columns of 8 samples that pass, and as many that fail
    kBegin,       // of <way>, name <number>
    kEnd,         // of <way>
    kEnable,      // HP's test
    kDisable,     //
    kPush,        // ENABLE_BIT
    kPop,         //
    kCall,        // list <number>
    kReadFlag,    // the rest is executed at once while a list is compiled
    kReadResult,  // of <way>, name <number>
    kDelete,      // of <way>, name <number>
    kCondition,   // BeginConditionalRender of name <number>
    kUncondition  // EndConditionalRender
};

struct Command {
    Verb verb;
    Way way = kWays[0];
    GLuint number = 0;

    bool compiles() const { return verb <= Verb::kCall; }
};

std::string describe(const Command& command);

class Model {
  public:
    // <names_are_fixed>: GL below 3.0 refuses to delete names while a query is active.
    explicit Model(bool names_are_fixed = false) : names_are_fixed_(names_are_fixed) {}

    // What a command that returns something returns; kUntouched where it is in error.
    GLuint returned = kUntouched;

    // Executes a command; its error, the first one if it is a call of a list with several.
    GLenum execute(const Command& command);

    bool test_enabled() const { return enabled_; }
    bool is_object(GLuint name) const { return objects_.count(name) != 0; }
    GLuint current(GLenum target) const { return slot_ == target ? active_ : 0; }

    std::map<GLuint, std::vector<Command>> lists;

  private:
    struct Object {
        bool boolean = false;
        std::uint64_t result = 0;
    };

    GLenum begin(const Way& way, GLuint name);
    GLenum end(const Way& way);
    GLenum read_result(const Way& way, GLuint name);
    GLenum remove(const Way& way, GLuint name);
    GLenum condition(GLuint name);
    GLenum call(GLuint list);

    bool names_are_fixed_;
    std::uint64_t counter_ = 0;  // HP's result is TRUE when it is not zero
    bool enabled_ = false;
    std::vector<bool> stack_;
    std::map<GLuint, Object> objects_;
    GLuint active_ = 0;       // name of the active query
    GLenum slot_ = 0;         // its target, 0 for none
    Object active_object_;    // apart, since its name may be deleted
    bool in_block_ = false;   // of conditional rendering
    bool draws_ = true;       // that is, is not discarded by it
    GLuint block_query_ = 0;  // its query's name, which is taken also when it is deleted
};

}  // namespace conformance
