// SPDX-License-Identifier: MIT
// Random numbers that are the same bits on every machine: the standard library fixes its engines but not its
// distributions. Generator: SplitMix64 (Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators,
// 2014).
#pragma once

#include <cstdint>

namespace apps {

class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        state_ += 0x9E3779B97F4A7C15ULL;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
        return z ^ (z >> 31);
    }

    /// In [0, 1), a multiple of 2^-24: every value is exact in a float.
    float unit() { return static_cast<float>(next() >> 40) * 0x1p-24F; }

    /// In [low, high).
    float between(float low, float high) { return low + (high - low) * unit(); }

    /// In 0..count-1; count > 0.
    int below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }

    /// An independent stream, so that a part of a scene does not move when another part draws one number
    /// more.
    Random split() { return Random(next() ^ 0xD1B54A32D192ED03ULL); }

  private:
    std::uint64_t state_;
};

}  // namespace apps
