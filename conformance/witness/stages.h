// SPDX-License-Identifier: MIT
// What stands between a scene's vertices and its fragments: fixed function, GLSL, separable stages or
// assembly.
#pragma once

namespace conformance {

enum class Stages {
    kFixed,
    kGlsl,           // a vertex and a fragment stage
    kDiscard,        // a fragment stage alone, which discards a pattern
    kFragmentDepth,  // a fragment stage that writes gl_FragDepth
    kGeometry,       // every triangle twice, in two layers where there are layers
    kSeparable,      // a pipeline object of two programs
    kAssembly,       // ARB_vertex_program and ARB_fragment_program
    kAssemblyKill,   // ARB_fragment_program that kills a pattern
    kAssemblyDepth,  // ARB_fragment_program that writes the depth
    kFetch,          // of the witness: samples of a multisampled texture side by side, 4 a pixel
    kFetchStencil,
};

// Makes <stages> the current ones; they are made at their first use.
void use(Stages stages);

// Whether <stages> take triangles only.
inline bool takes_triangles_only(Stages stages) {
    return stages == Stages::kGeometry;
}

// Frees them all; the context is going.
void forget_stages();

const char* name_of(Stages stages);

}  // namespace conformance
