// SPDX-License-Identifier: Apache-2.0
#include "kernels/core/moments.h"

#include <algorithm>

namespace ilot {
namespace {

double ratio(Int128 numerator, double denominator) {
  return static_cast<double>(numerator) / denominator;
}

constexpr std::size_t kSumsFit = (std::size_t{1} << 19) - 1;  // points whose sums of squares fit 64 bits

Moments moments_of_few(Points points, std::span<const std::uint32_t> indices) {
  std::int64_t x = 0, y = 0, z = 0, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  for (const std::uint32_t i : indices) {
    const std::int64_t px = static_cast<std::int32_t>(points.x[i]);
    const std::int64_t py = static_cast<std::int32_t>(points.y[i]);
    const std::int64_t pz = static_cast<std::int32_t>(points.z[i]);
    x += px;
    y += py;
    z += pz;
    xx += px * px;
    xy += px * py;
    xz += px * pz;
    yy += py * py;
    yz += py * pz;
    zz += pz * pz;
  }
  return {static_cast<std::int64_t>(indices.size()), x, y, z, xx, xy, xz, yy, yz, zz};
}

}  // namespace

void Moments::add_point(Index3 p) {
  ++n;
  x += p.x;
  y += p.y;
  z += p.z;
  xx += Int128{p.x} * p.x;
  xy += Int128{p.x} * p.y;
  xz += Int128{p.x} * p.z;
  yy += Int128{p.y} * p.y;
  yz += Int128{p.y} * p.z;
  zz += Int128{p.z} * p.z;
}

void Moments::add(const Moments& m) {
  n += m.n;
  x += m.x;
  y += m.y;
  z += m.z;
  xx += m.xx;
  xy += m.xy;
  xz += m.xz;
  yy += m.yy;
  yz += m.yz;
  zz += m.zz;
}

Moments moments_of(Points points, std::span<const std::uint32_t> indices) {
  Moments m;
  for (std::size_t begin = 0; begin < indices.size(); begin += kSumsFit)
    m.add(moments_of_few(points, indices.subspan(begin, std::min(kSumsFit, indices.size() - begin))));
  return m;
}

Moments shifted(const Moments& m, Index3 by) {
  const Int128 n = m.n, a = by.x, b = by.y, c = by.z;
  Moments r;
  r.n = m.n;
  r.x = m.x + n * a;
  r.y = m.y + n * b;
  r.z = m.z + n * c;
  r.xx = m.xx + 2 * a * m.x + n * a * a;
  r.xy = m.xy + a * m.y + b * m.x + n * a * b;
  r.xz = m.xz + a * m.z + c * m.x + n * a * c;
  r.yy = m.yy + 2 * b * m.y + n * b * b;
  r.yz = m.yz + b * m.z + c * m.y + n * b * c;
  r.zz = m.zz + 2 * c * m.z + n * c * c;
  return r;
}

Vec3 centroid(const Moments& m) {
  const double n = static_cast<double>(m.n);
  return {ratio(m.x, n), ratio(m.y, n), ratio(m.z, n)};
}

Symmetric3 covariance(const Moments& m) {
  const Int128 n = m.n;
  const double n2 = static_cast<double>(m.n) * static_cast<double>(m.n);
  return {ratio(n * m.xx - m.x * m.x, n2), ratio(n * m.xy - m.x * m.y, n2), ratio(n * m.xz - m.x * m.z, n2),
          ratio(n * m.yy - m.y * m.y, n2), ratio(n * m.yz - m.y * m.z, n2), ratio(n * m.zz - m.z * m.z, n2)};
}

}  // namespace ilot
