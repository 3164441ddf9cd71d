// SPDX-License-Identifier: MIT
// The program for overlay_preload.c: the overlay must see the program's look-ups and its swap, and GL must
// have the layer, whichever of the two preloads comes first.

#include "find_opened.h"

__attribute__((weak)) int overlay_lookups(void);
__attribute__((weak)) int overlay_swaps(void);

static void swap(const struct Session* session) {
#ifdef LOAD_GLX
    void (*swap_buffers)(Display*, GLXDrawable) =
        (void (*)(Display*, GLXDrawable))require_function(find_winsys_symbol, "glXSwapBuffers");
    swap_buffers(session->display, session->window);
#else
    EGLBoolean (*swap_buffers)(EGLDisplay, EGLSurface) =
        (EGLBoolean(*)(EGLDisplay, EGLSurface))require_function(find_winsys_symbol, "eglSwapBuffers");
    swap_buffers(session->display, session->surface);
#endif
}

int main(void) {
    if (!overlay_lookups || !overlay_swaps) return failed("the overlay is not loaded");
    open_gl_libraries();

    struct Session session = open_session(find_winsys_symbol);
    const int lookups_before = overlay_lookups();
    const struct Gl gl = find_gl(find_gl_symbol);
    if (overlay_lookups() != lookups_before + 1)
        return failed("the overlay did not see the look-up of glVertex3f");
    swap(&session);
    if (overlay_swaps() != 1) return failed("the overlay did not see exactly one swap");
    const int status = check_gl(&gl);
    close_session(&session);
    return status;
}
