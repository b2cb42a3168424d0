// SPDX-License-Identifier: Apache-2.0
// Eight float lanes with mask registers, sixteen where a kernel asks for the widest. Only the bodies of body.cpp.in,
// compiled with -mavx512f -mavx512vl -mavx512dq -mavx512bw, include this.
#pragma once
#include <immintrin.h>

#include <cstdint>

namespace ilot::simd::avx512 {

struct F8 {
  __m256 v;
};
inline F8 load8(const float* p) {
  return {_mm256_loadu_ps(p)};
}
inline void store8(float* p, F8 a) {
  _mm256_storeu_ps(p, a.v);
}
inline F8 splat(float v) {
  return {_mm256_set1_ps(v)};
}
inline F8 operator+(F8 a, F8 b) {
  return {_mm256_add_ps(a.v, b.v)};
}
inline F8 operator-(F8 a, F8 b) {
  return {_mm256_sub_ps(a.v, b.v)};
}
inline F8 operator*(F8 a, F8 b) {
  return {_mm256_mul_ps(a.v, b.v)};
}
inline F8 operator/(F8 a, F8 b) {
  return {_mm256_div_ps(a.v, b.v)};
}
inline F8 max8(F8 a, F8 b) {
  return {_mm256_max_ps(a.v, b.v)};
}
inline F8 root(F8 a) {
  return {_mm256_sqrt_ps(a.v)};
}
inline F8 magnitude(F8 a) {
  return {_mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.v)};
}
inline std::uint32_t mask_le(F8 a, F8 b) {
  return _mm256_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ);
}
// Lane by lane: yes where a is at most b, otherwise no.
inline F8 select_le(F8 a, F8 b, F8 yes, F8 no) {
  return {_mm256_mask_blend_ps(_mm256_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ), no.v, yes.v)};
}
inline F8 gather8(const float* from, const std::uint32_t* at) {
  return {_mm256_i32gather_ps(from, _mm256_loadu_si256(reinterpret_cast<const __m256i*>(at)), 4)};
}

// The lanes that a mask selects. put() writes the selected lanes side by side. Eight elements are overwritten.
struct Pick8 {
  __mmask8 mask;
  std::uint32_t count;
};
inline Pick8 pick8(std::uint32_t mask) {
  return {static_cast<__mmask8>(mask), static_cast<std::uint32_t>(__builtin_popcount(mask))};
}
inline void put(float* to, const Pick8& pick, F8 v) {
  _mm256_storeu_ps(to, _mm256_maskz_compress_ps(pick.mask, v.v));
}
// Writes the numbers of the selected lanes, counted from first.
inline void put_numbers(std::uint32_t* to, const Pick8& pick, std::uint32_t first) {
  const __m256i numbers =
      _mm256_add_epi32(_mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7), _mm256_set1_epi32(static_cast<int>(first)));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_maskz_compress_epi32(pick.mask, numbers));
}

// As many floats as the widest register holds.
struct Wide {
  __m512 v;
};
constexpr std::uint32_t kWide = 16;
inline Wide load_wide(const float* p) {
  return {_mm512_loadu_ps(p)};
}
// Loads into a register, which the compiler would do again for each use with a memory operand.
inline Wide load_once(const float* p) {
  Wide a = load_wide(p);
  asm("" : "+v"(a.v));
  return a;
}
inline void store_wide(float* p, Wide a) {
  _mm512_storeu_ps(p, a.v);
}
inline Wide splat_wide(float v) {
  return {_mm512_set1_ps(v)};
}
inline Wide operator+(Wide a, Wide b) {
  return {_mm512_add_ps(a.v, b.v)};
}
inline Wide operator-(Wide a, Wide b) {
  return {_mm512_sub_ps(a.v, b.v)};
}
inline Wide operator*(Wide a, Wide b) {
  return {_mm512_mul_ps(a.v, b.v)};
}
inline Wide operator/(Wide a, Wide b) {
  return {_mm512_div_ps(a.v, b.v)};
}
inline Wide max8(Wide a, Wide b) {
  return {_mm512_max_ps(a.v, b.v)};
}
inline Wide root(Wide a) {
  return {_mm512_sqrt_ps(a.v)};
}
inline Wide min_wide(Wide a, Wide b) {
  return {_mm512_min_ps(a.v, b.v)};
}
inline Wide select_le(Wide a, Wide b, Wide yes, Wide no) {
  return {_mm512_mask_blend_ps(_mm512_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ), no.v, yes.v)};
}
// Rounds towards zero.
inline Wide truncated(Wide a) {
  return {_mm512_cvtepi32_ps(_mm512_cvttps_epi32(a.v))};
}
inline void store_truncated(std::int32_t* to, Wide a) {
  _mm512_storeu_si512(to, _mm512_cvttps_epi32(a.v));
}
inline Wide magnitude(Wide a) {
  return {_mm512_abs_ps(a.v)};
}
// a b + c, rounded once.
inline Wide fused(Wide a, Wide b, Wide c) {
  return {_mm512_fmadd_ps(a.v, b.v, c.v)};
}
// Returns v where it is at most the limit, otherwise 0.
inline Wide where_le(Wide v, Wide limit) {
  return {_mm512_maskz_mov_ps(_mm512_cmp_ps_mask(v.v, limit.v, _CMP_LE_OQ), v.v)};
}
inline float greatest(Wide a) {
  return _mm512_reduce_max_ps(a.v);
}
// Appends from[i] of the lanes where the value is at most the limit. kWide elements are overwritten. Returns how many
// were appended.
inline std::uint32_t append_le(std::uint32_t* to, const std::uint32_t* from, Wide value, Wide limit) {
  const __mmask16 mask = _mm512_cmp_ps_mask(value.v, limit.v, _CMP_LE_OQ);
  _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(mask, _mm512_loadu_si512(from)));
  return static_cast<std::uint32_t>(__builtin_popcount(mask));
}

// Does the same for the values.
inline void append_values_le(float* to, Wide value, Wide limit) {
  const __mmask16 mask = _mm512_cmp_ps_mask(value.v, limit.v, _CMP_LE_OQ);
  _mm512_storeu_ps(to, _mm512_maskz_compress_ps(mask, value.v));
}

struct WideCount {
  __m512i v;
};
inline WideCount zero_wide_count() {
  return {_mm512_setzero_si512()};
}
inline void count_le(WideCount& c, Wide a, Wide b) {
  c.v = _mm512_mask_sub_epi32(c.v, _mm512_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ), c.v, _mm512_set1_epi32(-1));
}
inline void count_both_le(WideCount& c, Wide a, Wide b, Wide e, Wide f) {
  const __mmask16 first = _mm512_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ);
  c.v = _mm512_mask_sub_epi32(c.v, _mm512_mask_cmp_ps_mask(first, e.v, f.v, _CMP_LE_OQ), c.v, _mm512_set1_epi32(-1));
}
// The lanes between -2 and 2: the upper bit of their exponent is 0.
inline __mmask16 below_two(Wide a) {
  return _mm512_testn_epi32_mask(_mm512_castps_si512(a.v), _mm512_set1_epi32(0x40000000));
}
inline void count_below_two(WideCount& c, Wide a) {
  c.v = _mm512_mask_sub_epi32(c.v, below_two(a), c.v, _mm512_set1_epi32(-1));
}
// Counts the lanes where a is between -2 and 2, and e at most f.
inline void count_below_two_and_le(WideCount& c, Wide a, Wide e, Wide f) {
  const __mmask16 both = _mm512_mask_cmp_ps_mask(below_two(a), e.v, f.v, _CMP_LE_OQ);
  c.v = _mm512_mask_sub_epi32(c.v, both, c.v, _mm512_set1_epi32(-1));
}
inline std::uint32_t total(WideCount c) {
  return static_cast<std::uint32_t>(_mm512_reduce_add_epi32(c.v));
}
// The count of each lane.
inline Wide counts(WideCount c) {
  return {_mm512_cvtepi32_ps(c.v)};
}

// Sums of integers, each of which a float represents exactly.
struct Sum8 {
  __m256i v;
};
inline Sum8 zero_sum() {
  return {_mm256_setzero_si256()};
}
inline void add_whole(Sum8& s, F8 a) {
  s.v = _mm256_add_epi32(s.v, _mm256_cvtps_epi32(a.v));
}
inline void store_totals(std::int32_t* to, const Sum8 (&s)[8]) {
  const __m256i ab = _mm256_hadd_epi32(s[0].v, s[1].v), cd = _mm256_hadd_epi32(s[2].v, s[3].v);
  const __m256i ef = _mm256_hadd_epi32(s[4].v, s[5].v), gh = _mm256_hadd_epi32(s[6].v, s[7].v);
  const __m256i low = _mm256_hadd_epi32(ab, cd), high = _mm256_hadd_epi32(ef, gh);
  const __m256i sums =
      _mm256_add_epi32(_mm256_permute2x128_si256(low, high, 0x20), _mm256_permute2x128_si256(low, high, 0x31));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), sums);
}

// Double lanes and their masks.
struct D {
  __m512d v;
};
struct DMask {
  __mmask8 v;
};
constexpr std::uint32_t kDoubles = 8;
inline D load_d(const double* p) {
  return {_mm512_loadu_pd(p)};
}
inline D splat_d(double v) {
  return {_mm512_set1_pd(v)};
}
inline D operator+(D a, D b) {
  return {_mm512_add_pd(a.v, b.v)};
}
inline D operator-(D a, D b) {
  return {_mm512_sub_pd(a.v, b.v)};
}
inline D operator*(D a, D b) {
  return {_mm512_mul_pd(a.v, b.v)};
}
inline D operator/(D a, D b) {
  return {_mm512_div_pd(a.v, b.v)};
}
inline D root(D a) {
  return {_mm512_sqrt_pd(a.v)};
}
inline DMask operator<(D a, D b) {
  return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ)};
}
inline DMask operator==(D a, D b) {
  return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_EQ_OQ)};
}
inline DMask operator&(DMask a, DMask b) {
  return {static_cast<__mmask8>(a.v & b.v)};
}
inline DMask operator|(DMask a, DMask b) {
  return {static_cast<__mmask8>(a.v | b.v)};
}
inline bool any(DMask m) {
  return m.v != 0;
}
inline D select(DMask m, D yes, D no) {
  return {_mm512_mask_blend_pd(m.v, no.v, yes.v)};
}
inline void store_d(double* p, D a) {
  _mm512_storeu_pd(p, a.v);
}
// Returns two to the power of integers from -1022 to 1023. The last bits of 1.5 x 2^52 + n + 1023 are those of the
// exponent.
inline D power_of_two(D whole) {
  const __m512d shifted = _mm512_add_pd(whole.v, _mm512_set1_pd(0x1.8p52 + 1023));
  return {_mm512_castsi512_pd(_mm512_slli_epi64(_mm512_castpd_si512(shifted), 52))};
}
// Rounds to the nearest integer, ties to even.
inline void store_rounded(std::int32_t* to, D a) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm512_cvtpd_epi32(a.v));
}

// The eight least values that were added, in ascending order.
struct Least8 {
  __m512d v;
};
inline Least8 no_least() {
  return {_mm512_set1_pd(__builtin_inf())};
}
// Adds a value from 0 on. Each slot gets the middle one of its value, the value of the slot before, and the new one.
inline void add(Least8& s, double d) {
  const __m512i before = _mm512_alignr_epi64(_mm512_castpd_si512(s.v), _mm512_setzero_si512(), 7);  // 0 is first
  s.v = _mm512_max_pd(_mm512_castsi512_pd(before), _mm512_min_pd(s.v, _mm512_set1_pd(d)));
}
inline void store_least(double* to, const Least8& s) {
  _mm512_storeu_pd(to, s.v);
}

}  // namespace ilot::simd::avx512
