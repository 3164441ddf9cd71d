// SPDX-License-Identifier: MIT
// A call of the driver's that draws. It can be made again: that is how a draw's fragments are looked at once
// more.
#pragma once

#include <type_traits>

namespace glext_emu::features {

// Refers to a callable that outlives it.
class DrawCall {
  public:
    template <class Call>
    requires(!std::is_same_v<Call, DrawCall>) DrawCall(const Call& call)
        : call_(&call), invoke_([](const void* it) { (*static_cast<const Call*>(it))(); }) {}

    void operator()() const { invoke_(call_); }

  private:
    const void* call_;
    void (*invoke_)(const void*);
};

}  // namespace glext_emu::features
