// SPDX-License-Identifier: MIT
// What the benchmarks are made of. GL does them (Stage), and the model says how long they should take
// (Model): a mix that is checked is written once and given to both.
#pragma once

#include <cstddef>

namespace apps {

/// Meshes are grids of kMeshColumns by kMeshRows quads, two triangles each, and a draw takes their first
/// triangles.
constexpr int kMeshColumns = 64;
constexpr int kMeshRows = 128;
constexpr int kMeshTriangles = 2 * kMeshColumns * kMeshRows;

enum class MeshSize {
    kSubPixel,  // half a pixel a triangle, so that every second one makes a fragment
    kPixels,    // sixteen pixels a triangle
};

/// Pixels, of a quad of the mesh.
struct QuadSize {
    int width;
    int height;
};
constexpr QuadSize quad_size(MeshSize size) {
    return size == MeshSize::kSubPixel ? QuadSize{1, 1} : QuadSize{8, 4};
}

constexpr double fragments_of(int triangles, MeshSize size) {
    return 0.5 * triangles * quad_size(size).width * quad_size(size).height;
}

/// A box is drawn as the cullers draw theirs, front and back, and we look straight at one face.
constexpr double box_fragments(int side) {
    return 2.0 * side * side;
}

class Commands {
  public:
    virtual ~Commands() = default;

    /// Draws the first <triangles> triangles, two at least, of a mesh in buffer objects.
    virtual void mesh(int triangles, MeshSize size) = 0;
    /// Two triangles with colour and depth, all of whose fragments pass: <eighths> of the window, 1 to 8,
    /// each way.
    virtual void quad(int eighths) = 0;
    /// The next query, from 0: a box of side x side pixels that writes nothing.
    virtual void query(int side) = 0;
    virtual void wait(std::size_t query) = 0;
    /// Depths of side x side pixels to the CPU.
    virtual void read(int side) = 0;
    /// Colour and depth of the window.
    virtual void clear() = 0;
    virtual void finish() = 0;
};

}  // namespace apps
