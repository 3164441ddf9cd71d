// SPDX-License-Identifier: MIT
// A query object that goes with its scope, through the names of core GL.
#pragma once

#include "harness/gl.h"

namespace conformance {

inline constexpr GLuint kUntouched = 0xDEADBEEF;  // what an output holds that no call may write

class Query {
  public:
    explicit Query(GLenum target = GL_SAMPLES_PASSED) : target_(target) { glGenQueries(1, &name_); }
    ~Query() { glDeleteQueries(1, &name_); }
    Query(const Query&) = delete;
    Query& operator=(const Query&) = delete;

    GLuint name() const { return name_; }
    void begin() const { glBeginQuery(target_, name_); }
    void end() const { glEndQuery(target_); }

    // Waits for the result.
    GLuint result() const {
        GLuint value = kUntouched;
        glGetQueryObjectuiv(name_, GL_QUERY_RESULT, &value);
        return value;
    }

    template <typename Draw>
    GLuint count(Draw draw) const {
        begin();
        draw();
        end();
        return result();
    }

  private:
    GLenum target_;
    GLuint name_ = 0;
};

// The name that is active on a target, 0 for none.
inline GLint current_query(GLenum target) {
    GLint name = -1;
    glGetQueryiv(target, GL_CURRENT_QUERY, &name);
    return name;
}

}  // namespace conformance
