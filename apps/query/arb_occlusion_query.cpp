// SPDX-License-Identifier: MIT
// The test through query objects of GL_ARB_occlusion_query, or of GL 1.5 which made it core.
#include "apps/query/occlusion_test_makers.h"
#include "apps/query/query_objects.h"

namespace apps {
namespace {

struct ArbCommands {
    static constexpr std::string_view kExtension = "GL_ARB_occlusion_query";

    explicit ArbCommands(Platform& platform) {
        const std::string suffix = platform.has_extension(kExtension) ? "ARB" : "";
        find_command(platform, gen, "glGenQueries" + suffix);
        find_command(platform, remove, "glDeleteQueries" + suffix);
        find_command(platform, begin_query, "glBeginQuery" + suffix);
        find_command(platform, end_query, "glEndQuery" + suffix);
        find_command(platform, get_query_object, "glGetQueryObjectuiv" + suffix);
    }

    void begin(GLuint name) const { begin_query(GL_SAMPLES_PASSED, name); }
    void end() const { end_query(GL_SAMPLES_PASSED); }

    bool is_available(GLuint name) const {
        GLuint available = GL_TRUE;  // no answer means that waiting is over
        get_query_object(name, GL_QUERY_RESULT_AVAILABLE, &available);
        return available != GL_FALSE;
    }

    GLuint result(GLuint name) const {
        GLuint samples = 1;  // no answer means visible
        get_query_object(name, GL_QUERY_RESULT, &samples);
        return samples;
    }

    PFNGLGENQUERIESPROC gen = nullptr;
    PFNGLDELETEQUERIESPROC remove = nullptr;
    PFNGLBEGINQUERYPROC begin_query = nullptr;
    PFNGLENDQUERYPROC end_query = nullptr;
    PFNGLGETQUERYOBJECTUIVPROC get_query_object = nullptr;
};

}  // namespace

std::unique_ptr<OcclusionTest> make_arb_occlusion_query(Platform& platform) {
    return std::make_unique<QueryObjects<ArbCommands>>(platform);
}

}  // namespace apps
