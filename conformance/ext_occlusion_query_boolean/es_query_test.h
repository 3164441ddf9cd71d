// SPDX-License-Identifier: MIT
// The fixture: an OpenGL ES context and the extension's seven commands, by GetProcAddress as a program of
// OpenGL ES gets them.
#pragma once

#include <array>
#include <string>

#include "harness/es_test.h"
#include "harness/query.h"

namespace conformance {

inline constexpr GLenum kAny = GL_ANY_SAMPLES_PASSED;
inline constexpr GLenum kConservative = GL_ANY_SAMPLES_PASSED_CONSERVATIVE;
inline constexpr std::array<GLenum, 2> kTargets = {kAny, kConservative};

class EsQueryTest : public EsTest {
  protected:
    void SetUp() override {
        EsTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        if (const auto why = lacks("GL_EXT_occlusion_query_boolean")) GTEST_SKIP() << *why;
        load("glGenQueriesEXT", gen_queries);
        load("glDeleteQueriesEXT", delete_queries);
        load("glIsQueryEXT", is_query);
        load("glBeginQueryEXT", begin_query);
        load("glEndQueryEXT", end_query);
        load("glGetQueryivEXT", get_query);
        load("glGetQueryObjectuivEXT", get_query_object);
    }

    GLuint new_name() const {
        GLuint name = 0;
        gen_queries(1, &name);
        return name;
    }

    // The name of an object that has been used once, on a target.
    GLuint new_object(GLenum target = kAny) const {
        const GLuint name = new_name();
        begin_query(target, name);
        end_query(target);
        return name;
    }

    GLint current(GLenum target) const {
        GLint name = -1;
        get_query(target, GL_CURRENT_QUERY, &name);
        return name;
    }

    GLuint get(GLuint name, GLenum parameter = GL_QUERY_RESULT) const {
        GLuint value = kUntouched;
        get_query_object(name, parameter, &value);
        return value;
    }

    PFNGLGENQUERIESPROC gen_queries = nullptr;
    PFNGLDELETEQUERIESPROC delete_queries = nullptr;
    PFNGLISQUERYPROC is_query = nullptr;
    PFNGLBEGINQUERYPROC begin_query = nullptr;
    PFNGLENDQUERYPROC end_query = nullptr;
    PFNGLGETQUERYIVPROC get_query = nullptr;
    PFNGLGETQUERYOBJECTUIVPROC get_query_object = nullptr;

  private:
    template <typename Function>
    static void load(const char* name, Function& function) {
        function = reinterpret_cast<Function>(platform().get_proc_address(name));
        ASSERT_NE(function, nullptr) << name;
    }
};

// Every test of a suite in both kinds of context.
inline std::string es_version(const ::testing::TestParamInfo<int>& major) {
    return "es" + std::to_string(major.param);
}

}  // namespace conformance
