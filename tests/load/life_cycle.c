// SPDX-License-Identifier: MIT
// What becomes of the hardware's state when contexts and libraries come and go: `life_cycle CASE`.
#include "find_linked.h"

static GLboolean test_is_enabled(const struct Gl* gl) {
    GLboolean enabled = GL_TRUE;
    gl->glGetBooleanv(OCCLUSION_TEST_HP, &enabled);
    return enabled;
}

// HP_occlusion_test, New State: "initial value of FALSE"; its enable likewise.
static int starts_clean(const struct Gl* gl) {
    return test_is_enabled(gl) == GL_FALSE && read_result(gl) == GL_FALSE && gl->glGetError() == GL_NO_ERROR;
}

static void leave_a_result_unread(const struct Gl* gl) {
    gl->glEnable(OCCLUSION_TEST_HP);
    draw_quad(gl, 0);
}

// GL ends a context that is destroyed while current only when it is current no more; OSMesa ends it at once.
static int destroy_current(void) {
    struct Session session = open_session(find_linked);
    const struct Gl gl = find_gl(find_linked);
    leave_a_result_unread(&gl);
    destroy_context(&session, session.context);
#ifndef LOAD_OSMESA
    if (test_is_enabled(&gl) != GL_TRUE) return failed("destroying the current context disabled its test");
    if (read_result(&gl) != GL_TRUE) return failed("destroying the current context lost its result");
    draw_quad(&gl, 0);
    make_current(&session, NULL);
#endif

    session.context = create_context(&session);
    if (!make_current(&session, session.context)) return failed("the next context cannot be made current");
    if (!starts_clean(&gl)) return failed("the next context has state of the destroyed one");
    const int status = check_gl(&gl);
    close_session(&session);
    return status;
}

static int is_among(ContextHandle handle, const ContextHandle* handles, int count) {
    for (int i = 0; i < count; ++i)
        if (handles[i] == handle) return 1;
    return 0;
}

// Several contexts at a time, so that some address is given again whatever else is allocated in between.
// Skipped where the allocator never does (a sanitizer's quarantine).
static int handle_reuse(void) {
    enum { kMostRounds = 40, kContexts = 8 };
    struct Session session = open_session(find_linked);
    const struct Gl gl = find_gl(find_linked);
    ContextHandle destroyed[kMostRounds * kContexts] = {0};
    int reused = 0;
    for (int round = 0; round < kMostRounds && reused < 3; ++round) {
        ContextHandle contexts[kContexts];
        for (int i = 0; i < kContexts; ++i) {
            contexts[i] = create_context(&session);
            reused += is_among(contexts[i], destroyed, round * kContexts);
        }
        for (int i = 0; i < kContexts; ++i) {
            if (!make_current(&session, contexts[i])) return failed("a context cannot be made current");
            if (!starts_clean(&gl))
                return failed("a context has state of an earlier one at the same address");
            leave_a_result_unread(&gl);
        }
        make_current(&session, NULL);
        for (int i = 0; i < kContexts; ++i) destroy_context(&session, contexts[i]);
        memcpy(destroyed + round * kContexts, contexts, sizeof contexts);
    }
    make_current(&session, session.context);
    const int status = check_gl(&gl);
    close_session(&session);
    if (status == kPassed && reused == 0) return kSkipped;
    return status;
}

static int away_and_back(void) {
    struct Session session = open_session(find_linked);
    const struct Gl gl = find_gl(find_linked);
    leave_a_result_unread(&gl);
    make_current(&session, NULL);
    const ContextHandle other = create_context(&session);
    if (!make_current(&session, other)) return failed("a second context cannot be made current");
    if (!starts_clean(&gl)) return failed("a second context has state of the first");
    make_current(&session, session.context);
    make_current(&session, session.context);  // again: it is current already
    destroy_context(&session, other);
    if (test_is_enabled(&gl) != GL_TRUE) return failed("the test was disabled while its context was away");
    if (read_result(&gl) != GL_TRUE) return failed("the result was lost while its context was away");
    gl.glDisable(OCCLUSION_TEST_HP);
    const int status = check_gl(&gl);
    close_session(&session);
    return status;
}

// GL without a context is undefined; Mesa ignores it, and the layer has to as well.
static void call_everything(const struct Gl* gl) {
    gl->glEnable(OCCLUSION_TEST_HP);
    draw_quad(gl, 0);
    read_result(gl);
    gl->glGetString(GL_EXTENSIONS);
    gl->glClear(GL_DEPTH_BUFFER_BIT);
    gl->glDisable(OCCLUSION_TEST_HP);
    gl->glGetError();
}

static int no_context(void) {
    const struct Gl gl = find_gl(find_linked);
    call_everything(&gl);
    struct Session session = open_session(find_linked);
    make_current(&session, NULL);
    call_everything(&gl);
    if (!make_current(&session, session.context)) return failed("the context cannot be made current again");
    if (!starts_clean(&gl)) return failed("calls without a context changed the context's state");
    const int status = check_gl(&gl);
    close_session(&session);
    return status;
}

int main(int argc, char** argv) {
    const char* name = argc == 2 ? argv[1] : "";
    if (strcmp(name, "destroy_current") == 0) return destroy_current();
    if (strcmp(name, "handle_reuse") == 0) return handle_reuse();
    if (strcmp(name, "away_and_back") == 0) return away_and_back();
    if (strcmp(name, "no_context") == 0) return no_context();
    return kBadUse;
}
