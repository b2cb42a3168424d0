// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/plane_fit.h"

#include <algorithm>
#include <cmath>

namespace ilot {

PlaneFit fit_plane(const Moments& m) {
  if (m.n < 3) return {};
  const Eigen3 e = eigen_symmetric(covariance(m));
  if (!(e.values[1] > 1e-12 * e.values[2])) return {};
  Vec3 n = e.vectors[0];
  n = (1 / norm(n)) * n;
  if (n.z < 0 || (n.z == 0 && (n.y < 0 || (n.y == 0 && n.x < 0)))) n = -1.0 * n;
  return {{n, -dot(n, centroid(m))}, std::sqrt(std::max(0.0, e.values[0])), true};
}

double rms_to_plane(const Moments& m, const Plane& plane) {
  const Symmetric3 c = covariance(m);
  const Vec3 n = plane.n;
  const double spread = n.x * n.x * c.xx + n.y * n.y * c.yy + n.z * n.z * c.zz +
                        2 * (n.x * n.y * c.xy + n.x * n.z * c.xz + n.y * n.z * c.yz);
  const double offset = signed_distance(plane, centroid(m));
  return std::sqrt(std::max(0.0, spread) + offset * offset);
}

Plane shifted(const Plane& plane, Vec3 by) {
  return {plane.n, plane.d - dot(plane.n, by)};
}

}  // namespace ilot
