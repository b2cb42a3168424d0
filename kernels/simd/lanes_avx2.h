// SPDX-License-Identifier: Apache-2.0
// Eight float lanes in one AVX register. Only isa_avx2.cpp, compiled with -mavx2, includes this.
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
inline F8 max8(F8 a, F8 b) {
  return {_mm256_max_ps(a.v, b.v)};
}
inline F8 abs8(F8 a) {
  return {_mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.v)};
}
inline std::uint32_t mask_le(F8 a, F8 b) {
  return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)));
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

// Appends the lanes of the mask to values, and first + lane to indices; eight elements may be overwritten behind the
// end. Returns how many lanes there were.
inline std::uint32_t append8(float* values, std::uint32_t* indices, F8 v, std::uint32_t first, std::uint32_t mask) {
  const __m256i lanes = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(kCompress.lanes[mask])));
  _mm256_storeu_ps(values, _mm256_permutevar8x32_ps(v.v, lanes));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(indices),
                      _mm256_add_epi32(lanes, _mm256_set1_epi32(static_cast<int>(first))));
  return static_cast<std::uint32_t>(__builtin_popcount(mask));
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
inline std::uint32_t total(Count8 c) {
  alignas(32) std::uint32_t v[8];
  _mm256_store_si256(reinterpret_cast<__m256i*>(v), c.v);
  return v[0] + v[1] + v[2] + v[3] + v[4] + v[5] + v[6] + v[7];
}

}  // namespace ilot::simd::avx2
