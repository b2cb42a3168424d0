// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <map>
#include <memory>

#include "engine/formats/writer.h"
#include "tools/scan/scan_record.h"
#include "tools/scan/street_scan.h"
#include "tools/scan/truth_writer.h"

namespace ilot::scan {
namespace {

constexpr double kGrid = 0.001;         // metres per coordinate unit of the cloud
constexpr double kTrajectoryStep = 10;  // metres

std::string settings_text(const StreetScan& scan) {
  const StreetParams& s = scan.street;
  const MobileParams& d = scan.drive;
  return fmt::format(
      R"("scene":"street","seed":{},"blocks":{},"slope_percent":{},"touching":{},"trees_per_block":{},)"
      R"("profiles_per_m":{},"step_deg":{},"turned_deg":{},"lane_m":{},"height_m":{},"blind_deg":{},"range_m":{},"grid_m":{})",
      s.seed, s.blocks, s.slope_percent, s.touching, s.trees, d.profiles, d.step_deg, d.turned_deg, d.lane, d.height,
      d.blind_deg, d.range, kGrid);
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
  truth.object_class = name_of(object.artefact_class);
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

std::map<int, std::string> class_names() {
  std::map<int, std::string> names;
  for (int value = 1; value <= static_cast<int>(StreetClass::roof); ++value)
    names[value] = name_of(static_cast<StreetClass>(value));
  return names;
}

std::map<int, std::string> material_names(const StreetModel& model) {
  std::map<int, std::string> names{{1 + static_cast<int>(Material::foliage), name_of(Material::foliage)}};
  for (const SurfaceLabel& label : model.scene.surfaces)
    names.emplace(1 + static_cast<int>(label.material), name_of(label.material));
  return names;
}

}  // namespace

ScanCounts scan_street_scene(const ScanRequest& request) {
  StreetScan scan = plan_street_scan(request.values, request.seed);
  const StreetStage stage = set_stage(scan);
  if (request.points) fit_points(scan, stage, *request.points);
  const RecordLayout layout = coloured_layout(kGrid);
  const std::unique_ptr<PointWriter> writer = create_cloud(request.output, cloud_spec(layout));
  TruthWriter truth(truth_path(request.output), settings_text(scan));
  truth.noise({scan.drive.noise});
  truth.classes(class_names());
  truth.materials(material_names(stage.model));

  std::vector<std::uint64_t> on_plane(stage.model.planes.size() + 1), on_object(stage.objects.size() + 1);
  std::uint64_t total = 0;
  scan_street(scan, stage, [&](std::span<const std::byte> records) {
    writer->write(records);
    for (std::size_t at = 0; at < records.size(); at += layout.record_length) {
      const RecordTruth t = truth_of(&records[at]);
      ++on_plane[t.true_plane];
      ++on_object[t.true_element];
    }
    total += records.size() / layout.record_length;
    request.written(records.size() / layout.record_length);
  });
  for (const TruePlane& plane : stage.model.planes) truth.add(in_scene(plane, on_plane[plane.id]));
  std::array<std::uint64_t, 4> of_class{};
  for (const StreetObject& object : stage.objects) {
    truth.add(in_scene(object, on_object[object.id]));
    ++of_class[static_cast<std::size_t>(object.artefact_class)];
  }
  write_blocks(truth, stage.street);
  write_trajectory(truth, scan, stage.street);
  ScanCounts counts{{"points", total}, {"planes", stage.model.planes.size()}, {"objects", stage.objects.size()}};
  const std::array<const char*, 4> names{"cars", "lampposts", "pedestrians", "others"};
  for (std::size_t c = 0; c < 4; ++c) counts.push_back({names[c], of_class[c]});
  counts.push_back({"blocks", stage.street.blocks.size()});
  counts.push_back({"gaps", stage.street.blocks.size() - 1});
  writer->finish();
  truth.finish(counts);
  return counts;
}

}  // namespace ilot::scan
