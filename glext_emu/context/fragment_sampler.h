// SPDX-License-Identifier: MIT
// Which windows of a frame have their fragments counted, since the driver takes about 2 us for each: the
// first ones all, of the others about a quarter, and what is left out is taken to be like those before it.
// Deterministic.
#pragma once

#include <cstdint>

namespace glext_emu {

class FragmentSampler {
  public:
    explicit FragmentSampler(bool takes_all) : takes_all_(takes_all) {}

    // True where the next window is to be counted.
    bool picks() {
        ++windows_;
        if (takes_all_ || ++windows_of_frame_ <= kCountedOfFrame) return true;
        // splitmix64: every fourth one in turn would fall in with the order of a binary tree.
        std::uint64_t bits = windows_ * 0x9E3779B97F4A7C15;
        bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9;
        bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EB;
        return ((bits ^ (bits >> 31)) & 3) == 0;
    }
    void next_frame() { windows_of_frame_ = 0; }

  private:
    static constexpr std::uint64_t kCountedOfFrame = 64;

    bool takes_all_;
    std::uint64_t windows_ = 0;
    std::uint64_t windows_of_frame_ = 0;
};

// Fragments of a thing, as they were lately: the last eight weigh most.
class FragmentAverage {
  public:
    void add(std::uint64_t fragments, std::uint64_t things) {
        fragments_ += fragments - fragments_ / kMemory;
        things_ += things - things_ / kMemory;
    }
    std::uint64_t of(std::uint64_t things) const {
        __extension__ using Wide = unsigned __int128;
        return things_ == 0 ? 0 : static_cast<std::uint64_t>(Wide{fragments_} * things / things_);
    }

  private:
    static constexpr std::uint64_t kMemory = 8;

    std::uint64_t fragments_ = 0;
    std::uint64_t things_ = 0;
};

}  // namespace glext_emu
