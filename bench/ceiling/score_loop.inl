// SPDX-License-Identifier: Apache-2.0
// Scores four planes on one register of points. opaque() makes the compiler treat a value as new and has no cost.
inline std::uint32_t loop(std::uint32_t rounds) {
  constexpr int kPlanes = 4;
  Wide x = splat_wide(1.0f), y = splat_wide(2.0f), z = splat_wide(3.0f);
  const Wide a = splat_wide(0.5f), b = splat_wide(0.25f), c = splat_wide(0.75f);
  Wide d[kPlanes];
  WideCount counts[kPlanes];
  for (int i = 0; i < kPlanes; ++i) {
    d[i] = splat_wide(static_cast<float>(i));
    counts[i] = zero_wide_count();
  }
  for (std::uint32_t r = 0; r < rounds; ++r) {
    for (int i = 0; i < kPlanes; ++i) {
      opaque(x);
      count_below_two(counts[i], fused(a, x, fused(b, y, fused(c, z, d[i]))));
      opaque(y);
      opaque(z);
    }
  }
  std::uint32_t sum = 0;
  for (const WideCount& n : counts) sum += total(n);
  return sum;
}
