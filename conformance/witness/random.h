// SPDX-License-Identifier: MIT
// Random numbers of a seed, the same with every compiler and library: a scene that failed somewhere can be
// played again everywhere.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace conformance {

// Steele, Lea, Flood, "Fast splittable pseudorandom number generators", 2014: SplitMix64.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed * 0xD1342543DE82EF95u + 1) {}

    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }
    // One of 0 ... count - 1.
    int below(int count) { return static_cast<int>((bits() >> 33) % static_cast<std::uint64_t>(count)); }
    // One of lowest ... highest.
    int integer(int lowest, int highest) { return lowest + below(highest - lowest + 1); }
    float real(float lowest, float highest) {
        return lowest + (highest - lowest) * (static_cast<float>(bits() >> 40) * 0x1p-24f);
    }
    bool chance(int percent) { return below(100) < percent; }
    template <typename T, std::size_t Size>
    T one_of(const std::array<T, Size>& choices) {
        return choices[static_cast<std::size_t>(below(static_cast<int>(Size)))];
    }

  private:
    std::uint64_t state_;
};

}  // namespace conformance
