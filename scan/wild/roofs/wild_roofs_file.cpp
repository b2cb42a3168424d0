// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <span>
#include <string>

#include "engine/deliverables/solids/city_json.h"
#include "engine/formats/file.h"
#include "engine/formats/writer.h"
#include "scan/roofs/roofs_truth.h"
#include "scan/scanners/echo_point.h"
#include "scan/scanners/scan_record.h"
#include "scan/unit.h"
#include "scan/wild/roofs/wild_roofs_scan.h"

namespace ilot::scan {
namespace {

constexpr int kEpsg = 2154;
constexpr std::uint64_t kMostPoints = 2'000'000;  // unless --points asks for another number

std::string settings_text(const ScanRequest& request, const WildRoofsScan& scan) {
  return fmt::format(R"("scene":"roofs-wild","seed":{}{},"width_m":{},"density_used":{},"grid_m":{})", request.seed,
                     request.values.json(), scan.wild.width, scan.scanner.flight.density, kUnit);
}

std::string ring_text(const std::vector<Vec3>& ring) {
  std::string text = "[";
  for (std::size_t i = 0; i <= ring.size(); ++i) {
    const Vec3 p = ring[i % ring.size()] + kSceneOrigin;
    text += fmt::format("{}[{:.3f},{:.3f}]", i ? "," : "", p.x, p.y);
  }
  return text + "]";
}

// Writes GeoJSON with the CRS as a member, as registers do.
void write_footprints(const std::filesystem::path& path, const std::vector<WildFootprint>& footprints) {
  OutputFile file(path);
  const auto append = [&](const std::string& text) { file.append(std::as_bytes(std::span(text))); };
  append(fmt::format(
      "{{\"type\":\"FeatureCollection\",\"name\":\"footprints\",\n\"crs\":{{\"type\":\"name\",\"properties\":"
      "{{\"name\":\"urn:ogc:def:crs:EPSG::{}\"}}}},\n\"features\":[\n",
      kEpsg));
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    std::string rings, ids;
    for (const auto& ring : footprints[i].rings) rings += (rings.empty() ? "" : ",") + ring_text(ring);
    for (const std::uint32_t id : footprints[i].buildings) ids += fmt::format("{}{}", ids.empty() ? "" : " ", id);
    append(
        fmt::format("{{\"type\":\"Feature\",\"properties\":{{\"id\":\"building-{}\",\"buildings\":\"{}\"}},"
                    "\"geometry\":{{\"type\":\"Polygon\",\"coordinates\":[{}]}}}}{}\n",
                    footprints[i].id, ids, rings, i + 1 < footprints.size() ? "," : ""));
  }
  append("]}\n");
  file.commit();
}

void write_names(TruthWriter& truth, const WildRoofsScan& scan) {
  truth.noise({scan.scanner.noise});
  truth.classes({{1, "ground"}, {2, "roof"}, {3, "wall"}, {4, "vegetation"}, {5, "installation"}, {6, "car"}});
  std::map<int, std::string> names;
  for (std::size_t m = 0; m < kMaterials; ++m)
    names.emplace(1 + static_cast<int>(m), name_of(static_cast<Material>(m)));
  truth.materials(names);
}

void write_truth(TruthWriter& truth, CityJsonWriter& model, const WildRoofsScan& scan, const PointTally& tally) {
  for (const TruePlane& plane : planes_of_town(scan.wild.town, tally.planes))
    if (plane.id > 0) truth.add(plane);
  for (std::uint32_t b = 0; b < scan.wild.town.buildings.size(); ++b) {
    const RoofBuilding& building = scan.wild.town.buildings[b];
    TrueBuilding known = truth_of_building(building, b + 1);
    known.roof = scan.wild.forms[b];
    truth.add(known);
    Building solid = model_of(building, b + 1);
    for (auto& [key, value] : solid.attributes)
      if (key == "roof_type") value = std::string(scan.wild.forms[b]);
    model.add(solid);
  }
  for (std::size_t i = 0; i < scan.wild.trees.size(); ++i) {
    TrueTree tree = scan.wild.trees[i].truth;
    tree.id = kFirstTreeElement + static_cast<std::uint32_t>(i);
    tree.points = PointTally::of(tally.elements, tree.id);
    truth.add(tree);
  }
}

}  // namespace

ScanCounts scan_wild_roofs_scene(const ScanRequest& request) {
  Draws draws(request.values, kWildRoofsGroups, request.seed);
  WildRoofsScan scan = plan_wild_roofs(draws, request.seed, request.points.value_or(kMostPoints));
  if (request.points) fit_wild_roofs(scan, *request.points);
  const std::vector<WildFootprint> footprints = draw_footprints(scan.wild, draws);
  const RecordLayout layout = coloured_layout(kUnit);
  const std::unique_ptr<PointWriter> writer = create_cloud(request.output, cloud_spec(layout));
  TruthWriter truth(truth_path(request.output), settings_text(request, scan));
  CityJsonWriter model(truth_path(request.output).replace_extension(".city.json"), {kEpsg, kSceneOrigin});
  write_names(truth, scan);
  truth.add(draws.drawn());
  PointTally tally;
  tally.planes.resize(scan.wild.town.plane_count + kFirstWildPlane);
  scan_wild_roofs(scan, [&](std::span<const std::byte> records) {
    writer->write(records);
    tally.add(records, layout);
    request.written(records.size() / layout.record_length);
  });
  write_truth(truth, model, scan, tally);
  const ScanCounts counts{{"points", tally.points},
                          {"buildings", scan.wild.town.buildings.size()},
                          {"planes", std::uint64_t{scan.wild.town.plane_count} + 1},
                          {"trees", scan.wild.trees.size()},
                          {"footprints", footprints.size()}};
  writer->finish();
  truth.finish(counts);
  model.finish();
  std::filesystem::path outlines = request.output;
  write_footprints(outlines.replace_extension(".footprints.geojson"), footprints);
  return counts;
}

}  // namespace ilot::scan
