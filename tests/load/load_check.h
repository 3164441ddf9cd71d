// SPDX-License-Identifier: MIT
// What every load path is judged by: is the layer under the GL that this path reached?
//
// The witness is GL_HP_occlusion_test, which no Mesa has: under a device that has it the name must be listed
// once and the test must tell a visible quad from a hidden one; without the layer none of it may be there.
// Which of the two is right stands in EXPECT (`layer` or `nothing`), so that each path has a control run.
// A program brings a Finder, its own way to a function, and is otherwise only its load path.
#pragma once

#include <GL/gl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define OCCLUSION_TEST_HP 0x8165         // gl.xml
#define OCCLUSION_TEST_RESULT_HP 0x8166  // gl.xml

#define GL_COMMANDS(F) \
    F(glBegin)         \
    F(glClear)         \
    F(glDisable)       \
    F(glEnable)        \
    F(glEnd)           \
    F(glGetBooleanv)   \
    F(glGetError)      \
    F(glGetString)     \
    F(glVertex3f)

typedef void (*Function)(void);
typedef Function (*Finder)(const char* name);

// typeof of the dereferenced name: libepoxy's names are macros for variables that point to functions.
#define MEMBER(name) __typeof__(*name)* name;
#define FILL(name) table.name = (__typeof__(*name)*)require_function(find, #name);
#define ROW(name) {#name, (Function)name},

enum { kPassed = 0, kFailed = 1, kBadUse = 2, kSkipped = 77 };

struct Gl {
    GL_COMMANDS(MEMBER)
};

struct NamedFunction {
    const char* name;
    Function function;
};

static inline int failed(const char* sentence) {
    fprintf(stderr, "failed: %s\n", sentence);
    return kFailed;
}

// POSIX dlsym returns void*, which ISO C does not convert to a function pointer.
static inline Function as_function(void* pointer) {
    Function function;
    memcpy(&function, &pointer, sizeof function);
    return function;
}

static inline Function find_in_rows(const struct NamedFunction* rows, size_t count, const char* name) {
    for (size_t i = 0; i < count; ++i)
        if (strcmp(rows[i].name, name) == 0) return rows[i].function;
    return NULL;
}

static inline Function require_function(Finder find, const char* name) {
    Function function = find(name);
    if (!function) {
        fprintf(stderr, "failed: this path does not find %s\n", name);
        exit(kFailed);
    }
    return function;
}

static inline struct Gl find_gl(Finder find) {
    struct Gl table;
    GL_COMMANDS(FILL)
    return table;
}

static inline int expects_layer(void) {
    const char* expect = getenv("EXPECT");
    if (expect && strcmp(expect, "layer") == 0) return 1;
    if (expect && strcmp(expect, "nothing") == 0) return 0;
    fprintf(stderr, "EXPECT must be `layer` or `nothing`\n");
    exit(kBadUse);
}

static inline int count_word(const char* words, const char* word) {
    int count = 0;
    const size_t length = strlen(word);
    for (const char* at = words; (at = strstr(at, word)) != NULL; at += length)
        if ((at == words || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0')) ++count;
    return count;
}

// A quad that covers the viewport at window depth (z + 1) / 2.
static inline void draw_quad(const struct Gl* gl, float z) {
    gl->glBegin(GL_QUADS);
    gl->glVertex3f(-1, -1, z);
    gl->glVertex3f(1, -1, z);
    gl->glVertex3f(1, 1, z);
    gl->glVertex3f(-1, 1, z);
    gl->glEnd();
}

static inline GLboolean read_result(const struct Gl* gl) {
    GLboolean result = GL_FALSE;
    gl->glGetBooleanv(OCCLUSION_TEST_RESULT_HP, &result);
    return result;
}

// Needs a current compatibility context with a depth buffer and no state changed. Returns kPassed or kFailed.
static inline int check_gl(const struct Gl* gl) {
    const int layer = expects_layer();
    const char* extensions = (const char*)gl->glGetString(GL_EXTENSIONS);
    if (!extensions) return failed("glGetString(GL_EXTENSIONS) is null");
    if (count_word(extensions, "GL_HP_occlusion_test") != layer)
        return failed(layer ? "GL_HP_occlusion_test is not listed exactly once"
                            : "GL_HP_occlusion_test is listed");

    if (gl->glGetError() != GL_NO_ERROR) return failed("an error is pending before the test");
    gl->glEnable(OCCLUSION_TEST_HP);
    const GLenum enable_error = gl->glGetError();
    if (!layer)
        return enable_error == GL_INVALID_ENUM ? kPassed : failed("enabling an unknown cap is no error");
    if (enable_error != GL_NO_ERROR) return failed("glEnable(GL_OCCLUSION_TEST_HP) is an error");

    gl->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl->glEnable(GL_DEPTH_TEST);
    draw_quad(gl, -0.5f);
    // HP_occlusion_test, New State: "The result is set to FALSE as a side effect of reading it".
    if (read_result(gl) != GL_TRUE) return failed("a visible quad is reported as hidden");
    if (read_result(gl) != GL_FALSE) return failed("reading the result does not clear it");
    draw_quad(gl, 0.5f);
    if (read_result(gl) != GL_FALSE) return failed("a hidden quad is reported as visible");

    gl->glDisable(GL_DEPTH_TEST);
    gl->glDisable(OCCLUSION_TEST_HP);
    return gl->glGetError() == GL_NO_ERROR ? kPassed : failed("an error is pending after the test");
}
