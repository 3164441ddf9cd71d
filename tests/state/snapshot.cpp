// SPDX-License-Identifier: MIT
// Reads state by every kind of Get that has a name for it.
#include "snapshot.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <sstream>

#include "harness/gl_test.h"

namespace tests {

namespace {

constexpr std::size_t kMostValues = 16;  // a matrix
constexpr std::size_t kRoom = 4096;      // some lists (compressed formats) are longer than any state
constexpr GLuint kIndices = 4;           // of indexed state

struct Row {
    const char* text;
    GLenum value;
};

constexpr Row kEnumerants[] = {
#include "enumerants.inc"
};

bool may_be_read(GLenum name) {
    switch (name) {
        case GL_OCCLUSION_TEST_RESULT_HP:  // reading clears it
        case GL_TIMESTAMP:                 // the time
        case GL_DEVICE_LUID_EXT:           // Mesa 22.3 calls a null pointer, without any layer
        case GL_DEVICE_NODE_MASK_EXT:
            return false;
        default:
            return true;
    }
}

// What a Get left as it was is told from what it wrote by a pattern that no state has.
constexpr int kPattern = 0xA7;

template <typename T, typename Get>
std::string values_of(Get get) {
    static std::array<T, kRoom> values;  // what lies beyond kMostValues is written at times, and never read
    std::memset(values.data(), kPattern, kMostValues * sizeof(T));
    T unwritten;
    std::memset(&unwritten, kPattern, sizeof(T));
    get(values.data());
    std::ostringstream text;
    text.precision(17);
    for (std::size_t i = 0; i < kMostValues; ++i) {
        if (std::memcmp(&values[i], &unwritten, sizeof(T)) == 0) break;
        text << (i ? " " : "") << +values[i];
    }
    return text.str();
}

// One attempt: true where it raised no error.
template <typename Attempt>
bool is_accepted(Attempt attempt) {
    attempt();
    return glGetError() == GL_NO_ERROR;
}

}  // namespace

std::set<std::string> changed_rows(const Snapshot& before, const Snapshot& after) {
    std::set<std::string> names;
    for (const auto& [name, value] : before) {
        const auto found = after.find(name);
        if (found == after.end() || found->second != value) names.insert(name);
    }
    for (const auto& [name, value] : after) {
        if (!before.contains(name)) names.insert(name);
    }
    return names;
}

StateReader::StateReader() : version_(conformance::gl_version()) {
    find_plain();
    find_indexed();
    find_targets();
}

void StateReader::find_plain() {
    std::vector<GLint> room(kRoom);
    for (const Row& row : kEnumerants) {
        if (!may_be_read(row.value)) continue;
        if (is_accepted([&] { glGetIntegerv(row.value, room.data()); }))
            plain_.push_back({row.text, row.value});
        if (is_accepted([&] { glIsEnabled(row.value); })) capabilities_.push_back({row.text, row.value});
        void* pointer = nullptr;
        if (is_accepted([&] { glGetPointerv(row.value, &pointer); }))
            pointers_.push_back({row.text, row.value});
    }
}

void StateReader::find_indexed() {
    if (version_ < 30) return;
    std::vector<GLint> room(kRoom);
    for (const Row& row : kEnumerants) {
        if (!may_be_read(row.value)) continue;
        for (GLuint index = 0; index < kIndices; ++index) {
            if (!is_accepted([&] { glGetIntegeri_v(row.value, index, room.data()); })) break;
            indexed_.push_back({row.text, row.value, index});
        }
    }
}

void StateReader::find_targets() {
    if (version_ < 15 && !conformance::has_extension("GL_ARB_occlusion_query")) return;
    for (const Row& row : kEnumerants) {
        GLint value = 0;
        if (is_accepted([&] { glGetQueryiv(row.value, GL_CURRENT_QUERY, &value); })) {
            query_targets_.push_back({row.text, row.value});
        }
    }
}

Snapshot StateReader::read() const {
    Snapshot snapshot;
    for (const Name& name : plain_) {
        const GLenum pname = name.value;
        snapshot[std::string("Integerv ") + name.text] =
            values_of<GLint>([pname](GLint* values) { glGetIntegerv(pname, values); });
        snapshot[std::string("Floatv ") + name.text] =
            values_of<GLfloat>([pname](GLfloat* values) { glGetFloatv(pname, values); });
        snapshot[std::string("Doublev ") + name.text] =
            values_of<GLdouble>([pname](GLdouble* values) { glGetDoublev(pname, values); });
        snapshot[std::string("Booleanv ") + name.text] =
            values_of<GLboolean>([pname](GLboolean* values) { glGetBooleanv(pname, values); });
    }
    for (const Name& name : indexed_) {
        snapshot["Integeri_v " + std::to_string(name.index) + ' ' + name.text] =
            values_of<GLint>([name](GLint* values) { glGetIntegeri_v(name.value, name.index, values); });
    }
    for (const Name& name : capabilities_) {
        snapshot[std::string("IsEnabled ") + name.text] = glIsEnabled(name.value) ? "1" : "0";
    }
    for (const Name& name : pointers_) {
        void* pointer = nullptr;
        glGetPointerv(name.value, &pointer);
        std::ostringstream text;
        text << reinterpret_cast<std::uintptr_t>(pointer);
        snapshot[std::string("Pointerv ") + name.text] = text.str();
    }
    for (const Name& name : query_targets_) {
        GLint current = -1;
        GLint bits = -1;
        glGetQueryiv(name.value, GL_CURRENT_QUERY, &current);
        glGetQueryiv(name.value, GL_QUERY_COUNTER_BITS, &bits);
        snapshot[std::string("Query ") + name.text] = std::to_string(current) + " of " + std::to_string(bits);
    }
    add_fixed_function(snapshot);
    add_object_names(snapshot, version_);
    return snapshot;
}

std::size_t StateReader::size() const {
    return plain_.size() + capabilities_.size() + indexed_.size() + pointers_.size() + query_targets_.size();
}

}  // namespace tests
