// SPDX-License-Identifier: Apache-2.0
// The pulses of a vehicle, of tripods and of an aircraft over `street-wild`.
#include <algorithm>
#include <cmath>

#include "scan/optics/value_noise.h"
#include "scan/wild/street/wild_street_scan.h"

namespace ilot::scan {
namespace {

constexpr double kDegrees = 180 / 3.14159265358979323846;
constexpr double kAt = 8;  // metres, the distance for which the density of a scanner on the ground holds
constexpr double kTurnsAtOnce = 8, kColumnsAtOnce = 16;
constexpr double kLow = -62, kHigh = 86;  // degrees of elevation of a tripod
constexpr double kTile = 20;              // metres
constexpr double kRunUp = 4;              // metres that a vehicle drives beyond both ends

// Returns two directions across another one.
void set_across(StreetPulse& pulse) {
  const Vec3 d = pulse.ray.direction;
  const Vec3 helper = std::abs(d.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 right = cross(d, helper);
  pulse.right = (1 / norm(right)) * right;
  pulse.up = cross(pulse.right, d);
}

// Returns the plane of ground at which pulses from the air are aimed.
Ground ground_of(const WildStreet& street) {
  const double middle = street.length / 2;
  const double slope = (street.profile_height(street.length) - street.profile_height(0)) / street.length;
  const Vec3 centre = street.to_scene({middle, 0, street.profile_height(middle)});
  const SinCos h = sin_cos_deg(street.heading_deg);
  const double x = slope * h.cos, y = slope * h.sin;
  return {centre.z - x * centre.x - y * centre.y, x, y};
}

std::vector<Rect> tiles_of(const WildStreetScan& scan) {
  double x0 = 1e9, y0 = 1e9, x1 = -1e9, y1 = -1e9;
  const WildStreetScanner& scanner = scan.scanner;
  for (const double s : {scanner.s0, scanner.s1})
    for (const double t : {-scanner.half_width, scanner.half_width}) {
      const Vec3 p = scan.street.to_scene({s, t, 0});
      x0 = std::min(x0, p.x), y0 = std::min(y0, p.y), x1 = std::max(x1, p.x), y1 = std::max(y1, p.y);
    }
  std::vector<Rect> tiles;
  for (double y = std::floor(y0 / kTile) * kTile; y < y1; y += kTile)
    for (double x = std::floor(x0 / kTile) * kTile; x < x1; x += kTile) {
      const Vec3 p = scan.street.to_street({x + kTile / 2, y + kTile / 2, 0});
      if (p.x > scanner.s0 - kTile && p.x < scanner.s1 + kTile && std::abs(p.y) < scanner.half_width + kTile)
        tiles.push_back({x, y, x + kTile, y + kTile});
    }
  return tiles;
}

}  // namespace

struct StreetPulses::State {
  const WildStreetScan& scan;
  // vehicle
  double profiles = 10, step_deg = 0.4;
  std::uint64_t turns = 0, grains_of_head = 0;
  // tripod
  double station_step_deg = 0.1;
  std::uint64_t columns = 0, grains_of_station = 0;
  // air
  std::vector<Rect> tiles;
  std::optional<FlightPlan> flight;

  explicit State(const WildStreetScan& s) : scan(s) {
    const WildStreetScanner& scanner = scan.scanner;
    const double lines = scanner.platform == Platform::vehicle ? scanner.heads * scanner.passes
                                                               : static_cast<double>(scanner.stations.size());
    const double own = scanner.density / std::max(1.0, lines);
    profiles = std::sqrt(own * scanner.shape);
    step_deg = kDegrees * profiles / (own * kAt);
    turns = static_cast<std::uint64_t>((scan.street.length + 2 * kRunUp) * profiles) + 1;
    grains_of_head = static_cast<std::uint64_t>(std::ceil(static_cast<double>(turns) / kTurnsAtOnce));
    station_step_deg = kDegrees / (kAt * std::sqrt(own));
    columns = static_cast<std::uint64_t>(360 / station_step_deg);
    grains_of_station = static_cast<std::uint64_t>(std::ceil(static_cast<double>(columns) / kColumnsAtOnce));
    if (scanner.platform != Platform::air) return;
    tiles = tiles_of(scan);
    AirborneParams params = scanner.flight;
    params.density = scanner.density;
    flight.emplace(params, ground_of(scan.street), scan.seed);
  }

  Vec3 drive_error(int pass, double s) const {
    const std::uint64_t key = scan.seed + 77 * static_cast<std::uint64_t>(pass);
    Rng rng(key ^ 0x70617373ull);
    const double x = gaussian(rng), y = gaussian(rng), z = gaussian(rng);
    const Vec3 at{s / 15, 0.5, 0.5};
    const Vec3 wander{value_noise(at, key + 1), value_noise(at, key + 2), value_noise(at, key + 3)};
    return scan.scanner.pass_shift * Vec3{x, y, z} + scan.scanner.wander * wander;
  }

  // One turn of one head; the second pass drives on the other lane.
  void visit_turn(int pass, int head, std::uint64_t turn, const std::function<void(StreetPulse&)>& visit) const {
    const WildStreetScanner& c = scan.scanner;
    const SinCos turned = sin_cos_deg((head == 0 ? 1 : -1) * c.turned_deg);
    const double lane = pass == 0 ? c.lane : -c.lane;
    const auto steps = static_cast<std::int64_t>((180 - c.blind_deg / 2) / step_deg);
    for (std::int64_t step = -steps; step <= steps; ++step) {
      const double angle_deg = static_cast<double>(step) * step_deg;
      const double at = static_cast<double>(turn) + angle_deg / 360 + 0.5 + 0.5 * head;
      const double s = at / profiles - kRunUp;
      const SinCos angle = sin_cos_deg(angle_deg);
      StreetPulse pulse;
      pulse.ray = {{s, lane, scan.street.profile_height(s) - scan.street.camber * std::abs(lane) + c.height},
                   {angle.sin * turned.sin, angle.sin * turned.cos, angle.cos}};
      set_across(pulse);
      pulse.time = s / c.speed;
      pulse.gps_time = 100000 + 500.0 * pass + (pass == 0 ? pulse.time : scan.street.length / c.speed - pulse.time);
      pulse.visit = static_cast<std::uint16_t>(1 + pass);
      pulse.source = static_cast<std::uint16_t>(1 + 2 * pass + head);
      pulse.angle_deg = angle_deg;
      pulse.shift = drive_error(pass, s);
      pulse.rng = Rng(mix64(scan.seed ^ 0x64726976ull) + pulse.source,
                      (turn << 24) ^ static_cast<std::uint64_t>(step + (std::int64_t{1} << 22)));
      visit(pulse);
    }
  }

  void visit_column(std::size_t station, std::uint64_t column, const std::function<void(StreetPulse&)>& visit) const {
    const double share = static_cast<double>(column) / static_cast<double>(columns);
    const SinCos azimuth = sin_cos_deg(360 * share - 180);
    Rng error(mix64(scan.seed ^ 0x73746174ull), station);
    const double x = gaussian(error), y = gaussian(error), z = gaussian(error);
    const auto rows = static_cast<std::uint64_t>((kHigh - kLow) / station_step_deg);
    for (std::uint64_t row = 0; row < rows; ++row) {
      const double angle_deg = kLow + static_cast<double>(row) * station_step_deg;
      const SinCos up = sin_cos_deg(angle_deg);
      StreetPulse pulse;
      pulse.ray = {scan.scanner.stations[station], {up.cos * azimuth.cos, up.cos * azimuth.sin, up.sin}};
      set_across(pulse);
      pulse.time = scan.scanner.sweep * share;
      pulse.gps_time = 100000 + 1000.0 * static_cast<double>(station) + pulse.time;
      pulse.visit = pulse.source = static_cast<std::uint16_t>(1 + station);
      pulse.shift = scan.scanner.pass_shift * Vec3{x, y, z};
      pulse.rng = Rng(mix64(scan.seed ^ 0x746c73ull) + station, (column << 24) ^ row);
      visit(pulse);
    }
  }

  void visit_tile(const Rect& tile, const std::function<void(StreetPulse&)>& visit) const {
    flight->for_each_pulse(tile, [&](const Pulse& from) {
      StreetPulse pulse;
      pulse.ray = {scan.street.to_street(from.ray.origin), scan.street.turned_to_street(from.ray.direction)};
      set_across(pulse);
      pulse.time = pulse.gps_time = from.gps_time;
      pulse.visit = pulse.source = from.line;
      pulse.angle_deg = from.scan_angle_deg;
      Rng error(mix64(scan.seed ^ 0x737472ull), from.line);
      const double x = gaussian(error), y = gaussian(error), z = gaussian(error);
      pulse.shift = scan.scanner.pass_shift * Vec3{2 * x, 2 * y, z};
      pulse.rng = from.rng;
      visit(pulse);
    });
  }
};

StreetPulses::StreetPulses(const WildStreetScan& scan) : state_(std::make_unique<State>(scan)) {}
StreetPulses::~StreetPulses() = default;

std::size_t StreetPulses::grains() const {
  const WildStreetScanner& c = state_->scan.scanner;
  if (c.platform == Platform::air) return state_->tiles.size();
  if (c.platform == Platform::tripod) return c.stations.size() * state_->grains_of_station;
  return static_cast<std::size_t>(c.heads * c.passes) * state_->grains_of_head;
}

void StreetPulses::visit(std::size_t grain, const std::function<void(StreetPulse&)>& visit) const {
  const WildStreetScanner& c = state_->scan.scanner;
  if (c.platform == Platform::air) {
    state_->visit_tile(state_->tiles[grain], visit);
  } else if (c.platform == Platform::tripod) {
    const std::uint64_t first = grain % state_->grains_of_station * static_cast<std::uint64_t>(kColumnsAtOnce);
    for (std::uint64_t i = first; i < std::min(state_->columns, first + static_cast<std::uint64_t>(kColumnsAtOnce));
         ++i)
      state_->visit_column(grain / state_->grains_of_station, i, visit);
  } else {
    const std::size_t line = grain / state_->grains_of_head;
    const std::uint64_t first = grain % state_->grains_of_head * static_cast<std::uint64_t>(kTurnsAtOnce);
    const int pass = static_cast<int>(line) / c.heads, head = static_cast<int>(line) % c.heads;
    for (std::uint64_t i = first; i < std::min(state_->turns, first + static_cast<std::uint64_t>(kTurnsAtOnce)); ++i)
      state_->visit_turn(pass, head, i, visit);
  }
}

}  // namespace ilot::scan
