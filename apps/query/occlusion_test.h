// SPDX-License-Identifier: MIT
// How a culler asks: draw a proxy between begin() and end(), then fetch the answer. Which GL extension
// answers is chosen from what the machine advertises; entry points are taken by name.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "apps/platform/platform.h"

namespace apps {

class OcclusionTest {
  public:
    virtual ~OcclusionTest() = default;

    virtual std::string_view extension() const = 0;

    /// False: one test at a time, its answer fetched before the next begins.
    virtual bool has_queries() const = 0;

    /// Starts a test and gives its id: where there are queries, the name of a GL query object.
    virtual std::uint32_t begin() = 0;
    virtual void end() = 0;

    virtual bool is_available(std::uint32_t id) = 0;

    /// Blocks until the answer is there: samples that passed the depth test, or 0 and 1 of a flag. Asked once
    /// a test; the id is free afterwards.
    virtual std::uint32_t fetch(std::uint32_t id) = 0;
};

/// Of "GL_ARB_occlusion_query" (or GL 1.5, which made it core), "GL_NV_occlusion_query" and
/// "GL_HP_occlusion_test" the first that the machine has, or `wanted` where that is not empty; null if it has
/// none. A context is current.
std::unique_ptr<OcclusionTest> choose_occlusion_test(Platform& platform, std::string_view wanted = {});

}  // namespace apps
