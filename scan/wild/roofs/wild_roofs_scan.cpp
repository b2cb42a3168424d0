// SPDX-License-Identifier: Apache-2.0
#include "scan/wild/roofs/wild_roofs_scan.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/error.h"
#include "engine/pass/stop.h"
#include "kernels/core/parallel.h"
#include "scan/optics/value_noise.h"
#include "scan/roofs/roofs_scan.h"
#include "scan/scanners/pulse_tracer.h"
#include "scan/scanners/scan_record.h"
#include "scan/unit.h"

namespace ilot::scan {
namespace {

constexpr double kTile = 40;
constexpr std::size_t kTilesAtOnce = 24;
constexpr double kBeyond = 6;         // metres around the built square that stay in the cloud
constexpr double kEchoes = 1.12;      // per pulse
constexpr double kNearCurve = 0.8;    // metres from a facet to the curved surface that it stands for
constexpr double kRelief = 0.03;      // metres, of grass
constexpr double kLargestTown = 300;  // metres

// All that a tile needs.
class Overflight {
 public:
  explicit Overflight(const WildRoofsScan& scan)
      : scan_(scan),
        scene_(all_solids(scan)),
        middle_{scan.wild.town.area.x1 / 2, scan.wild.town.area.y1 / 2, scan.wild.town.ground.base},
        rays_(scene_.solids, scan.wild.town.crowns, middle_),
        flight_(scan.scanner.flight, scan.wild.town.ground, scan.seed),
        layout_(coloured_layout(kUnit)) {
    for (std::size_t w = 0; w < scan.wild.wings.size(); ++w)
      for (std::size_t p = 0; p < scan.wild.wings[w].planes + 4; ++p) wing_of_face_.push_back(w);
  }

  std::vector<std::byte> scan_tile(const Rect& tile) const {
    std::vector<std::byte> records;
    std::vector<PulseEcho> echoes;
    CastResult found;
    const std::vector<const RoofExtra*> cars = cars_near(tile);
    flight_.for_each_pulse(tile, [&](Pulse pulse) { follow(pulse, cars, found, echoes, records); });
    return records;
  }

 private:
  struct Seen {
    double range = 0;
    RoofClass true_class = RoofClass::ground;
    std::uint32_t plane = 0, element = 0;
    Material material = Material::grass;
    Vec3 normal;
    bool lost = false, at_house = false;
  };

  static RoofsScene all_solids(const WildRoofsScan& scan) {
    RoofsScene scene = make_roofs_scene(scan.wild.town);
    auto face = static_cast<std::uint32_t>(scene.targets.size());
    for (const RoofExtra& extra : scan.wild.extras) {
      scene.solids.push_back(extra.solid);
      scene.solids.back().first_face = face;
      face += extra.solid.face_count;
    }
    return scene;
  }

  std::vector<const RoofExtra*> cars_near(const Rect& tile) const {
    std::vector<const RoofExtra*> cars;
    for (const RoofExtra& car : scan_.wild.cars) {
      const Box3<Vec3>& box = car.solid.bounds;
      if (box.max.x > tile.x0 - 8 && box.min.x < tile.x1 + 8 && box.max.y > tile.y0 - 8 && box.min.y < tile.y1 + 8)
        cars.push_back(&car);
    }
    return cars;
  }

  double relief(Vec3 place, Material material) const {
    const double share = material == Material::grass ? 1 : 0.25;
    return kRelief * share *
           (value_noise(0.3 * place, scan_.seed + 1) + 0.5 * value_noise(2.5 * place, scan_.seed + 2));
  }

  Seen see_ground(const Ray& ray, double range) const {
    Seen seen;
    const Plane plane = scan_.wild.town.ground.plane();
    const Vec3 place = point_at(ray, range);
    seen.material = ground_material(place);
    seen.range = range + relief(place, seen.material) / dot(plane.n, ray.direction);
    seen.plane = kWildGround;
    seen.normal = plane.n;
    const double water = 0.5 + 0.5 * value_noise(0.03 * Vec3{place.x, place.y, 0}, scan_.seed + 3);
    seen.lost = water < scan_.scanner.wet_ground;
    return seen;
  }

  Material ground_material(Vec3 place) const {
    const double kind = value_noise(0.05 * Vec3{place.x, place.y, 0}, scan_.seed + 4);
    return kind < -0.1 ? Material::asphalt : kind < 0.1 ? Material::paving : Material::grass;
  }

  static Seen see_extra(double range, const RoofExtra& extra, std::uint32_t face) {
    const bool car = extra.kind == RoofExtraKind::car;
    return {range,
            car ? RoofClass::car : RoofClass::installation,
            0,
            extra.building,
            extra.material,
            extra.solid.planes[face].n};
  }

  const RoofExtra& extra_of(std::uint32_t face, std::uint32_t& own) const {
    std::uint32_t left = face - static_cast<std::uint32_t>(scene_.targets.size());
    std::size_t i = 0;
    while (left >= scan_.wild.extras[i].solid.face_count) left -= scan_.wild.extras[i++].solid.face_count;
    own = left;
    return scan_.wild.extras[i];
  }

  Seen see_building(const Ray& ray, double range, std::uint32_t face, Rng& rng) const {
    const WingSurface& wing = scan_.wild.wings[wing_of_face_[face]];
    const RoofsScene::Target& target = scene_.targets[face];
    const RoofBuilding& building = scan_.wild.town.buildings[target.building];
    const std::uint32_t number = face_met(scan_.wild.town, target, point_at(ray, range));
    const RoofFace& met = building.solid.faces[number];
    const bool roof = met.part == RoofPart::roof;
    Seen seen{range,
              roof ? RoofClass::roof : RoofClass::wall,
              kFirstWildPlane + building.face_plane[number],
              target.building + 1,
              roof ? building.roof : building.wall,
              building.frame.direction_to_town(met.plane.n)};
    if (wing.curve && roof)
      if (const auto inside = chord(ray, *wing.curve); inside && std::abs(inside->enter - range) < kNearCurve)
        seen.range = inside->enter;
    if (wing.glass) look_through(ray, wing, seen, rng);
    const bool flat = roof && seen.normal.z > 0.999;
    const double puddle = 0.5 + 0.5 * value_noise(0.2 * point_at(ray, range), scan_.seed + 5);
    if (flat && scan_.scanner.wet > 0 && puddle < scan_.scanner.wet) seen.lost = rng.uniform() < 0.95;
    return seen;
  }

  // Glass returns a share of the pulses; others are mirrored away or meet what is below.
  void look_through(const Ray& ray, const WingSurface& wing, Seen& seen, Rng& rng) const {
    seen.material = Material::glass;
    if (rng.uniform() < scan_.scanner.glass_echo) return;
    if (rng.uniform() >= scan_.scanner.glass_through) {
      seen.lost = true;
      return;
    }
    const double range = (wing.below - ray.origin.z) / ray.direction.z;
    if (range <= seen.range) return;
    seen = {range, RoofClass::ground, 0, seen.element, Material::paving, {0, 0, 1}};
  }

  Seen see(const Ray& ray, const PulseEcho& echo, const std::vector<CrownHit>& crowns, Rng& rng) const {
    if (echo.from == PulseEcho::From::ground) return see_ground(ray, echo.range);
    if (echo.from == PulseEcho::From::crown) {
      Seen seen{echo.range, RoofClass::vegetation, 0, 0, Material::foliage, -1.0 * ray.direction};
      for (const CrownHit& hit : crowns)
        if (echo.range >= hit.chord.enter && echo.range <= hit.chord.leave) {
          const std::uint32_t tree = scan_.wild.tree_of_crown[hit.crown];
          seen.element = kFirstTreeElement + tree;
          seen.at_house = scan_.wild.trees[tree].at_house;
        }
      // Leaves hang in clumps: a pulse that would end in a gap between them is lost among twigs.
      const Vec3 place = point_at(ray, echo.range);
      seen.lost = value_noise(1.1 * place, scan_.seed + 8) + 0.5 * value_noise(3.5 * place, scan_.seed + 9) < -0.12;
      return seen;
    }
    if (echo.face < scene_.targets.size()) return see_building(ray, echo.range, echo.face, rng);
    std::uint32_t own = 0;
    const RoofExtra& extra = extra_of(echo.face, own);
    return see_extra(echo.range, extra, own);
  }

  void follow(Pulse& pulse, const std::vector<const RoofExtra*>& cars, CastResult& found,
              std::vector<PulseEcho>& echoes, std::vector<std::byte>& records) const {
    const Plane ground = scan_.wild.town.ground.plane();
    rays_.cast(pulse.ray, found);
    PulseEcho last{-signed_distance(ground, pulse.ray.origin) / dot(ground.n, pulse.ray.direction)};
    if (found.solid && found.solid->t < last.range) last = {found.solid->t, PulseEcho::From::face, found.solid->face};
    std::optional<Seen> car;
    for (const RoofExtra* extra : cars) {
      const auto hit = enter(pulse.ray, extra->solid);
      if (!hit || hit->t > last.range || (car && car->range < hit->t)) continue;
      if (Rng(extra->key, pulse.line).uniform() > scan_.scanner.car_there) continue;
      car = see_extra(hit->t, *extra, hit->face);
    }
    find_echoes(found.crowns, car ? PulseEcho{car->range} : last, pulse.rng, echoes);
    std::uint8_t number = 0;
    for (const PulseEcho& echo : echoes) {
      const bool is_car = car && echo.from == PulseEcho::From::ground;
      const Seen seen = is_car ? *car : see(pulse.ray, echo, found.crowns, pulse.rng);
      if (!seen.lost) add(pulse, seen, ++number, static_cast<std::uint8_t>(echoes.size()), records);
    }
  }

  bool is_kept(const Seen& seen, Vec3 place) const {
    if (!scan_.wild.holds(place.x, place.y, kBeyond)) return false;
    if (seen.true_class != RoofClass::ground) return true;
    const WildRoofsScanner& c = scan_.scanner;
    if (c.ground_kept < 1) {
      const double patch = 0.5 + 0.5 * value_noise(0.08 * Vec3{place.x, place.y, 0}, scan_.seed + 6);
      if (patch > c.ground_kept) return false;
    }
    if (c.ground_dropped_near <= 0) return true;
    return std::none_of(scan_.wild.town.buildings.begin(), scan_.wild.town.buildings.end(), [&](const RoofBuilding& b) {
      return distance_to_building(b, place.x, place.y) < c.ground_dropped_near;
    });
  }

  std::uint8_t las_class(const Seen& seen, Vec3 place, Rng& rng) const {
    constexpr std::array<std::uint8_t, 7> kRight{0, 2, 6, 6, 5, 6, 1};
    constexpr std::array<std::uint8_t, 5> kOthers{1, 2, 5, 6, 9};
    const bool as_building =
        seen.at_house && Rng(scan_.seed ^ 0x7472656573ull, seen.element).uniform() < scan_.scanner.trees_as_building;
    const std::uint8_t right = as_building ? 6 : kRight[static_cast<std::size_t>(seen.true_class)];
    const double clump = 0.5 + 0.5 * value_noise(0.5 * place, scan_.seed + 7);
    if (clump < 4 * scan_.scanner.wrong_classes && clump < 0.3)
      return kOthers[static_cast<std::size_t>(1e6 * clump) % kOthers.size()];
    if (rng.uniform() < scan_.scanner.wrong_classes / 2) return kOthers[rng.below(kOthers.size())];
    return right;
  }

  void add(Pulse& pulse, const Seen& seen, std::uint8_t number, std::uint8_t count,
           std::vector<std::byte>& records) const {
    const WildRoofsScanner& c = scan_.scanner;
    const Vec3 surface = point_at(pulse.ray, seen.range);
    const bool stray = pulse.rng.uniform() < c.stray;
    double range = seen.range + c.noise * gaussian(pulse.rng);
    if (stray) range -= 40 * pulse.rng.uniform();
    Rng strip(scan_.seed ^ 0x7374726970ull, pulse.line);
    const double x = gaussian(strip), y = gaussian(strip), z = gaussian(strip);
    ColouredPoint point;
    point.place = point_at(pulse.ray, range) + c.strip_shift * Vec3{2 * x, 2 * y, z};
    if (!is_kept(seen, surface)) return;
    point.classification = stray ? 7 : las_class(seen, surface, pulse.rng);
    point.true_class = stray ? 0 : static_cast<std::uint8_t>(seen.true_class);
    point.true_plane = stray ? 0 : seen.plane;
    point.true_element = stray ? 0 : seen.element;
    point.material = static_cast<std::uint8_t>(1 + static_cast<std::uint8_t>(seen.material));
    const double cosine = std::abs(dot(seen.normal, pulse.ray.direction));
    if (c.intensity)
      point.intensity = static_cast<std::uint16_t>(65535 * reflectance(seen.material) * (0.2 + 0.8 * cosine));
    if (c.colour) point.rgb = colour(seen.material, surface);
    point.return_number = number;
    point.return_count = std::max(number, count);
    point.source = pulse.line;
    point.scan_angle_deg = pulse.scan_angle_deg;
    point.gps_time = pulse.gps_time;
    append_record(records, point, layout_);
  }

  const WildRoofsScan& scan_;
  RoofsScene scene_;
  Vec3 middle_;
  RayScene rays_;
  FlightPlan flight_;
  RecordLayout layout_;
  std::vector<std::size_t> wing_of_face_;
};

void draw_scanner(WildRoofsScanner& c, Draws& draws) {
  c.flight.density = draws.number("roofs.density");
  c.flight.height = draws.number("roofs.flight_height");
  c.flight.angle_deg = draws.number("roofs.scan_angle");
  c.flight.jitter = draws.number("roofs.jitter");
  c.noise = draws.number("roofs.noise");
  c.strip_shift = draws.number("roofs.strip_shift");
  c.glass_echo = draws.number("roofs.glass_echo");
  c.glass_through = draws.number("roofs.glass_through");
  c.wet = draws.number("roofs.wet");
  c.wet_ground = draws.number("roofs.water");
  c.ground_kept = draws.is("roofs.ground", "whole")  ? 1
                  : draws.is("roofs.ground", "none") ? 0
                                                     : draws.number("roofs.ground_kept");
  c.ground_dropped_near = draws.number("roofs.ground_gap");
  c.wrong_classes = draws.number("roofs.wrong_classes");
  c.trees_as_building = draws.number("roofs.trees_as_building");
  c.stray = draws.number("roofs.stray_points");
  c.colour = draws.is("roofs.colour", "present");
  c.intensity = draws.is("roofs.intensity", "present");
}

}  // namespace

const std::array<std::string_view, 1> kWildRoofsGroups{"roofs"};

std::span<const SceneOption> wild_roofs_options() {
  return drawn_options(kWildRoofsGroups);
}

WildRoofsScan plan_wild_roofs(Draws& draws, std::uint64_t seed, std::uint64_t points) {
  WildRoofsScan scan;
  scan.seed = seed;
  draw_scanner(scan.scanner, draws);
  const double side = std::sqrt(0.9 * static_cast<double>(points) / (scan.scanner.flight.density * kEchoes));
  scan.wild = build_wild_town(draws, seed, std::clamp(side - 2 * kBeyond, 90.0, kLargestTown));
  return scan;
}

void fit_wild_roofs(WildRoofsScan& scan, std::uint64_t points) {
  WildRoofsScan sparse = scan;
  const double side = scan.wild.width + 2 * kBeyond;
  sparse.scanner.flight.density = 50000 / (side * side);
  std::uint64_t bytes = 0;
  scan_wild_roofs(sparse, [&](std::span<const std::byte> records) { bytes += records.size(); });
  const double counted = static_cast<double>(bytes / coloured_layout(kUnit).record_length);
  if (counted == 0) throw Error("the flight sees nothing of this town");
  scan.scanner.flight.density = sparse.scanner.flight.density * static_cast<double>(points) / counted;
}

void scan_wild_roofs(const WildRoofsScan& scan, const std::function<void(std::span<const std::byte>)>& take) {
  const Overflight overflight(scan);
  const double side = scan.wild.town.area.x1;
  std::vector<Rect> tiles;
  for (double y = 0; y < side; y += kTile)
    for (double x = 0; x < side; x += kTile)
      if (scan.wild.holds(x + kTile / 2, y + kTile / 2, kTile))
        tiles.push_back({x, y, std::min(side, x + kTile), std::min(side, y + kTile)});
  for (std::size_t first = 0; first < tiles.size(); first += kTilesAtOnce) {
    if (stop_requested()) throw Error("interrupted: nothing was written", ExitCode::interrupted);
    std::vector<std::vector<std::byte>> batch(std::min(kTilesAtOnce, tiles.size() - first));
    parallel_for(batch.size(), [&](std::size_t i) { batch[i] = overflight.scan_tile(tiles[first + i]); });
    for (const auto& records : batch) take(records);
  }
}

}  // namespace ilot::scan
