// SPDX-License-Identifier: Apache-2.0
// Body of normals over near neighbours. Sums are integers. Then as many matrices are solved at once as a register has
// doubles, by the steps of smallest_eigen (core/eigen3), so that every bit is the same as there.

namespace {

constexpr std::uint32_t kBatch = 64;

// x y z xx xy xz yy yz zz of each query's neighbours relative to it, per row; then n^2 times the covariance.
struct BatchMoments {
  double sum[9][kBatch];
};

// Neighbours are within 2^12 of the query, so products are below 2^24 and sums of 64 of them are below 2^30.
inline void sum_neighbours(const NormalArgs& a, std::uint32_t query, const std::uint32_t* neighbours, double n,
                           BatchMoments& out, std::uint32_t slot) {
  const F8 qx = splat(a.x[query]), qy = splat(a.y[query]), qz = splat(a.z[query]);
  Sum8 sums[8], last = zero_sum(), none = zero_sum();
  for (Sum8& s : sums) s = zero_sum();
  for (int j = 0; j < a.k; j += 8) {  // the list is filled up with the query itself, which adds nothing
    const F8 dx = gather8(a.x, neighbours + j) - qx, dy = gather8(a.y, neighbours + j) - qy,
             dz = gather8(a.z, neighbours + j) - qz;
    add_whole(sums[0], dx);
    add_whole(sums[1], dy);
    add_whole(sums[2], dz);
    add_whole(sums[3], dx * dx);
    add_whole(sums[4], dx * dy);
    add_whole(sums[5], dx * dz);
    add_whole(sums[6], dy * dy);
    add_whole(sums[7], dy * dz);
    add_whole(last, dz * dz);
  }
  std::int32_t totals[16];
  store_totals(totals, sums);
  const Sum8 rest[8] = {last, none, none, none, none, none, none, none};
  store_totals(totals + 8, rest);
  const double x = totals[0], y = totals[1], z = totals[2];
  const double products[6] = {x * x, x * y, x * z, y * y, y * z, z * z};
  for (int i = 0; i < 6; ++i) out.sum[i][slot] = n * static_cast<double>(totals[3 + i]) - products[i];
}

struct D3 {
  D x, y, z;
};
inline D dot_d(const D3& a, const D3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline D3 cross_d(const D3& a, const D3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline D3 select_d(DMask m, const D3& yes, const D3& no) {
  return {select(m, yes.x, no.x), select(m, yes.y, no.y), select(m, yes.z, no.z)};
}

// Newton's iteration from below, as in smallest_eigen. Lanes that have converged no longer change.
inline D smallest_root(D c0, D c1) {
  const D zero = splat_d(0), one = splat_d(1), two = splat_d(2), three = splat_d(3);
  D t = zero;
  DMask moving = zero < one;
  for (int i = 0; i < 40; ++i) {
    const D value = ((t - one) * t + c1) * t - c0;
    const D slope = (three * t - two) * t + c1;
    const D next = t - value / slope;
    moving = moving & (zero < slope) & (t < next);
    if (!any(moving)) break;
    t = select(moving, next, t);
  }
  return t;
}

// Computes the normals and curvatures of kDoubles matrices from slot on.
inline void solve(const BatchMoments& m, std::uint32_t slot, std::int16_t* out, std::uint32_t count) {
  const D zero = splat_d(0), one = splat_d(1);
  const D mxx = load_d(m.sum[0] + slot), mxy = load_d(m.sum[1] + slot), mxz = load_d(m.sum[2] + slot);
  const D myy = load_d(m.sum[3] + slot), myz = load_d(m.sum[4] + slot), mzz = load_d(m.sum[5] + slot);
  const D trace = mxx + myy + mzz;
  const DMask spread = zero < trace;
  const D s = one / select(spread, trace, one);
  const D xx = mxx * s, xy = mxy * s, xz = mxz * s, yy = myy * s, yz = myz * s, zz = mzz * s;
  const D c1 = xx * yy - xy * xy + xx * zz - xz * xz + yy * zz - yz * yz;
  const D c0 = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  const D t = smallest_root(c0, c1);
  const D3 r0{xx - t, xy, xz}, r1{xy, yy - t, yz}, r2{xz, yz, zz - t};
  D3 best = cross_d(r0, r1);
  const D3 second = cross_d(r0, r2), third = cross_d(r1, r2);
  best = select_d(dot_d(best, best) < dot_d(second, second), second, best);
  best = select_d(dot_d(best, best) < dot_d(third, third), third, best);
  const D length = root(dot_d(best, best));
  const DMask unique = spread & (splat_d(1e-10) < length);
  const D scale = one / select(unique, length, one);
  const D3 n{scale * best.x, scale * best.y, scale * best.z};
  const DMask down = (n.z < zero) | ((n.z == zero) & ((n.y < zero) | ((n.y == zero) & (n.x < zero))));
  const D side = select(unique, select(down, splat_d(-32767), splat_d(32767)), zero);
  D curvature = splat_d(3) * (t * trace) / select(spread, trace, one);
  curvature = select(curvature < zero, zero, select(one < curvature, one, curvature));
  std::int32_t row[4][kDoubles];
  store_rounded(row[0], n.x * side);
  store_rounded(row[1], n.y * side);
  store_rounded(row[2], n.z * side);
  store_rounded(row[3], select(unique, curvature * splat_d(65535), zero));
  for (std::uint32_t i = 0; i < count; ++i)
    for (int c = 0; c < 4; ++c) out[4 * i + c] = static_cast<std::int16_t>(row[c][i]);
}

}  // namespace

void neighbour_normals(const NormalArgs& a) {
  BatchMoments moments;
  const std::uint32_t k = static_cast<std::uint32_t>(a.k);
  for (std::uint32_t begin = 0; begin < a.query_count; begin += kBatch) {
    const std::uint32_t count = a.query_count - begin < kBatch ? a.query_count - begin : kBatch;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t query = a.queries[begin + i];
      const std::uint32_t* list = a.neighbours + std::size_t{begin + i} * k;
      std::uint32_t padded[64 + 8];
      if (k % 8 != 0) {
        for (std::uint32_t j = 0; j < (k + 7) / 8 * 8; ++j) padded[j] = j < k ? list[j] : query;
        list = padded;
      }
      sum_neighbours(a, query, list, static_cast<double>(k), moments, i);
    }
    for (std::uint32_t i = count; i % kDoubles != 0; ++i)
      for (auto& row : moments.sum) row[i] = 0;
    for (std::uint32_t i = 0; i < count; i += kDoubles)
      solve(moments, i, a.out + std::size_t{4} * (begin + i), count - i < kDoubles ? count - i : kDoubles);
  }
}

// The last line exports the bodies compiled here under one name.
extern const NormalsBody kNormals;
const NormalsBody kNormals{neighbour_normals};
