// SPDX-License-Identifier: Apache-2.0
#include "scan/streets/street_flight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/error.h"
#include "engine/pass/stop.h"
#include "kernels/core/parallel.h"
#include "scan/scanners/pulse_tracer.h"
#include "scan/streets/street_garden.h"
#include "scan/unit.h"

namespace ilot::scan {
namespace {

constexpr std::array<SceneOption, 10> kFlight{{
    {"scene.blocks", 30, "blocks", 1, 50, "along the street, each with houses on both sides; objects go with them"},
    {"scene.density", 20, "pulses/m2", 0.5, 1000, "pulses per area, both flight lines together"},
    {"scene.noise", 0.02, "m", 0, 0.5, "standard deviation of the range"},
    {"scene.height", 500, "m", 100, 5000, "flying height above the ground"},
    {"scene.scan_angle", 20, "deg", 5, 30, "largest scan angle to either side"},
    {"scene.slope", 2, "%", 0, 20, "rise of the street"},
    {"scene.touching", 0.15, "share", 0, 0.5, "objects that touch another"},
    {"scene.trees", 1.5, "per block", 0, 4, "trees on the pavements"},
    {"scene.gardens", 4, "per block and side", 0, 40, "bushes, hedges, trees, sheds and walls behind the houses"},
    {"scene.mirrored", 0.6, "share", 0, 0.9, "of the pulses on a car's paint that it mirrors away, at most"},
}};

constexpr double kTile = 40;           // metres
constexpr std::size_t kAtOnce = 32;    // tiles
constexpr double kAhead = 10;          // metres beyond the ends of the street that are scanned
constexpr double kGlass = 2.0 / 3;     // share of the pulses on glass that are mirrored away
constexpr double kDarkCars = 1.0 / 3;  // share of the cars; the paint of the others returns all of the light
constexpr double kEchoes = 1.05;       // per pulse (measured)

// Returns the plane of the road in the scene.
Ground ground_of(const Street& street) {
  const SinCos h = street_heading();
  const Vec3 origin = street_to_scene({0, 0, 0});
  const double x = street.slope * h.cos, y = street.slope * h.sin;
  return {street.base - x * origin.x - y * origin.y, x, y};
}

bool is_seen(const Street& street, Vec3 p, double beyond = 0) {
  return p.x >= -kAhead - beyond && p.x <= street.length + kAhead + beyond && std::abs(p.y) <= kGardenTo + beyond;
}

// Returns the tiles of the scene that may contain a part of what is scanned.
std::vector<Rect> tiles_of(const Street& street) {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  for (const double s : {-kAhead, street.length + kAhead})
    for (const double t : {-kGardenTo, kGardenTo}) {
      const Vec3 p = street_to_scene({s, t, 0});
      x0 = std::min(x0, p.x), y0 = std::min(y0, p.y), x1 = std::max(x1, p.x), y1 = std::max(y1, p.y);
    }
  std::vector<Rect> tiles;
  for (double y = std::floor(y0 / kTile) * kTile; y < y1; y += kTile)
    for (double x = std::floor(x0 / kTile) * kTile; x < x1; x += kTile)
      if (is_seen(street, scene_to_street({x + kTile / 2, y + kTile / 2, 0}), 0.75 * kTile))
        tiles.push_back({x, y, x + kTile, y + kTile});
  return tiles;
}

struct Overflight {
  const StreetFlight& flight;
  const StreetStage& stage;
  PartScene parts;
  RayScene crowns;
  FlightPlan plan;
  RecordLayout layout = coloured_layout(kUnit);

  Overflight(const StreetFlight& f, const StreetStage& s)
      : flight(f),
        stage(s),
        parts(s.model.scene.parts),
        crowns({}, s.model.crowns, {s.street.length / 2, 0, s.street.road_height(s.street.length / 2)}),
        plan(f.flight, ground_of(s.street), f.street.seed) {}
};

// Returns whether the light is mirrored away.
bool is_mirrored(const Overflight& scene, const SurfaceLabel& label, Rng& rng) {
  if (label.material == Material::glass) return rng.uniform() < kGlass;
  if (label.material != Material::car_paint) return false;
  const double drawn = Rng(scene.flight.street.seed ^ 0x7061696e74ull, label.element).uniform();
  return rng.uniform() < scene.flight.mirrored * std::max(0.0, 1 - drawn / kDarkCars);
}

ColouredPoint point_of(const SurfaceLabel& label, Vec3 surface_place, double cosine) {
  ColouredPoint point = labelled_point(label, surface_place);
  point.intensity = static_cast<std::uint16_t>(65535 * reflectance(label.material) * (0.3 + 0.7 * cosine));
  return point;
}

// Makes records of the echoes of one pulse.
void follow(const Overflight& scene, Pulse& pulse, std::vector<PulseEcho>& echoes, CastResult& crowns,
            std::vector<std::byte>& records) {
  static const SurfaceLabel leaves{static_cast<std::uint8_t>(StreetClass::vegetation), 0, 0, Material::foliage};
  const Ray ray{scene_to_street(pulse.ray.origin), turned_to_street(pulse.ray.direction)};
  const auto hit = scene.parts.cast(ray);
  if (!hit || !is_seen(scene.stage.street, point_at(ray, hit->t))) return;
  scene.crowns.cast(ray, crowns);
  find_echoes(crowns.crowns, {hit->t, PulseEcho::From::face, hit->surface}, pulse.rng, echoes);
  const auto solid = [](const PulseEcho& e) { return e.from == PulseEcho::From::face; };
  if (solid(echoes.back()) && is_mirrored(scene, scene.stage.model.scene.surfaces[hit->surface], pulse.rng))
    echoes.pop_back();
  std::uint8_t number = 0;
  for (const PulseEcho& echo : echoes) {
    const bool leaf = !solid(echo);
    ColouredPoint point = point_of(leaf ? leaves : scene.stage.model.scene.surfaces[hit->surface],
                                   point_at(ray, echo.range), leaf ? 0.7 : std::abs(dot(hit->normal, ray.direction)));
    point.place = street_to_scene(point_at(ray, echo.range + scene.flight.noise * gaussian(pulse.rng)));
    point.return_number = ++number;
    point.return_count = static_cast<std::uint8_t>(echoes.size());
    point.source = pulse.line;
    point.scan_angle_deg = pulse.scan_angle_deg;
    point.gps_time = pulse.gps_time;
    append_record(records, point, scene.layout);
  }
}

}  // namespace

std::span<const SceneOption> street_flight_options() {
  return kFlight;
}

StreetFlight plan_street_flight(const SceneValues& values, std::uint64_t seed) {
  StreetFlight f;
  f.street.blocks = static_cast<std::uint64_t>(values.get("scene.blocks"));
  f.street.slope_percent = values.get("scene.slope");
  f.street.touching = values.get("scene.touching");
  f.street.trees = values.get("scene.trees");
  f.street.seed = seed;
  f.flight.density = values.get("scene.density");
  f.flight.height = values.get("scene.height");
  f.flight.angle_deg = values.get("scene.scan_angle");
  f.noise = values.get("scene.noise");
  f.gardens = values.get("scene.gardens");
  f.mirrored = values.get("scene.mirrored");
  return f;
}

StreetStage set_stage(const StreetFlight& flight) {
  StreetStage stage = set_stage(flight.street);
  add_gardens(stage, flight.gardens, flight.street.seed);
  return stage;
}

void fit_points(StreetFlight& flight, const StreetStage& stage, std::uint64_t points) {
  const double area = (stage.street.length + 2 * kAhead) * 2 * kGardenTo;
  flight.flight.density = static_cast<double>(points) / (area * kEchoes);
}

void scan_street_flight(const StreetFlight& flight, const StreetStage& stage,
                        const std::function<void(std::span<const std::byte>)>& take) {
  const Overflight scene(flight, stage);
  const std::vector<Rect> tiles = tiles_of(stage.street);
  for (std::size_t first = 0; first < tiles.size(); first += kAtOnce) {
    if (stop_requested()) throw Error("interrupted: nothing was written", ExitCode::interrupted);
    std::vector<std::vector<std::byte>> batch(std::min(kAtOnce, tiles.size() - first));
    parallel_for(batch.size(), [&](std::size_t i) {
      std::vector<PulseEcho> echoes;
      CastResult crowns;
      scene.plan.for_each_pulse(tiles[first + i], [&](Pulse pulse) { follow(scene, pulse, echoes, crowns, batch[i]); });
    });
    for (const auto& records : batch) take(records);
  }
}

}  // namespace ilot::scan
