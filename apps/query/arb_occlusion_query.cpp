// SPDX-License-Identifier: MIT
// The test through a query object: GL_ARB_occlusion_query, or GL 1.5 which made it core. Any sample that
// passes counts.
#include "apps/query/occlusion_test_makers.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <string>

namespace apps {
namespace {

class ArbOcclusionQuery final : public OcclusionTest {
  public:
    explicit ArbOcclusionQuery(Platform& platform) {
        const std::string suffix = platform.has_extension("GL_ARB_occlusion_query") ? "ARB" : "";
        const auto find = [&](auto& function, const char* name) {
            function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(
                platform.function((name + suffix).c_str()));
        };
        find(gen_queries_, "glGenQueries");
        find(delete_queries_, "glDeleteQueries");
        find(begin_query_, "glBeginQuery");
        find(end_query_, "glEndQuery");
        find(get_query_object_, "glGetQueryObjectuiv");
        gen_queries_(1, &query_);
    }

    ArbOcclusionQuery(const ArbOcclusionQuery&) = delete;
    ArbOcclusionQuery& operator=(const ArbOcclusionQuery&) = delete;
    ~ArbOcclusionQuery() override { delete_queries_(1, &query_); }

    std::string_view extension() const override { return "GL_ARB_occlusion_query"; }
    void begin() override { begin_query_(GL_SAMPLES_PASSED, query_); }
    void end() override { end_query_(GL_SAMPLES_PASSED); }

    bool wait() override {
        GLuint samples = 1;  // no answer means visible
        get_query_object_(query_, GL_QUERY_RESULT, &samples);
        return samples != 0;
    }

  private:
    PFNGLGENQUERIESPROC gen_queries_ = nullptr;
    PFNGLDELETEQUERIESPROC delete_queries_ = nullptr;
    PFNGLBEGINQUERYPROC begin_query_ = nullptr;
    PFNGLENDQUERYPROC end_query_ = nullptr;
    PFNGLGETQUERYOBJECTUIVPROC get_query_object_ = nullptr;
    GLuint query_ = 0;
};

}  // namespace

std::unique_ptr<OcclusionTest> make_arb_occlusion_query(Platform& platform) {
    return std::make_unique<ArbOcclusionQuery>(platform);
}

}  // namespace apps
