// SPDX-License-Identifier: Apache-2.0
// Body of count_inliers: blocks of points that stay in the first cache level, four planes a sweep so that each load of
// a point serves four planes. Counts are integers, so neither blocking nor lane width can change the answer.

namespace {

constexpr std::size_t kBlock = 1024;  // 24 KiB with normals: half of a first-level cache

struct PlaneLanes {
  F8 a, b, c, d;
};

inline PlaneLanes load_plane(const float* p) { return {splat(p[0]), splat(p[1]), splat(p[2]), splat(p[3])}; }

inline F8 distance8(const PlaneLanes& p, F8 x, F8 y, F8 z) { return abs8(p.a * x + p.b * y + p.c * z + p.d); }

template <int kPlanes>
inline void count_sweep(const CountArgs& args, std::size_t begin, std::size_t end, std::size_t plane) {
  PlaneLanes planes[kPlanes];
  Count8 counts[kPlanes];
  for (int i = 0; i < kPlanes; ++i) {
    planes[i] = load_plane(args.planes + 4 * (plane + i));
    counts[i] = zero_count();
  }
  const F8 epsilon = splat(args.max_distance);
  const F8 cosine = splat(args.min_cos);
  if (args.nx != nullptr) {
    for (std::size_t j = begin; j < end; j += 8) {
      const F8 x = load8(args.x + j), y = load8(args.y + j), z = load8(args.z + j);
      const F8 nx = load8(args.nx + j), ny = load8(args.ny + j), nz = load8(args.nz + j);
      for (int i = 0; i < kPlanes; ++i) {
        const F8 agreement = abs8(planes[i].a * nx + planes[i].b * ny + planes[i].c * nz);
        count_both_le(counts[i], distance8(planes[i], x, y, z), epsilon, cosine, agreement);
      }
    }
  } else {
    for (std::size_t j = begin; j < end; j += 8) {
      const F8 x = load8(args.x + j), y = load8(args.y + j), z = load8(args.z + j);
      for (int i = 0; i < kPlanes; ++i) count_le(counts[i], distance8(planes[i], x, y, z), epsilon);
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
  const std::size_t whole = args.size & ~std::size_t{7};
  for (std::size_t begin = 0; begin < whole; begin += kBlock) {
    const std::size_t end = begin + kBlock < whole ? begin + kBlock : whole;
    std::size_t plane = 0;
    for (; plane + 4 <= args.plane_count; plane += 4) count_sweep<4>(args, begin, end, plane);
    for (; plane < args.plane_count; ++plane) count_sweep<1>(args, begin, end, plane);
  }
  count_tail(args, whole);
}
