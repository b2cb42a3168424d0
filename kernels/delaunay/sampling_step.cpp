// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/sampling_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "kernels/delaunay/place_neighbours.h"
#include "kernels/delaunay/plane_order.h"

namespace ilot {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kPi = 3.14159265358979323846;

struct BothWays {
  Vec3 there, back;
};

// Turns v about a unit axis, which need not be perpendicular to v, by an angle below 0.1, in both senses. Cosine and
// sine come from the tangent of the half angle, by a series that is exact to the last bits for such angles.
BothWays turned(Vec3 v, Vec3 axis, double angle) {
  const double h = angle / 2, h2 = h * h, t = h * (1 + h2 * (1.0 / 3 + h2 * (2.0 / 15 + h2 * 17.0 / 315)));
  const double scale = 1 / (1 + t * t), cosine = (1 - t * t) * scale, sine = 2 * t * scale;
  const Vec3 same = cosine * v, perpendicular = sine * cross(axis, v), along = (1 - cosine) * dot(axis, v) * axis;
  return {same + perpendicular + along, same - perpendicular + along};
}

// Computes where the ray meets the plane, as a vector from the station. Returns false when it does not meet the plane.
bool meet(Vec3 ray, const Plane& plane, double station_distance, Vec3& out) {
  const double towards = -dot(plane.n, ray);
  if (!(towards * station_distance > 0)) return false;
  out = (station_distance / towards) * ray;
  return true;
}

// The cell around a point of a plane, between the rays half a step to each side. It is nearly a parallelogram.
struct RayCell {
  Vec3 across, along;  // its sides; the first between profiles
};

std::optional<RayCell> ray_cell(const Scanner& s, const Plane& plane, Vec3 p) {
  const Vec3 ray = p - s.position;
  const Vec3 side = cross(ray, s.axis);
  const double level = norm(side);
  const double height = signed_distance(plane, s.position);
  if (!(level > 0)) return std::nullopt;
  const Vec3 lift = (1 / level) * side;
  const BothWays sideways = turned(ray, s.axis, s.azimuth_step / 2), upwards = turned(ray, lift, s.elevation_step / 2);
  Vec3 left, right, up, down;
  if (!meet(sideways.there, plane, height, left) || !meet(sideways.back, plane, height, right) ||
      !meet(upwards.there, plane, height, up) || !meet(upwards.back, plane, height, down))
    return std::nullopt;
  return RayCell{left - right, up - down};
}

}  // namespace

double predicted_step(const Scanner& s, const Plane& plane, Vec3 p) {
  const auto cell = ray_cell(s, plane, p);
  return cell ? std::max(norm(cell->across + cell->along), norm(cell->across - cell->along)) : kNever;
}

double predicted_step(std::span<const Scanner> stations, const Plane& plane, Vec3 p) {
  double least = kNever;
  for (const Scanner& s : stations) least = std::min(least, predicted_step(s, plane, p));
  return least;
}

double predicted_density(const Scanner& s, const Plane& plane, Vec3 p) {
  const auto cell = ray_cell(s, plane, p);
  if (!cell) return 0;
  const double area = norm(cross(cell->across, cell->along));
  return area > 0 ? 1 / area : 0;
}

double predicted_density(std::span<const Scanner> stations, const Plane& plane, Vec3 p) {
  double sum = 0;
  for (const Scanner& s : stations) sum += predicted_density(s, plane, p);
  return sum;
}

double documented_step(const Scanner& s, const Plane& plane, Vec3 p) {
  const double d = std::abs(signed_distance(plane, s.position));
  const Vec3 ray = p - s.position;
  const double level2 = ray.x * ray.x + ray.y * ray.y;
  const double cos_theta = d / std::sqrt(level2);
  const double cos_phi = std::sqrt(level2 / dot(ray, ray));
  const double du = d * s.azimuth_step / (cos_theta * cos_theta);
  const double dv = d * s.elevation_step / (cos_phi * cos_phi * cos_theta);
  return std::sqrt(du * du + dv * dv);
}

double raster_step(double squared_radius, int k) {
  return std::sqrt(2 * kPi * squared_radius / k);
}

MeasuredSteps measured_steps(std::span<const Point2> points, int k, std::int64_t farthest) {
  MeasuredSteps out{std::vector<float>(points.size()), std::vector<std::int64_t>(points.size(), -1)};
  const PlaneOrder order = plane_order(points);
  std::vector<std::uint32_t> all(order.points.size());
  std::iota(all.begin(), all.end(), 0u);
  std::vector<std::int64_t> squared(all.size());
  kth_distances(place_cells(order), all, k, farthest, squared);
  for (const std::uint32_t i : all) {
    const double d2 = static_cast<double>(squared[i] < 0 ? farthest * farthest : squared[i]);
    out.step[order.index[i]] = static_cast<float>(raster_step(d2, k));
    out.reach2[order.index[i]] = squared[i];
  }
  for (const auto& [left_out, kept] : order.duplicates) {
    out.step[left_out] = out.step[kept];
    out.reach2[left_out] = out.reach2[kept];
  }
  return out;
}

}  // namespace ilot
