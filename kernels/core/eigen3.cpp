// SPDX-License-Identifier: Apache-2.0
#include "kernels/core/eigen3.h"

#include <cmath>
#include <utility>

namespace ilot {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

void rotate(Matrix& a, Matrix& v, std::size_t p, std::size_t q) {
  if (a[p][q] == 0) return;
  const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const double t = (theta >= 0 ? 1.0 : -1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1);
  const double s = t * c;
  const std::size_t r = 3 - p - q;
  const double apq = a[p][q];
  a[p][p] -= t * apq;
  a[q][q] += t * apq;
  a[p][q] = a[q][p] = 0;
  const double arp = a[r][p];
  const double arq = a[r][q];
  a[r][p] = a[p][r] = c * arp - s * arq;
  a[r][q] = a[q][r] = s * arp + c * arq;
  for (std::size_t i = 0; i < 3; ++i) {
    const double vip = v[i][p];
    const double viq = v[i][q];
    v[i][p] = c * vip - s * viq;
    v[i][q] = s * vip + c * viq;
  }
}

}  // namespace

Eigen3 eigen_symmetric(const Symmetric3& m) {
  Matrix a{{{m.xx, m.xy, m.xz}, {m.xy, m.yy, m.yz}, {m.xz, m.yz, m.zz}}};
  Matrix v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  constexpr int kMaxSweeps = 16;  // convergence is quadratic: 5 or 6 sweeps reach zero
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    const double off = std::abs(a[0][1]) + std::abs(a[0][2]) + std::abs(a[1][2]);
    if (off == 0) break;
    rotate(a, v, 0, 1);
    rotate(a, v, 0, 2);
    rotate(a, v, 1, 2);
  }
  std::array<std::size_t, 3> order{0, 1, 2};
  const auto sort_pair = [&](std::size_t i) {
    if (a[order[i + 1]][order[i + 1]] < a[order[i]][order[i]]) std::swap(order[i], order[i + 1]);
  };
  for (const std::size_t i : {0u, 1u, 0u}) sort_pair(i);  // equal values keep their order
  Eigen3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t c = order[i];
    result.values[i] = a[c][c];
    result.vectors[i] = {v[0][c], v[1][c], v[2][c]};
  }
  return result;
}

SmallestEigen smallest_eigen(const Symmetric3& m) {
  const double trace = m.xx + m.yy + m.zz;
  if (!(trace > 0)) return {};
  const double s = 1 / trace;  // eigenvalues now sum to 1
  const double xx = m.xx * s, xy = m.xy * s, xz = m.xz * s, yy = m.yy * s, yz = m.yz * s, zz = m.zz * s;
  const double c1 = xx * yy - xy * xy + xx * zz - xz * xz + yy * zz - yz * yz;
  const double c0 = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  // p(t) = t^3 - t^2 + c1 t - c0 is increasing and concave to the left of its smallest root.
  double t = 0;
  for (int i = 0; i < 40; ++i) {
    const double value = ((t - 1) * t + c1) * t - c0;
    const double slope = (3 * t - 2) * t + c1;
    if (!(slope > 0)) break;
    const double next = t - value / slope;
    if (!(next > t)) break;
    t = next;
  }
  const Vec3 r0{xx - t, xy, xz}, r1{xy, yy - t, yz}, r2{xz, yz, zz - t};
  const Vec3 candidates[3]{cross(r0, r1), cross(r0, r2), cross(r1, r2)};
  Vec3 best = candidates[0];
  for (const Vec3& c : candidates)
    if (dot(c, c) > dot(best, best)) best = c;
  const double length = norm(best);
  SmallestEigen result;
  result.value = t * trace;
  // The length is (l1 - l0)(l2 - l0) of the scaled values. When it is nearly zero there is no unique direction.
  if (!(length > 1e-10)) return result;
  result.vector = (1 / length) * best;
  result.unique = true;
  return result;
}

}  // namespace ilot
