// SPDX-License-Identifier: MIT
// The Gets that read the result: each of them returns it, clears it, and is refused where all Gets are
// (HP-28, HP-29, HP-37).
#include "hp_occlusion_test/hp_test.h"

namespace conformance {
namespace {

class ResultGets : public HpTest {};

// One Get form each; the value comes back as 0, 1 or whatever else was written.
using Read = double (*)();

double read_boolean() {
    GLboolean value = 0xAA;
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &value);
    return value;
}

double read_integer() {
    GLint value = -1;
    glGetIntegerv(GL_OCCLUSION_TEST_RESULT_HP, &value);
    return value;
}

double read_float() {
    GLfloat value = -1.0f;
    glGetFloatv(GL_OCCLUSION_TEST_RESULT_HP, &value);
    return static_cast<double>(value);
}

double read_double() {
    GLdouble value = -1.0;
    glGetDoublev(GL_OCCLUSION_TEST_RESULT_HP, &value);
    return value;
}

double read_integer64() {
    GLint64 value = -1;
    glGetInteger64v(GL_OCCLUSION_TEST_RESULT_HP, &value);
    return static_cast<double>(value);
}

std::vector<Read> reads() {
    std::vector<Read> forms = {read_boolean, read_integer, read_float, read_double};
    if (!lacks(32, "GL_ARB_sync")) forms.push_back(read_integer64);
    return forms;
}

// HP-28. HP, New Tokens: the result is "Accepted by the <pname> of GetBooleanv, GetIntegerv, GetFloatv, and
// GetDoublev"; GL 4.5, 2.2.2 gives boolean state as 1 or 0.
TEST_F(ResultGets, every_get_returns_true_as_one_and_false_as_zero) {
    const auto forms = reads();
    for (std::size_t form = 0; form < forms.size(); ++form) {
        SCOPED_TRACE(form);
        pass_one_fragment();
        EXPECT_EQ(forms[form](), 1.0);
        EXPECT_TRUE(no_error());
    }
    for (const Read read : forms) EXPECT_EQ(read(), 0.0);
}

// HP-29. HP, New State: "The result is set to FALSE as a side effect of reading it (executing a Get call)."
TEST_F(ResultGets, every_get_clears_the_result_for_every_get) {
    const auto forms = reads();
    for (std::size_t first = 0; first < forms.size(); ++first) {
        for (std::size_t second = 0; second < forms.size(); ++second) {
            pass_one_fragment();
            EXPECT_EQ(forms[first](), 1.0);
            EXPECT_EQ(forms[second](), 0.0) << "form " << second << " after form " << first;
        }
    }
}

// HP-37. NV, Errors: INVALID_OPERATION between Begin and End; GL 4.5, 2.3.1: then the command has no other
// effect.
TEST_F(ResultGets, a_get_between_begin_and_end_neither_writes_nor_clears) {
    pass_one_fragment();
    GLboolean result = 0xAA;
    glBegin(GL_POINTS);
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &result);
    glEnd();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(result, 0xAA);
    EXPECT_TRUE(read_result());
}

}  // namespace
}  // namespace conformance
