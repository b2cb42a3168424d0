// SPDX-License-Identifier: Apache-2.0
// Body of count_inliers. It works on blocks of points that stay in the first cache level, with several planes per sweep,
// so that each load of a point serves all of them: as many as the registers hold. Planes are scaled so that the greatest distance is 2: whether a float
// is below 2 is one bit of it. A point and a plane take three fused operations, one test and one count. Counts are
// integers, so neither blocks nor lane width can change the result, and fused operations are rounded once everywhere.

namespace {

constexpr int kSweep = kWide > 8 ? 4 : 2;  // planes; AVX-512 has 32 registers, the others 16
// Points whose coordinates, and normals, fill 24 KiB: half to three quarters of a first-level cache.
constexpr std::size_t kBlock = 2048, kBlockWithNormals = 1024;

struct PlaneLanes {
  Wide a, b, c, d;
};

inline PlaneLanes load_plane(const float* p, float scale) {
  return {splat_wide(scale * p[0]), splat_wide(scale * p[1]), splat_wide(scale * p[2]), splat_wide(scale * p[3])};
}

inline Wide distance(const PlaneLanes& p, Wide x, Wide y, Wide z) {
  return fused(p.a, x, fused(p.b, y, fused(p.c, z, p.d)));
}

inline Wide cosine(const PlaneLanes& p, Wide x, Wide y, Wide z) {
  return magnitude(fused(p.a, x, fused(p.b, y, p.c * z)));
}

template <int kPlanes>
inline void count_sweep(const CountArgs& args, std::size_t begin, std::size_t end, std::size_t plane) {
  // Derived: two units in the last place less, so that the greatest distance itself is below 2.
  constexpr float kBelow = 1 - 0x1p-22f;
  // Derived: stands for a distance of 0, whose scale would be infinite; coordinates times its scale are below the greatest float.
  constexpr float kSmallest = 1e-20f;
  const float scale = 2 * kBelow / (args.max_distance > kSmallest ? args.max_distance : kSmallest);
  PlaneLanes planes[kPlanes];
  WideCount counts[kPlanes];
  for (int i = 0; i < kPlanes; ++i) {
    planes[i] = load_plane(args.planes + 4 * (plane + i), scale);
    counts[i] = zero_wide_count();
  }
  if (args.nx != nullptr) {
    const Wide least = splat_wide(scale * args.min_cos * kBelow);
    for (std::size_t j = begin; j < end; j += kWide) {
      const Wide x = load_once(args.x + j), y = load_once(args.y + j), z = load_once(args.z + j);
      const Wide nx = load_wide(args.nx + j), ny = load_wide(args.ny + j), nz = load_wide(args.nz + j);
      for (int i = 0; i < kPlanes; ++i)
        count_below_two_and_le(counts[i], distance(planes[i], x, y, z), least, cosine(planes[i], nx, ny, nz));
    }
  } else {
    for (std::size_t j = begin; j < end; j += kWide) {
      const Wide x = load_once(args.x + j), y = load_once(args.y + j), z = load_once(args.z + j);
      for (int i = 0; i < kPlanes; ++i) count_below_two(counts[i], distance(planes[i], x, y, z));
    }
  }
  for (int i = 0; i < kPlanes; ++i) args.counts[plane + i] += total(counts[i]);
}

inline void count_block(const CountArgs& args, std::size_t begin, std::size_t end) {
  std::size_t plane = 0;
  for (; plane + kSweep <= args.plane_count; plane += kSweep) count_sweep<kSweep>(args, begin, end, plane);
  for (; plane < args.plane_count; ++plane) count_sweep<1>(args, begin, end, plane);
}

// Counts the last points, fewer than a register holds, in copies filled up with points that lie on no plane.
inline void count_tail(CountArgs args, std::size_t begin) {
  float copies[6][kWide];
  const float* from[6] = {args.x, args.y, args.z, args.nx, args.ny, args.nz};
  for (int k = 0; k < (args.nx != nullptr ? 6 : 3); ++k)
    for (std::size_t j = 0; j < kWide; ++j)
      copies[k][j] = begin + j < args.size ? from[k][begin + j] : __builtin_nanf("");
  args.x = copies[0], args.y = copies[1], args.z = copies[2];
  if (args.nx != nullptr) args.nx = copies[3], args.ny = copies[4], args.nz = copies[5];
  count_block(args, 0, kWide);
}

}  // namespace

void count_inliers(const CountArgs& args) {
  for (std::size_t p = 0; p < args.plane_count; ++p) args.counts[p] = 0;
  if (!(args.max_distance >= 0)) return;
  const std::size_t whole = args.size & ~std::size_t{kWide - 1};
  const std::size_t block = args.nx != nullptr ? kBlockWithNormals : kBlock;
  for (std::size_t begin = 0; begin < whole; begin += block)
    count_block(args, begin, begin + block < whole ? begin + block : whole);
  if (whole < args.size) count_tail(args, whole);
}

// The last line exports the bodies compiled here under one name.
extern const PlaneScoreBody kPlaneScore;
const PlaneScoreBody kPlaneScore{count_inliers};
