// SPDX-License-Identifier: MIT
// How a culler asks: draw a proxy between begin() and end(), then wait() for the answer. Which GL extension
// answers is chosen from what the machine advertises; entry points are taken by name.
#pragma once

#include <memory>
#include <string_view>

#include "apps/platform/platform.h"

namespace apps {

class OcclusionTest {
  public:
    virtual ~OcclusionTest() = default;

    virtual std::string_view extension() const = 0;

    virtual void begin() = 0;
    virtual void end() = 0;

    /// Blocks until the answer to the last test is there: could a sample pass the depth test? Asked once a
    /// test.
    virtual bool wait() = 0;
};

/// GL_ARB_occlusion_query (or GL 1.5, which made it core), else GL_HP_occlusion_test, else nothing. A context
/// is current.
std::unique_ptr<OcclusionTest> choose_occlusion_test(Platform& platform);

}  // namespace apps
