// SPDX-License-Identifier: MIT
// The extension's own state: the far end, the limit, the pixels read; and where the extension is.
#include "emu_depth_region_query/region_test.h"

namespace conformance {
namespace {

using RegionState = RegionTest;

// "advertised by EXTENSIONS"
TEST_F(RegionState, the_extension_is_advertised_and_has_its_commands) {
    int times = 0;
    for (const auto& name : extensions()) times += name == "GL_EMU_depth_region_query";
    EXPECT_EQ(times, 1);
    for (const char* name : {"glFarDepthEMU", "glGetDepthRegionfvEMU", "glGetDepthRegionsfvEMU",
                             "glQueryDepthRegionsEMU", "glQueryDepthRegionsBufferEMU"}) {
        EXPECT_NE(platform().get_proc_address(name), nullptr) << name;
    }
}

// "FAR_DEPTH_EMU, initially ONE"
TEST_F(RegionState, far_is_one_at_first) {
    EXPECT_EQ(get_integer(GL_FAR_DEPTH_EMU), GL_ONE);
}

// "by GetBooleanv, GetIntegerv, GetInteger64v, GetFloatv and GetDoublev"
TEST_F(RegionState, every_get_tells_the_far_end) {
    for (const GLenum end : {GL_ZERO, GL_ONE}) {
        far_depth(end);
        GLboolean as_bool = 7;
        GLint64 as_long = -1;
        GLfloat as_float = -1;
        GLdouble as_double = -1;
        glGetBooleanv(GL_FAR_DEPTH_EMU, &as_bool);
        glGetInteger64v(GL_FAR_DEPTH_EMU, &as_long);
        glGetFloatv(GL_FAR_DEPTH_EMU, &as_float);
        glGetDoublev(GL_FAR_DEPTH_EMU, &as_double);
        EXPECT_EQ(get_integer(GL_FAR_DEPTH_EMU), static_cast<GLint>(end));
        EXPECT_EQ(as_bool, end);
        EXPECT_EQ(as_long, end);
        EXPECT_EQ(as_float, static_cast<GLfloat>(end));
        EXPECT_EQ(as_double, static_cast<GLdouble>(end));
    }
}

// "INVALID_ENUM if <end> is not ONE or ZERO"
TEST_F(RegionState, another_far_end_is_refused) {
    far_depth(GL_ZERO);
    for (const GLenum end : {GLenum{GL_LESS}, GLenum{GL_DEPTH}, GLenum{2}}) {
        far_depth(end);
        EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    }
    EXPECT_EQ(get_integer(GL_FAR_DEPTH_EMU), GL_ZERO);
}

// "FAR_DEPTH_EMU belongs to no attribute group"
TEST_F(RegionState, no_attribute_group_holds_the_far_end) {
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    far_depth(GL_ZERO);
    glPopAttrib();
    EXPECT_EQ(get_integer(GL_FAR_DEPTH_EMU), GL_ZERO);
}

// "MAX_DEPTH_REGIONS_EMU, at least 1"
TEST_F(RegionState, the_limit_is_told_and_as_many_regions_are_answered) {
    const GLint most = get_integer(GL_MAX_DEPTH_REGIONS_EMU);
    ASSERT_GE(most, 1);
    put_depth(kWhole, kTwoFifths);
    const std::vector<Rect> rects(static_cast<std::size_t>(most), Rect{3, 3, 1, 1});
    std::vector<GLfloat> values(rects.size(), kUnwritten);
    get_regions(GL_REGION_OCCLUDED_EMU, most, rects.data(), values.data());
    EXPECT_EQ(values, std::vector<GLfloat>(rects.size(), 1.0f));
}

// "DEPTH_REGION_PIXELS_READ_EMU ... initially zero ... pixels of all regions asked for, after clipping"
TEST_F(RegionState, pixels_are_counted_as_they_are_asked_for) {
    EXPECT_EQ(pixels_read(), 0u);
    furthest({0, 0, 8, 4});
    EXPECT_EQ(pixels_read(), 32u);
    furthest({60, 60, 100, 100});
    EXPECT_EQ(pixels_read(), 48u);
    occluded({8, 8, 0, 5});
    occluded({64, 64, 5, 5});
    EXPECT_EQ(pixels_read(), 48u);
}

// "... also where they overlap"
TEST_F(RegionState, pixels_of_regions_that_overlap_are_counted_for_each) {
    const Rect rects[] = {{0, 0, 10, 10}, {0, 0, 10, 10}, {5, 5, 10, 10}};
    for (const GLenum pname : kEachQuestion) {
        const GLuint64 before = pixels_read();
        GLfloat values[3];
        get_regions(pname, 3, rects, values);
        EXPECT_EQ(pixels_read() - before, 300u);
    }
    std::array<GLuint, 3> ids{};
    glGenQueries(3, ids.data());
    query_regions(GL_FURTHEST_DEPTH_EMU, 3, rects, ids.data());
    EXPECT_EQ(pixels_read(), 1200u);
    glDeleteQueries(3, ids.data());
}

// "a command in error counts none"
TEST_F(RegionState, a_refused_command_reads_no_pixels) {
    GLfloat value = 0;
    get_region(GL_DEPTH, kWhole, &value);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    const GLuint nobody = 0;
    query_regions(GL_FURTHEST_DEPTH_EMU, 1, &kWhole, &nobody);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(pixels_read(), 0u);
}

// "State of the context"
TEST_F(RegionState, each_context_has_its_own_far_end_and_count) {
    far_depth(GL_ZERO);
    furthest(kWhole);
    const Context other({}, &context());
    ASSERT_TRUE(other);
    ASSERT_TRUE(other.make_current(surface()));
    EXPECT_EQ(get_integer(GL_FAR_DEPTH_EMU), GL_ONE);
    EXPECT_EQ(pixels_read(), 0u);
    come_back();
    EXPECT_EQ(get_integer(GL_FAR_DEPTH_EMU), GL_ZERO);
    EXPECT_EQ(pixels_read(), static_cast<GLuint64>(kWhole.area()));
}

}  // namespace
}  // namespace conformance
