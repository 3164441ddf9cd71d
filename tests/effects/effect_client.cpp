// SPDX-License-Identifier: MIT
// A GL program whose frames are told on its command line, so that what a test expects of them stands beside
// what they are. Words of the first two lines are settings; a frame is what the other words say in turn.
//
//   window=W,H  frames=N  samples=S (draw to a framebuffer object with so many)  video=M (MiB of vertices)
//   picture=FILE (the last frame, asked of Mesa behind the layer's back)
//   clear  depth=D  work=US  mesh=T,N  arrays=T,N  immediate=T,N  list=T,N  empty=N
//   fill=W,H,N  paint=W,H,N  stamp=W,H,N  ask=W,H,N  region=W,H,N  unit=W,H,N  read=W,H,N
//   condition=W,H,N
//
// The first four are N draws of T triangles without a pixel: from a buffer, from the program's memory,
// between Begin and End, in a display list; empty calls a list that holds nothing. The next three are N draws
// of a triangle that covers W x H pixels: from a buffer, between Begin and End, in a list. ask is N samples
// queries, each waited for, of W x H pixels without colour, and condition N of them for each of which the GPU
// has to wait; region and unit ask for depths by the proposed extensions. Prints {"results": [...]}, in the
// order of asking.
#include "gl_window.h"

#include <GL/glext_emu.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

namespace {

using effects::fail;

struct Word {
    std::string name;
    std::string text;
    std::vector<double> numbers;
};

Word parse(const char* argument) {
    Word word;
    const char* const equals = std::strchr(argument, '=');
    if (equals == nullptr) return {argument, "", {}};
    word.name.assign(argument, equals);
    word.text = equals + 1;
    for (const char* at = equals; at != nullptr; at = std::strchr(at + 1, ','))
        word.numbers.push_back(std::strtod(at + 1, nullptr));
    return word;
}

template <typename Function>
Function function_of_gl(const char* name) {
    const auto found = reinterpret_cast<Function>(eglGetProcAddress(name));
    if (found == nullptr) fail(std::string("this GL has no ") + name);
    return found;
}

class Client {
  public:
    explicit Client(const std::vector<Word>& words) {
        for (const Word& word : words) {
            if (!is_setting(word)) frame_.push_back(word);
        }
        window_.emplace(width_, height_);
        if (samples_ > 0) effects::draw_to_samples(width_, height_, samples_);
        fill_video_memory();
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LEQUAL);
        glClearColor(0.2F, 0.4F, 0.6F, 1);
        glGenQueries(1, &query_);
    }

    void run() {
        for (int frame = 0; frame < frames_; ++frame) {
            for (const Word& word : frame_) execute(word);
            window_->swap();
        }
        // Not before: the layer counts what is drawn until then, and reading draws.
        if (!picture_.empty()) effects::save_picture(picture_, width_, height_);
        if (const GLenum error = glGetError(); error != GL_NO_ERROR)
            fail("GL error " + std::to_string(error));
        std::printf("{\"results\": [");
        for (std::size_t i = 0; i < results_.size(); ++i)
            std::printf("%s%.9g", i == 0 ? "" : ", ", results_[i]);
        std::printf("]}\n");
    }

  private:
    bool is_setting(const Word& word) {
        const auto number = [&](std::size_t at) { return static_cast<int>(word.numbers.at(at)); };
        if (word.name == "window") {
            width_ = number(0);
            height_ = number(1);
        } else if (word.name == "frames") {
            frames_ = number(0);
        } else if (word.name == "samples") {
            samples_ = number(0);
        } else if (word.name == "video") {
            video_mib_ = number(0);
        } else if (word.name == "picture") {
            picture_ = word.text;
        } else {
            return false;
        }
        return true;
    }

    // The first vertices are one triangle over the whole window, and beyond; the others are one point.
    void fill_video_memory() {
        const std::size_t bytes = static_cast<std::size_t>(video_mib_) << 20;
        vertices_.resize(std::max(bytes / sizeof(float), kMostVertices * 2));
        std::copy(std::begin(kCovering), std::end(kCovering), vertices_.begin());
        glGenBuffers(1, &buffer_);
        glBindBuffer(GL_ARRAY_BUFFER, buffer_);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size() * sizeof(float)),
                     vertices_.data(), GL_STATIC_DRAW);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glEnableClientState(GL_VERTEX_ARRAY);
        list_ = glGenLists(1);
        empty_list_ = glGenLists(1);
        glNewList(empty_list_, GL_COMPILE);
        glEndList();
        covering_list_ = glGenLists(1);
        glNewList(covering_list_, GL_COMPILE);
        draw_between_begin_and_end();
        glEndList();
    }

    void execute(const Word& word) {
        if (word.name == "clear") return glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        if (word.name == "depth") return glDepthRange(word.numbers.at(0), word.numbers.at(0));
        if (word.name == "work") return work(word.numbers.at(0));
        const int count = static_cast<int>(word.numbers.at(word.numbers.size() - 1));
        const int size[] = {static_cast<int>(word.numbers.at(0)),
                            static_cast<int>(word.numbers.at(word.numbers.size() / 2))};
        for (int i = 0; i < count; ++i) {
            glColor3f(static_cast<float>(i % 7) / 7, static_cast<float>(i % 5) / 5, 0.5F);
            repeat(word.name, size[0], size[1]);
        }
    }

    void repeat(const std::string& name, int first, int second) {
        if (name == "fill") return cover(first, second, [&] { draw_covering(); });
        if (name == "paint") return cover(first, second, [] { draw_between_begin_and_end(); });
        if (name == "stamp") return cover(first, second, [&] { glCallList(covering_list_); });
        if (name == "mesh") return draw_from(buffer_, first);
        if (name == "arrays") return draw_from(0, first);
        if (name == "immediate") return draw_points(first);
        if (name == "list") return draw_list(first);
        if (name == "empty") return glCallList(empty_list_);
        if (name == "ask") return ask(first, second);
        if (name == "condition") return draw_on_condition(first, second);
        if (name == "region") return ask_region(first, second);
        if (name == "unit") return ask_unit(first, second);
        if (name == "read") return read(first, second);
        fail("`" + name + "` is no word of a frame");
    }

    void draw_from(GLuint buffer, int triangles) const {
        if (triangles * 3 + 3 > static_cast<int>(kMostVertices)) fail("too many triangles in a draw");
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        glVertexPointer(2, GL_FLOAT, 0, buffer == 0 ? vertices_.data() : nullptr);
        glDrawArrays(GL_TRIANGLES, 3, triangles * 3);
    }

    static void draw_points(int triangles) {
        glBegin(GL_TRIANGLES);
        for (int i = 0; i < triangles * 3; ++i) glVertex2f(0, 0);
        glEnd();
    }

    void draw_list(int triangles) {
        if (list_triangles_ != triangles) {
            glNewList(list_, GL_COMPILE);
            draw_points(triangles);
            glEndList();
            list_triangles_ = triangles;
        }
        glCallList(list_);
    }

    void draw_covering() const {
        glBindBuffer(GL_ARRAY_BUFFER, buffer_);
        glVertexPointer(2, GL_FLOAT, 0, nullptr);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }

    static void draw_between_begin_and_end() {
        glBegin(GL_TRIANGLES);
        for (int i = 0; i < 6; i += 2) glVertex2fv(&kCovering[i]);
        glEnd();
    }

    template <typename Draw>
    void cover(int width, int height, Draw draw) const {
        glViewport(0, 0, width, height);
        draw();
        glViewport(0, 0, width_, height_);
    }

    // A volume: no colour, no depth.
    void query_about(int width, int height) const {
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glDepthMask(GL_FALSE);
        glBeginQuery(GL_SAMPLES_PASSED, query_);
        cover(width, height, [&] { draw_covering(); });
        glEndQuery(GL_SAMPLES_PASSED);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glDepthMask(GL_TRUE);
    }

    void ask(int width, int height) {
        query_about(width, height);
        GLuint samples = 0;
        glGetQueryObjectuiv(query_, GL_QUERY_RESULT, &samples);
        results_.push_back(samples);
    }

    void draw_on_condition(int width, int height) const {
        query_about(width, height);
        glBeginConditionalRender(query_, GL_QUERY_WAIT);
        draw_from(buffer_, 1);
        glEndConditionalRender();
    }

    void ask_region(int width, int height) {
        static const auto get = function_of_gl<PFNGLGETDEPTHREGIONFVEMUPROC>("glGetDepthRegionfvEMU");
        GLfloat depth = -1;
        get(GL_FURTHEST_DEPTH_EMU, 0, 0, width, height, &depth);
        results_.push_back(depth);
    }

    void ask_unit(int width, int height) {
        static const auto begin = function_of_gl<PFNGLBEGINOCCLUSIONUNITEMUPROC>("glBeginOcclusionUnitEMU");
        static const auto end = function_of_gl<PFNGLENDOCCLUSIONUNITEMUPROC>("glEndOcclusionUnitEMU");
        static const auto get = function_of_gl<PFNGLGETOCCLUSIONRECORDSEMUPROC>("glGetOcclusionRecordsEMU");
        static GLuint object = 0;
        if (object == 0) glGenQueries(1, &object);
        GLocclusionrecordEMU record;
        begin(GL_ALL_REGISTERS_EMU, object);
        cover(width, height, [&] { draw_covering(); });
        end();
        get(object, 0, 1, &record);
        results_.push_back(static_cast<double>(record.visible_hits));
        results_.push_back(record.nearest_depth);
    }

    void read(int width, int height) {
        std::vector<GLubyte> pixels(static_cast<std::size_t>(width * height) * 4);
        glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        results_.push_back(pixels[0]);
    }

    static void work(double microseconds) {
        static const auto tell = function_of_gl<PFNGLDEVICEWORKEMUPROC>("glDeviceWorkEMU");
        tell(static_cast<GLuint64>(microseconds * 1000));
    }

    static constexpr std::size_t kMostVertices = 4096;
    static constexpr float kCovering[] = {-1, -1, 3, -1, -1, 3};

    int width_ = 64;
    int height_ = 64;
    int frames_ = 2;
    int samples_ = 0;
    int video_mib_ = 0;
    std::string picture_;
    std::vector<Word> frame_;
    std::optional<effects::Window> window_;
    std::vector<float> vertices_;
    std::vector<double> results_;
    GLuint buffer_ = 0;
    GLuint query_ = 0;
    GLuint list_ = 0;
    GLuint empty_list_ = 0;
    GLuint covering_list_ = 0;
    int list_triangles_ = -1;
};

}  // namespace

int main(int argc, char** argv) {
    std::vector<Word> words;
    for (int i = 1; i < argc; ++i) words.push_back(parse(argv[i]));
    Client(words).run();
}
