// SPDX-License-Identifier: Apache-2.0
// Lanes of double precision for any machine, in plain loops; a part of lanes_baseline.h.
#pragma once
#include <cstdint>

namespace ilot::simd::baseline {

// Double lanes and their masks.
struct D {
  double v[2];
};
struct DMask {
  bool v[2];
};
constexpr std::uint32_t kDoubles = 2;
inline D load_d(const double* p) {
  return {p[0], p[1]};
}
inline D splat_d(double v) {
  return {v, v};
}
inline D operator+(D a, D b) {
  return {a.v[0] + b.v[0], a.v[1] + b.v[1]};
}
inline D operator-(D a, D b) {
  return {a.v[0] - b.v[0], a.v[1] - b.v[1]};
}
inline D operator*(D a, D b) {
  return {a.v[0] * b.v[0], a.v[1] * b.v[1]};
}
inline D operator/(D a, D b) {
  return {a.v[0] / b.v[0], a.v[1] / b.v[1]};
}
inline D root(D a) {
  return {__builtin_sqrt(a.v[0]), __builtin_sqrt(a.v[1])};
}
inline DMask operator<(D a, D b) {
  return {a.v[0] < b.v[0], a.v[1] < b.v[1]};
}
inline DMask operator==(D a, D b) {
  return {a.v[0] == b.v[0], a.v[1] == b.v[1]};
}
inline DMask operator&(DMask a, DMask b) {
  return {a.v[0] && b.v[0], a.v[1] && b.v[1]};
}
inline DMask operator|(DMask a, DMask b) {
  return {a.v[0] || b.v[0], a.v[1] || b.v[1]};
}
inline bool any(DMask m) {
  return m.v[0] || m.v[1];
}
inline D select(DMask m, D yes, D no) {
  return {m.v[0] ? yes.v[0] : no.v[0], m.v[1] ? yes.v[1] : no.v[1]};
}
inline void store_d(double* p, D a) {
  p[0] = a.v[0];
  p[1] = a.v[1];
}
// Returns two to the power of integers from -1022 to 1023. The last bits of 1.5 x 2^52 + n + 1023 are those of the
// exponent.
inline D power_of_two(D whole) {
  D out;
  for (int i = 0; i < 2; ++i) {
    const double shifted = whole.v[i] + (0x1.8p52 + 1023);
    std::uint64_t bits;
    __builtin_memcpy(&bits, &shifted, sizeof bits);
    bits <<= 52;
    __builtin_memcpy(&out.v[i], &bits, sizeof bits);
  }
  return out;
}
// Rounds to the nearest integer, ties to even.
inline void store_rounded(std::int32_t* to, D a) {
  for (int i = 0; i < 2; ++i) to[i] = static_cast<std::int32_t>(__builtin_nearbyint(a.v[i]));
}

// The eight least values that were added, in ascending order. They are kept in order without branches, which would be
// mispredicted.
struct Least8 {
  double v[8];
};
inline Least8 no_least() {
  Least8 s;
  for (double& v : s.v) v = __builtin_inf();
  return s;
}
// Adds a value from 0 on.
inline void add(Least8& s, double d) {
  for (double& slot : s.v) {
    const double smaller = d < slot ? d : slot;
    d = d < slot ? slot : d;
    slot = smaller;
  }
}
inline void store_least(double* to, const Least8& s) {
  for (int i = 0; i < 8; ++i) to[i] = s.v[i];
}

}  // namespace ilot::simd::baseline
