// SPDX-License-Identifier: Apache-2.0
// Body of count_inliers. It works on blocks of points that stay in the first cache level, with four planes per sweep,
// so that each load of a point serves four planes. Counts are integers, so neither blocks nor lane width can change the
// result.

namespace {

constexpr std::size_t kBlock = 1024;  // 24 KiB with normals: half of a first-level cache

struct PlaneLanes {
  Wide a, b, c, d;
};

inline PlaneLanes load_plane(const float* p) { return {splat_wide(p[0]), splat_wide(p[1]), splat_wide(p[2]), splat_wide(p[3])}; }

inline Wide distance(const PlaneLanes& p, Wide x, Wide y, Wide z) { return magnitude(p.a * x + p.b * y + p.c * z + p.d); }

template <int kPlanes>
inline void count_sweep(const CountArgs& args, std::size_t begin, std::size_t end, std::size_t plane) {
  PlaneLanes planes[kPlanes];
  WideCount counts[kPlanes];
  for (int i = 0; i < kPlanes; ++i) {
    planes[i] = load_plane(args.planes + 4 * (plane + i));
    counts[i] = zero_wide_count();
  }
  const Wide epsilon = splat_wide(args.max_distance);
  const Wide cosine = splat_wide(args.min_cos);
  if (args.nx != nullptr) {
    for (std::size_t j = begin; j < end; j += kWide) {
      const Wide x = load_wide(args.x + j), y = load_wide(args.y + j), z = load_wide(args.z + j);
      const Wide nx = load_wide(args.nx + j), ny = load_wide(args.ny + j), nz = load_wide(args.nz + j);
      for (int i = 0; i < kPlanes; ++i) {
        const Wide agreement = magnitude(planes[i].a * nx + planes[i].b * ny + planes[i].c * nz);
        count_both_le(counts[i], distance(planes[i], x, y, z), epsilon, cosine, agreement);
      }
    }
  } else {
    for (std::size_t j = begin; j < end; j += kWide) {
      const Wide x = load_wide(args.x + j), y = load_wide(args.y + j), z = load_wide(args.z + j);
      for (int i = 0; i < kPlanes; ++i) count_le(counts[i], distance(planes[i], x, y, z), epsilon);
    }
  }
  for (int i = 0; i < kPlanes; ++i) args.counts[plane + i] += total(counts[i]);
}

inline void count_tail(const CountArgs& args, std::size_t begin) {
  for (std::size_t p = 0; p < args.plane_count; ++p) {
    const float* q = args.planes + 4 * p;
    for (std::size_t j = begin; j < args.size; ++j) {
      const float s = q[0] * args.x[j] + q[1] * args.y[j] + q[2] * args.z[j] + q[3];
      const float distance = s < 0 ? -s : s;
      float agreement = args.min_cos;
      if (args.nx != nullptr) {
        const float c = q[0] * args.nx[j] + q[1] * args.ny[j] + q[2] * args.nz[j];
        agreement = c < 0 ? -c : c;
      }
      args.counts[p] += distance <= args.max_distance && args.min_cos <= agreement;
    }
  }
}

}  // namespace

void count_inliers(const CountArgs& args) {
  for (std::size_t p = 0; p < args.plane_count; ++p) args.counts[p] = 0;
  const std::size_t whole = args.size & ~std::size_t{kWide - 1};
  for (std::size_t begin = 0; begin < whole; begin += kBlock) {
    const std::size_t end = begin + kBlock < whole ? begin + kBlock : whole;
    std::size_t plane = 0;
    for (; plane + 4 <= args.plane_count; plane += 4) count_sweep<4>(args, begin, end, plane);
    for (; plane < args.plane_count; ++plane) count_sweep<1>(args, begin, end, plane);
  }
  count_tail(args, whole);
}

// The last line exports the bodies compiled here under one name.
extern const PlaneScoreBody kPlaneScore;
const PlaneScoreBody kPlaneScore{count_inliers};
