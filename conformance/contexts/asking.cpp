// SPDX-License-Identifier: MIT
// The ways to ask.
#include "contexts/asking.h"

namespace conformance {

namespace {

class HpAsking final : public Asking {
  public:
    ~HpAsking() override {
        if (!is_left_) glDisable(GL_OCCLUSION_TEST_HP);
    }
    void begin() override {
        result();  // what another test left
        glEnable(GL_OCCLUSION_TEST_HP);
    }
    void end() override { glDisable(GL_OCCLUSION_TEST_HP); }
    GLuint result() override {
        GLboolean visible = GL_FALSE;
        glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &visible);
        return visible;
    }
    bool active() const override { return glIsEnabled(GL_OCCLUSION_TEST_HP) == GL_TRUE; }
    bool boolean() const override { return true; }
};

class NvAsking final : public Asking {
  public:
    NvAsking() { glGenOcclusionQueriesNV(1, &name_); }
    ~NvAsking() override {
        if (!is_left_) glDeleteOcclusionQueriesNV(1, &name_);
    }
    void begin() override { glBeginOcclusionQueryNV(name_); }
    void end() override { glEndOcclusionQueryNV(); }
    GLuint result() override {
        GLuint count = kUntouched;
        glGetOcclusionQueryuivNV(name_, GL_PIXEL_COUNT_NV, &count);
        return count;
    }
    bool active() const override { return get_integer(GL_CURRENT_OCCLUSION_QUERY_ID_NV) != 0; }
    bool boolean() const override { return false; }

  private:
    GLuint name_ = 0;
};

class QueryAsking final : public Asking {
  public:
    explicit QueryAsking(GLenum target) : target_(target) { glGenQueries(1, &name_); }
    ~QueryAsking() override {
        if (!is_left_) glDeleteQueries(1, &name_);
    }
    void begin() override { glBeginQuery(target_, name_); }
    void end() override { glEndQuery(target_); }
    GLuint result() override {
        GLuint value = kUntouched;
        glGetQueryObjectuiv(name_, GL_QUERY_RESULT, &value);
        return value;
    }
    bool active() const override { return current_query(target_) != 0; }
    bool boolean() const override { return target_ != GL_SAMPLES_PASSED; }

  private:
    GLenum target_;
    GLuint name_ = 0;
};

}  // namespace

const Way kHpWay = {"hp", [] { return lacks("GL_HP_occlusion_test"); },
                    []() -> std::unique_ptr<Asking> { return std::make_unique<HpAsking>(); }};
const Way kNvWay = {"nv", [] { return lacks("GL_NV_occlusion_query"); },
                    []() -> std::unique_ptr<Asking> { return std::make_unique<NvAsking>(); }};
const Way kArbWay = {
    "arb", [] { return lacks(15, "GL_ARB_occlusion_query"); },
    []() -> std::unique_ptr<Asking> { return std::make_unique<QueryAsking>(GL_SAMPLES_PASSED); }};
const Way kAnyWay = {
    "any", [] { return lacks(33, "GL_ARB_occlusion_query2"); },
    []() -> std::unique_ptr<Asking> { return std::make_unique<QueryAsking>(GL_ANY_SAMPLES_PASSED); }};

}  // namespace conformance
