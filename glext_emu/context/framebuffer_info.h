// SPDX-License-Identifier: MIT
// What the DRAW framebuffer is made of, as far as questions about its depths and samples need it.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstdint>

namespace glext_emu {

struct Context;

struct FramebufferInfo {
    GLuint name = 0;    // 0: the default framebuffer
    GLsizei width = 0;  // in pixels; of attachments of different sizes what they have in common
    GLsizei height = 0;
    GLint samples = 0;     // 0: single-sampled
    GLint layers = 0;      // 0: not layered
    GLint depth_bits = 0;  // 0: no depth buffer
    bool has_float_depth = false;
    GLint stencil_bits = 0;
    bool is_default = false;
    bool is_between_begin_and_end =
        false;                 // then nothing can be asked, and the driver notes the question as an error
    bool is_complete = false;  // all else is 0 where it is not
};

// Changes no state and leaves no error. A drawable's size is that of the last time that a driver took it
// over: when the context was made current, buffers were swapped or the program changed its viewport.
FramebufferInfo draw_framebuffer_info(Context& ctx);

// Of the drawable that the context draws to, whatever framebuffer is bound.
std::uint64_t window_pixels(Context& ctx);

// What one count of the driver's samples query stands for, with the present MULTISAMPLE and draw framebuffer,
// in samples. NV_occlusion_query, issues: samples are counted "even if GL_MULTISAMPLE is disabled but
// GL_SAMPLE_BUFFERS is 1"; Mesa counts pixels then.
GLuint samples_per_count(Context& ctx);

// How many of the driver's counts make a fragment, of which every sample passes. SGIX_depth_pass_instrument:
// with multisampling "the counter is incremented by one for each fragment containing at least one sample for
// which the depth test passed"; the driver counts samples then, and pixels without.
GLuint samples_per_fragment(Context& ctx);

}  // namespace glext_emu
