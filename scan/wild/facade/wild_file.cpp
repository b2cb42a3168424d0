// SPDX-License-Identifier: Apache-2.0
#include "scan/wild/facade/wild_file.h"

#include <fmt/format.h>

#include <filesystem>

#include "engine/formats/file.h"
#include "scan/optics/exact_math.h"
#include "scan/scanners/scene_truth.h"
#include "scan/scanners/stations_file.h"

namespace ilot::scan {
namespace {

constexpr double kNear = 0.05;      // metres: how well places are known that are known nearly
constexpr double kDrivePlaces = 5;  // metres between the places of a drive in the truth

std::string wild_settings(const ScanRequest& request, const WildScan& scan) {
  return fmt::format("\"scene\":\"{}\",\"seed\":{}{},\"grid_m\":{}", request.scene, request.seed, request.values.json(),
                     scan.grid);
}

// Writes what the office knows about the stations. An older file of a scan of the same name is removed.
void write_known_stations(const std::filesystem::path& path, const WildScan& scan) {
  std::error_code code;
  std::filesystem::remove(path, code);
  if (scan.drive || scan.knowledge == StationKnowledge::unknown) return;
  std::vector<StationParams> known = scan.scene.stations;
  for (StationParams& station : known) {
    Rng rng(mix64(scan.seed ^ 0x6e656172ull), station.id);
    const double x = gaussian(rng), y = gaussian(rng), z = gaussian(rng);
    if (scan.knowledge == StationKnowledge::near) station.position = station.position + kNear * Vec3{x, y, z};
  }
  if (scan.steps_given) return write_stations(path, known);
  std::string text = "name,x,y,z\n";
  for (const StationParams& s : known) {
    const Vec3 p = kSceneOrigin + s.position;
    text += fmt::format("{},{:.4f},{:.4f},{:.4f}\n", s.id, p.x, p.y, p.z);
  }
  OutputFile file(path);
  file.append(std::as_bytes(std::span(text)));
  file.commit();
}

void add_drive(TruthWriter& truth, const WildDrive& drive) {
  std::uint32_t id = 0;
  for (double s = 0; s <= drive.length; s += kDrivePlaces)
    truth.add(TrueStation{++id, drive.start + s * drive.way, 0, drive.step_deg});
}

}  // namespace

ScanCounts write_wild(WildScan scan, const ScanRequest& request) {
  const double density = fit_density(scan, kMostWildPoints, request.points);
  scan.drawn.scene.push_back({"density_reached", density, "points/m2", "", false});
  const RecordLayout layout = wild_layout(scan);
  const std::unique_ptr<PointWriter> writer = create_cloud(request.output, cloud_spec(layout));
  TruthWriter truth(truth_path(request.output), wild_settings(request, scan));
  truth.add(scan.drawn);
  PointTally tally;
  scan_wild(scan, [&](std::span<const std::byte> records) {
    writer->write(records);
    tally.add(records, layout);
    if (request.written) request.written(records.size() / layout.record_length);
  });
  write_scene_truth(truth, scan.scene, scan.beam, tally);
  if (scan.drive) add_drive(truth, *scan.drive);
  const ScanCounts counts = scene_counts(scan.scene, tally);
  writer->finish();
  write_known_stations(stations_path(request.output), scan);
  truth.finish(counts);
  return counts;
}

}  // namespace ilot::scan
