// SPDX-License-Identifier: Apache-2.0
#include "scan/districts/district_scan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/error.h"
#include "engine/pass/stop.h"
#include "kernels/core/parallel.h"
#include "scan/optics/exact_math.h"
#include "scan/scanners/cell_scan.h"

namespace ilot::scan {
namespace {

constexpr double kBatchBytes = 160e6;  // of records in memory at a time

// Returns the number of cells per batch. It depends only on the scene and never on the number of threads.
std::size_t batch_size(const DistrictScan& scan, const District& district) {
  const double cell_area = scan.district.side * scan.district.side / static_cast<double>(district.cell_count());
  const double cell_bytes = cell_area * scan.flight.density * 36;
  return static_cast<std::size_t>(std::clamp(kBatchBytes / cell_bytes, 1.0, 64.0));
}

// Returns the pulses to send per requested point. Rows and columns of pulses do not fill the border of the area evenly,
// so a few more pulses than necessary are sent. However, crowns give 0.0016 to 0.0018 further echoes per pulse for each
// tree per hectare (measured). Two thirds of these echoes are taken into account where cells are large enough to
// contain trees.
double points_margin(double points, double area, double trees) {
  const double echoes = area > 1e4 ? 1 + 0.0012 * trees : 1;
  return (1.005 + 4 / std::sqrt(points)) / echoes;
}

}  // namespace

DistrictScan plan_district(const SceneValues& values, std::uint64_t seed, std::optional<std::uint64_t> points) {
  DistrictScan scan;
  double area = values.get("scene.area_km2") * 1e6, density = values.get("scene.density");
  if (points) {
    const bool area_set = values.is_set("scene.area_km2");
    if (area_set && values.is_set("scene.density"))
      throw Error("--points, scene.area_km2 and scene.density contradict each other; leave out one", ExitCode::usage);
    const auto wanted = static_cast<double>(*points);
    const double margin = points_margin(wanted, area_set ? area : wanted / density, values.get("scene.trees"));
    if (area_set)
      density = margin * wanted / area;
    else
      area = margin * wanted / density;
  }
  scan.points = points;
  scan.noise = values.get("scene.noise");
  scan.flight.density = density;
  scan.flight.height = values.get("scene.height");
  scan.flight.angle_deg = values.get("scene.scan_angle");
  scan.flight.jitter = values.get("scene.jitter");
  scan.district.side = std::sqrt(area);
  scan.district.slope_percent = values.get("scene.slope");
  scan.district.trees = values.get("scene.trees");
  scan.district.adjoining = values.get("scene.adjoining");
  scan.district.flat = values.get("scene.flat");
  scan.district.hip = values.get("scene.hip");
  scan.district.seed = seed;
  // The clearance is the lean of the highest house in the most oblique view, plus half a metre for the jitter of the
  // aim.
  scan.district.clearance = kMaxHouseHeight * (tan_deg(scan.flight.angle_deg) + kForwardTangent) + 0.5;
  return scan;
}

void scan_district(const DistrictScan& scan, const std::function<void(const ScannedCell&)>& take) {
  const District district(scan.district);
  const FlightPlan flight(scan.flight, district.ground(), scan.district.seed);
  const std::size_t record_length = scan_layout().record_length;
  std::uint64_t left = scan.points.value_or(std::numeric_limits<std::uint64_t>::max());
  std::uint64_t next_plane = kGroundPlane + 1, next_building = 1;
  const std::size_t at_once = batch_size(scan, district);
  for (std::uint64_t first = 0; first < district.cell_count() && left > 0; first += at_once) {
    if (stop_requested()) throw Error("interrupted: nothing was written", ExitCode::interrupted);
    std::vector<ScannedCell> batch(std::min<std::uint64_t>(at_once, district.cell_count() - first));
    parallel_for(batch.size(), [&](std::size_t i) { batch[i].cell = district.build_cell(first + i); });
    for (ScannedCell& item : batch) {
      item.first_plane = static_cast<std::uint32_t>(next_plane);
      item.first_building = static_cast<std::uint32_t>(next_building);
      next_plane += item.cell.plane_count;
      next_building += item.cell.houses.size();
      if (next_plane > std::numeric_limits<std::uint32_t>::max())
        throw Error("This district has more planes than true_plane can number (2^32); choose a smaller area");
    }
    parallel_for(batch.size(), [&](std::size_t i) {
      batch[i].records = scan_cell(batch[i].cell, flight, district.ground(), batch[i].first_plane, scan.noise);
    });
    for (ScannedCell& item : batch) {
      if (left == 0) break;
      const std::uint64_t keep = std::min<std::uint64_t>(left, item.records.size() / record_length);
      item.records.resize(keep * record_length);
      left -= keep;
      take(item);
    }
  }
  if (scan.points && left > 0)
    throw Error("The district has " + std::to_string(*scan.points - left) +
                " points only; set a larger scene.area_km2");
}

}  // namespace ilot::scan
