// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/facades/truth_facades.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "kernels/core/portable_math.h"
#include "kernels/outlines/circle_fit.h"

namespace ilot {
namespace {

constexpr double kOnPlane = 0.01, kSamePlane = 0.2;      // CRS units
constexpr double kParallel = 0.9962, kUpright = 0.0872;  // cosine and sine of 5 degrees

bool is_opening(const std::string& kind) {
  return kind == "window" || kind == "door" || kind == "shop" || kind == "opening";
}

std::size_t corners_on(const Plane& plane, const std::vector<const TrueElement*>& elements, bool openings) {
  std::size_t corners = 0;
  for (const TrueElement* e : elements)
    if (!openings || is_opening(e->kind))
      for (const Vec3& p : e->ring) corners += std::abs(signed_distance(plane, p)) <= kOnPlane;
  return corners;
}

const TruePlane* wall_of(const Truth& truth, const std::vector<const TrueElement*>& elements) {
  const bool openings =
      std::any_of(elements.begin(), elements.end(), [](const TrueElement* e) { return is_opening(e->kind); });
  const TruePlane* best = nullptr;
  std::size_t most = 0;
  for (const TruePlane& plane : truth.planes) {
    const std::size_t corners = corners_on(plane.plane, elements, openings);
    if (corners > most && std::abs(plane.plane.n.z) < kUpright && !plane.polygons.empty())
      best = &plane, most = corners;
  }
  return best;
}

// The longest run of corners on one circle in a ring of many corners. It is an arch, which the truth stores as chords.
std::optional<FacadeArc> arc_of(const Ring3& ring, const Facade& facade) {
  constexpr std::size_t kLeast = 6;   // corners; fewer are no arch
  constexpr double kOnCircle = 5e-4;  // CRS units: the corners of chords are written to a tenth of a millimetre
  const std::size_t n = ring.size();
  std::vector<PlanePoint> corners;
  for (const Vec3& p : ring)
    corners.push_back({dot(p - facade.origin, facade.right), dot(p - facade.origin, facade.up)});
  std::size_t longest = kLeast - 1;
  std::optional<FacadeArc> arc;
  for (std::size_t first = 0; first < n; ++first) {
    std::vector<PlanePoint> run{corners[first], corners[(first + 1) % n]};
    CircleFit circle;
    for (std::size_t k = 2; k < n; ++k) {
      run.push_back(corners[(first + k) % n]);
      const CircleFit wider = fit_circle(run);
      if (!wider.found || wider.rms > kOnCircle) break;
      circle = wider;
      if (run.size() <= longest) continue;
      longest = run.size();
      const auto direction = [&](PlanePoint p) {
        return direction_degrees(p.x - circle.centre.x, p.y - circle.centre.y);
      };
      arc = {facade.origin + circle.centre.x * facade.right + circle.centre.y * facade.up, circle.radius,
             direction(run.front()), direction(run.back())};
    }
  }
  return arc;
}

FacadeElement element_of(const TrueElement& given, const Facade& facade) {
  FacadeElement e;
  e.id = static_cast<std::uint32_t>(facade.elements.size() + 1);
  e.kind = given.kind;
  e.opening = is_opening(given.kind);
  e.row = given.row;
  e.column = given.column;
  e.ring = given.ring;
  if (const std::optional<FacadeArc> arc = arc_of(given.ring, facade)) e.arcs = {*arc};
  e.width_m = given.width_m;
  e.height_m = given.height_m;
  e.depth_m = given.depth_m;
  return e;
}

// The axes of the facade and the rectangle around the wall's polygons.
Facade bare_wall(std::uint32_t id, const TruePlane& wall) {
  Facade f;
  f.id = id;
  f.out = wall.plane.n;
  const Vec3 right = cross({0, 0, 1}, f.out);
  f.right = (1 / norm(right)) * right;
  f.up = cross(f.out, f.right);
  const Vec3 about = wall.polygons[0].ring[0];
  double u0 = INFINITY, u1 = -INFINITY, v0 = INFINITY, v1 = -INFINITY;
  for (const TruePolygon& polygon : wall.polygons)
    for (const Vec3& p : polygon.ring) {
      const double u = dot(p - about, f.right), v = dot(p - about, f.up);
      u0 = std::min(u0, u), u1 = std::max(u1, u), v0 = std::min(v0, v), v1 = std::max(v1, v);
    }
  f.origin = about + u0 * f.right + v0 * f.up;
  f.width_m = u1 - u0;
  f.height_m = v1 - v0;
  FacadeElement outline;
  outline.id = 1;
  outline.kind = "outline";
  outline.region = FacadeRegion::facade;
  outline.ring = {f.origin, f.origin + f.width_m * f.right, f.origin + f.width_m * f.right + f.height_m * f.up,
                  f.origin + f.height_m * f.up};
  outline.width_m = f.width_m;
  outline.height_m = f.height_m;
  f.elements.push_back(std::move(outline));
  return f;
}

}  // namespace

std::vector<Facade> true_facades(const Truth& truth) {
  std::map<std::uint32_t, std::vector<const TrueElement*>> by_facade;
  for (const TrueElement& e : truth.elements)
    if (e.facade != 0 && e.ring.size() >= 3) by_facade[e.facade].push_back(&e);
  std::vector<Facade> facades;
  for (const auto& [id, elements] : by_facade) {
    const TruePlane* wall = wall_of(truth, elements);
    if (wall == nullptr) continue;
    facades.push_back(bare_wall(id, *wall));
    for (const TrueElement* e : elements) facades.back().elements.push_back(element_of(*e, facades.back()));
  }
  return facades;
}

std::optional<Facade> truth_in_frame_of(const std::vector<Facade>& truth, const Facade& found) {
  const Facade* nearest = nullptr;
  double least = kSamePlane;
  for (const Facade& f : truth) {
    const Vec3 middle = f.origin + (f.width_m / 2) * f.right + (f.height_m / 2) * f.up;
    const double away = std::abs(dot(middle - found.origin, found.out));
    if (dot(f.out, found.out) < kParallel || away > least) continue;
    least = away;
    nearest = &f;
  }
  if (nearest == nullptr) return std::nullopt;
  Facade same = *nearest;
  same.id = found.id;
  same.crs = found.crs;
  same.origin = found.origin;
  same.right = found.right;
  same.up = found.up;
  same.out = found.out;
  return same;
}

}  // namespace ilot
