// SPDX-License-Identifier: MIT
// What the device is too old for. A core name is hidden only below the version that made it core, and only in
// compatibility contexts: docs/decisions/0001-version-and-hiding.md.
#pragma once

#include <GL/gl.h>

#include "context/context.h"

namespace glext_emu {

// True where the device does not know <target> of BeginQuery.
bool refuses_target(const Context& ctx, GLenum target);
// True where it has no conditional rendering.
bool refuses_conditional_render(const Context& ctx);
// True where it does not know <mode> of BeginConditionalRender.
bool refuses_conditional_mode(const Context& ctx, GLenum mode);
// True where no result goes into a buffer.
bool refuses_query_buffers(const Context& ctx);

}  // namespace glext_emu
