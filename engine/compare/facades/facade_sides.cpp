// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/facades/facade_sides.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ilot {
namespace {

constexpr double kNearM = 0.5;        // to the plane of a facade, and beyond its extent
constexpr double kCosParallel = 0.9;  // 25 degrees

// The extent of the elements along the axes of their facade.
struct Extent {
  double right[2]{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
  double up[2]{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
};

Extent extent_of(const Facade& facade) {
  Extent e;
  for (const FacadeElement& element : facade.elements) {
    for (const Vec3& p : element.ring) {
      const double r = dot(p - facade.origin, facade.right), u = dot(p - facade.origin, facade.up);
      e.right[0] = std::min(e.right[0], r), e.right[1] = std::max(e.right[1], r);
      e.up[0] = std::min(e.up[0], u), e.up[1] = std::max(e.up[1], u);
    }
  }
  return e;
}

bool lies_on(Vec3 p, const Facade& facade, const Extent& e, double near) {
  const double r = dot(p - facade.origin, facade.right), u = dot(p - facade.origin, facade.up);
  return std::abs(dot(p - facade.origin, facade.out)) <= near && r >= e.right[0] - near && r <= e.right[1] + near &&
         u >= e.up[0] - near && u <= e.up[1] + near;
}

// The direction in which the ring turns counter-clockwise, of unit length; zero without an area.
Vec3 direction_of(const Ring3& ring) {
  Vec3 sum;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum = sum + cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return norm(sum) > 0 ? (1 / norm(sum)) * sum : Vec3{};
}

}  // namespace

FacadeSides evaluate_facade_sides(std::span<const TrueOpening> truth, std::span<const Facade> facades,
                                  double metres_per_unit) {
  FacadeSides sides;
  for (const Facade& facade : facades) {
    const Extent extent = extent_of(facade);
    int same = 0, against = 0;
    for (const TrueOpening& opening : truth) {
      if (opening.ring.size() < 3 || !lies_on(opening.ring[0], facade, extent, kNearM / metres_per_unit)) continue;
      const double cosine = dot(direction_of(opening.ring), facade.out);
      same += cosine >= kCosParallel;
      against += cosine <= -kCosParallel;
    }
    sides.judged += same + against > 0;
    sides.mirrored += against > same;
  }
  return sides;
}

}  // namespace ilot
