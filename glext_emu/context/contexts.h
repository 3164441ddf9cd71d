// SPDX-License-Identifier: MIT
// The life of contexts: from the window system's handle to what the layer remembers. A handle is forgotten
// when its context is destroyed, since its value may be used again; the context itself lives on while it is
// current somewhere.
#pragma once

#include "context/context.h"

namespace glext_emu {

// <share> is the handle of a context to share with, or null.
void context_created(const char* platform, const RealGl& real, const void* handle, const void* share);

// Takes <handle> out before the driver destroys its context: from then on its value may be given to a new
// one. What is returned goes to end_context, or back where the driver refused.
Context* forget_context(const void* handle);
void end_context(Context* ctx);
void restore_context(const void* handle, Context* ctx);

// The thread's context may leave it, by MakeCurrent or ReleaseThread: called before the driver is.
void context_leaves_thread();
// The driver has made <handle> current in this thread; null: none. An unknown handle (a context made before
// the layer was there) is taken up as new.
void context_made_current(const char* platform, const RealGl& real, const void* handle);
// The driver has copied the state groups of <mask> from one context to another (glXCopyContext).
void context_copied(const void* from, const void* to, GLbitfield mask);
// Calls <visit> for each context that is not destroyed yet and not current in another thread. Does nothing
// where a creation or destruction is under way.
void for_each_context(void (*visit)(Context& ctx));
// The program has swapped the buffers of the current context's drawable.
void buffers_swapped();

}  // namespace glext_emu
