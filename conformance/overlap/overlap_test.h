// SPDX-License-Identifier: MIT
// What the tests of overlapping occlusion tests share: the four ways to count between a Begin and an End, and
// fixtures that skip where the occlusion test of HP or the way is absent.
#pragma once

#include <memory>
#include <ostream>

#include "hp_occlusion_test/hp_test.h"
#include "nv_occlusion_query/nv_test.h"

namespace conformance {

// A way to count samples. NV_occlusion_query has no targets: its target is 0.
struct Way {
    const char* name;
    GLenum target;
    bool boolean;  // tells only whether anything passed

    // What a query of this way says when <samples> passed.
    GLuint of(GLuint samples) const { return boolean ? GLuint{samples > 0} : samples; }
    // Why it cannot be had here, or nothing.
    std::optional<std::string> missing() const {
        if (target == 0) return lacks("GL_NV_occlusion_query");
        if (target == GL_SAMPLES_PASSED) return lacks(15, "GL_ARB_occlusion_query");
        if (target == GL_ANY_SAMPLES_PASSED) return lacks(33, "GL_ARB_occlusion_query2");
        return lacks(43, "GL_ARB_ES3_compatibility");
    }
};

inline void PrintTo(const Way& way, std::ostream* out) {
    *out << way.name;
}

inline constexpr Way kWays[] = {
    {"nv", 0, false},
    {"samples", GL_SAMPLES_PASSED, false},
    {"any_samples", GL_ANY_SAMPLES_PASSED, true},
    {"any_samples_conservative", GL_ANY_SAMPLES_PASSED_CONSERVATIVE, true},
};

// The commands of a way.
inline GLint active_name(const Way& way) {
    return way.target ? current_query(way.target) : get_integer(GL_CURRENT_OCCLUSION_QUERY_ID_NV);
}

inline bool is_query(const Way& way, GLuint name) {
    return (way.target ? glIsQuery(name) : glIsOcclusionQueryNV(name)) == GL_TRUE;
}

inline void begin(const Way& way, GLuint name) {
    way.target ? glBeginQuery(way.target, name) : glBeginOcclusionQueryNV(name);
}

inline void end(const Way& way) {
    way.target ? glEndQuery(way.target) : glEndOcclusionQueryNV();
}

inline void delete_query(const Way& way, GLuint name) {
    way.target ? glDeleteQueries(1, &name) : glDeleteOcclusionQueriesNV(1, &name);
}

// QUERY_RESULT, which waits, or QUERY_RESULT_AVAILABLE: NV's parameters have the same values. kUntouched
// where the Get writes nothing.
inline GLuint get(const Way& way, GLuint name, GLenum parameter) {
    GLuint value = kUntouched;
    way.target ? glGetQueryObjectuiv(name, parameter, &value)
               : glGetOcclusionQueryuivNV(name, parameter, &value);
    return value;
}

// A query of any way. Has to end its life while no query is active, as NV's text demands.
class AnyQuery {
  public:
    explicit AnyQuery(const Way& way) : way_(way) {
        way.target ? glGenQueries(1, &name_) : glGenOcclusionQueriesNV(1, &name_);
    }
    ~AnyQuery() { delete_query(way_, name_); }
    AnyQuery(const AnyQuery&) = delete;
    AnyQuery& operator=(const AnyQuery&) = delete;

    GLuint name() const { return name_; }
    void begin() const { conformance::begin(way_, name_); }
    void end() const { conformance::end(way_); }
    bool exists() const { return is_query(way_, name_); }
    GLuint result() const { return get(way_, name_, GL_QUERY_RESULT); }
    bool available() const { return get(way_, name_, GL_QUERY_RESULT_AVAILABLE) == GL_TRUE; }

    template <typename Draw>
    GLuint count(Draw draw) const {
        begin();
        draw();
        end();
        return result();
    }

  private:
    Way way_;
    GLuint name_ = 0;
};

// HP overlapped with each way.
class OverlapTest : public HpTest, public ::testing::WithParamInterface<Way> {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(HpTest::SetUp());
        if (IsSkipped()) return;
        if (const auto why = way().missing()) GTEST_SKIP() << *why;
    }
    static const Way& way() { return GetParam(); }
};

// Eight rows: 8 <width> samples.
inline void draw_columns(int width) {
    draw_rect({0, 0, width, 8}, kMiddle);
}

inline std::string way_name(const ::testing::TestParamInfo<Way>& info) {
    return info.param.name;
}

}  // namespace conformance
