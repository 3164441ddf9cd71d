// SPDX-License-Identifier: MIT
// What conditional rendering does not discard: everything that is no rendering command (COND-19, COND-27,
// COND-29).
#include <vector>

#include "nv_conditional_render/conditional_test.h"

// After GoogleTest, whose words its macros take.
#include <X11/Xlib.h>
#include <X11/Xutil.h>

namespace conformance {
namespace {

// GL 4.5, 2.4 lists the rendering commands; all others are executed. Each test works under a query of no
// samples.
class Preserved : public ConditionalTest {
  protected:
    template <typename Commands>
    static void hidden(Commands commands) {
        const Answered query(Answered::kHidden);
        glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
        draw_rect({0, 0, 8, 8}, kNear);  // something to copy and to read
        glFlush();                       // drawn before the block, not collected
        under(query, GL_QUERY_WAIT, [&] {
            commands();
            draw_rect(kWhole, kNear);  // that the block discards at all
        });
        EXPECT_TRUE(no_error());
        EXPECT_EQ(drawn_pixels(), 64);
    }

    // Number of texels of a level that are not black.
    static int white_texels(GLint level, int size) {
        std::vector<GLubyte> texels(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
        glGetTexImage(GL_TEXTURE_2D, level, GL_RED, GL_UNSIGNED_BYTE, texels.data());
        int white = 0;
        for (const GLubyte texel : texels) white += texel != 0;
        return white;
    }
};

const std::vector<GLubyte> kWhiteTexels(4 * 16 * 16, 255);

void define_black(int size) {
    const std::vector<GLubyte> black(static_cast<std::size_t>(4 * size * size), 0);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, black.data());
}

TEST_F(Preserved, texture_uploads) {
    hidden([] {
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, kWhiteTexels.data());
    });
    EXPECT_EQ(white_texels(0, 16), 256);
    define_black(16);
    hidden([] {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, kWhiteTexels.data());
    });
    EXPECT_EQ(white_texels(0, 16), 16);
}

TEST_F(Preserved, copies_into_textures) {
    hidden([] { glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 16, 16, 0); });
    EXPECT_EQ(white_texels(0, 16), 64);
    define_black(16);
    hidden([] { glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 0, 8, 4); });
    EXPECT_EQ(white_texels(0, 16), 16);
}

TEST_F(Preserved, generated_mipmaps) {
    define_black(16);
    hidden([] {
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, kWhiteTexels.data());
        glGenerateMipmap(GL_TEXTURE_2D);
    });
    EXPECT_EQ(white_texels(1, 8), 64);
    EXPECT_EQ(white_texels(4, 1), 1);
}

TEST_F(Preserved, cleared_textures) {
    if (const auto why = lacks(44, "GL_ARB_clear_texture")) GTEST_SKIP() << *why;
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    define_black(16);
    hidden([&] { glClearTexImage(name, 0, GL_RGBA, GL_UNSIGNED_BYTE, kWhiteTexels.data()); });
    EXPECT_EQ(white_texels(0, 16), 256);
    glDeleteTextures(1, &name);
}

TEST_F(Preserved, buffer_contents) {
    GLuint name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(GL_ARRAY_BUFFER, name);
    const auto first = [] {
        GLuint value = kUntouched;
        glGetBufferSubData(GL_ARRAY_BUFFER, 0, sizeof value, &value);
        return value;
    };
    const GLuint one = 1;
    const GLuint two = 2;
    const GLuint three = 3;
    hidden([&] { glBufferData(GL_ARRAY_BUFFER, sizeof one, &one, GL_STATIC_DRAW); });
    EXPECT_EQ(first(), 1u);
    hidden([&] { glBufferSubData(GL_ARRAY_BUFFER, 0, sizeof two, &two); });
    EXPECT_EQ(first(), 2u);
    if (!lacks(43, "GL_ARB_clear_buffer_object")) {
        hidden(
            [&] { glClearBufferData(GL_ARRAY_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &three); });
        EXPECT_EQ(first(), 3u);
    }
    glDeleteBuffers(1, &name);
}

TEST_F(Preserved, reading_pixels) {
    int pixels = 0;
    hidden([&] { pixels = drawn_pixels(); });
    EXPECT_EQ(pixels, 64);
}

TEST_F(Preserved, state_and_matrices) {
    hidden([] {
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, 3, 5);
        glMatrixMode(GL_PROJECTION);
        glPushMatrix();
        glTranslatef(10.0f, 0.0f, 0.0f);
    });
    EXPECT_TRUE(glIsEnabled(GL_SCISSOR_TEST));
    GLint depth = -1;
    glGetIntegerv(GL_PROJECTION_STACK_DEPTH, &depth);
    EXPECT_EQ(depth, 2);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    clear();
    glDisable(GL_SCISSOR_TEST);
    EXPECT_EQ(drawn_pixels(), 64 - 15) << "only the scissored pixels are cleared";
}

// COND-19. Query commands are no rendering commands: they run, and count what is drawn: nothing.
TEST_F(Preserved, queries) {
    const Query query;
    hidden([&] {
        query.begin();
        EXPECT_EQ(current_query(GL_SAMPLES_PASSED), static_cast<GLint>(query.name()));
        draw_rect(kWhole, kNear);
        query.end();
        EXPECT_EQ(query.result(), 0u);
    });
    EXPECT_TRUE(glIsQuery(query.name()));
}

// COND-29. Nor are Flush and Finish.
TEST_F(Preserved, flush_and_finish) {
    hidden([] {
        draw_rect(kWhole, kNear);
        glFlush();
        draw_rect(kWhole, kNear);
        glFinish();
    });
}

// Pixels of the screen that are not black where the window stands; -1 without a screen.
int pixels_on_screen() {
    Display* const display = XOpenDisplay(nullptr);
    if (!display) return -1;
    XImage* const image =
        XGetImage(display, DefaultRootWindow(display), 0, 0, kSurfaceSize, kSurfaceSize, AllPlanes, ZPixmap);
    int pixels = 0;
    for (int y = 0; y < kSurfaceSize; ++y) {
        for (int x = 0; x < kSurfaceSize; ++x) pixels += (XGetPixel(image, x, y) & 0xFFFFFF) != 0;
    }
    XDestroyImage(image);
    XCloseDisplay(display);
    return pixels;
}

// COND-27. GLX 1.4, 3.3.10 (EGL 1.5, 3.9.3): a swap is a command of the window system, no rendering command.
// The front buffer is looked at on the screen; a surface without one only has to go on as before.
TEST_F(Preserved, swaps) {
    const bool has_front = get_integer(GL_DOUBLEBUFFER) == GL_TRUE;
    const Answered query(Answered::kHidden);
    surface().swap();
    if (has_front) {
        ASSERT_EQ(pixels_on_screen(), 0);
    }
    draw_rect({0, 0, 8, 8}, kNear);
    glFlush();
    under(query, GL_QUERY_WAIT, [&] {
        surface().swap();
        draw_rect(kWhole, kNear);
    });
    if (has_front) {
        EXPECT_EQ(pixels_on_screen(), 64);
    } else {
        EXPECT_EQ(drawn_pixels(), 64);
    }
}

}  // namespace
}  // namespace conformance
