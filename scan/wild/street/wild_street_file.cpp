// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "engine/formats/writer.h"
#include "scan/scanners/echo_point.h"
#include "scan/scanners/scan_record.h"
#include "scan/streets/object_classes.h"
#include "scan/truth_writer.h"
#include "scan/unit.h"
#include "scan/wild/street/wild_pavements.h"
#include "scan/wild/street/wild_street_scan.h"

namespace ilot::scan {
namespace {

constexpr double kTrajectoryStep = 10;            // metres
constexpr std::uint64_t kMostPoints = 2'000'000;  // unless --points asks for another number

std::string settings_text(const ScanRequest& request, const WildStreetScan& scan) {
  return fmt::format(R"("scene":"street-wild","seed":{}{},"length_m":{},"density_used":{},"grid_m":{})", request.seed,
                     request.values.json(), scan.street.length, scan.scanner.density, kUnit);
}

Vec3 direction_to_scene(const WildStreet& street, Vec3 v) {
  return street.to_scene(v) - street.to_scene({0, 0, 0});
}

TruePlane in_scene(const WildStreet& street, TruePlane plane, std::uint64_t points) {
  for (TruePolygon& polygon : plane.polygons) {
    for (Vec3& p : polygon.ring) p = street.to_scene(p);
    for (auto& hole : polygon.holes)
      for (Vec3& p : hole) p = street.to_scene(p);
  }
  plane.plane.n = direction_to_scene(street, plane.plane.n);
  plane.plane.d = -dot(plane.plane.n, plane.polygons[0].ring[0]);
  plane.points = points;
  return plane;
}

std::vector<Vec3> outline_in_scene(const WildStreet& street, const WildObject& object) {
  std::vector<Vec3> outline = low_outline(object);
  for (Vec3& p : outline) p = street.to_scene(p);
  return outline;
}

std::optional<double> known(double share) {
  return std::isnan(share) ? std::nullopt : std::optional(share);
}

TrueObject object_in_scene(const WildStreet& street, const WildObject& object, std::uint64_t points, double hidden) {
  TrueObject truth;
  truth.id = object.id;
  truth.object_class = label_name(object.is_plant() ? PointLabel::vegetation : object_class_of(object.kind->name));
  if (!object.is_plant()) truth.group = name_of(artefact_class_of(object.kind->name));
  truth.variant = object.kind->name;
  truth.base = street.to_scene(object.pose.base);
  truth.box_centre = street.to_scene(object.pose.place(0.5 * (object.box.min + object.box.max)));
  truth.box_size = object.box.max - object.box.min;
  truth.heading_deg = object.heading_deg + street.heading_deg;
  truth.touches = object.touches;
  truth.points = points;
  truth.occluded = known(hidden);
  truth.moves = object.moves();
  truth.sometimes = object.comes_and_goes;
  truth.outline = outline_in_scene(street, object);
  return truth;
}

TrueTree tree_in_scene(const WildStreet& street, const WildObject& tree, std::uint64_t points, double hidden) {
  const Vec3 size = tree.box.max - tree.box.min;
  return {tree.id,
          std::string(tree.kind->name),
          street.to_scene(tree.pose.base),
          tree.box.max.z,
          tree.shape.crown_base,
          0.25 * (size.x + size.y),
          tree.shape.trunk_radius,
          points,
          known(hidden),
          outline_in_scene(street, tree)};
}

void write_names(TruthWriter& truth, const WildStreetScan& scan) {
  truth.noise({scan.scanner.beam.noise, 0, scan.scanner.beam.divergence_mrad, 0});
  truth.classes(street_class_names());
  std::map<int, std::string> materials{{1 + static_cast<int>(Material::foliage), name_of(Material::foliage)}};
  for (const SurfaceLabel& label : scan.model.street.scene.surfaces)
    materials.emplace(1 + static_cast<int>(label.material), name_of(label.material));
  truth.materials(materials);
}

void write_stations(TruthWriter& truth, const WildStreetScan& scan) {
  const WildStreetScanner& c = scan.scanner;
  std::uint32_t id = 0;
  if (c.platform == Platform::tripod)
    for (const Vec3& station : c.stations) truth.add(TrueStation{++id, scan.street.to_scene(station), 0, 0});
  if (c.platform == Platform::vehicle)
    for (double s = 0; s <= scan.street.length; s += kTrajectoryStep)
      truth.add(TrueStation{++id, scan.street.to_scene({s, c.lane, scan.street.profile_height(s) + c.height}), 0, 0});
}

void write_truth(TruthWriter& truth, const WildStreetScan& scan, const PointTally& tally) {
  const std::vector<double> hidden = hidden_shares(scan);
  for (const TruePlane& plane : scan.model.street.planes)
    truth.add(in_scene(scan.street, plane, tally.planes[plane.id]));
  for (const WildObject& object : scan.objects) {
    const std::uint64_t points = tally.elements[object.id];
    const double share = hidden[object.id - 1];
    if (object.is_tree())
      truth.add(tree_in_scene(scan.street, object, points, share));
    else if (object.is_plant())
      truth.add_plant(object_in_scene(scan.street, object, points, share));
    else
      truth.add(object_in_scene(scan.street, object, points, share));
  }
  for (TrueBlock block : scan.model.blocks) truth.add(block);
  for (const Kerb& kerb : scan.model.kerbs) {
    TrueKerb line{{}, kerb.height};
    for (const Vec3& p : kerb.line) line.line.push_back(scan.street.to_scene(p));
    truth.add(line);
  }
  for (TruePavement pavement : true_pavements(scan.street)) {
    for (Vec3& p : pavement.line) p = scan.street.to_scene(p);
    truth.add(pavement);
  }
  for (TrueCarriageway road : true_carriageways(scan.street)) {
    for (Vec3& p : road.ring) p = scan.street.to_scene(p);
    truth.add(road);
  }
  write_stations(truth, scan);
}

ScanCounts counts_of(const WildStreetScan& scan, const PointTally& tally) {
  const auto count = [&](auto is) {
    return static_cast<std::uint64_t>(std::count_if(scan.objects.begin(), scan.objects.end(), is));
  };
  const std::uint64_t trees = count([](const WildObject& o) { return o.is_tree(); });
  const std::uint64_t plants = count([](const WildObject& o) { return o.is_plant(); });
  return {{"points", tally.points},
          {"planes", scan.model.street.planes.size()},
          {"objects", scan.objects.size() - trees - plants},
          {"trees", trees},
          {"plants", plants},
          {"kerbs", scan.model.kerbs.size()}};
}

}  // namespace

ScanCounts scan_wild_street_scene(const ScanRequest& request) {
  Draws draws(request.values, kWildStreetGroups, request.seed);
  WildStreetScan scan = plan_wild_street_scan(draws, request.seed, request.points.value_or(kMostPoints));
  fit_wild_points(scan, request.points.value_or(kMostPoints), request.points.has_value());
  const RecordLayout layout = coloured_layout(kUnit);
  const std::unique_ptr<PointWriter> writer = create_cloud(request.output, cloud_spec(layout));
  TruthWriter truth(truth_path(request.output), settings_text(request, scan));
  write_names(truth, scan);
  truth.add(draws.drawn());
  PointTally tally{std::vector<std::uint64_t>(scan.model.street.planes.size() + 1),
                   std::vector<std::uint64_t>(scan.objects.size() + 1)};
  scan_wild_street(scan, [&](std::span<const std::byte> records) {
    writer->write(records);
    tally.add(records, layout);
    request.written(records.size() / layout.record_length);
  });
  write_truth(truth, scan, tally);
  const ScanCounts counts = counts_of(scan, tally);
  writer->finish();
  truth.finish(counts);
  return counts;
}

}  // namespace ilot::scan
