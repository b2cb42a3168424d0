// SPDX-License-Identifier: Apache-2.0
// Eight float lanes out of two SSE2 registers, or plain loops where there is no SSE2.
#pragma once
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>

namespace ilot::simd::baseline {

struct F8 {
  __m128 lo, hi;
};
inline F8 load8(const float* p) {
  return {_mm_loadu_ps(p), _mm_loadu_ps(p + 4)};
}
inline void store8(float* p, F8 a) {
  _mm_storeu_ps(p, a.lo);
  _mm_storeu_ps(p + 4, a.hi);
}
inline F8 splat(float v) {
  return {_mm_set1_ps(v), _mm_set1_ps(v)};
}
inline F8 operator+(F8 a, F8 b) {
  return {_mm_add_ps(a.lo, b.lo), _mm_add_ps(a.hi, b.hi)};
}
inline F8 operator-(F8 a, F8 b) {
  return {_mm_sub_ps(a.lo, b.lo), _mm_sub_ps(a.hi, b.hi)};
}
inline F8 operator*(F8 a, F8 b) {
  return {_mm_mul_ps(a.lo, b.lo), _mm_mul_ps(a.hi, b.hi)};
}
inline F8 max8(F8 a, F8 b) {
  return {_mm_max_ps(a.lo, b.lo), _mm_max_ps(a.hi, b.hi)};
}
inline F8 abs8(F8 a) {
  const __m128 sign = _mm_set1_ps(-0.0f);
  return {_mm_andnot_ps(sign, a.lo), _mm_andnot_ps(sign, a.hi)};
}
// Bit i is set where a[i] <= b[i].
inline std::uint32_t mask_le(F8 a, F8 b) {
  return static_cast<std::uint32_t>(_mm_movemask_ps(_mm_cmple_ps(a.lo, b.lo))) |
         static_cast<std::uint32_t>(_mm_movemask_ps(_mm_cmple_ps(a.hi, b.hi))) << 4;
}

// Per-lane counters of how often a condition held.
struct Count8 {
  __m128i lo, hi;
};
inline Count8 zero_count() {
  return {_mm_setzero_si128(), _mm_setzero_si128()};
}
inline void count_le(Count8& c, F8 a, F8 b) {
  c.lo = _mm_sub_epi32(c.lo, _mm_castps_si128(_mm_cmple_ps(a.lo, b.lo)));
  c.hi = _mm_sub_epi32(c.hi, _mm_castps_si128(_mm_cmple_ps(a.hi, b.hi)));
}
inline void count_both_le(Count8& c, F8 a, F8 b, F8 e, F8 f) {
  c.lo = _mm_sub_epi32(c.lo, _mm_castps_si128(_mm_and_ps(_mm_cmple_ps(a.lo, b.lo), _mm_cmple_ps(e.lo, f.lo))));
  c.hi = _mm_sub_epi32(c.hi, _mm_castps_si128(_mm_and_ps(_mm_cmple_ps(a.hi, b.hi), _mm_cmple_ps(e.hi, f.hi))));
}
inline std::uint32_t total(Count8 c) {
  alignas(16) std::uint32_t v[4];
  _mm_store_si128(reinterpret_cast<__m128i*>(v), _mm_add_epi32(c.lo, c.hi));
  return v[0] + v[1] + v[2] + v[3];
}

}  // namespace ilot::simd::baseline

#else

namespace ilot::simd::baseline {

struct F8 {
  float v[8];
};
inline F8 load8(const float* p) {
  F8 r;
  for (int i = 0; i < 8; ++i) r.v[i] = p[i];
  return r;
}
inline void store8(float* p, F8 a) {
  for (int i = 0; i < 8; ++i) p[i] = a.v[i];
}
inline F8 splat(float s) {
  F8 r;
  for (float& v : r.v) v = s;
  return r;
}
inline F8 operator+(F8 a, F8 b) {
  for (int i = 0; i < 8; ++i) a.v[i] += b.v[i];
  return a;
}
inline F8 operator-(F8 a, F8 b) {
  for (int i = 0; i < 8; ++i) a.v[i] -= b.v[i];
  return a;
}
inline F8 operator*(F8 a, F8 b) {
  for (int i = 0; i < 8; ++i) a.v[i] *= b.v[i];
  return a;
}
inline F8 max8(F8 a, F8 b) {
  for (int i = 0; i < 8; ++i) a.v[i] = a.v[i] > b.v[i] ? a.v[i] : b.v[i];
  return a;
}
inline F8 abs8(F8 a) {
  for (float& v : a.v) v = v < 0 ? -v : v;
  return a;
}
inline std::uint32_t mask_le(F8 a, F8 b) {
  std::uint32_t m = 0;
  for (int i = 0; i < 8; ++i) m |= static_cast<std::uint32_t>(a.v[i] <= b.v[i]) << i;
  return m;
}
struct Count8 {
  std::uint32_t n;
};
inline Count8 zero_count() {
  return {0};
}
inline void count_le(Count8& c, F8 a, F8 b) {
  for (int i = 0; i < 8; ++i) c.n += a.v[i] <= b.v[i];
}
inline void count_both_le(Count8& c, F8 a, F8 b, F8 e, F8 f) {
  for (int i = 0; i < 8; ++i) c.n += (a.v[i] <= b.v[i]) & (e.v[i] <= f.v[i]);
}
inline std::uint32_t total(Count8 c) {
  return c.n;
}

}  // namespace ilot::simd::baseline
#endif

namespace ilot::simd::baseline {

// Appends the lanes of the mask to values, and first + lane to indices; eight elements may be overwritten behind the
// end. Returns how many lanes there were.
inline std::uint32_t append8(float* values, std::uint32_t* indices, F8 v, std::uint32_t first, std::uint32_t mask) {
  float lanes[8];
  store8(lanes, v);
  std::uint32_t n = 0;
  for (std::uint32_t lane = 0; lane < 8; ++lane) {
    values[n] = lanes[lane];
    indices[n] = first + lane;
    n += mask >> lane & 1;
  }
  return n;
}

}  // namespace ilot::simd::baseline
