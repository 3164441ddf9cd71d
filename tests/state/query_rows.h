// SPDX-License-Identifier: MIT
// The rows of state that tell which queries there are and which is active. GL_NV_occlusion_query shows the
// same objects by its own names, where the machine has it.
#pragma once

#include "state_test.h"

namespace tests {

// Which names are query objects.
inline Rows objects() {
    Rows rows;
    if (conformance::gl_version() >= 15) rows.insert("IsQuery");
    if (conformance::has_extension("GL_NV_occlusion_query")) rows.insert("IsOcclusionQueryNV");
    return rows;
}

// CURRENT_QUERY is asked of each target; only the one may change. GL_CURRENT_OCCLUSION_QUERY_ID_NV has the
// value of GL_CURRENT_QUERY, the shorter name.
inline Rows active(const char* target) {
    Rows rows;
    if (conformance::gl_version() >= 15) rows.insert(std::string("Query ") + target);
    if (conformance::has_extension("GL_NV_occlusion_query"))
        rows = rows + number_from_or_to_zero("GL_CURRENT_QUERY");
    return rows;
}

}  // namespace tests
