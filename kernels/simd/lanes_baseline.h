// SPDX-License-Identifier: Apache-2.0
// Eight float lanes made of two SSE2 registers, or plain loops where there is no SSE2.
#pragma once
#include <cstdint>

#include "kernels/simd/lanes_baseline_doubles.h"

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
inline F8 operator/(F8 a, F8 b) {
  return {_mm_div_ps(a.lo, b.lo), _mm_div_ps(a.hi, b.hi)};
}
inline F8 max8(F8 a, F8 b) {
  return {_mm_max_ps(a.lo, b.lo), _mm_max_ps(a.hi, b.hi)};
}
inline F8 root(F8 a) {
  return {_mm_sqrt_ps(a.lo), _mm_sqrt_ps(a.hi)};
}
inline F8 magnitude(F8 a) {
  const __m128 sign = _mm_set1_ps(-0.0f);
  return {_mm_andnot_ps(sign, a.lo), _mm_andnot_ps(sign, a.hi)};
}
// a b + c of the two lower lanes, rounded once, without the instruction for it. The product is exact in double. The sum
// is rounded to odd: where it is not exact, its last bit is set. Rounding that to float is rounding the exact sum
// [Boldo and Melquiond 2008].
inline __m128 fused_low(__m128 a, __m128 b, __m128 c) {
  const __m128d product = _mm_mul_pd(_mm_cvtps_pd(a), _mm_cvtps_pd(b)), added = _mm_cvtps_pd(c);
  const __m128d sum = _mm_add_pd(product, added), part = _mm_sub_pd(sum, product);
  const __m128d error = _mm_add_pd(_mm_sub_pd(product, _mm_sub_pd(sum, part)), _mm_sub_pd(added, part));
  const __m128i one = _mm_set_epi32(0, 1, 0, 1), bits = _mm_castpd_si128(sum);
  const __m128i even = _mm_sub_epi64(_mm_and_si128(bits, one), one);  // all bits where the last one is 0
  const __m128i inexact = _mm_and_si128(even, _mm_castpd_si128(_mm_cmpneq_pd(error, _mm_setzero_pd())));
  const __m128i towards_zero = _mm_srli_epi64(_mm_xor_si128(bits, _mm_castpd_si128(error)), 63);
  const __m128i odd =
      _mm_add_epi64(bits, _mm_and_si128(inexact, _mm_sub_epi64(one, _mm_add_epi64(towards_zero, towards_zero))));
  return _mm_cvtpd_ps(_mm_castsi128_pd(odd));
}
inline __m128 fused_4(__m128 a, __m128 b, __m128 c) {
  const __m128 high = fused_low(_mm_movehl_ps(a, a), _mm_movehl_ps(b, b), _mm_movehl_ps(c, c));
  return _mm_movelh_ps(fused_low(a, b, c), high);
}
// a b + c, rounded once.
inline F8 fused(F8 a, F8 b, F8 c) {
  return {fused_4(a.lo, b.lo, c.lo), fused_4(a.hi, b.hi, c.hi)};
}
// Bit i is set where a[i] <= b[i].
inline std::uint32_t mask_le(F8 a, F8 b) {
  return static_cast<std::uint32_t>(_mm_movemask_ps(_mm_cmple_ps(a.lo, b.lo))) |
         static_cast<std::uint32_t>(_mm_movemask_ps(_mm_cmple_ps(a.hi, b.hi))) << 4;
}

// Returns v where it is at most the limit, otherwise 0.
inline F8 where_le(F8 v, F8 limit) {
  return {_mm_and_ps(v.lo, _mm_cmple_ps(v.lo, limit.lo)), _mm_and_ps(v.hi, _mm_cmple_ps(v.hi, limit.hi))};
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
// All bits of the lanes between -2 and 2: the upper bit of their exponent is 0.
inline __m128i below_two(__m128 a) {
  return _mm_cmpeq_epi32(_mm_and_si128(_mm_castps_si128(a), _mm_set1_epi32(0x40000000)), _mm_setzero_si128());
}
inline void count_below_two(Count8& c, F8 a) {
  c.lo = _mm_sub_epi32(c.lo, below_two(a.lo));
  c.hi = _mm_sub_epi32(c.hi, below_two(a.hi));
}
// Counts the lanes where a is between -2 and 2, and e at most f.
inline void count_below_two_and_le(Count8& c, F8 a, F8 e, F8 f) {
  c.lo = _mm_sub_epi32(c.lo, _mm_and_si128(below_two(a.lo), _mm_castps_si128(_mm_cmple_ps(e.lo, f.lo))));
  c.hi = _mm_sub_epi32(c.hi, _mm_and_si128(below_two(a.hi), _mm_castps_si128(_mm_cmple_ps(e.hi, f.hi))));
}
// The count of each lane.
inline F8 counts(Count8 c) {
  return {_mm_cvtepi32_ps(c.lo), _mm_cvtepi32_ps(c.hi)};
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
inline F8 operator/(F8 a, F8 b) {
  for (int i = 0; i < 8; ++i) a.v[i] /= b.v[i];
  return a;
}
inline F8 max8(F8 a, F8 b) {
  for (int i = 0; i < 8; ++i) a.v[i] = a.v[i] > b.v[i] ? a.v[i] : b.v[i];
  return a;
}
inline F8 root(F8 a) {
  for (float& v : a.v) v = __builtin_sqrtf(v);
  return a;
}
inline F8 magnitude(F8 a) {
  for (float& v : a.v) v = v < 0 ? -v : v;
  return a;
}
// a b + c, rounded once.
inline F8 fused(F8 a, F8 b, F8 c) {
  for (int i = 0; i < 8; ++i) a.v[i] = __builtin_fmaf(a.v[i], b.v[i], c.v[i]);
  return a;
}
inline std::uint32_t mask_le(F8 a, F8 b) {
  std::uint32_t m = 0;
  for (int i = 0; i < 8; ++i) m |= static_cast<std::uint32_t>(a.v[i] <= b.v[i]) << i;
  return m;
}
inline F8 where_le(F8 v, F8 limit) {
  for (int i = 0; i < 8; ++i) v.v[i] = v.v[i] <= limit.v[i] ? v.v[i] : 0.0f;
  return v;
}
struct Count8 {
  std::uint32_t n[8];
};
inline Count8 zero_count() {
  return {};
}
inline void count_le(Count8& c, F8 a, F8 b) {
  for (int i = 0; i < 8; ++i) c.n[i] += a.v[i] <= b.v[i];
}
inline void count_both_le(Count8& c, F8 a, F8 b, F8 e, F8 f) {
  for (int i = 0; i < 8; ++i) c.n[i] += (a.v[i] <= b.v[i]) & (e.v[i] <= f.v[i]);
}
inline bool below_two(float v) {
  return v > -2 && v < 2;
}
inline void count_below_two(Count8& c, F8 a) {
  for (int i = 0; i < 8; ++i) c.n[i] += below_two(a.v[i]);
}
// Counts the lanes where a is between -2 and 2, and e at most f.
inline void count_below_two_and_le(Count8& c, F8 a, F8 e, F8 f) {
  for (int i = 0; i < 8; ++i) c.n[i] += below_two(a.v[i]) & (e.v[i] <= f.v[i]);
}
// The count of each lane.
inline F8 counts(Count8 c) {
  F8 r;
  for (int i = 0; i < 8; ++i) r.v[i] = static_cast<float>(c.n[i]);
  return r;
}
inline std::uint32_t total(Count8 c) {
  std::uint32_t sum = 0;
  for (const std::uint32_t n : c.n) sum += n;
  return sum;
}

}  // namespace ilot::simd::baseline
#endif

namespace ilot::simd::baseline {

// Lane by lane: yes where a is at most b, otherwise no.
inline F8 select_le(F8 a, F8 b, F8 yes, F8 no) {
  const std::uint32_t mask = mask_le(a, b);
  float y[8], n[8];
  store8(y, yes);
  store8(n, no);
  for (int i = 0; i < 8; ++i) n[i] = (mask >> i & 1) != 0 ? y[i] : n[i];
  return load8(n);
}
// Rounds towards zero.
inline void store_truncated(std::int32_t* to, F8 a) {
  float lanes[8];
  store8(lanes, a);
  for (int i = 0; i < 8; ++i) to[i] = static_cast<std::int32_t>(lanes[i]);
}
inline F8 truncated(F8 a) {
  std::int32_t whole[8];
  store_truncated(whole, a);
  float lanes[8];
  for (int i = 0; i < 8; ++i) lanes[i] = static_cast<float>(whole[i]);
  return load8(lanes);
}
inline float greatest(F8 a) {
  float lanes[8];
  store8(lanes, a);
  float most = lanes[0];
  for (const float v : lanes) most = v > most ? v : most;
  return most;
}
inline F8 gather8(const float* from, const std::uint32_t* at) {
  float lanes[8];
  for (int i = 0; i < 8; ++i) lanes[i] = from[at[i]];
  return load8(lanes);
}

// The lanes that a mask selects. put() writes the selected lanes side by side. Eight elements are overwritten.
struct Pick8 {
  std::uint32_t mask, count;
};
inline Pick8 pick8(std::uint32_t mask) {
  std::uint32_t count = 0;
  for (int lane = 0; lane < 8; ++lane) count += mask >> lane & 1;
  return {mask, count};
}
inline void put(float* to, const Pick8& pick, F8 v) {
  float lanes[8];
  store8(lanes, v);
  std::uint32_t n = 0;
  for (int lane = 0; lane < 8; ++lane) {
    to[n] = lanes[lane];
    n += pick.mask >> lane & 1;
  }
}
// Writes the numbers of the selected lanes, counted from first.
inline void put_numbers(std::uint32_t* to, const Pick8& pick, std::uint32_t first) {
  std::uint32_t n = 0;
  for (std::uint32_t lane = 0; lane < 8; ++lane) {
    to[n] = first + lane;
    n += pick.mask >> lane & 1;
  }
}

// As many floats as the widest register holds.
using Wide = F8;
using WideCount = Count8;
constexpr std::uint32_t kWide = 8;
inline Wide load_wide(const float* p) {
  return load8(p);
}
inline Wide load_once(const float* p) {
  return load_wide(p);
}
inline void store_wide(float* p, Wide a) {
  store8(p, a);
}
inline Wide splat_wide(float v) {
  return splat(v);
}
inline Wide min_wide(Wide a, Wide b) {
  return select_le(a, b, a, b);
}
inline WideCount zero_wide_count() {
  return zero_count();
}
// Appends from[i] of the lanes where the value is at most the limit. kWide elements are overwritten. Returns how many
// were appended.
inline std::uint32_t append_le(std::uint32_t* to, const std::uint32_t* from, Wide value, Wide limit) {
  const std::uint32_t mask = mask_le(value, limit);
  std::uint32_t n = 0;
  for (int lane = 0; lane < 8; ++lane) {
    to[n] = from[lane];
    n += mask >> lane & 1;
  }
  return n;
}

// Does the same for the values.
inline void append_values_le(float* to, Wide value, Wide limit) {
  put(to, pick8(mask_le(value, limit)), value);
}

// Sums of integers, each of which a float represents exactly.
struct Sum8 {
  std::int32_t v[8];
};
inline Sum8 zero_sum() {
  return {};
}
inline void add_whole(Sum8& s, F8 a) {
  float lanes[8];
  store8(lanes, a);
  for (int i = 0; i < 8; ++i) s.v[i] += static_cast<std::int32_t>(lanes[i]);
}
inline void store_totals(std::int32_t* to, const Sum8 (&s)[8]) {
  for (int n = 0; n < 8; ++n) {
    to[n] = 0;
    for (const std::int32_t v : s[n].v) to[n] += v;
  }
}

}  // namespace ilot::simd::baseline
