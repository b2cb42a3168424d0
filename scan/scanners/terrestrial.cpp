// SPDX-License-Identifier: Apache-2.0
#include "scan/scanners/terrestrial.h"

#include <algorithm>
#include <cmath>

#include "engine/error.h"
#include "engine/pass/stop.h"
#include "kernels/core/parallel.h"
#include "scan/optics/exact_math.h"
#include "scan/scanners/scan_record.h"
#include "scan/scanners/scene_truth.h"
#include "scan/scanners/stations_file.h"

namespace ilot::scan {
namespace {

constexpr std::uint64_t kGrainPulses = 1 << 16, kGrainsAtOnce = 24;
constexpr double kPulseRate = 100000, kStationSeconds = 3600, kFirstSecond = 200000;
constexpr double kIntensityRange = 8;  // metres: at this range a white, perpendicular surface fills the scale
constexpr double kMostPilotPulses = 400000, kLeastPilotPulses = 60000;

// The columns [first, first + count) of a station.
struct Grain {
  std::size_t station = 0;
  std::uint64_t first = 0, count = 0;
};

class TerrestrialScanner {
 public:
  explicit TerrestrialScanner(const TerrestrialScan& scan)
      : scan_(scan), layout_(coloured_layout(scan.grid)), scene_(scan.scene.model.parts, reach(scan)) {
    for (const StationParams& station : scan.scene.stations) {
      grids_.emplace_back(station);
      Rng rng(mix64(scan.seed ^ 0x726567ull), station.id);
      const double x = gaussian(rng), y = gaussian(rng), z = gaussian(rng);
      shifts_.push_back(scan.registration * Vec3{x, y, z});
    }
  }

  std::vector<Grain> grains() const {
    std::vector<Grain> all;
    for (std::size_t s = 0; s < grids_.size(); ++s) {
      const std::uint64_t columns = grids_[s].columns();
      const std::uint64_t width =
          std::max<std::uint64_t>(1, kGrainPulses / std::max<std::uint64_t>(1, grids_[s].rows()));
      for (std::uint64_t first = 0; first < columns; first += width)
        all.push_back({s, first, std::min(width, columns - first)});
    }
    return all;
  }

  std::vector<std::byte> scan_grain(const Grain& grain) const {
    const StationGrid& grid = grids_[grain.station];
    BeamTracer tracer(scan_.scene.model, scene_, scan_.beam);
    std::vector<Echo> echoes;
    std::vector<std::byte> records;
    for (std::uint64_t column = grain.first; column < grain.first + grain.count; ++column) {
      const SinCos azimuth = grid.azimuth(column);
      for (std::uint64_t row = 0; row < grid.rows(); ++row) {
        const Aim aim = grid.aim(azimuth, row);
        const StationParams& station = scan_.scene.stations[grain.station];
        Rng rng(mix64(scan_.seed ^ 0x746c73ull) + station.id, grid.key(column, row));
        tracer.trace(station.position, aim, rng, echoes);
        const double second = static_cast<double>(column * grid.rows() + row) / kPulseRate;
        for (std::size_t i = 0; i < echoes.size(); ++i)
          add_point(grain.station, aim, echoes, i, rng, kFirstSecond + kStationSeconds * station.id + second, records);
      }
    }
    return records;
  }

 private:
  static double reach(const TerrestrialScan& scan) {
    double furthest = 0;
    const Box3<Vec3> all = bounds_of(scan.scene.model.parts);
    for (const StationParams& station : scan.scene.stations)
      furthest = std::max({furthest, norm(all.min - station.position), norm(all.max - station.position)});
    const double footprint = footprint_radius(scan.beam, std::min(kMaxRange, furthest + norm(all.max - all.min)));
    return 1.1 * footprint;
  }

  void add_point(std::size_t at, const Aim& aim, const std::vector<Echo>& echoes, std::size_t i, Rng& rng,
                 double second, std::vector<std::byte>& records) const {
    const StationParams& station = scan_.scene.stations[at];
    const Echo& echo = echoes[i];
    const double range = echo.range + scan_.beam.range_noise * gaussian(rng);
    const Vec3 place = station.position + range * aim.axis;
    if (!scan_.scene.keep.contains(place)) return;
    const SurfaceLabel& label = scan_.scene.model.surfaces[echo.surface];
    ColouredPoint point = echo_point(echoes, i, label, {station.position, aim.axis}, kIntensityRange,
                                     std::max(scan_.beam.range_noise, scan_.grid));
    point.place = place + shifts_[at];
    point.source = station.id;
    point.gps_time = second;
    append_record(records, point, layout_);
  }

  const TerrestrialScan& scan_;
  RecordLayout layout_;
  PartScene scene_;
  std::vector<StationGrid> grids_;
  std::vector<Vec3> shifts_;  // registration errors of the positions of the stations
};

void scale_steps(TerrestrialScan& scan, double factor) {
  for (StationParams& station : scan.scene.stations) {
    station.step_horizontal_deg *= factor;
    station.step_vertical_deg *= factor;
  }
}

std::uint64_t count_points(const TerrestrialScan& scan) {
  std::uint64_t bytes = 0;
  scan_terrestrial(scan, [&](std::span<const std::byte> records) { bytes += records.size(); });
  return bytes / coloured_layout(scan.grid).record_length;
}

std::string settings_text(const ScanRequest& request, const TerrestrialScan& scan) {
  std::string text = "\"scene\":\"" + std::string(request.scene) + "\",\"seed\":" + std::to_string(request.seed);
  text += request.values.json();
  return text + ",\"grid_m\":" + std::to_string(scan.grid);
}

}  // namespace

TerrestrialScan empty_scan(const SceneValues& values, std::uint64_t seed) {
  TerrestrialScan scan;
  scan.beam = {values.get("scene.noise"), values.get("scene.angle_noise"), values.get("scene.divergence"),
               values.get("scene.diameter"), values.get("scene.separation")};
  scan.registration = values.get("scene.registration");
  scan.seed = seed;
  return scan;
}

void fit_points(TerrestrialScan& scan, std::uint64_t points) {
  double pulses = 0;
  for (const StationParams& station : scan.scene.stations) {
    const StationGrid grid(station);
    pulses += static_cast<double>(grid.columns()) * static_cast<double>(grid.rows());
  }
  const double pilot = std::clamp(4 * static_cast<double>(points), kLeastPilotPulses, kMostPilotPulses);
  scale_steps(scan, std::sqrt(pulses / pilot));
  const std::uint64_t seen = count_points(scan);
  if (seen == 0) throw Error("the stations see nothing of this scene");
  scale_steps(scan, std::sqrt(static_cast<double>(seen) / static_cast<double>(points)));
}

void scan_terrestrial(const TerrestrialScan& scan, const std::function<void(std::span<const std::byte>)>& take) {
  const TerrestrialScanner scanner(scan);
  const std::vector<Grain> grains = scanner.grains();
  for (std::size_t first = 0; first < grains.size(); first += kGrainsAtOnce) {
    if (stop_requested()) throw Error("interrupted: nothing was written", ExitCode::interrupted);
    std::vector<std::vector<std::byte>> batch(std::min<std::size_t>(kGrainsAtOnce, grains.size() - first));
    parallel_for(batch.size(), [&](std::size_t i) { batch[i] = scanner.scan_grain(grains[first + i]); });
    for (const std::vector<std::byte>& records : batch) take(records);
  }
}

ScanCounts write_terrestrial(const TerrestrialScan& scan, const ScanRequest& request) {
  const RecordLayout layout = coloured_layout(scan.grid);
  const std::unique_ptr<PointWriter> writer = create_cloud(request.output, cloud_spec(layout));
  TruthWriter truth(truth_path(request.output), settings_text(request, scan));
  const std::size_t length = writer->record_length();
  PointTally tally;
  scan_terrestrial(scan, [&](std::span<const std::byte> records) {
    writer->write(records);
    tally.add(records, layout);
    if (request.written) request.written(records.size() / length);
  });
  write_scene_truth(truth, scan.scene, scan.beam, tally);
  const ScanCounts counts = scene_counts(scan.scene, tally);
  writer->finish();
  write_stations(stations_path(request.output), scan.scene.stations);
  truth.finish(counts);
  return counts;
}

}  // namespace ilot::scan
