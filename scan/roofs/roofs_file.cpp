// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <map>
#include <memory>
#include <string>

#include "engine/deliverables/solids/city_json.h"
#include "engine/formats/writer.h"
#include "scan/roofs/roofs_scan.h"
#include "scan/roofs/roofs_truth.h"
#include "scan/scanners/scan_record.h"
#include "scan/truth_writer.h"
#include "scan/unit.h"

namespace ilot::scan {
namespace {

constexpr int kEpsg = 2154;

std::string settings_text(const RoofsScan& scan) {
  const RoofTownParams& t = scan.town;
  const AirborneParams& f = scan.flight;
  return fmt::format(R"("scene":"roofs","seed":{},"buildings":{},"adjoining":{},"chimneys":{},"slope_percent":{},)"
                     R"("trees_per_hectare":{},"density":{},"height_m":{},"scan_angle_deg":{},"jitter":{},"grid_m":{})",
                     t.seed, t.buildings, t.adjoining, t.chimneys, t.slope_percent, t.trees, f.density, f.height,
                     f.angle_deg, f.jitter, kUnit);
}

std::map<int, std::string> materials_of(const RoofTown& town) {
  std::map<int, std::string> names;
  const auto add = [&](Material material) { names.emplace(1 + static_cast<int>(material), name_of(material)); };
  for (Material material : {Material::asphalt, Material::paving, Material::grass, Material::foliage}) add(material);
  for (const RoofBuilding& building : town.buildings) {
    add(building.roof);
    add(building.wall);
  }
  return names;
}

}  // namespace

ScanCounts scan_roofs_scene(const ScanRequest& request) {
  RoofsScan scan = plan_roofs(request.values, request.seed, request.points);
  const RoofTown town = build_roof_town(scan.town);
  if (scan.points) scan.flight.density = density_for(town, *scan.points);
  const RecordLayout layout = coloured_layout(kUnit);
  const std::unique_ptr<PointWriter> writer = create_cloud(request.output, cloud_spec(layout));
  TruthWriter truth(truth_path(request.output), settings_text(scan));
  CityJsonWriter model(truth_path(request.output).replace_extension(".city.json"), {kEpsg, kSceneOrigin});
  truth.noise({scan.noise});
  truth.materials(materials_of(town));
  truth.classes({{1, "ground"}, {2, "roof"}, {3, "wall"}, {4, "vegetation"}});

  std::vector<std::uint64_t> points(town.plane_count + kFirstTownPlane);
  std::uint64_t total = 0;
  scan_roofs(scan, town, [&](std::span<const std::byte> records) {
    writer->write(records);
    for (std::size_t at = 0; at < records.size(); at += layout.record_length)
      ++points[truth_of(&records[at], layout).true_plane];
    total += records.size() / layout.record_length;
    request.written(records.size() / layout.record_length);
  });
  for (const TruePlane& plane : planes_of_town(town, points))
    if (plane.id > 0) truth.add(plane);
  for (std::uint32_t b = 0; b < town.buildings.size(); ++b) {
    truth.add(truth_of_building(town.buildings[b], b + 1));
    model.add(model_of(town.buildings[b], b + 1));
  }
  const ScanCounts counts{
      {"points", total}, {"buildings", town.buildings.size()}, {"planes", std::uint64_t{town.plane_count} + 1}};
  writer->finish();
  truth.finish(counts);
  model.finish();
  return counts;
}

}  // namespace ilot::scan
