// SPDX-License-Identifier: Apache-2.0
#include "scan/roofs/roofs_scan.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/error.h"
#include "engine/pass/stop.h"
#include "kernels/core/parallel.h"
#include "scan/scanners/pulse_tracer.h"
#include "scan/scanners/scan_record.h"
#include "scan/unit.h"

namespace ilot::scan {
namespace {

constexpr std::array<SceneOption, 10> kRoofs{{
    {"scene.buildings", 445, "buildings", 1, 100000, "of which 128 of 445 under gables, 52 of 445 under hips"},
    {"scene.density", 10, "pulses/m2", 0.1, 1000, "pulses per area, both flight lines together"},
    {"scene.noise", 0.02, "m", 0, 1, "standard deviation of the range"},
    {"scene.jitter", 0.2, "spacings", 0, 0.5, "largest shift of a pulse's aim"},
    {"scene.height", 500, "m", 100, 5000, "flying height above the ground"},
    {"scene.scan_angle", 20, "deg", 5, 30, "largest scan angle to either side"},
    {"scene.slope", 2, "%", 0, 10, "slope of the ground"},
    {"scene.trees", 25, "per ha", 0, 60, "trees"},
    {"scene.adjoining", 0.4, "share", 0, 1, "buildings that start a terrace"},
    {"scene.chimneys", 0, "share", 0, 1, "buildings with a chimney"},
}};

// Further echoes per pulse for each tree per hectare (measured).
constexpr double kEchoesPerTree = 0.0022;
constexpr double kTile = 40;                                                // metres
constexpr double kBatchBytes = 100e6;                                       // of records in memory at a time
constexpr double kPlaneTolerance = 1e-6;                                    // metres; tolerance for equal planes
constexpr std::uint8_t kVegetation = 4, kRoof = 2, kWall = 3, kGround = 1;  // true_class

Plane plane_in_town(const Plane& plane, const RoofFrame& frame) {
  const Vec3 n = frame.direction_to_town(plane.n);
  return {n, plane.d - n.x * frame.x - n.y * frame.y};
}

// Returns the roof planes and the four walls of a wing, in its own frame and in metres.
std::vector<Plane> planes_of(const Wing& wing) {
  std::vector<Plane> planes;
  for (const RoofPlane& p : wing.planes) {
    const Vec3 outward{-static_cast<double>(p.a), -static_cast<double>(p.b), static_cast<double>(kSlopeUnit)};
    planes.push_back({(1 / norm(outward)) * outward, -kUnit * static_cast<double>(p.c) / norm(outward)});
  }
  for (const GridLine& side : half_planes(wing.rect))
    planes.push_back(
        {{-static_cast<double>(side.a), -static_cast<double>(side.b), 0}, -kUnit * static_cast<double>(side.c)});
  return planes;
}

Box3<Vec3> bounds_of(const RoofBuilding& building, const Wing& wing) {
  const Vec3 first =
      building.frame.to_town({kUnit * static_cast<double>(wing.rect.u0), kUnit * static_cast<double>(wing.rect.v0), 0});
  Box3<Vec3> box{{first.x, first.y, building.floor}, {first.x, first.y, building.ridge}};
  for (Integer u : {wing.rect.u0, wing.rect.u1})
    for (Integer v : {wing.rect.v0, wing.rect.v1}) {
      const Vec3 p = building.frame.to_town({kUnit * static_cast<double>(u), kUnit * static_cast<double>(v), 0});
      box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), box.min.z};
      box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), box.max.z};
    }
  return box;
}

std::vector<std::uint32_t> faces_in(const RoofSolid& solid, const Plane& plane) {
  std::vector<std::uint32_t> faces;
  for (std::uint32_t f = 0; f < solid.faces.size(); ++f) {
    const Plane& other = solid.faces[f].plane;
    if (dot(plane.n, other.n) > 1 - 1e-9 && std::abs(plane.d - other.d) < kPlaneTolerance) faces.push_back(f);
  }
  return faces;
}

double distance_to_side(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 way = b - a;
  const double t = std::clamp(dot(p - a, way) / dot(way, way), 0.0, 1.0);
  return norm(p - a - t * way);
}

double distance_to_outline(const RoofSolid& solid, const RoofFace& face, Vec3 p) {
  double nearest = 1e9;
  for (const auto& ring : face.rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      nearest =
          std::min(nearest, distance_to_side(p, solid.vertices[ring[i]], solid.vertices[ring[(i + 1) % ring.size()]]));
  return nearest;
}

// All data about the town that a tile needs.
struct Stage {
  const RoofTown& town;
  const RoofsScan& scan;
  const FlightPlan& flight;
  const RoofsScene& scene;
  const RayScene& rays;
  RecordLayout layout;
};

struct Seen {
  ColouredPoint point;
  Material material = Material::grass;
  Vec3 normal;
};

Seen see(const Stage& stage, const Ray& ray, const PulseEcho& echo) {
  Seen seen;
  const Vec3 place = point_at(ray, echo.range);
  if (echo.from == PulseEcho::From::crown) {
    seen.point.classification = 5;
    seen.point.true_class = kVegetation;
    seen.material = Material::foliage;
    seen.normal = -1.0 * ray.direction;
  } else if (echo.from == PulseEcho::From::ground) {
    seen.point.classification = 2;
    seen.point.true_class = kGround;
    seen.point.true_plane = kTownGround;
    seen.material = ground_cover(stage.town, place.x, place.y);
    seen.normal = stage.town.ground.plane().n;
  } else {
    const RoofsScene::Target& target = stage.scene.targets[echo.face];
    const RoofBuilding& building = stage.town.buildings[target.building];
    const std::uint32_t number = face_met(stage.town, target, place);
    const RoofFace& face = building.solid.faces[number];
    const bool roof = face.part == RoofPart::roof;
    seen.point.classification = 6;
    seen.point.true_class = roof ? kRoof : kWall;
    seen.point.true_plane = kFirstTownPlane + building.face_plane[number];
    seen.material = roof ? building.roof : building.wall;
    seen.normal = building.frame.direction_to_town(face.plane.n);
  }
  const double cosine = std::abs(dot(seen.normal, ray.direction));
  seen.point.intensity = static_cast<std::uint16_t>(65535 * reflectance(seen.material) * (0.3 + 0.7 * cosine));
  seen.point.material = static_cast<std::uint8_t>(1 + static_cast<std::uint8_t>(seen.material));
  seen.point.rgb = colour(seen.material, place);
  return seen;
}

std::vector<std::byte> scan_tile(const Stage& stage, const Rect& tile) {
  PulseTracer tracer(stage.rays, stage.town.ground.plane());
  std::vector<PulseEcho> echoes;
  std::vector<std::byte> records;
  stage.flight.for_each_pulse(tile, [&](Pulse pulse) {
    tracer.trace(pulse.ray, pulse.rng, echoes);
    std::uint8_t number = 0;
    for (const PulseEcho& echo : echoes) {
      ColouredPoint point = see(stage, pulse.ray, echo).point;
      point.place = point_at(pulse.ray, echo.range + stage.scan.noise * gaussian(pulse.rng));
      point.return_number = ++number;
      point.return_count = static_cast<std::uint8_t>(echoes.size());
      point.source = pulse.line;
      point.scan_angle_deg = pulse.scan_angle_deg;
      point.gps_time = pulse.gps_time;
      append_record(records, point, stage.layout);
    }
  });
  return records;
}

}  // namespace

std::span<const SceneOption> roofs_options() {
  return kRoofs;
}

RoofsScan plan_roofs(const SceneValues& values, std::uint64_t seed, std::optional<std::uint64_t> points) {
  if (points && values.is_set("scene.density"))
    throw Error("--points and scene.density contradict each other; leave out one", ExitCode::usage);
  RoofsScan scan;
  scan.points = points;
  scan.noise = values.get("scene.noise");
  scan.flight.density = values.get("scene.density");
  scan.flight.height = values.get("scene.height");
  scan.flight.angle_deg = values.get("scene.scan_angle");
  scan.flight.jitter = values.get("scene.jitter");
  scan.town.buildings = static_cast<std::uint64_t>(values.get("scene.buildings"));
  scan.town.slope_percent = values.get("scene.slope");
  scan.town.trees = values.get("scene.trees");
  scan.town.adjoining = values.get("scene.adjoining");
  scan.town.chimneys = values.get("scene.chimneys");
  scan.town.seed = seed;
  return scan;
}

double density_for(const RoofTown& town, std::uint64_t points) {
  const double side = town.area.x1, area = side * side;
  const double trees = 1e4 * static_cast<double>(town.crowns.size()) / area;
  return static_cast<double>(points) / (area * (1 + kEchoesPerTree * trees));
}

RoofsScene make_roofs_scene(const RoofTown& town) {
  RoofsScene scene;
  for (std::uint32_t b = 0; b < town.buildings.size(); ++b) {
    const RoofBuilding& building = town.buildings[b];
    for (const Wing& wing : building.wings) {
      ConvexSolid solid;
      solid.first_face = static_cast<std::uint32_t>(scene.targets.size());
      solid.bounds = bounds_of(building, wing);
      for (const Plane& plane : planes_of(wing)) {
        solid.planes[solid.face_count++] = plane_in_town(plane, building.frame);
        scene.targets.push_back({b, faces_in(building.solid, plane)});
      }
      scene.solids.push_back(solid);
    }
  }
  return scene;
}

std::uint32_t face_met(const RoofTown& town, const RoofsScene::Target& target, Vec3 place) {
  if (target.faces.size() == 1) return target.faces[0];
  const RoofBuilding& building = town.buildings[target.building];
  const Vec3 local = building.frame.to_local(place);
  for (std::uint32_t f : target.faces)
    if (face_contains(building.solid, building.solid.faces[f], local)) return f;
  // Near an edge, rounding may move the position outside its face.
  std::uint32_t nearest = 0;
  double least = 1e9;
  for (std::uint32_t f = 0; f < building.solid.faces.size(); ++f) {
    if (building.solid.faces[f].part == RoofPart::floor) continue;
    const double distance = distance_to_outline(building.solid, building.solid.faces[f], local);
    if (distance < least) {
      least = distance;
      nearest = f;
    }
  }
  return nearest;
}

void scan_roofs(const RoofsScan& scan, const RoofTown& town,
                const std::function<void(std::span<const std::byte>)>& take) {
  const RoofsScene scene = make_roofs_scene(town);
  const Vec3 middle{(town.area.x0 + town.area.x1) / 2, (town.area.y0 + town.area.y1) / 2, town.ground.base};
  const RayScene rays(scene.solids, town.crowns, middle);
  const FlightPlan flight(scan.flight, town.ground, scan.town.seed);
  const Stage stage{town, scan, flight, scene, rays, coloured_layout(kUnit)};
  const double side = town.area.x1;
  const auto tiles = static_cast<std::size_t>(std::ceil(side / kTile));
  const double tile_bytes = kTile * kTile * scan.flight.density * 1.3 * stage.layout.record_length;
  const auto at_once = static_cast<std::size_t>(std::clamp(kBatchBytes / tile_bytes, 1.0, 64.0));
  for (std::size_t first = 0; first < tiles * tiles; first += at_once) {
    if (stop_requested()) throw Error("interrupted: nothing was written", ExitCode::interrupted);
    std::vector<std::vector<std::byte>> batch(std::min(at_once, tiles * tiles - first));
    parallel_for(batch.size(), [&](std::size_t i) {
      const auto column = static_cast<double>((first + i) % tiles), row = static_cast<double>((first + i) / tiles);
      batch[i] = scan_tile(stage, {column * kTile, row * kTile, std::min(side, (column + 1) * kTile),
                                   std::min(side, (row + 1) * kTile)});
    });
    for (const auto& records : batch) take(records);
  }
}

}  // namespace ilot::scan
