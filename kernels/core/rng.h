// SPDX-License-Identifier: Apache-2.0
// Counter-based random numbers. The i-th number of a key is a pure function of (key, i), so the thread and the order of
// the calls do not matter. The mixer is the finaliser of SplitMix64 (Steele, Lea, Flood 2014).
#pragma once
#include <cstdint>

namespace ilot {

constexpr std::uint64_t mix64(std::uint64_t v) {
  v += 0x9e3779b97f4a7c15ull;
  v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9ull;
  v = (v ^ (v >> 27)) * 0x94d049bb133111ebull;
  return v ^ (v >> 31);
}

class Rng {
 public:
  explicit constexpr Rng(std::uint64_t key) : key_(mix64(key)) {}
  constexpr Rng(std::uint64_t key, std::uint64_t stream) : key_(mix64(mix64(key) ^ stream)) {}

  constexpr std::uint64_t at(std::uint64_t i) const { return mix64(key_ + i * 0xd1342543de82ef95ull); }
  constexpr std::uint64_t next() { return at(counter_++); }

  // Returns a uniform integer in [0, bound), bound > 0. The bias is below bound / 2^64.
  constexpr std::uint64_t below(std::uint64_t bound) {
    return static_cast<std::uint64_t>((static_cast<unsigned __int128>(next()) * bound) >> 64);
  }
  // Returns a uniform multiple of 2^-53 in [0, 1).
  constexpr double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  std::uint64_t key_;
  std::uint64_t counter_ = 0;
};

}  // namespace ilot
