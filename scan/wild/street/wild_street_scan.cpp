// SPDX-License-Identifier: Apache-2.0
#include "scan/wild/street/wild_street_scan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/error.h"
#include "engine/pass/stop.h"
#include "kernels/core/parallel.h"
#include "scan/optics/value_noise.h"
#include "scan/scanners/scan_record.h"
#include "scan/unit.h"

namespace ilot::scan {
namespace {

constexpr std::size_t kGrainsAtOnce = 48;
constexpr double kBorder = 1.5;   // metres along the end of the ground that are not in the cloud: its upright side
constexpr double kAirArea = 110;  // metres across that are seen from the air
constexpr double kPilotPoints = 60000;
constexpr double kKeptBeyond = 5;      // metres beyond both ends that stay in the cloud of a scanner on the ground
constexpr double kFullIntensity = 14;  // metres; half of the light fills half of the scale there

Platform platform_of(std::string_view name) {
  return name == "tripod" ? Platform::tripod : name == "air" ? Platform::air : Platform::vehicle;
}

// Square metres that a scanner on the ground sees per metre of street, in units of its density: measured.
constexpr double kSeenPerMetre = 38;

double length_for(Platform platform, double density, std::uint64_t points) {
  const double wanted = 0.75 * static_cast<double>(points);
  if (platform == Platform::air) return std::clamp(wanted / (density * kAirArea), 60.0, 350.0);
  return std::clamp(wanted / (density * kSeenPerMetre), 30.0, 260.0);
}

bool is_free(const std::vector<WildObject>& objects, double s, double t) {
  const PlanBox foot{s, t, {}, 0.5, 0.5};
  return std::none_of(objects.begin(), objects.end(), [&](const WildObject& o) { return closer(foot, o.plan, 0.3); });
}

void place_stations(WildStreetScan& scan, Draws& draws) {
  const int count = draws.whole("street.stations");
  const WildStreet& street = scan.street;
  for (int i = 0; i < count; ++i) {
    Rng rng = draws.random("street.station", static_cast<std::uint64_t>(i));
    const bool in_yard = draws.happens("street.yard_stations", static_cast<std::uint64_t>(i));
    for (int attempt = 0; attempt < 40; ++attempt) {
      const double s = street.length * ((i + rng.uniform()) / count), reach = street.half_street() - 0.8;
      double t = between(rng, -reach, reach);
      if (i > 0 && in_yard) t = (t < 0 ? -1 : 1) * (street.half_street() + between(rng, 1, 25));  // a yard
      const GroundPatch* patch = street.patch_at(s, t);
      if (!patch || patch->kind == GroundPatch::Kind::passage || !is_free(scan.objects, s, t)) continue;
      scan.scanner.stations.push_back({s, t, street.ground_height(s, t) + between(rng, 1.4, 2.1)});
      break;
    }
  }
  if (scan.scanner.stations.empty())
    scan.scanner.stations.push_back({street.length / 2, 0, street.profile_height(street.length / 2) + 1.8});
}

void draw_scanner(WildStreetScanner& c, Draws& draws) {
  const bool air = c.platform == Platform::air;
  c.density = draws.number(air ? "street.air_density" : "street.density");
  c.beam.noise = draws.number(air ? "street.air_noise" : "street.noise");
  c.beam.divergence_mrad = draws.number(air ? "street.air_divergence" : "street.divergence");
  c.beam.separation = air ? 1.2 : draws.number("street.separation");
  c.flight.height = draws.number("street.flight_height");
  c.beam.range = air ? 1.4 * c.flight.height + 200 : draws.number("street.range");
  c.beam.glass_echo = draws.number("street.glass_echo");
  c.beam.glass_through = draws.number("street.glass_through");
  c.beam.wet = draws.number("street.wet");
  c.beam.roughness = draws.number("street.roughness");
  c.beam.bow = draws.number("street.bow");
  c.height = draws.number("street.height");
  c.turned_deg = draws.number("street.turned");
  c.blind_deg = draws.number("street.blind");
  c.speed = draws.number("street.speed");
  c.shape = draws.number("street.shape");
  c.heads = draws.whole("street.heads");
  c.passes = draws.whole("street.passes");
  c.pass_shift = draws.number("street.pass_shift");
  c.wander = draws.number("street.wander");
  c.sweep = draws.number("street.sweep");
  c.flight.angle_deg = draws.number("street.scan_angle");
  if (draws.is("street.cut", "cut") && !air) c.cut = draws.number("street.cut_height");
  c.colour = draws.is("street.colour", "present");
  c.intensity = draws.is("street.intensity", "present");
  c.classes = draws.is("street.classes", "present");
  c.wrong_classes = draws.number("street.wrong_classes");
  c.stray = draws.number("street.stray_points");
}

class Recorder {
 public:
  explicit Recorder(const WildStreetScan& scan) : scan_(scan), layout_(coloured_layout(kUnit)) {}

  void add(StreetPulse& pulse, const std::vector<WildEcho>& echoes, std::vector<std::byte>& records) const {
    for (std::size_t i = 0; i < echoes.size(); ++i) {
      WildEcho echo = echoes[i];
      const double noise = scan_.scanner.beam.noise * gaussian(pulse.rng);
      if (pulse.rng.uniform() < scan_.scanner.stray) {
        echo.range *= scan_.scanner.platform == Platform::air ? 1 - 0.02 * pulse.rng.uniform() : pulse.rng.uniform();
        echo.label = {0, 0, 0, echo.label.material};
      }
      const Vec3 surface = point_at(pulse.ray, echo.surface_range);
      const Vec3 place = point_at(pulse.ray, echo.range + noise) + pulse.shift;
      if (!is_kept(place)) continue;
      ColouredPoint point = point_of(echo, pulse, surface);
      point.place = scan_.street.to_scene(place);
      point.return_number = static_cast<std::uint8_t>(i + 1);
      point.return_count = static_cast<std::uint8_t>(echoes.size());
      append_record(records, point, layout_);
    }
  }

 private:
  bool is_kept(Vec3 p) const {
    const WildStreetScanner& c = scan_.scanner;
    if (p.x < c.s0 || p.x > c.s1 || std::abs(p.y) > c.half_width) return false;
    return !c.cut || p.z < scan_.street.profile_height(p.x) + *c.cut;
  }

  ColouredPoint point_of(const WildEcho& echo, StreetPulse& pulse, Vec3 surface) const {
    const WildStreetScanner& c = scan_.scanner;
    ColouredPoint point;
    point.material = static_cast<std::uint8_t>(1 + static_cast<std::uint8_t>(echo.label.material));
    point.true_class = echo.label.true_class;
    point.true_plane = echo.label.plane;
    point.true_element = echo.label.element;
    if (c.classes)
      point.classification =
          wrong_class(las_class(static_cast<StreetClass>(echo.label.true_class)), surface, pulse.rng);
    if (c.colour) point.rgb = colour(echo.label.material, surface);
    if (c.intensity) {
      const double fall = c.platform == Platform::air ? 1 : kFullIntensity / std::max(echo.range, kFullIntensity / 4);
      point.intensity = static_cast<std::uint16_t>(
          std::min(65535.0, 65535 * reflectance(echo.label.material) * std::max(0.02, echo.cosine) * fall * fall));
    }
    point.source = pulse.source;
    point.scan_angle_deg = pulse.angle_deg;
    point.gps_time = pulse.gps_time;
    return point;
  }

  // Classes are wrong in clumps of about a metre and, half as often, point by point.
  std::uint8_t wrong_class(std::uint8_t right, Vec3 place, Rng& rng) const {
    constexpr std::array<std::uint8_t, 5> kClasses{1, 2, 5, 6, 3};
    const double clump = 0.5 + 0.5 * value_noise(0.8 * place, scan_.seed + 9);
    // The noise is in the middle more often than at the ends: below 0.2 for about one in twenty.
    const bool in_clump = clump < 4 * scan_.scanner.wrong_classes && clump < 0.3;
    const bool alone = rng.uniform() < scan_.scanner.wrong_classes / 2;
    if (!in_clump && !alone) return right;
    return kClasses[in_clump ? static_cast<std::size_t>(1e6 * clump) % kClasses.size() : rng.below(kClasses.size())];
  }

  const WildStreetScan& scan_;
  RecordLayout layout_;
};

Vec3 anchor_of(const WildStreetScan& scan) {
  return {scan.street.length / 2, 0, scan.street.profile_height(scan.street.length / 2)};
}

}  // namespace

const std::array<std::string_view, 1> kWildStreetGroups{"street"};

std::span<const SceneOption> wild_street_options() {
  return drawn_options(kWildStreetGroups);
}

WildStreetScan plan_wild_street_scan(Draws& draws, std::uint64_t seed, std::uint64_t points) {
  WildStreetScan scan;
  scan.seed = seed;
  WildStreetScanner& c = scan.scanner;
  c.platform = platform_of(draws.choice("street.platform"));
  draw_scanner(c, draws);
  scan.street = plan_wild_street(draws, c.platform, length_for(c.platform, c.density, points));
  c.lane = -std::min(1.7, 0.4 * scan.street.half_road);
  const bool air = c.platform == Platform::air;
  c.s0 = air ? 0 : -kKeptBeyond;
  c.s1 = scan.street.length + (air ? 0 : kKeptBeyond);
  c.half_width = air ? std::min(kAirArea / 2, scan.street.half_street() + kPlotEnd - kBorder) : c.beam.range;
  scan.objects = place_wild_objects(scan.street, draws, c.lane);
  scan.model = build_wild_street(scan.street, scan.objects, draws);
  if (c.platform == Platform::tripod) place_stations(scan, draws);
  return scan;
}

std::vector<WildMotion> motions_of(const WildStreetScan& scan) {
  const WildStreetScanner& c = scan.scanner;
  const std::size_t visits = c.platform == Platform::vehicle  ? static_cast<std::size_t>(c.passes)
                             : c.platform == Platform::tripod ? c.stations.size()
                                                              : 9;
  std::vector<WildMotion> motions;
  for (const WildMoving& moving : scan.model.moving) {
    const WildObject& object = scan.objects[moving.object - 1];
    WildMotion motion{object.velocity,
                      object.seen_at_s / c.speed,
                      visits > 1 && (object.comes_and_goes || c.platform == Platform::vehicle),
                      c.platform == Platform::air,
                      mix64(scan.seed ^ 0x6d6f7665ull) + object.id,
                      0};
    if (c.platform == Platform::tripod) motion.sweep = c.sweep;
    motions.push_back(motion);
  }
  return motions;
}

void fit_wild_points(WildStreetScan& scan, std::uint64_t points, bool exactly) {
  WildStreetScan& changed = scan;
  const double wanted = static_cast<double>(points), full = changed.scanner.density;
  // A sparse scan first, whose density depends on the street alone.
  const double area = scan.street.length * (scan.scanner.platform == Platform::air ? kAirArea : kSeenPerMetre);
  changed.scanner.density = kPilotPoints / area;
  std::uint64_t bytes = 0;
  scan_wild_street(changed, [&](std::span<const std::byte> records) { bytes += records.size(); });
  const double counted = static_cast<double>(bytes / coloured_layout(kUnit).record_length);
  if (counted == 0) throw Error("the scanner sees nothing of this street");
  const double fitting = changed.scanner.density * wanted / counted;
  changed.scanner.density = exactly ? fitting : std::min(full, fitting);
}

void scan_wild_street(const WildStreetScan& scan, const std::function<void(std::span<const std::byte>)>& take) {
  const WildOptics optics(scan.model, scan.scanner.beam, motions_of(scan), anchor_of(scan), scan.seed);
  const StreetPulses pulses(scan);
  const Recorder recorder(scan);
  for (std::size_t first = 0; first < pulses.grains(); first += kGrainsAtOnce) {
    if (stop_requested()) throw Error("interrupted: nothing was written", ExitCode::interrupted);
    std::vector<std::vector<std::byte>> batch(std::min(kGrainsAtOnce, pulses.grains() - first));
    parallel_for(batch.size(), [&](std::size_t i) {
      WildTracer tracer(optics);
      std::vector<WildEcho> echoes;
      pulses.visit(first + i, [&](StreetPulse& pulse) {
        tracer.trace(pulse, echoes);
        recorder.add(pulse, echoes, batch[i]);
      });
    });
    for (const auto& records : batch) take(records);
  }
}

std::vector<double> hidden_shares(const WildStreetScan& scan) {
  const WildOptics optics(scan.model, scan.scanner.beam, motions_of(scan), anchor_of(scan), scan.seed);
  const WildStreetScanner& c = scan.scanner;
  std::vector<double> shares(scan.objects.size(), std::numeric_limits<double>::quiet_NaN());
  parallel_for(scan.objects.size(), [&](std::size_t i) {
    const WildObject& object = scan.objects[i];
    if (object.moves()) return;
    WildTracer tracer(optics);
    const Vec3 base = object.pose.base, middle = object.pose.place(0.5 * (object.box.min + object.box.max));
    std::vector<Vec3> from;
    if (c.platform == Platform::tripod) from = c.stations;
    if (c.platform == Platform::vehicle)
      for (const double ds : {-8.0, -3.0, 0.0, 3.0, 8.0}) {
        const double s = std::clamp(base.x + ds, 0.0, scan.street.length);
        from.push_back({s, c.lane, scan.street.profile_height(s) + c.height});
      }
    if (c.platform == Platform::air)
      for (const double dt : {-0.3, -0.1, 0.1, 0.3}) from.push_back(middle + c.flight.height * Vec3{0.03, dt, 1});
    // Rays towards places in the object's box: those that would meet it alone, and those of them that something else
    // meets before.
    std::vector<Part> own;
    for (const Solid& local : object.shape.solids) own.push_back(placed(local, object.pose));
    std::uint64_t alone = 0, seen = 0;
    Rng rng(mix64(scan.seed ^ 0x68696465ull), object.id);
    for (const Vec3& eye : from)
      for (int k = 0; k < 60; ++k) {
        const Vec3 local{between(rng, object.box.min.x, object.box.max.x),
                         between(rng, object.box.min.y, object.box.max.y),
                         between(rng, object.box.min.z, object.box.max.z)};
        const Vec3 way = object.pose.place(local) - eye;
        const double length = norm(way);
        if (length > c.beam.range || length < 0.1) continue;
        const Ray ray{eye, (1 / length) * way};
        const bool meets =
            std::any_of(own.begin(), own.end(), [&](const Part& part) { return meet(ray, part, 0).has_value(); }) ||
            std::any_of(object.shape.leaves.begin(), object.shape.leaves.end(), [&](const Crown& leaf) {
              const auto chord = cross(ray, Crown{object.pose.place(leaf.centre), leaf.radii});
              return chord && chord->leave > 0;
            });
        if (!meets) continue;
        ++alone;
        seen += tracer.element_met(ray, 0, 1) == object.id;
      }
    if (alone > 0) shares[i] = 1 - static_cast<double>(seen) / static_cast<double>(alone);
  });
  return shares;
}

}  // namespace ilot::scan
