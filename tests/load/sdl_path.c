// SPDX-License-Identifier: MIT
// Load path: SDL2. SDL_VIDEODRIVER and SDL_VIDEO_X11_FORCE_EGL choose GLX or EGL, SDL opens the libraries.
#include <SDL2/SDL.h>

#include "load_check.h"

static Function find_by_sdl(const char* name) {
    return as_function(SDL_GL_GetProcAddress(name));
}

int main(void) {
    const char* driver = getenv("SDL_VIDEODRIVER");
    if (driver && strcmp(driver, "x11") == 0 && !getenv("DISPLAY")) return kSkipped;
    if (SDL_Init(SDL_INIT_VIDEO) != 0) return failed(SDL_GetError());
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 16);
    SDL_Window* window = SDL_CreateWindow("load path", 0, 0, 64, 64,
                                          SDL_WINDOW_OPENGL | SDL_WINDOW_HIDDEN | SDL_WINDOW_BORDERLESS);
    if (!window) return failed(SDL_GetError());
    SDL_GLContext context = SDL_GL_CreateContext(window);
    if (!context) return failed(SDL_GetError());
    const struct Gl gl = find_gl(find_by_sdl);
    // SDL asks an EGL context for GL_MAJOR_VERSION, which a GL before 3.0 refuses, and leaves the error
    // behind.
    gl.glGetError();
    const int status = check_gl(&gl);
    SDL_GL_DeleteContext(context);
    SDL_DestroyWindow(window);
    SDL_Quit();
    return status;
}
