// SPDX-License-Identifier: MIT
// The driver's lists that the program's open list is made of, one after the other.
#pragma once

#include "context/display_lists.h"

namespace glext_emu {

// A list of the driver's that the program never sees.
GLuint make_hidden_list(Context& ctx);
// Deletes it, once nobody plays it.
void delete_hidden_list(Context& ctx, GLuint list);
// Remembers what the driver's list that ends here does to a Begin/End pair.
void note_begin_end(ShareGroup& group, const ListRecording& recording);
// Ends the driver's open list; it is a step of the recipe.
void close_step(Context& ctx);
// Opens the next one.
void open_step(Context& ctx);

// The same around a draw that has to stand alone, so that it can be repeated. Inside, <mode> is compiled.
void open_draw_step(Context& ctx, GLenum mode);
void close_draw_step(Context& ctx, DrawKind kind);

// Inside this scope the driver executes the layer's own calls instead of compiling them. Does nothing where
// no list is being compiled.
class ListPause {
  public:
    explicit ListPause(Context& ctx);
    ~ListPause();
    ListPause(const ListPause&) = delete;
    ListPause& operator=(const ListPause&) = delete;

  private:
    Context& ctx_;
    bool is_pausing_;
};

}  // namespace glext_emu
