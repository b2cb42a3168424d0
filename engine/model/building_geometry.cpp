// SPDX-License-Identifier: Apache-2.0
#include "engine/model/building_geometry.h"

#include <algorithm>
#include <cmath>

#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

constexpr double kLevel = 1e-6;  // sine of the slope up to which a face has no direction

// Returns Newell's normal of all rings; its length is twice the area in CRS units.
Vec3 doubled_area_vector(const Building& building, const BuildingSurface& surface) {
  Vec3 sum;
  if (surface.rings.empty() || surface.rings[0].empty()) return sum;
  const Vec3 anchor = building.vertices[surface.rings[0][0]];
  for (const auto& ring : surface.rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      sum = sum + cross(building.vertices[ring[i]] - anchor, building.vertices[ring[(i + 1) % ring.size()]] - anchor);
  return sum;
}

}  // namespace

SurfaceShape surface_shape(const Building& building, const BuildingSurface& surface, double metres_per_unit) {
  const Vec3 n = doubled_area_vector(building, surface);
  const double length = norm(n), level = std::sqrt(n.x * n.x + n.y * n.y);
  if (!(length > 0)) return {};
  SurfaceShape shape{length / 2 * metres_per_unit * metres_per_unit, direction_degrees(n.z, level), -1};
  if (level > kLevel * length) shape.azimuth_deg = direction_degrees(n.y, n.x);
  return shape;
}

// The volume is the sum of cones from the first vertex over every face; any corner of a face gives its plane.
double volume_m3(const Building& building, double metres_per_unit) {
  double sum = 0;
  for (const BuildingSurface& surface : building.surfaces) {
    if (surface.rings.empty() || surface.rings[0].empty()) continue;
    const Vec3 apex = building.vertices[surface.rings[0][0]] - building.vertices[0];
    sum += dot(apex, doubled_area_vector(building, surface));
  }
  return sum / 6 * metres_per_unit * metres_per_unit * metres_per_unit;
}

const Building* finest_solid(std::span<const Building> levels) {
  const Building* finest = nullptr;
  for (const Building& level : levels)
    if (!level.surfaces.empty() && !level.lod.starts_with('0')) finest = &level;
  return finest;
}

}  // namespace ilot
