// SPDX-License-Identifier: MIT
// The test through query objects of GL_NV_occlusion_query.
#include "apps/query/occlusion_test_makers.h"
#include "apps/query/query_objects.h"

namespace apps {
namespace {

struct NvCommands {
    static constexpr std::string_view kExtension = "GL_NV_occlusion_query";

    explicit NvCommands(Platform& platform) {
        find_command(platform, gen, "glGenOcclusionQueriesNV");
        find_command(platform, remove, "glDeleteOcclusionQueriesNV");
        find_command(platform, begin, "glBeginOcclusionQueryNV");
        find_command(platform, end, "glEndOcclusionQueryNV");
        find_command(platform, get_occlusion_query, "glGetOcclusionQueryuivNV");
    }

    bool is_available(GLuint name) const {
        GLuint available = GL_TRUE;  // no answer means that waiting is over
        get_occlusion_query(name, GL_PIXEL_COUNT_AVAILABLE_NV, &available);
        return available != GL_FALSE;
    }

    GLuint result(GLuint name) const {
        GLuint samples = 1;  // no answer means visible
        get_occlusion_query(name, GL_PIXEL_COUNT_NV, &samples);
        return samples;
    }

    PFNGLGENOCCLUSIONQUERIESNVPROC gen = nullptr;
    PFNGLDELETEOCCLUSIONQUERIESNVPROC remove = nullptr;
    PFNGLBEGINOCCLUSIONQUERYNVPROC begin = nullptr;
    PFNGLENDOCCLUSIONQUERYNVPROC end = nullptr;
    PFNGLGETOCCLUSIONQUERYUIVNVPROC get_occlusion_query = nullptr;
};

}  // namespace

std::unique_ptr<OcclusionTest> make_nv_occlusion_query(Platform& platform) {
    return std::make_unique<QueryObjects<NvCommands>>(platform);
}

}  // namespace apps
