// SPDX-License-Identifier: MIT
// The slow paths that the generated wrappers call, a chapter of the specification each. Every one of them
// refuses what the texts refuse, remembers, and forwards to the driver, in that order.
#pragma once

#include "context/context.h"
#include "features/draw_call.h"
#include "features/triangles.h"

namespace glext_emu::features {

// draw_scope.cpp
// Executes a draw; everything that wants to know of draws, or to repeat them, is told here.
void draw(Context& ctx, Triangles triangles, DrawCall call);
// The same of a primitive, <list> being what stands between its Begin and End.
void draw_collected(Context& ctx, GLenum mode, GLuint list);
void draw_pixels(Context& ctx, GLsizei width, GLsizei height, GLenum format, GLenum type, const void* pixels);
void copy_pixels(Context& ctx, GLint x, GLint y, GLsizei width, GLsizei height, GLenum type);
void begin(Context& ctx, GLenum mode);
void end(Context& ctx);

// device_commands.cpp
void clear(Context& ctx, GLbitfield mask);
void clear_bufferfi(Context& ctx, GLenum buffer, GLint index, GLfloat depth, GLint stencil);
void clear_bufferfv(Context& ctx, GLenum buffer, GLint index, const GLfloat* value);
void clear_bufferiv(Context& ctx, GLenum buffer, GLint index, const GLint* value);
void clear_bufferuiv(Context& ctx, GLenum buffer, GLint index, const GLuint* value);
void clear_named_framebufferfi(Context& ctx, GLuint framebuffer, GLenum buffer, GLint index, GLfloat depth,
                               GLint stencil);
void clear_named_framebufferfv(Context& ctx, GLuint framebuffer, GLenum buffer, GLint index,
                               const GLfloat* value);
void clear_named_framebufferiv(Context& ctx, GLuint framebuffer, GLenum buffer, GLint index,
                               const GLint* value);
void clear_named_framebufferuiv(Context& ctx, GLuint framebuffer, GLenum buffer, GLint index,
                                const GLuint* value);
void read_pixels(Context& ctx, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type,
                 void* pixels);
void readn_pixels(Context& ctx, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type,
                  GLsizei size, void* data);
void buffer_data(Context& ctx, GLenum target, GLsizeiptr size, const void* data, GLenum usage);
void buffer_storage(Context& ctx, GLenum target, GLsizeiptr size, const void* data, GLbitfield flags);
void named_buffer_data(Context& ctx, GLuint buffer, GLsizeiptr size, const void* data, GLenum usage);
void named_buffer_storage(Context& ctx, GLuint buffer, GLsizeiptr size, const void* data, GLbitfield flags);
void delete_buffers(Context& ctx, GLsizei n, const GLuint* buffers);
void device_work_emu(Context& ctx, GLuint64 nanoseconds);

// fences.cpp
void finish(Context& ctx);
GLsync fence_sync(Context& ctx, GLenum condition, GLbitfield flags);
GLenum client_wait_sync(Context& ctx, GLsync sync, GLbitfield flags, GLuint64 timeout_ns);
void get_synciv(Context& ctx, GLsync sync, GLenum pname, GLsizei count, GLsizei* length, GLint* values);
void delete_sync(Context& ctx, GLsync sync);

// occlusion_test.cpp: GL_HP_occlusion_test.
void enable(Context& ctx, GLenum cap);
void disable(Context& ctx, GLenum cap);
GLboolean is_enabled(Context& ctx, GLenum cap);
void push_attrib(Context& ctx, GLbitfield mask);
void pop_attrib(Context& ctx);
// Reads the flag as a Get does: it waits for the clock, and the flag is FALSE afterwards.
bool read_test_result(Context& ctx);

// instruments.cpp: GL_SGIX_instruments, GL_SGIX_depth_pass_instrument, GL_SGIX_occlusion_instrument.
bool is_instrument(const Context& ctx, GLenum cap);
bool is_instrument_enabled(const Context& ctx, GLenum cap);
void set_instrument(Context& ctx, GLenum cap, bool is_enabled);
std::uint64_t depth_pass_max(Context& ctx);
// Waits for all measurements that were asked for, and writes them.
void deliver_measurements(Context& ctx);
void instruments_buffer_sgix(Context& ctx, GLsizei size, GLint* buffer);
void start_instruments_sgix(Context& ctx);
void stop_instruments_sgix(Context& ctx, GLint marker);
void read_instruments_sgix(Context& ctx, GLint marker);
GLint poll_instruments_sgix(Context& ctx, GLint* marker);
GLint get_instruments_sgix(Context& ctx);
void get_pointerv(Context& ctx, GLenum pname, void** params);

// visibility_test.cpp: GL_HP_visibility_test.
bool is_visibility_test(const Context& ctx, GLenum cap);
void set_visibility_test(Context& ctx, bool is_enabled);
void visibility_buffer_hp(Context& ctx, GLsizei size, GLboolean* buffer, GLboolean wait_on_get);
void next_visibility_test_hp(Context& ctx);
// Writes the results that have come; true where all of a batch that has ended have.
bool read_visibility_tests(Context& ctx);

// depth_regions.cpp: GL_EMU_depth_region_query.
GLint max_depth_regions();
void far_depth_emu(Context& ctx, GLenum end);
void get_depth_regionfv_emu(Context& ctx, GLenum pname, GLint x, GLint y, GLsizei width, GLsizei height,
                            GLfloat* value);
void get_depth_regionsfv_emu(Context& ctx, GLenum pname, GLsizei count, const GLint* rectangles,
                             GLfloat* values);
void query_depth_regions_emu(Context& ctx, GLenum pname, GLsizei count, const GLint* rectangles,
                             const GLuint* ids);
void query_depth_regions_buffer_emu(Context& ctx, GLenum pname, GLsizei count, const GLint* rectangles,
                                    GLuint buffer, GLintptr offset);

// occlusion_unit.cpp, occlusion_shapes.cpp: GL_EMU_occlusion_unit.
GLint max_occlusion_shapes();
GLint unit_counter_bits();
// True, with the error raised, where neither form of the query may begin now.
bool refuses_unit_query(Context& ctx, GLbitfield registers, GLuint id);
void begin_occlusion_unit_emu(Context& ctx, GLbitfield registers, GLuint id);
void end_occlusion_unit_emu(Context& ctx);
void occlusion_unit_shapes_emu(Context& ctx, GLbitfield registers, GLenum shape, GLsizei count,
                               const GLfloat* vertices, const GLfloat* matrix, GLuint id);
void get_occlusion_records_emu(Context& ctx, GLuint id, GLsizei first, GLsizei count,
                               GLocclusionrecordEMU* records);
// False in feedback and selection mode, and while primitives are discarded.
bool makes_fragments(Context& ctx);
// A draw while a unit's query is active.
void draw_under_unit(Context& ctx, DrawKind kind, DrawCall call);
// The same, and a device under its own clock is told of it once.
void draw_watched(Context& ctx, Triangles triangles, DrawCall call);

// query_objects.cpp
void gen_queries(Context& ctx, GLsizei n, GLuint* ids);
void create_queries(Context& ctx, GLenum target, GLsizei n, GLuint* ids);
void delete_queries(Context& ctx, GLsizei n, const GLuint* ids);
GLboolean is_query(Context& ctx, GLuint id);
void begin_query(Context& ctx, GLenum target, GLuint id);
void begin_query_indexed(Context& ctx, GLenum target, GLuint index, GLuint id);
void end_query(Context& ctx, GLenum target);
void end_query_indexed(Context& ctx, GLenum target, GLuint index);
// Begin and End of an occlusion query as they are executed, by whichever extension's command.
void start_query(Context& ctx, GLenum target, GLuint id);
void finish_query(Context& ctx, GLenum target);
void query_counter(Context& ctx, GLuint id, GLenum target);
// A generated name has become an object of a target of the driver's, unless that failed.
void note_object(Context& ctx, GLuint id);
void get_queryiv(Context& ctx, GLenum target, GLenum pname, GLint* params);
void get_query_indexediv(Context& ctx, GLenum target, GLuint index, GLenum pname, GLint* params);
void object_label(Context& ctx, GLenum identifier, GLuint name, GLsizei length, const GLchar* label);
void get_object_label(Context& ctx, GLenum identifier, GLuint name, GLsizei size, GLsizei* length,
                      GLchar* label);

// nv_occlusion_query.cpp
void gen_occlusion_queries_nv(Context& ctx, GLsizei n, GLuint* ids);
void delete_occlusion_queries_nv(Context& ctx, GLsizei n, const GLuint* ids);
GLboolean is_occlusion_query_nv(Context& ctx, GLuint id);
void begin_occlusion_query_nv(Context& ctx, GLuint id);
void end_occlusion_query_nv(Context& ctx);
void get_occlusion_queryiv_nv(Context& ctx, GLuint id, GLenum pname, GLint* params);
void get_occlusion_queryuiv_nv(Context& ctx, GLuint id, GLenum pname, GLuint* params);
// The bits of the samples-passed counter.
GLint counter_bits(Context& ctx);

// timer_queries.cpp: under the device's clock.
// Begin and End of a query that has nothing to do with occlusion.
void start_timed_query(Context& ctx, GLenum target, GLuint id);
void end_timed_query(Context& ctx, GLenum target);
void stamp_query(Context& ctx, GLuint id, GLenum target);
bool is_timer(GLenum target);
// What a timer query that has ended shows; its result is there.
std::uint64_t device_nanoseconds(Context& ctx, const QueryRecord& timer);
// The object's timer, if it is one, is begun anew or deleted.
void forget_timer(Context& ctx, GLuint id);

// query_results.cpp
void get_query_objectiv(Context& ctx, GLuint id, GLenum pname, GLint* params);
void get_query_objectuiv(Context& ctx, GLuint id, GLenum pname, GLuint* params);
void get_query_objecti64v(Context& ctx, GLuint id, GLenum pname, GLint64* params);
void get_query_objectui64v(Context& ctx, GLuint id, GLenum pname, GLuint64* params);
// RESULT or RESULT_AVAILABLE of a query that has ended, to client memory whatever query buffer is bound.
void read_count(Context& ctx, GLuint id, GLenum pname, GLint* params);
void read_count(Context& ctx, GLuint id, GLenum pname, GLuint* params);
void get_query_buffer_objectiv(Context& ctx, GLuint id, GLuint buffer, GLenum pname, GLintptr offset);
void get_query_buffer_objectuiv(Context& ctx, GLuint id, GLuint buffer, GLenum pname, GLintptr offset);
void get_query_buffer_objecti64v(Context& ctx, GLuint id, GLuint buffer, GLenum pname, GLintptr offset);
void get_query_buffer_objectui64v(Context& ctx, GLuint id, GLuint buffer, GLenum pname, GLintptr offset);

// conditional_render.cpp
void begin_conditional_render(Context& ctx, GLuint id, GLenum mode);
void begin_conditional_render_nvx(Context& ctx, GLuint id);
void end_conditional_render(Context& ctx);

// display_lists.cpp
void new_list(Context& ctx, GLuint list, GLenum mode);
void end_list(Context& ctx);
void call_list(Context& ctx, GLuint list);
void call_lists(Context& ctx, GLsizei n, GLenum type, const void* lists);
void delete_lists(Context& ctx, GLuint list, GLsizei range);
GLboolean is_list(Context& ctx, GLuint list);

// state_queries.cpp
void get_booleanv(Context& ctx, GLenum pname, GLboolean* params);
void get_integerv(Context& ctx, GLenum pname, GLint* params);
void get_integer64v(Context& ctx, GLenum pname, GLint64* params);
void get_floatv(Context& ctx, GLenum pname, GLfloat* params);
void get_doublev(Context& ctx, GLenum pname, GLdouble* params);
const GLubyte* get_string(Context& ctx, GLenum name);
const GLubyte* get_stringi(Context& ctx, GLenum name, GLuint index);
GLenum get_error(Context& ctx);

}  // namespace glext_emu::features
