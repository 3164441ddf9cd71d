// SPDX-License-Identifier: MIT
// Drawing whose fragments can be counted by hand: rectangles of whole pixels at a stated window depth.
//
// Coordinates are pixels from the lower left, depths are window depths in [0, 1]. Drawing uses glBegin/glEnd,
// which every GL since 1.0 has. Everything drawn is white, so that the colour buffer is a second witness of
// what passed.
#pragma once

#include <array>
#include <vector>

#include "harness/gl.h"
#include "harness/platform.h"

namespace conformance {

struct Rect {
    int x;
    int y;
    int width;
    int height;
    int area() const { return width * height; }
};

inline constexpr Rect kWhole = {0, 0, kSurfaceSize, kSurfaceSize};
inline constexpr float kNear = 0.25f;   // in front of kMiddle
inline constexpr float kMiddle = 0.5f;  // where occluders stand
inline constexpr float kFar = 0.75f;    // behind kMiddle

// Fixed-function matrices under which glVertex3f(x, y, z) is the pixel corner (x, y) at window depth z.
void use_pixel_coordinates(int width = kSurfaceSize, int height = kSurfaceSize);

// Colour black, depth as given, stencil 0.
void clear(float depth = 1.0f);

void draw_rect(const Rect& rect, float depth);
void draw_triangle(float depth);             // one primitive over the lower left half of all pixels
void draw_point(int x, int y, float depth);  // the one pixel (x, y)

// An occluder over all pixels at kMiddle, in the cleared depth buffer; leaves the depth test on with LESS and
// the colour buffer black.
void draw_occluder();

// Number of pixels of the read buffer that are not black.
int drawn_pixels(const Rect& rect = kWhole);

std::vector<std::array<GLubyte, 4>> read_colours(const Rect& rect = kWhole);
std::vector<GLfloat> read_depths(const Rect& rect = kWhole);

}  // namespace conformance
