// SPDX-License-Identifier: MIT
// The context, what it can, and the state that a scene starts from.
#include "witness/machine.h"

#include <cstdio>
#include <string>

#include "witness/stages.h"

namespace conformance {

namespace {

constexpr int kEnoughRecords = 50;  // for a share to say something

// Owned by GoogleTest.
auto* const the_machine = static_cast<Machine*>(::testing::AddGlobalTestEnvironment(new Machine));

}  // namespace

Machine& machine() {
    return *the_machine;
}

void Machine::SetUp() {
    surface_.emplace();
    context_.emplace();
    ASSERT_TRUE(*surface_ && *context_ && context_->make_current(*surface_)) << "no compatibility context";
    ASSERT_FALSE(lacks(32)) << "the scenes need GL 3.2";
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (has_extension("GL_ARB_stencil_texturing")) most_samples = get_integer(GL_MAX_DEPTH_TEXTURE_SAMPLES);
    has_indirect_draws = has_extension("GL_ARB_draw_indirect");
    const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    const bool is_softpipe = renderer.find("softpipe") != std::string::npos;
    repeats_lines = !is_softpipe;
    layers_agree = !is_softpipe;
    has_unit = has_extension("GL_EMU_occlusion_unit");
    has_regions = has_extension("GL_EMU_depth_region_query");
    ASSERT_TRUE(no_error());
}

void Machine::TearDown() {
    const auto [records, hits, depths] = determinacy;
    if (records > 0) {
        std::printf("of %d records, not determined: projected hits %d, nearest depth %d\n", records, hits,
                    depths);
    }
    if (records >= kEnoughRecords) {
        EXPECT_LE(4 * hits, records) << "more than a quarter was never compared";
        EXPECT_LE(4 * depths, records) << "more than a quarter was never compared";
    }
    if (context_ && *context_) {
        forget_stages();
        Context::release_current();
    }
    context_.reset();
    surface_.reset();
}

void neutral() {
    use(Stages::kFixed);
    constexpr std::array kSwitches = {
        GL_ALPHA_TEST,
        GL_BLEND,
        GL_COLOR_LOGIC_OP,
        GL_CULL_FACE,
        GL_DEPTH_TEST,
        GL_STENCIL_TEST,
        GL_SCISSOR_TEST,
        GL_POLYGON_OFFSET_FILL,
        GL_POLYGON_OFFSET_LINE,
        GL_POLYGON_OFFSET_POINT,
        GL_POLYGON_STIPPLE,
        GL_LINE_STIPPLE,
        GL_SAMPLE_ALPHA_TO_COVERAGE,
        GL_SAMPLE_COVERAGE,
        GL_CLIP_PLANE0,
        GL_DEPTH_CLAMP,
    };
    for (const GLenum name : kSwitches) glDisable(static_cast<GLenum>(name));
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDepthRange(0.0, 1.0);
    glStencilMask(0xFF);
    glStencilFunc(GL_ALWAYS, 0, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    glLineWidth(1.0f);
    glPointSize(1.0f);
    glPixelZoom(1.0f, 1.0f);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace conformance
