// SPDX-License-Identifier: Apache-2.0
// The options of a scan of a model, and where its scanners are.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/error.h"
#include "engine/run/inputs/read_stations.h"
#include "scan/models/model_scan.h"

namespace ilot::scan {
namespace {

constexpr auto kOptions = with_beam_options(std::array<SceneOption, 23>{{
    {"scene.step", 0.04, "deg", 0.001, 1, "angular step of stations, horizontal and vertical; --points scales it"},
    {"scene.distance", 0, "m", 0, 200, "of automatic stations and paths from the building; 0 = by its height, 5 to 20"},
    {"scene.station_height", 1.8, "m", 0.2, 30, "of automatic stations above the ground"},
    {"scene.vehicle_height", 2.6, "m", 0.5, 10, "of the heads on an automatic path above the ground"},
    {"scene.vehicle_noise", 0.008, "m", 0, 0.5, "standard deviation of the range of a vehicle's heads"},
    {"scene.profiles", 40, "per m", 0.2, 400, "turns of each head of a vehicle per metre; --points scales it"},
    {"scene.vehicle_step", 0.25, "deg", 0.005, 5, "between the pulses of a turn; --points scales it"},
    {"scene.turned", 40, "deg", 0, 70, "of a vehicle's scanning planes from straight across, one head to each side"},
    {"scene.blind", 20, "deg", 0, 120, "of a turn, downwards, where the vehicle hides the road"},
    {"scene.density", 20, "pulses/m2", 0.1, 1000, "of a flight, all its lines together; --points scales it"},
    {"scene.flying_height", 500, "m", 50, 5000, "above the ground"},
    {"scene.scan_angle", 20, "deg", 5, 30, "largest scan angle of a flight to either side"},
    {"scene.flight_noise", 0.02, "m", 0, 1, "standard deviation of the range of a flight"},
    {"scene.flight_divergence", 0.3, "mrad", 0, 5, "full angle of the beam of a flight"},
    {"scene.range", 120, "m", 10, 300, "farthest echo of stations and vehicles"},
    {"scene.ground", 20, "m", 0, 500, "of flat ground around the model, at its lowest point; 0 = none"},
    {"scene.glass_nothing", 0.66, "share", 0, 1, "of the pulses on panes that give no echo"},
    {"scene.glass_through", 0.13, "share", 0, 1, "of the pulses on panes that go on to what is behind"},
    {"scene.glass_mirrored", 0, "share", 0, 1, "of the pulses on panes that give a mirror image behind the pane"},
    {"scene.room", 4, "m", 0, 50, "mean depth of the rooms behind panes; 0 = pulses go on to the model's other walls"},
    {"scene.intensity_noise", 0.15, "share", 0, 1, "standard deviation of the intensity of each echo"},
    {"scene.closures", 0, "0 or 1", 0, 1, "1 = closure surfaces of CityJSON are walls, 0 = nothing is built there"},
    {"scene.grid", 0.0001, "m", 0.00001, 0.01, "step of the coordinates"},
}});

constexpr double kStationRange = 8, kVehicleRange = 14;  // metres where a white surface fills the scale of intensities
constexpr double kFlightSeparation = 1.5, kFlightDiameter = 0.01;  // metres: of the receiver and of the beam
constexpr double kVehicleDivergence = 0.5;                         // mrad
constexpr std::size_t kMostStations = 500;
constexpr double kFlightMargin = 5;  // metres beyond the model that are aimed at where there is no ground
constexpr std::uint16_t kVehicleSource = 30001, kFlightSource = 40001;

BeamParams beam_of(const SceneValues& values) {
  BeamParams beam{values.get("scene.noise"), values.get("scene.angle_noise"), values.get("scene.divergence"),
                  values.get("scene.diameter"), values.get("scene.separation")};
  beam.farthest = values.get("scene.range");
  beam.glass = {values.get("scene.glass_nothing"), values.get("scene.glass_through"),
                values.get("scene.glass_mirrored")};
  beam.room = values.get("scene.room");
  if (beam.glass.lost + beam.glass.through + beam.glass.mirrored > 1 + 1e-12)
    throw Error("--set scene.glass_nothing, glass_through and glass_mirrored: their sum is above 1", ExitCode::usage);
  return beam;
}

StationParams station_at(std::uint16_t id, Vec3 place, const ModelStage& stage, double step) {
  const Box3<Vec3> target = stage.box.grown(2);
  if (!target.contains({place.x, place.y, 0.5 * (target.min.z + target.max.z)}))
    return station_towards(id, place, target, step);
  StationParams all{id, place, {0, 1, 0}, step, step, {-180, 180 - step, -60, 88}};
  return all;
}

std::vector<Vec3> places_of(const std::filesystem::path& path, const ModelStage& stage) {
  std::vector<Vec3> places;
  for (const Station& s : read_stations(path)) places.push_back(s.position - stage.place.origin);
  if (places.empty()) throw Error(path.string() + ": contains no place", ExitCode::usage);
  const double reach = 2 * norm(stage.box.max - stage.box.min) + 1000;
  const Vec3 middle = 0.5 * (stage.box.min + stage.box.max);
  if (std::none_of(places.begin(), places.end(), [&](const Vec3& p) { return norm(p - middle) < reach; })) {
    const Vec3 at = places[0] + stage.place.origin, model = middle + stage.place.origin;
    throw Error(fmt::format("{}: ({:.1f}, {:.1f}) is far from the model at ({:.1f}, {:.1f}); both need the same "
                            "coordinate system, in metres",
                            path.string(), at.x, at.y, model.x, model.y),
                ExitCode::usage);
  }
  return places;
}

void place_stations(ModelScan& scan, const ModelScanners& scanners, const SceneValues& values) {
  const bool automatic = !scanners.stations || scanners.stations->empty();
  std::vector<Vec3> places;
  double distance = 0;
  if (automatic) {
    const auto placed =
        automatic_stations(scan.stage, {values.get("scene.distance"), values.get("scene.station_height")});
    for (const PlacedStation& p : placed) {
      places.push_back(p.position);
      distance = std::max(distance, p.distance);
    }
    if (places.empty())
      throw Error("scan: no place for a station around the model; give --stations FILE, --vehicle or --flight");
  } else {
    places = places_of(*scanners.stations, scan.stage);
  }
  if (places.size() > kMostStations)
    throw Error(fmt::format("scan: {} stations are more than {}; give fewer with --stations FILE, or take --vehicle or "
                            "--flight",
                            places.size(), kMostStations),
                ExitCode::usage);
  std::string where;
  for (const Vec3& place : places) {
    const auto id = static_cast<std::uint16_t>(scan.stations.size() + 1);
    scan.stations.push_back(station_at(id, place, scan.stage, values.get("scene.step")));
    const Vec3 world = place + scan.stage.place.origin;
    if (id <= 8)
      where += fmt::format("{} {} ({:.1f}, {:.1f}, {:.1f})", id > 1 ? "," : "", id, world.x, world.y, world.z);
  }
  if (places.size() > 8) where += " ...";
  if (automatic)
    scan.notes.push_back(
        fmt::format("{} stations placed, up to {:.1f} m {}:{}", places.size(), distance,
                    scan.stage.openings.empty() ? "around the buildings" : "before sides with openings", where));
}

void place_vehicle(ModelScan& scan, const std::filesystem::path& path, const SceneValues& values) {
  VehicleParams vehicle;
  if (path.empty()) {
    vehicle.path = automatic_path(scan.stage, {values.get("scene.distance"), values.get("scene.vehicle_height")});
    scan.notes.push_back(fmt::format("the vehicle drives {:.0f} m, once around the model", path_length(vehicle.path)));
  } else {
    for (const Vec3& place : places_of(path, scan.stage))
      if (vehicle.path.empty() || norm(place - vehicle.path.back()) > 1e-3) vehicle.path.push_back(place);
  }
  if (vehicle.path.size() < 2)
    throw Error(path.empty() ? "scan: no building to drive around; give --vehicle FILE"
                             : path.string() + ": a path needs two places or more",
                ExitCode::usage);
  vehicle.profiles = values.get("scene.profiles");
  vehicle.step_deg = values.get("scene.vehicle_step");
  vehicle.turned_deg = values.get("scene.turned");
  vehicle.blind_deg = values.get("scene.blind");
  vehicle.source = kVehicleSource;
  scan.vehicle = vehicle;
}

void place_flight(ModelScan& scan, const SceneValues& values) {
  FlightParams flight;
  flight.airborne = {values.get("scene.density"), values.get("scene.flying_height"), values.get("scene.scan_angle")};
  const double margin = std::max(kFlightMargin, values.get("scene.ground"));
  const Box3<Vec3>& box = scan.stage.box;
  flight.area = {box.min.x - margin, box.min.y - margin, box.max.x + margin, box.max.y + margin};
  flight.ground_z = scan.stage.ground_z;
  flight.source = kFlightSource;
  scan.flight = flight;
  scan.notes.push_back(
      fmt::format("flight lines run north and south, {:.0f} m above the ground", flight.airborne.height));
}

}  // namespace

std::span<const SceneOption> model_options() {
  return kOptions;
}

ModelScan plan_model_scan(const ModelInput& input, const ModelScanners& scanners, const SceneValues& values,
                          std::uint64_t seed) {
  ModelInput wanted = input;
  wanted.closures = values.get("scene.closures") > 0.5;
  ScannedModel model = read_scanned_model(wanted);
  ModelScan scan;
  scan.notes = model.notes;
  scan.stage = make_stage(std::move(model), values.get("scene.ground"));
  scan.seed = seed;
  scan.registration = values.get("scene.registration");
  scan.grid = values.get("scene.grid");
  scan.intensity_noise = values.get("scene.intensity_noise");
  scan.station_beam = {beam_of(values), kStationRange, {}};
  scan.vehicle_beam = {beam_of(values), kVehicleRange, {}};
  scan.vehicle_beam.beam.range_noise = values.get("scene.vehicle_noise");
  scan.vehicle_beam.beam.divergence_mrad = kVehicleDivergence;
  BeamParams flying = beam_of(values);
  flying.range_noise = values.get("scene.flight_noise");
  flying.divergence_mrad = values.get("scene.flight_divergence");
  flying.diameter = kFlightDiameter;
  flying.separation = kFlightSeparation;
  flying.farthest = 2 * values.get("scene.flying_height");
  scan.flight_beam = {flying, values.get("scene.flying_height"), {}};
  if (scanners.stations || (!scanners.vehicle && !scanners.flight)) place_stations(scan, scanners, values);
  if (scanners.vehicle) place_vehicle(scan, *scanners.vehicle, values);
  if (scanners.flight) place_flight(scan, values);
  return scan;
}

}  // namespace ilot::scan
