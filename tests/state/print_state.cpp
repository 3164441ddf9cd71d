// SPDX-License-Identifier: MIT
// Runs a fixed script of ordinary GL and prints, after each step, the error and every row of state that
// changed; first all rows, and the extension list. Two machines that are the same to a program print the
// same.
//
//     print_state [egl|glx]
#include <cstdio>
#include <functional>
#include <string>

#include "harness/draw.h"
#include "harness/gl_test.h"
#include "harness/query.h"
#include "scenery.h"
#include "snapshot.h"

namespace {

using conformance::draw_rect;
using conformance::kNear;
using conformance::kWhole;

class Printer {
  public:
    Printer() : last_(reader_.read()) {
        for (const auto& [name, value] : last_) std::printf("%s: %s\n", name.c_str(), value.c_str());
        for (const std::string& name : conformance::extensions()) std::printf("extension %s\n", name.c_str());
        for (const GLenum name : {GL_VENDOR, GL_RENDERER, GL_VERSION, GL_SHADING_LANGUAGE_VERSION}) {
            std::printf("string %s\n", reinterpret_cast<const char*>(glGetString(name)));
        }
    }

    void step(const char* title, const std::function<void()>& commands) {
        commands();
        const std::string first = conformance::error_name(glGetError());
        const std::string second = conformance::error_name(glGetError());
        std::printf("step %s: %s %s\n", title, first.c_str(), second.c_str());
        const tests::Snapshot now = reader_.read();
        for (const std::string& name : tests::changed_rows(last_, now)) {
            std::printf("  %s: %s\n", name.c_str(), now.at(name).c_str());
        }
        last_ = now;
    }

  private:
    tests::StateReader reader_;
    tests::Snapshot last_;
};

void run_errors(Printer& printer) {
    printer.step("unknown capability", [] { glEnable(0xFFFF); });
    printer.step("two errors", [] {
        glLineWidth(-1.0f);
        glEnable(0xFFFF);
    });
    printer.step("the test that is not there", [] { glEnable(GL_OCCLUSION_TEST_HP); });
    printer.step("the result that is not there",
                 [] { conformance::get_integer(GL_OCCLUSION_TEST_RESULT_HP); });
    printer.step("enable inside begin and end", [] {
        glBegin(GL_POINTS);
        glEnable(GL_FOG);
        glEnd();
    });
    printer.step("end without begin", [] { glEnd(); });
    printer.step("pop too often", [] {
        for (int i = 0; i < 20; ++i) glPopAttrib();
    });
    printer.step("bad draws", [] {
        glDrawArrays(0xFFFF, 0, 3);
        glDrawArrays(GL_TRIANGLES, 0, -3);
    });
}

void run_queries(Printer& printer) {
    GLuint names[3] = {};
    printer.step("gen", [&] { glGenQueries(3, names); });
    std::printf("names %u %u %u\n", names[0], names[1], names[2]);
    printer.step("begin", [&] { glBeginQuery(GL_SAMPLES_PASSED, names[0]); });
    printer.step("begin again", [&] { glBeginQuery(GL_SAMPLES_PASSED, names[1]); });
    printer.step("read the active one", [&] {
        GLuint value = conformance::kUntouched;
        glGetQueryObjectuiv(names[0], GL_QUERY_RESULT, &value);
        std::printf("value %u\n", value);
    });
    printer.step("draw", [] { draw_rect(kWhole, kNear); });
    printer.step("end", [] { glEndQuery(GL_SAMPLES_PASSED); });
    printer.step("end again", [] { glEndQuery(GL_SAMPLES_PASSED); });
    printer.step("read", [&] {
        GLuint value = conformance::kUntouched;
        glGetQueryObjectuiv(names[0], GL_QUERY_RESULT, &value);
        std::printf("value %u\n", value);
    });
    printer.step("unbind the query buffer", [] { glBindBuffer(GL_QUERY_BUFFER, 0); });
    printer.step("read to memory", [&] {
        GLuint value = conformance::kUntouched;
        glGetQueryObjectuiv(names[0], GL_QUERY_RESULT, &value);
        std::printf("value %u\n", value);
    });
    printer.step("delete the active one", [&] {
        glBeginQuery(GL_SAMPLES_PASSED, names[2]);
        glDeleteQueries(1, &names[2]);
    });
    printer.step("end the deleted one", [] { glEndQuery(GL_SAMPLES_PASSED); });
    printer.step("name zero", [] { glBeginQuery(GL_SAMPLES_PASSED, 0); });
    printer.step("unknown target", [&] { glBeginQuery(GL_TEXTURE_2D, names[1]); });
    printer.step("unknown name", [] {
        GLuint value = conformance::kUntouched;
        glGetQueryObjectuiv(4711, GL_QUERY_RESULT, &value);
        std::printf("value %u\n", value);
    });
    printer.step("conditional", [&] {
        glBeginConditionalRender(names[0], GL_QUERY_WAIT);
        glBeginQuery(GL_SAMPLES_PASSED, names[0]);
        glEndQuery(GL_SAMPLES_PASSED);
        glEndConditionalRender();
    });
    printer.step("conditional without object", [] { glBeginConditionalRender(4711, GL_QUERY_WAIT); });
}

// Where Mesa departs from the texts, a machine that passes through departs too.
void run_departures(Printer& printer) {
    GLuint names[3] = {};
    glGenQueries(3, names);
    printer.step("label without object", [&] { glObjectLabel(GL_QUERY, names[0], -1, "nobody"); });
    printer.step("conditional, generated only", [&] { glBeginConditionalRender(names[0], GL_QUERY_WAIT); });
    printer.step("boolean", [&] {
        glBeginQuery(GL_ANY_SAMPLES_PASSED, names[1]);
        glEndQuery(GL_ANY_SAMPLES_PASSED);
    });
    printer.step("boolean as conservative",
                 [&] { glBeginQuery(GL_ANY_SAMPLES_PASSED_CONSERVATIVE, names[1]); });
    printer.step("end of conservative", [] { glEndQuery(GL_ANY_SAMPLES_PASSED_CONSERVATIVE); });
    printer.step("gen and delete while active", [&] {
        glBeginQuery(GL_SAMPLES_PASSED, names[2]);
        GLuint other = 0;
        glGenQueries(1, &other);
        glDeleteQueries(1, &other);
        glEndQuery(GL_SAMPLES_PASSED);
    });
    // NV's commands, which a machine that passes through leaves to the driver.
    printer.step("the commands that are not there", [] {
        GLuint name = conformance::kUntouched;
        glGenOcclusionQueriesNV(1, &name);
        glBeginOcclusionQueryNV(name);
        glEndOcclusionQueryNV();
        std::printf("value %u\n", name);
    });
}

void run_lists(Printer& printer) {
    const GLuint list = glGenLists(1);
    printer.step("compile", [list] {
        glNewList(list, GL_COMPILE);
        glEnable(GL_FOG);
        glEnable(GL_OCCLUSION_TEST_HP);
        glPushAttrib(GL_ENABLE_BIT);
        draw_rect(kWhole, kNear);
        glEndList();
    });
    printer.step("call", [list] { glCallList(list); });
    printer.step("pop", [] { glPopAttrib(); });
    printer.step("read pixels", [] {
        glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        std::printf("pixels %d\n", conformance::drawn_pixels());
    });
}

}  // namespace

int main(int argc, char** argv) {
    if (!conformance::open_platform(argc > 1 ? argv[1] : "egl")) {
        std::fprintf(stderr, "%s: no display\n", argv[0]);
        return 1;
    }
    {
        const conformance::Surface surface;
        const conformance::Context context;
        if (!surface || !context || !context.make_current(surface)) return 1;
        conformance::use_pixel_coordinates();
        conformance::draw_occluder();
        tests::disarrange();
        Printer printer;
        run_errors(printer);
        run_queries(printer);
        run_departures(printer);
        run_lists(printer);
        conformance::Context::release_current();
    }
    conformance::close_platform();
    return 0;
}
