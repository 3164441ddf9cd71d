// SPDX-License-Identifier: MIT
// The judgement of one emulated call: which rows of gettable state it changed, and that glGetError answers as
// GL says.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <initializer_list>
#include <memory>
#include <set>
#include <string>

#include "harness/gl_test.h"
#include "scenery.h"
#include "snapshot.h"

namespace tests {

using Rows = std::set<std::string>;

class StateTest : public conformance::GlTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
        conformance::draw_occluder();
        disarrange();
        ASSERT_TRUE(conformance::no_error());
        reader_ = std::make_unique<StateReader>();
        // An enumerant list that went missing would compare nothing with nothing.
        ASSERT_GT(reader_->size(), 300u);
    }

    // The call changes exactly these rows, raises <error>, and leaves an earlier error alone.
    void expect_changes(const Rows& rows, const std::function<void()>& call, GLenum error = GL_NO_ERROR) {
        const Snapshot before = reader_->read();
        call();
        EXPECT_TRUE(conformance::error_is(error));
        const Snapshot after = reader_->read();
        EXPECT_EQ(changed_rows(before, after), rows);
        EXPECT_TRUE(conformance::no_error()) << "reading state raised an error";
    }

    // As above, with an error of the program's own pending all the while.
    void expect_changes_with_error_pending(const Rows& rows, const std::function<void()>& call) {
        const Snapshot before = reader_->read();
        glPixelStorei(GL_TEXTURE_2D, 1);  // INVALID_ENUM, also while a list is compiled
        call();
        const Snapshot after = reader_->read();
        EXPECT_TRUE(conformance::error_is(GL_INVALID_ENUM)) << "the pending error was lost or replaced";
        EXPECT_TRUE(conformance::no_error());
        EXPECT_EQ(changed_rows(before, after), rows);
    }

    void expect_nothing(const std::function<void()>& call) {
        expect_changes({}, call);
        expect_changes_with_error_pending({}, call);
    }

    void expect_refusal(GLenum error, const std::function<void()>& call) { expect_changes({}, call, error); }

  private:
    std::unique_ptr<StateReader> reader_;
};

// A number that is not zero before nor after, so that GetBooleanv sees no change.
inline Rows number(const std::string& name) {
    return {"Doublev " + name, "Floatv " + name, "Integerv " + name};
}

// A number that becomes zero or was it.
inline Rows number_from_or_to_zero(const std::string& name) {
    Rows rows = number(name);
    rows.insert("Booleanv " + name);
    return rows;
}

inline Rows enable_of(const std::string& name) {
    Rows rows = number_from_or_to_zero(name);
    rows.insert("IsEnabled " + name);
    return rows;
}

inline Rows operator+(Rows one, const Rows& other) {
    one.insert(other.begin(), other.end());
    return one;
}

}  // namespace tests
