// SPDX-License-Identifier: Apache-2.0
#include "scan/streets/street_scan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/error.h"
#include "engine/pass/stop.h"
#include "kernels/core/parallel.h"
#include "scan/unit.h"

namespace ilot::scan {
namespace {

constexpr std::array<SceneOption, 12> kStreet{{
    {"scene.blocks", 30, "blocks", 1, 50, "along the street, each with houses on both sides; objects go with them"},
    {"scene.profiles", 10, "per m", 0.2, 200, "turns of each of the two heads per metre; --points chooses it"},
    {"scene.step", 0.4, "deg", 0.005, 5, "between the pulses of a turn; --points chooses it"},
    {"scene.noise", 0.008, "m", 0, 0.5, "standard deviation of the range"},
    {"scene.turned", 40, "deg", 0, 70, "of the scanning planes from straight across, one head to each side"},
    {"scene.lane", -1.6, "m", -4, 4, "of the vehicle, to the left of the street's axis"},
    {"scene.height", 2.6, "m", 1.5, 5, "of the heads above the road"},
    {"scene.blind", 20, "deg", 0, 120, "of a turn, downwards, where the vehicle hides the road"},
    {"scene.range", 50, "m", 10, 300, "farthest echo"},
    {"scene.slope", 2, "%", 0, 20, "rise of the street"},
    {"scene.touching", 0.15, "share", 0, 0.5, "objects that touch another"},
    {"scene.trees", 1.5, "per block", 0, 4, "trees"},
}};

constexpr std::uint64_t kStretch = 8;    // turns that are scanned together
constexpr std::size_t kStretches = 64;   // per batch
constexpr double kFullIntensity = 14.0;  // metres; half of the light fills half of the scale there

struct Rays {
  PartScene parts;
  RayScene crowns;
};

Rays make_rays(const StreetStage& stage) {
  const double middle = stage.street.length / 2;
  return {PartScene(stage.model.scene.parts),
          RayScene({}, stage.model.crowns, {middle, 0, stage.street.road_height(middle)})};
}

ColouredPoint point_of(const MobileEcho& echo) {
  ColouredPoint point = labelled_point(echo.label, echo.surface_place);
  point.place = street_to_scene(echo.place);
  const double fall = kFullIntensity / std::max(echo.range, kFullIntensity / 4);
  point.intensity = static_cast<std::uint16_t>(
      std::min(65535.0, 65535 * reflectance(echo.label.material) * std::max(0.02, echo.cosine) * fall * fall));
  point.source = echo.head;
  point.scan_angle_deg = echo.angle_deg;
  point.gps_time = 100000 + echo.time;
  return point;
}

MobileScene mobile_scene(const StreetStage& stage, const Rays& rays) {
  const SurfaceLabel leaves{static_cast<std::uint8_t>(StreetClass::vegetation), 0, 0, Material::foliage};
  return {stage.model.scene, rays.parts, rays.crowns, leaves, stage.street.base, stage.street.slope};
}

// Counts the echoes of every n-th turn.
std::uint64_t count_echoes(const MobileParams& drive, const StreetStage& stage, std::uint64_t every) {
  const Rays rays = make_rays(stage);
  const MobileScene scene = mobile_scene(stage, rays);
  const std::uint64_t turns = profile_count(drive) / every;
  std::vector<std::uint64_t> counts(turns);
  const MobileScanner ready(drive, scene);
  parallel_for(turns, [&](std::size_t i) {
    MobileScanner scanner = ready;
    for (int head : {1, 2}) scanner.scan(i * every, head, [&](const MobileEcho&) { ++counts[i]; });
  });
  std::uint64_t total = 0;
  for (std::uint64_t count : counts) total += count;
  return total;
}

}  // namespace

std::span<const SceneOption> street_options() {
  return kStreet;
}

StreetScan plan_street_scan(const SceneValues& values, std::uint64_t seed) {
  StreetScan scan;
  scan.street.blocks = static_cast<std::uint64_t>(values.get("scene.blocks"));
  scan.street.slope_percent = values.get("scene.slope");
  scan.street.touching = values.get("scene.touching");
  scan.street.trees = values.get("scene.trees");
  scan.street.scanner = {values.get("scene.lane"), values.get("scene.height"), values.get("scene.turned")};
  scan.street.seed = seed;
  scan.drive.profiles = values.get("scene.profiles");
  scan.drive.step_deg = values.get("scene.step");
  scan.drive.noise = values.get("scene.noise");
  scan.drive.turned_deg = values.get("scene.turned");
  scan.drive.lane = values.get("scene.lane");
  scan.drive.height = values.get("scene.height");
  scan.drive.blind_deg = values.get("scene.blind");
  scan.drive.range = values.get("scene.range");
  scan.drive.seed = seed;
  return scan;
}

ColouredPoint labelled_point(const SurfaceLabel& label, Vec3 surface_place) {
  ColouredPoint point;
  point.classification = las_class(static_cast<StreetClass>(label.true_class));
  point.material = static_cast<std::uint8_t>(1 + static_cast<std::uint8_t>(label.material));
  point.rgb = colour(label.material, surface_place);
  point.true_class = label.true_class;
  point.true_plane = label.plane;
  point.true_element = label.element;
  return point;
}

StreetStage set_stage(const StreetParams& street) {
  StreetStage stage;
  stage.street = plan_street(street);
  stage.objects = place_objects(stage.street);
  stage.model = build_street_model(stage.street, stage.objects);
  return stage;
}

StreetStage set_stage(StreetScan& scan) {
  StreetStage stage = set_stage(scan.street);
  scan.drive.from = 0;
  scan.drive.to = stage.street.length;
  return stage;
}

void fit_points(StreetScan& scan, const StreetStage& stage, std::uint64_t points) {
  // A sparse drive with its own spacing, independent of the request: a turn every 2.5 m, a pulse every degree.
  MobileParams sparse = scan.drive;
  sparse.profiles = 0.4;
  sparse.step_deg = 1;
  const double scale = std::sqrt(static_cast<double>(points) / static_cast<double>(count_echoes(sparse, stage, 1)));
  // The proportion of profiles to pulses does not change.
  const double shape = std::sqrt(scan.drive.profiles * scan.drive.step_deg / (sparse.profiles * sparse.step_deg));
  scan.drive.profiles = sparse.profiles * scale * shape;
  scan.drive.step_deg = sparse.step_deg / scale * shape;
}

void scan_street(const StreetScan& scan, const StreetStage& stage,
                 const std::function<void(std::span<const std::byte>)>& take) {
  const Rays rays = make_rays(stage);
  const MobileScene scene = mobile_scene(stage, rays);
  const RecordLayout layout = coloured_layout(kUnit);
  const std::uint64_t turns = profile_count(scan.drive), stretches = (turns + kStretch - 1) / kStretch;
  // A batch contains a bounded number of pulses, so it has few turns if they are long.
  const MobileScanner ready(scan.drive, scene);
  const std::uint64_t pulses = 2 * kStretch * ready.pulses_per_turn();
  const std::uint64_t at_once = std::clamp<std::uint64_t>(2'000'000 / pulses, 1, kStretches);
  for (std::uint64_t first = 0; first < stretches; first += at_once) {
    if (stop_requested()) throw Error("interrupted: nothing was written", ExitCode::interrupted);
    std::vector<std::vector<std::byte>> batch(std::min(at_once, stretches - first));
    parallel_for(batch.size(), [&](std::size_t i) {
      MobileScanner scanner = ready;
      const std::uint64_t from = (first + i) * kStretch, to = std::min(turns, from + kStretch);
      for (std::uint64_t turn = from; turn < to; ++turn)
        for (int head : {1, 2})
          scanner.scan(turn, head, [&](const MobileEcho& echo) { append_record(batch[i], point_of(echo), layout); });
    });
    for (const auto& records : batch) take(records);
  }
}

}  // namespace ilot::scan
