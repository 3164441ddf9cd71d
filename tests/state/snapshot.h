// SPDX-License-Identifier: MIT
// All of GL's gettable state, as rows of text that can be compared and printed.
//
// Which enumerants are state is not written down here: every one of gl.xml is tried once on the driver, and
// what some Get accepts is read from then on. Two values are never read: the result of the HP test, because
// reading clears it (hp_calls.cpp looks at it apart), and the time.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "harness/gl.h"

namespace tests {

// Row by name, e.g. "Integerv GL_VIEWPORT" -> "0 0 64 64".
using Snapshot = std::map<std::string, std::string>;

// The names of the rows that are not the same, or not there, in both.
std::set<std::string> changed_rows(const Snapshot& before, const Snapshot& after);

// State that no Get by one enumerant reaches: lights, materials, texture environments, clip planes, stipple,
// and which names are objects.
void add_fixed_function(Snapshot& snapshot);
void add_object_names(Snapshot& snapshot, int version);

class StateReader {
  public:
    // Finds out what the current context accepts; leaves no error behind.
    StateReader();

    // Raises no error and does not touch one that is pending.
    Snapshot read() const;

    std::size_t size() const;  // number of enumerants that are read

  private:
    struct Name {
        const char* text;
        GLenum value;
        GLuint index = 0;
    };

    void find_plain();
    void find_indexed();
    void find_targets();

    int version_;
    std::vector<Name> plain_;
    std::vector<Name> capabilities_;
    std::vector<Name> indexed_;
    std::vector<Name> pointers_;
    std::vector<Name> query_targets_;
};

}  // namespace tests
