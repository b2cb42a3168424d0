// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <map>
#include <memory>

#include "engine/error.h"
#include "engine/formats/writer.h"
#include "scan/scanners/echo_point.h"
#include "scan/scanners/scan_record.h"
#include "scan/streets/object_classes.h"
#include "scan/streets/street_flight.h"
#include "scan/streets/street_scan.h"
#include "scan/truth_writer.h"
#include "scan/unit.h"

namespace ilot::scan {
namespace {

constexpr double kTrajectoryStep = 10;  // metres

std::string settings_text(const StreetScan& scan) {
  const StreetParams& s = scan.street;
  const MobileParams& d = scan.drive;
  return fmt::format(
      R"("scene":"street","seed":{},"blocks":{},"slope_percent":{},"touching":{},"trees_per_block":{},)"
      R"("profiles_per_m":{},"step_deg":{},"turned_deg":{},"lane_m":{},"height_m":{},"blind_deg":{},"range_m":{},"grid_m":{})",
      s.seed, s.blocks, s.slope_percent, s.touching, s.trees, d.profiles, d.step_deg, d.turned_deg, d.lane, d.height,
      d.blind_deg, d.range, kUnit);
}

std::string settings_text(const StreetFlight& flight) {
  const StreetParams& s = flight.street;
  return fmt::format(
      R"("scene":"street-air","seed":{},"blocks":{},"slope_percent":{},"touching":{},"trees_per_block":{},)"
      R"("density":{},"height_m":{},"scan_angle_deg":{},"gardens":{},"mirrored":{},"grid_m":{})",
      s.seed, s.blocks, s.slope_percent, s.touching, s.trees, flight.flight.density, flight.flight.height,
      flight.flight.angle_deg, flight.gardens, flight.mirrored, kUnit);
}

Vec3 direction_to_scene(Vec3 v) {
  return street_to_scene(v) - street_to_scene({0, 0, 0});
}

TruePlane in_scene(TruePlane plane, std::uint64_t points) {
  for (TruePolygon& polygon : plane.polygons) {
    for (Vec3& p : polygon.ring) p = street_to_scene(p);
    for (auto& hole : polygon.holes)
      for (Vec3& p : hole) p = street_to_scene(p);
  }
  plane.plane.n = direction_to_scene(plane.plane.n);
  plane.plane.d = -dot(plane.plane.n, plane.polygons[0].ring[0]);
  plane.points = points;
  return plane;
}

TrueObject in_scene(const StreetObject& object, std::uint64_t points) {
  TrueObject truth;
  truth.id = object.id;
  truth.object_class = label_name(object_class_of(object.variant));
  truth.group = name_of(object.artefact_class);
  truth.variant = object.variant;
  truth.base = street_to_scene(object.pose.base);
  const double up = (object.box.min.z + object.box.max.z) / 2;
  truth.box_centre = street_to_scene({object.plan.x, object.plan.y, object.pose.base.z + up});
  truth.box_size = object.box.max - object.box.min;
  truth.heading_deg = object.heading_deg + kStreetHeadingDeg;
  truth.touches = object.touches;
  truth.points = points;
  return truth;
}

void write_blocks(TruthWriter& truth, const Street& street) {
  for (const StreetBlock& block : street.blocks)
    for (int side : {1, -1}) {
      const auto end = [&](double s) {
        return street_to_scene({s, side * kHalfStreet, street.ground_height(s, side * kHalfStreet)});
      };
      truth.add(TrueBlock{block.id, side > 0 ? "left" : "right", end(block.from), end(block.to)});
    }
}

void write_trajectory(TruthWriter& truth, const StreetScan& scan, const Street& street) {
  std::uint32_t id = 0;
  for (double s = 0; s <= street.length; s += kTrajectoryStep)
    truth.add(TrueStation{++id, street_to_scene({s, scan.drive.lane, street.road_height(s) + scan.drive.height}),
                          scan.drive.step_deg, scan.drive.step_deg});
}

std::map<int, std::string> material_names(const StreetModel& model) {
  std::map<int, std::string> names{{1 + static_cast<int>(Material::foliage), name_of(Material::foliage)}};
  for (const SurfaceLabel& label : model.scene.surfaces)
    names.emplace(1 + static_cast<int>(label.material), name_of(label.material));
  return names;
}

// The part of the output of a street that does not depend on the scanner.
class StreetFile {
 public:
  StreetFile(const ScanRequest& request, const std::string& settings, double noise, const StreetStage& stage)
      : request_(request),
        stage_(stage),
        writer_(create_cloud(request.output, cloud_spec(layout_))),
        truth_(truth_path(request.output), settings),
        tally_{std::vector<std::uint64_t>(stage.model.planes.size() + 1),
               std::vector<std::uint64_t>(stage.objects.size() + 1)} {
    truth_.noise({noise});
    truth_.classes(street_class_names());
    truth_.materials(material_names(stage.model));
  }

  TruthWriter& truth() { return truth_; }

  void take(std::span<const std::byte> records) {
    writer_->write(records);
    tally_.add(records, layout_);
    request_.written(records.size() / layout_.record_length);
  }

  // Adds planes, objects and blocks. The scanner adds its own truth afterwards.
  void add_street() {
    for (const TruePlane& plane : stage_.model.planes) truth_.add(in_scene(plane, tally_.planes[plane.id]));
    for (const StreetObject& object : stage_.objects) truth_.add(in_scene(object, tally_.elements[object.id]));
    write_blocks(truth_, stage_.street);
  }

  ScanCounts finish() {
    std::array<std::uint64_t, 4> of_class{};
    for (const StreetObject& object : stage_.objects) ++of_class[static_cast<std::size_t>(object.artefact_class)];
    ScanCounts counts{
        {"points", tally_.points}, {"planes", stage_.model.planes.size()}, {"objects", stage_.objects.size()}};
    const std::array<const char*, 4> names{"cars", "lampposts", "pedestrians", "others"};
    for (std::size_t c = 0; c < 4; ++c) counts.push_back({names[c], of_class[c]});
    counts.push_back({"blocks", stage_.street.blocks.size()});
    counts.push_back({"gaps", stage_.street.blocks.size() - 1});
    writer_->finish();
    truth_.finish(counts);
    return counts;
  }

 private:
  const ScanRequest& request_;
  const StreetStage& stage_;
  RecordLayout layout_ = coloured_layout(kUnit);
  std::unique_ptr<PointWriter> writer_;
  TruthWriter truth_;
  PointTally tally_;
};

}  // namespace

ScanCounts scan_street_scene(const ScanRequest& request) {
  StreetScan scan = plan_street_scan(request.values, request.seed);
  const StreetStage stage = set_stage(scan);
  if (request.points) fit_points(scan, stage, *request.points);
  StreetFile file(request, settings_text(scan), scan.drive.noise, stage);
  scan_street(scan, stage, [&](std::span<const std::byte> records) { file.take(records); });
  file.add_street();
  write_trajectory(file.truth(), scan, stage.street);
  return file.finish();
}

ScanCounts scan_street_flight_scene(const ScanRequest& request) {
  if (request.points && request.values.is_set("scene.density"))
    throw Error("--points and scene.density contradict each other; leave out one", ExitCode::usage);
  StreetFlight flight = plan_street_flight(request.values, request.seed);
  const StreetStage stage = set_stage(flight);
  if (request.points) fit_points(flight, stage, *request.points);
  StreetFile file(request, settings_text(flight), flight.noise, stage);
  scan_street_flight(flight, stage, [&](std::span<const std::byte> records) { file.take(records); });
  file.add_street();
  return file.finish();
}

}  // namespace ilot::scan
