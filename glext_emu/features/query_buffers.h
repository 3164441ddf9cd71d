// SPDX-License-Identifier: MIT
// A value of the layer's in a buffer of the program's, and back: for results that go into a query buffer and
// are not what the driver would write. Binding points and errors that the program has pending stay as they
// are.
#pragma once

#include <cstring>
#include <optional>

#include "context/context.h"

namespace glext_emu::features {

// Writes <size> bytes at <offset> of <buffer>, an object that exists.
void put_bytes(Context& ctx, GLuint buffer, GLintptr offset, const void* bytes, GLsizeiptr size);
// Reads them; false where the range does not lie in the buffer.
bool take_bytes(Context& ctx, GLuint buffer, GLintptr offset, void* bytes, GLsizeiptr size);

template <class T>
void put_in_buffer(Context& ctx, GLuint buffer, GLintptr offset, T value) {
    put_bytes(ctx, buffer, offset, &value, sizeof value);
}

template <class T>
std::optional<T> taken_from_buffer(Context& ctx, GLuint buffer, GLintptr offset) {
    T value{};
    return take_bytes(ctx, buffer, offset, &value, sizeof value) ? std::optional(value) : std::nullopt;
}

}  // namespace glext_emu::features
