// SPDX-License-Identifier: Apache-2.0
#include "scan/models/model_places.h"

#include <algorithm>
#include <cmath>

#include "scan/models/plan_hull.h"
#include "scan/unit.h"

namespace ilot::scan {
namespace {

constexpr double kNearest = 5, kFarthest = 20;  // metres
constexpr double kOfHeight = 0.75;              // a roof's edge is then seen at 53 degrees above the horizon at most
constexpr double kSpacing = 1.5;                // distances between stations
constexpr double kFacing = 0.5;                 // cosine of 60 degrees
constexpr double kShortSide = 0.05;             // metres

// A side of a footprint moved outwards.
struct Side {
  Vec3 from, to, out;
};

double distance_for(double wanted, double height) {
  return wanted > 0 ? wanted : std::clamp(kOfHeight * height, kNearest, kFarthest);
}

std::vector<Side> sides_of(const std::vector<Vec3>& hull, double distance) {
  std::vector<Side> sides;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec3 a = hull[i], b = hull[(i + 1) % hull.size()];
    const Vec3 along = b - a;
    const double length = norm(Vec3{along.x, along.y, 0});
    if (length < kShortSide) continue;
    const Vec3 out{along.y / length, -along.x / length, 0};
    sides.push_back({a + distance * out, b + distance * out, out});
  }
  return sides;
}

bool is_faced(const ModelStage& stage, std::uint32_t building, Vec3 out) {
  bool any = false;
  for (std::size_t i = 0; i < stage.openings.size(); ++i) {
    const std::uint32_t element = stage.openings[i].element;
    const auto plane = std::find_if(stage.planes.begin(), stage.planes.end(),
                                    [&](const TruePlane& p) { return p.element == element; });
    if (plane != stage.planes.end() && plane->polygons[0].building != building) continue;
    any = true;
    if (dot(stage.opening_normals[i], out) > kFacing) return true;
  }
  return !any;
}

double ground_at(const PartScene& scene, const ModelStage& stage, double x, double y) {
  const double top = stage.box.max.z + 10;
  const auto hit = scene.cast({{x, y, top}, {0, 0, -1}});
  return hit ? top - hit->t : stage.ground_z;
}

// Chords around the corners connect the sides.
std::vector<Vec3> line_around(const std::vector<Side>& sides) {
  std::vector<Vec3> line;
  for (const Side& side : sides) {
    line.push_back(side.from);
    line.push_back(side.to);
  }
  return line;
}

}  // namespace

bool is_covered(const PartScene& scene, const ModelStage& stage, Vec3 place) {
  return ground_at(scene, stage, place.x, place.y) > place.z;
}

std::vector<PlacedStation> automatic_stations(const ModelStage& stage, const AutomaticPlaces& wanted) {
  const PartScene scene(stage.scene.parts);
  std::vector<PlacedStation> placed;
  for (std::size_t b = 0; b < stage.buildings.size(); ++b) {
    const TrueBuilding& building = stage.buildings[b];
    if (stage.footprints[b].size() < 3) continue;
    const double distance = distance_for(wanted.distance, building.ridge - building.ground);
    for (const Side& side : sides_of(stage.footprints[b], distance)) {
      if (!is_faced(stage, building.id, side.out)) continue;
      const double length = norm(side.to - side.from);
      const auto count = static_cast<int>(std::max(1.0, std::ceil(length / (kSpacing * distance))));
      for (int i = 0; i < count; ++i) {
        Vec3 place = side.from + ((i + 0.5) / count) * (side.to - side.from);
        place.z = building.ground + wanted.height;
        const bool crowded = std::any_of(placed.begin(), placed.end(), [&](const PlacedStation& other) {
          return norm(other.position - place) < distance / 2;
        });
        if (!crowded && !is_covered(scene, stage, place)) placed.push_back({place, building.id, distance});
      }
    }
  }
  return placed;
}

std::vector<Vec3> automatic_path(const ModelStage& stage, const AutomaticPlaces& wanted) {
  std::vector<FlatPoint> points;
  for (const auto& footprint : stage.footprints)
    for (const Vec3& p : footprint) points.push_back({p.x, p.y});
  std::vector<Vec3> hull;
  for (const FlatPoint& p : plan_hull(points, 1 / kUnit)) hull.push_back({p.x, p.y, stage.ground_z + wanted.height});
  std::vector<Vec3> path =
      line_around(sides_of(hull, distance_for(wanted.distance, stage.box.max.z - stage.box.min.z)));
  if (!path.empty()) path.push_back(path.front());
  return path;
}

}  // namespace ilot::scan
