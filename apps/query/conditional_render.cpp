// SPDX-License-Identifier: MIT
// One class for all three: their commands differ in name, and NVX has no mode.
#include "apps/query/conditional_render.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include "apps/query/query_objects.h"

namespace apps {
namespace {

class GpuCondition final : public ConditionalRender {
  public:
    GpuCondition(Platform& platform, std::string_view extension, const std::string& suffix)
        : extension_(extension) {
        if (suffix == "NVX")
            find_command(platform, begin_waiting_, "glBeginConditionalRenderNVX");
        else
            find_command(platform, begin_, "glBeginConditionalRender" + suffix);
        find_command(platform, end_, "glEndConditionalRender" + suffix);
    }

    std::string_view extension() const override { return extension_; }

    void begin(std::uint32_t query, Condition condition) override {
        constexpr GLenum kModes[] = {GL_QUERY_WAIT, GL_QUERY_NO_WAIT, GL_QUERY_BY_REGION_WAIT,
                                     GL_QUERY_BY_REGION_NO_WAIT};
        if (begin_)
            begin_(query, kModes[static_cast<std::size_t>(condition)]);
        else
            begin_waiting_(query);
    }
    void end() override { end_(); }

  private:
    std::string_view extension_;
    PFNGLBEGINCONDITIONALRENDERPROC begin_ = nullptr;
    PFNGLBEGINCONDITIONALRENDERNVXPROC begin_waiting_ = nullptr;
    PFNGLENDCONDITIONALRENDERPROC end_ = nullptr;
};

}  // namespace

std::unique_ptr<ConditionalRender> choose_conditional_render(Platform& platform) {
    if (platform.is_at_least(3, 0)) return std::make_unique<GpuCondition>(platform, "OpenGL 3.0", "");
    if (platform.has_extension("GL_NV_conditional_render"))
        return std::make_unique<GpuCondition>(platform, "GL_NV_conditional_render", "NV");
    if (platform.has_extension("GL_NVX_conditional_render"))
        return std::make_unique<GpuCondition>(platform, "GL_NVX_conditional_render", "NVX");
    return nullptr;
}

}  // namespace apps
