// SPDX-License-Identifier: MIT
// Query objects, whichever extension brings them: the six commands, and names that are used again.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <string>
#include <vector>

#include "apps/query/occlusion_test.h"

namespace apps {

/// `Commands`: gen, remove (names), begin(name), end(), is_available(name), result(name).
template <class Commands>
class QueryObjects final : public OcclusionTest {
  public:
    explicit QueryObjects(Platform& platform) : gl_(platform) {}

    QueryObjects(const QueryObjects&) = delete;
    QueryObjects& operator=(const QueryObjects&) = delete;
    ~QueryObjects() override { gl_.remove(static_cast<GLsizei>(all_.size()), all_.data()); }

    std::string_view extension() const override { return Commands::kExtension; }
    bool has_queries() const override { return true; }

    std::uint32_t begin() override {
        if (free_.empty()) make_more();
        const GLuint name = free_.back();
        free_.pop_back();
        gl_.begin(name);
        return name;
    }

    void end() override { gl_.end(); }
    bool is_available(std::uint32_t name) override { return gl_.is_available(name); }

    std::uint32_t fetch(std::uint32_t name) override {
        const std::uint32_t samples = gl_.result(name);
        free_.push_back(name);
        return samples;
    }

  private:
    void make_more() {
        constexpr GLsizei kAtOnce = 64;
        GLuint names[kAtOnce] = {};
        gl_.gen(kAtOnce, names);
        all_.insert(all_.end(), names, names + kAtOnce);
        free_.insert(free_.end(), std::rbegin(names), std::rend(names));
    }

    Commands gl_;
    std::vector<GLuint> all_, free_;
};

/// Fetches entry point `name`.
template <class Function>
void find_command(Platform& platform, Function& function, const std::string& name) {
    function = reinterpret_cast<Function>(platform.function(name.c_str()));
}

}  // namespace apps
