// SPDX-License-Identifier: MIT
// One occlusion test: state first, so that nothing but the proxy is between begin and end.
#include "apps/render/gl_canvas.h"

#include <chrono>
#include <stdexcept>

namespace apps {

bool GlCanvas::is_visible(const Box& proxy) {
    if (!test_) throw std::logic_error("a culler asked on a machine without an occlusion test");
    renderer_.use_proxies();
    test_->begin();
    renderer_.draw_proxy(proxy);
    test_->end();
    ++counters_.queries;

    const auto start = std::chrono::steady_clock::now();
    const bool visible = test_->wait();
    const auto end = std::chrono::steady_clock::now();
    ++counters_.results_waited;
    counters_.stall_ms += std::chrono::duration<double, std::milli>(end - start).count();
    return visible;
}

}  // namespace apps
