// SPDX-License-Identifier: MIT
// A value of the layer's in a buffer of the program's, and back: for results that go into a query buffer and
// are not what the driver would write. No binding point changes, and an error that the program has pending
// stays.
#pragma once

#include <optional>

#include "context/context.h"

namespace glext_emu::features {

// True for a buffer that the program has mapped, and not persistently.
bool is_mapped(Context& ctx, GLuint buffer);
// True where the layer can write to the buffer <buffer>.
bool can_correct(Context& ctx, GLuint buffer);

// Writes <size> bytes at <offset>, which the buffer holds.
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
