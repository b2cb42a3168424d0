// SPDX-License-Identifier: Apache-2.0
// Eight float lanes in one AVX register. Only the bodies of body.cpp.in, compiled with -mavx2 -mfma, include this.
#pragma once
#include <immintrin.h>

#include <cstdint>

namespace ilot::simd::avx2 {

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
// a b + c, rounded once.
inline F8 fused(F8 a, F8 b, F8 c) {
  return {_mm256_fmadd_ps(a.v, b.v, c.v)};
}
inline std::uint32_t mask_le(F8 a, F8 b) {
  return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)));
}
// Returns v where it is at most the limit, otherwise 0.
inline F8 where_le(F8 v, F8 limit) {
  return {_mm256_and_ps(v.v, _mm256_cmp_ps(v.v, limit.v, _CMP_LE_OQ))};
}
// Lane by lane: yes where a is at most b, otherwise no.
inline F8 select_le(F8 a, F8 b, F8 yes, F8 no) {
  return {_mm256_blendv_ps(no.v, yes.v, _mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ))};
}
// Rounds towards zero.
inline F8 truncated(F8 a) {
  return {_mm256_cvtepi32_ps(_mm256_cvttps_epi32(a.v))};
}
inline void store_truncated(std::int32_t* to, F8 a) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_cvttps_epi32(a.v));
}
inline float greatest(F8 a) {
  __m128 m = _mm_max_ps(_mm256_castps256_ps128(a.v), _mm256_extractf128_ps(a.v, 1));
  m = _mm_max_ps(m, _mm_movehl_ps(m, m));
  return _mm_cvtss_f32(_mm_max_ss(m, _mm_shuffle_ps(m, m, 1)));
}
inline F8 gather8(const float* from, const std::uint32_t* at) {
  return {_mm256_i32gather_ps(from, _mm256_loadu_si256(reinterpret_cast<const __m256i*>(at)), 4)};
}

// For each mask, the lanes that are set, in order, one byte each.
struct CompressTable {
  std::uint64_t lanes[256];
  constexpr CompressTable() : lanes() {
    for (int mask = 0; mask < 256; ++mask) {
      int to = 0;
      for (int lane = 0; lane < 8; ++lane)
        if ((mask >> lane & 1) != 0) lanes[mask] |= static_cast<std::uint64_t>(lane) << 8 * to++;
    }
  }
};
constexpr CompressTable kCompress;

// The lanes that a mask selects. put() writes the selected lanes side by side. Eight elements are overwritten.
struct Pick8 {
  __m256i lanes;
  std::uint32_t count;
};
inline Pick8 pick8(std::uint32_t mask) {
  return {_mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(kCompress.lanes[mask]))),
          static_cast<std::uint32_t>(__builtin_popcount(mask))};
}
inline void put(float* to, const Pick8& pick, F8 v) {
  _mm256_storeu_ps(to, _mm256_permutevar8x32_ps(v.v, pick.lanes));
}
// Writes the numbers of the selected lanes, counted from first.
inline void put_numbers(std::uint32_t* to, const Pick8& pick, std::uint32_t first) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                      _mm256_add_epi32(pick.lanes, _mm256_set1_epi32(static_cast<int>(first))));
}

struct Count8 {
  __m256i v;
};
inline Count8 zero_count() {
  return {_mm256_setzero_si256()};
}
inline void count_le(Count8& c, F8 a, F8 b) {
  c.v = _mm256_sub_epi32(c.v, _mm256_castps_si256(_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)));
}
inline void count_both_le(Count8& c, F8 a, F8 b, F8 e, F8 f) {
  const __m256 both = _mm256_and_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ), _mm256_cmp_ps(e.v, f.v, _CMP_LE_OQ));
  c.v = _mm256_sub_epi32(c.v, _mm256_castps_si256(both));
}
// All bits of the lanes between -2 and 2: the upper bit of their exponent is 0.
inline __m256i below_two(F8 a) {
  const __m256i upper = _mm256_and_si256(_mm256_castps_si256(a.v), _mm256_set1_epi32(0x40000000));
  return _mm256_cmpeq_epi32(upper, _mm256_setzero_si256());
}
inline void count_below_two(Count8& c, F8 a) {
  c.v = _mm256_sub_epi32(c.v, below_two(a));
}
// Counts the lanes where a is between -2 and 2, and e at most f.
inline void count_below_two_and_le(Count8& c, F8 a, F8 e, F8 f) {
  const __m256i le = _mm256_castps_si256(_mm256_cmp_ps(e.v, f.v, _CMP_LE_OQ));
  c.v = _mm256_sub_epi32(c.v, _mm256_and_si256(below_two(a), le));
}
inline std::uint32_t total(Count8 c) {
  alignas(32) std::uint32_t v[8];
  _mm256_store_si256(reinterpret_cast<__m256i*>(v), c.v);
  return v[0] + v[1] + v[2] + v[3] + v[4] + v[5] + v[6] + v[7];
}

// As many floats as the widest register holds.
using Wide = F8;
using WideCount = Count8;
constexpr std::uint32_t kWide = 8;
inline Wide load_wide(const float* p) {
  return load8(p);
}
// Loads into a register, which the compiler would do again for each use with a memory operand.
inline Wide load_once(const float* p) {
  Wide a = load_wide(p);
  asm("" : "+x"(a.v));
  return a;
}
inline void store_wide(float* p, Wide a) {
  store8(p, a);
}
inline Wide splat_wide(float v) {
  return splat(v);
}
inline Wide min_wide(Wide a, Wide b) {
  return {_mm256_min_ps(a.v, b.v)};
}
inline WideCount zero_wide_count() {
  return zero_count();
}
// Appends from[i] of the lanes where the value is at most the limit. kWide elements are overwritten. Returns how many
// were appended.
inline std::uint32_t append_le(std::uint32_t* to, const std::uint32_t* from, Wide value, Wide limit) {
  const Pick8 pick = pick8(mask_le(value, limit));
  const __m256i v = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_permutevar8x32_epi32(v, pick.lanes));
  return pick.count;
}

// Does the same for the values.
inline void append_values_le(float* to, Wide value, Wide limit) {
  put(to, pick8(mask_le(value, limit)), value);
}
// The count of each lane.
inline Wide counts(WideCount c) {
  return {_mm256_cvtepi32_ps(c.v)};
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
  __m256d v;
};
struct DMask {
  __m256d v;
};
constexpr std::uint32_t kDoubles = 4;
inline D load_d(const double* p) {
  return {_mm256_loadu_pd(p)};
}
inline D splat_d(double v) {
  return {_mm256_set1_pd(v)};
}
inline D operator+(D a, D b) {
  return {_mm256_add_pd(a.v, b.v)};
}
inline D operator-(D a, D b) {
  return {_mm256_sub_pd(a.v, b.v)};
}
inline D operator*(D a, D b) {
  return {_mm256_mul_pd(a.v, b.v)};
}
inline D operator/(D a, D b) {
  return {_mm256_div_pd(a.v, b.v)};
}
inline D root(D a) {
  return {_mm256_sqrt_pd(a.v)};
}
inline DMask operator<(D a, D b) {
  return {_mm256_cmp_pd(a.v, b.v, _CMP_LT_OQ)};
}
inline DMask operator==(D a, D b) {
  return {_mm256_cmp_pd(a.v, b.v, _CMP_EQ_OQ)};
}
inline DMask operator&(DMask a, DMask b) {
  return {_mm256_and_pd(a.v, b.v)};
}
inline DMask operator|(DMask a, DMask b) {
  return {_mm256_or_pd(a.v, b.v)};
}
inline bool any(DMask m) {
  return _mm256_movemask_pd(m.v) != 0;
}
inline D select(DMask m, D yes, D no) {
  return {_mm256_blendv_pd(no.v, yes.v, m.v)};
}
inline void store_d(double* p, D a) {
  _mm256_storeu_pd(p, a.v);
}
// Returns two to the power of integers from -1022 to 1023. The last bits of 1.5 x 2^52 + n + 1023 are those of the
// exponent.
inline D power_of_two(D whole) {
  const __m256d shifted = _mm256_add_pd(whole.v, _mm256_set1_pd(0x1.8p52 + 1023));
  return {_mm256_castsi256_pd(_mm256_slli_epi64(_mm256_castpd_si256(shifted), 52))};
}
// Rounds to the nearest integer, ties to even.
inline void store_rounded(std::int32_t* to, D a) {
  _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm256_cvtpd_epi32(a.v));
}

// The eight least values that were added, in ascending order.
struct Least8 {
  __m256d low, high;
};
inline Least8 no_least() {
  return {_mm256_set1_pd(__builtin_inf()), _mm256_set1_pd(__builtin_inf())};
}
// Adds a value from 0 on. Each slot gets the middle one of its value, the value of the slot before, and the new one.
inline void add(Least8& s, double d) {
  const __m256d v = _mm256_set1_pd(d);
  const __m256d before_low = _mm256_shuffle_pd(_mm256_permute2f128_pd(s.low, s.low, 0x08), s.low, 5);  // 0 is first
  const __m256d before_high = _mm256_shuffle_pd(_mm256_permute2f128_pd(s.low, s.high, 0x21), s.high, 5);
  s = {_mm256_max_pd(before_low, _mm256_min_pd(s.low, v)), _mm256_max_pd(before_high, _mm256_min_pd(s.high, v))};
}
inline void store_least(double* to, const Least8& s) {
  _mm256_storeu_pd(to, s.low);
  _mm256_storeu_pd(to + 4, s.high);
}

}  // namespace ilot::simd::avx2
