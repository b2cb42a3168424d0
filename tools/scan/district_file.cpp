// SPDX-License-Identifier: Apache-2.0
#include "tools/scan/district_file.h"

#include <fmt/format.h>

#include <vector>

#include "engine/formats/writer.h"
#include "tools/scan/cell_scan.h"
#include "tools/scan/truth_json.h"

namespace ilot::scan {
namespace {

// EPSG:2154 as WKT 1, the form LAS 1.4 asks for. A constant: PROJ's own text changes with its version.
constexpr const char* kLambert93 =
    R"(PROJCS["RGF93 v1 / Lambert-93",GEOGCS["RGF93 v1",DATUM["Reseau_Geodesique_Francais_1993_v1",)"
    R"(SPHEROID["GRS 1980",6378137,298.257222101,AUTHORITY["EPSG","7019"]],AUTHORITY["EPSG","6171"]],)"
    R"(PRIMEM["Greenwich",0,AUTHORITY["EPSG","8901"]],UNIT["degree",0.0174532925199433,AUTHORITY["EPSG","9122"]],)"
    R"(AUTHORITY["EPSG","4171"]],PROJECTION["Lambert_Conformal_Conic_2SP"],PARAMETER["latitude_of_origin",46.5],)"
    R"(PARAMETER["central_meridian",3],PARAMETER["standard_parallel_1",49],PARAMETER["standard_parallel_2",44],)"
    R"(PARAMETER["false_easting",700000],PARAMETER["false_northing",6600000],)"
    R"(UNIT["metre",1,AUTHORITY["EPSG","9001"]],AXIS["Easting",EAST],AXIS["Northing",NORTH],)"
    R"(AUTHORITY["EPSG","2154"]])";

CloudSpec cloud_spec() {
  CloudSpec spec;
  spec.like.format = "las";
  spec.like.layout = scan_layout();
  spec.like.crs.wkt = kLambert93;
  spec.like.crs.epsg = 2154;
  spec.like.crs.unit_assumed = false;
  spec.software = "ilot scan";
  return spec;
}

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

std::filesystem::path truth_path(const std::filesystem::path& cloud) {
  std::filesystem::path path = cloud;
  return path.replace_extension(".truth.json");
}

ScanSummary write_district(const DistrictScan& scan, const std::filesystem::path& path,
                           const std::function<void(std::uint64_t)>& written) {
  const std::unique_ptr<PointWriter> writer = create_cloud(path, cloud_spec());
  TruthJson truth(truth_path(path), settings_text(scan));
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
    summary.points += item.records.size() / record_length;
    summary.buildings += item.cell.houses.size();
    summary.planes += item.cell.plane_count;
  });
  truth.add_ground(District(scan.district).ground(), {0, 0, scan.district.side, scan.district.side}, ground_points);
  writer->finish();
  truth.finish(summary.points, summary.buildings);
  return summary;
}

}  // namespace ilot::scan
