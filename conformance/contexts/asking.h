// SPDX-License-Identifier: MIT
// One way to ask whether something is visible, whatever the extension: every test of contexts runs for each.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "harness/gl_test.h"
#include "harness/query.h"  // kUntouched, current_query

namespace conformance {

// Belongs to the context that is current when it is made.
class Asking {
  public:
    virtual ~Asking() = default;
    virtual void begin() = 0;
    virtual void end() = 0;
    virtual GLuint result() = 0;      // waits; of a boolean GL_TRUE or GL_FALSE
    virtual bool active() const = 0;  // in the current context
    virtual bool boolean() const = 0;

    // Nothing is ended or deleted when this goes: its context does that, dying.
    void leave_to_context() { is_left_ = true; }

  protected:
    bool is_left_ = false;
};

struct Way {
    const char* name;
    std::optional<std::string> (*why_not)();  // why the current context has it not
    std::unique_ptr<Asking> (*make)();
};

extern const Way kHpWay;   // GL_HP_occlusion_test
extern const Way kNvWay;   // GL_NV_occlusion_query
extern const Way kArbWay;  // SAMPLES_PASSED of GL 1.5
extern const Way kAnyWay;  // ANY_SAMPLES_PASSED of GL 3.3

class ContextTest : public GlTest, public ::testing::WithParamInterface<Way> {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        if (HasFatalFailure()) return;
        if (const auto why = GetParam().why_not()) GTEST_SKIP() << *why;
        asking_ = GetParam().make();
    }
    void TearDown() override {
        if (asking_) come_back();
        asking_.reset();
        GlTest::TearDown();
    }

    Asking& asking() const { return *asking_; }

    // Begins, draws, ends and waits, in whatever context is current; the new object goes at once.
    template <typename Draw>
    static GLuint ask(Draw draw) {
        const auto fresh = GetParam().make();
        fresh->begin();
        draw();
        fresh->end();
        return fresh->result();
    }

    // What is_it says of a number of samples: the number, or whether there are any.
    GLuint as_told(GLuint samples) const {
        return asking_->boolean() ? static_cast<GLuint>(samples > 0) : samples;
    }

  private:
    std::unique_ptr<Asking> asking_;
};

inline std::string way_name(const ::testing::TestParamInfo<Way>& way) {
    return way.param.name;
}

inline auto every_way() {
    return ::testing::Values(kHpWay, kNvWay, kArbWay, kAnyWay);
}

}  // namespace conformance
