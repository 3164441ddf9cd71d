// SPDX-License-Identifier: MIT
// The test through GL_HP_occlusion_test: one flag in the machine, so one test at a time.
#include <GL/gl.h>
#include <GL/glext.h>

#include "apps/platform/gl.h"
#include "apps/query/occlusion_test_makers.h"

namespace apps {
namespace {

class HpOcclusionTest final : public OcclusionTest {
  public:
    /// "The result is set to FALSE as a side effect of reading it": what earlier drawing left behind is gone.
    HpOcclusionTest() { fetch(0); }

    std::string_view extension() const override { return "GL_HP_occlusion_test"; }
    bool has_queries() const override { return false; }

    std::uint32_t begin() override {
        glEnable(GL_OCCLUSION_TEST_HP);
        return 0;
    }
    void end() override { glDisable(GL_OCCLUSION_TEST_HP); }
    bool is_available(std::uint32_t) override { return true; }  // the machine does not tell

    std::uint32_t fetch(std::uint32_t) override {
        GLboolean result = GL_TRUE;  // no answer means visible
        glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &result);
        return result == GL_TRUE;
    }
};

}  // namespace

std::unique_ptr<OcclusionTest> make_hp_occlusion_test() {
    return std::make_unique<HpOcclusionTest>();
}

}  // namespace apps
