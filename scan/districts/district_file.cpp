// SPDX-License-Identifier: Apache-2.0
#include "scan/districts/district_file.h"

#include <fmt/format.h>

#include <vector>

#include "engine/deliverables/solids/city_json.h"
#include "engine/formats/writer.h"
#include "scan/districts/district_model.h"
#include "scan/scanners/cell_scan.h"
#include "scan/scanners/scan_record.h"
#include "scan/truth_json.h"
#include "scan/truth_writer.h"

namespace ilot::scan {
namespace {

std::string settings_text(const DistrictScan& scan) {
  const DistrictParams& d = scan.district;
  const AirborneParams& f = scan.flight;
  return fmt::format(
      R"("scene":"district","seed":{},"side_m":{},"slope_percent":{},"trees_per_hectare":{},"adjoining":{},"flat":{},)"
      R"("hip":{},"density":{},"height_m":{},"scan_angle_deg":{},"jitter":{},"range_noise_m":{},"grid_m":0.001)",
      d.seed, d.side, d.slope_percent, d.trees, d.adjoining, d.flat, d.hip, f.density, f.height, f.angle_deg, f.jitter,
      scan.noise);
}

}  // namespace

ScanSummary write_district(const DistrictScan& scan, const std::filesystem::path& path,
                           const std::function<void(std::uint64_t)>& written) {
  const std::unique_ptr<PointWriter> writer = create_cloud(path, cloud_spec(scan_layout()));
  TruthJson truth(truth_path(path), settings_text(scan));
  CityJsonWriter model(truth_path(path).replace_extension(".city.jsonl"), {2154, kSceneOrigin});
  const std::size_t record_length = writer->record_length();
  ScanSummary summary{0, 0, 1};
  std::uint64_t ground_points = 0;
  scan_district(scan, [&](const ScannedCell& item) {
    writer->write(item.records);
    if (written) written(item.records.size() / record_length);
    std::vector<std::uint64_t> points(item.cell.plane_count);
    for (std::size_t at = 0; at < item.records.size(); at += record_length) {
      const std::uint32_t plane = true_plane_of(&item.records[at]);
      if (plane == kGroundPlane) ++ground_points;
      if (plane >= item.first_plane) ++points[plane - item.first_plane];
    }
    truth.add_cell(item.cell, item.first_plane, item.first_building, points);
    for (std::uint32_t house = 0; house < item.cell.houses.size(); ++house)
      model.add(house_model(item.cell, house, item.first_plane, item.first_building));
    summary.points += item.records.size() / record_length;
    summary.buildings += item.cell.houses.size();
    summary.planes += item.cell.plane_count;
  });
  truth.add_ground(District(scan.district).ground(), {0, 0, scan.district.side, scan.district.side}, ground_points);
  writer->finish();
  truth.finish(summary.points, summary.buildings);
  model.finish();
  return summary;
}

ScanCounts scan_district_scene(const ScanRequest& request) {
  const DistrictScan plan = plan_district(request.values, request.seed, request.points);
  const ScanSummary made = write_district(plan, request.output, request.written);
  return {{"points", made.points}, {"buildings", made.buildings}, {"planes", made.planes}};
}

}  // namespace ilot::scan
