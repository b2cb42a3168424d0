// SPDX-License-Identifier: Apache-2.0
#include "scan/models/model_scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/error.h"
#include "engine/pass/stop.h"
#include "kernels/core/parallel.h"
#include "scan/optics/exact_math.h"
#include "scan/scanners/echo_point.h"
#include "scan/scanners/stations_file.h"

namespace ilot::scan {
namespace {

constexpr std::size_t kGrainsAtOnce = 24;
constexpr double kPilotPulses = 400000, kLeastPilotPulses = 60000;

// A plan and what its pulses have in common.
struct PlannedScan {
  std::unique_ptr<PulsePlan> plan;
  ScannerBeam beam;
};

std::vector<PlannedScan> plans_of(const ModelScan& scan) {
  std::vector<PlannedScan> plans;
  for (const StationParams& station : scan.stations) {
    ScannerBeam beam = scan.station_beam;
    Rng rng(mix64(scan.seed ^ 0x726567ull), station.id);
    const double x = gaussian(rng), y = gaussian(rng), z = gaussian(rng);
    beam.shift = scan.registration * Vec3{x, y, z};
    plans.push_back({plan_pulses(station, scan.seed), beam});
  }
  if (scan.vehicle) plans.push_back({plan_pulses(*scan.vehicle, scan.seed), scan.vehicle_beam});
  if (scan.flight) plans.push_back({plan_pulses(*scan.flight, scan.seed), scan.flight_beam});
  return plans;
}

double farthest_part(const ModelScan& scan, Vec3 from) {
  const Box3<Vec3> all = bounds_of(scan.stage.scene.parts);
  return norm(all.max - all.min) + std::max(norm(all.min - from), norm(all.max - from));
}

// The widest footprint of all beams on the model.
double reach_of(const ModelScan& scan) {
  double reach = 0;
  const auto take = [&](const BeamParams& beam, double range) {
    reach = std::max(reach, footprint_radius(beam, std::min(range, beam.farthest)));
  };
  for (const StationParams& s : scan.stations) take(scan.station_beam.beam, farthest_part(scan, s.position));
  if (scan.vehicle) take(scan.vehicle_beam.beam, farthest_part(scan, scan.vehicle->path[0]));
  return 1.1 * reach;
}

class ModelScanner {
 public:
  explicit ModelScanner(const ModelScan& scan)
      : scan_(scan),
        layout_(coloured_layout(scan.grid, scan.stage.place.origin)),
        near_(scan.stage.scene.parts, reach_of(scan)),
        far_(scan.stage.scene.parts,
             scan.flight ? 1.1 * footprint_radius(scan.flight_beam.beam, scan.flight_beam.beam.farthest) : 0),
        plans_(plans_of(scan)) {
    for (std::size_t p = 0; p < plans_.size(); ++p)
      for (std::uint64_t g = 0; g < plans_[p].plan->grains(); ++g) grains_.push_back({p, g});
  }

  std::size_t grains() const { return grains_.size(); }

  struct Result {
    std::vector<std::byte> records;
    std::vector<std::uint64_t> rays;  // by element
  };

  Result scan_grain(std::size_t grain) const {
    const auto [p, g] = grains_[grain];
    const ScannerBeam& beam = plans_[p].beam;
    const bool flying = scan_.flight && p + 1 == plans_.size();
    BeamTracer tracer(scan_.stage.scene, flying ? far_ : near_, beam.beam);
    std::vector<Echo> echoes;
    Result result;
    plans_[p].plan->for_each(g, [&](PlannedPulse& pulse) {
      tracer.trace(pulse.origin, pulse.aim, pulse.rng, echoes);
      if (const auto first = tracer.first_surface())
        if (const std::uint32_t element = scan_.stage.scene.surfaces[*first].element)
          PointTally::count(result.rays, element);
      for (std::size_t i = 0; i < echoes.size(); ++i) add_point(pulse, beam, echoes, i, result.records);
    });
    return result;
  }

 private:
  // What was seen through a pane or in it belongs to the window and lies on no plane.
  SurfaceLabel label_of(const Echo& echo) const {
    SurfaceLabel label = scan_.stage.scene.surfaces[echo.surface];
    if (!echo.pane) return label;
    label.true_class = static_cast<std::uint8_t>(FaceClass::other);
    label.plane = 0;
    if (echo.surface == *echo.pane) label.material = Material::interior;  // the back of a room
    label.element = scan_.stage.scene.surfaces[*echo.pane].element;
    return label;
  }

  static std::uint8_t las_class(FaceClass c) {
    switch (c) {
      case FaceClass::ground:
        return 2;
      case FaceClass::vegetation:
        return 5;
      case FaceClass::other:
        return 1;
      default:
        return 6;
    }
  }

  void add_point(PlannedPulse& pulse, const ScannerBeam& beam, const std::vector<Echo>& echoes, std::size_t i,
                 std::vector<std::byte>& records) const {
    const SurfaceLabel label = label_of(echoes[i]);
    const Ray ray{pulse.origin, pulse.aim.axis};
    ColouredPoint point =
        echo_point(echoes, i, label, ray, beam.full_range, std::max(beam.beam.range_noise, scan_.grid));
    point.place = point_at(ray, echoes[i].range + beam.beam.range_noise * gaussian(pulse.rng)) + beam.shift;
    const double noise = std::max(0.0, 1 + scan_.intensity_noise * gaussian(pulse.rng));
    point.intensity = static_cast<std::uint16_t>(std::min(65535.0, noise * point.intensity));
    point.classification = las_class(static_cast<FaceClass>(label.true_class));
    point.source = pulse.source;
    point.gps_time = pulse.time;
    point.scan_angle_deg = pulse.angle_deg;
    append_record(records, point, layout_);
  }

  const ModelScan& scan_;
  RecordLayout layout_;
  PartScene near_, far_;  // for beams of the ground, and for the wide ones of a flight
  std::vector<PlannedScan> plans_;
  std::vector<std::pair<std::size_t, std::uint64_t>> grains_;
};

double pulses_of(const ModelScan& scan) {
  double pulses = 0;
  for (const StationParams& s : scan.stations) {
    const StationGrid grid(s);
    pulses += static_cast<double>(grid.columns()) * static_cast<double>(grid.rows());
  }
  if (const auto& v = scan.vehicle)
    pulses += path_length(v->path) * v->profiles * 2 * (360 - v->blind_deg) / v->step_deg;
  if (const auto& f = scan.flight)
    pulses += f->airborne.density * (f->area.x1 - f->area.x0) * (f->area.y1 - f->area.y0);
  return pulses;
}

// Makes all pulses sparser by a factor in each of two directions.
void scale_steps(ModelScan& scan, double factor) {
  for (StationParams& s : scan.stations) {
    s.step_horizontal_deg *= factor;
    s.step_vertical_deg *= factor;
  }
  if (scan.vehicle) {
    scan.vehicle->profiles /= factor;
    scan.vehicle->step_deg *= factor;
  }
  if (scan.flight) scan.flight->airborne.density /= factor * factor;
}

std::string scanners_text(const ModelScan& scan) {
  std::string text = fmt::format(R"(,"stations":{})", scan.stations.size());
  if (scan.vehicle) {
    text += R"(,"vehicle_path":[)";
    for (std::size_t i = 0; i < scan.vehicle->path.size(); ++i) {
      const Vec3 p = scan.vehicle->path[i] + scan.stage.place.origin;
      text += fmt::format("{}[{:.4f},{:.4f},{:.4f}]", i ? "," : "", p.x, p.y, p.z);
    }
    text += "]";
  }
  return text + fmt::format(R"(,"flight":{})", scan.flight.has_value());
}

void write_truth(TruthWriter& truth, const ModelScan& scan, const PointTally& tally,
                 const std::vector<std::uint64_t>& rays) {
  const BeamParams& beam =
      scan.stations.empty() ? (scan.vehicle ? scan.vehicle_beam.beam : scan.flight_beam.beam) : scan.station_beam.beam;
  truth.noise({beam.range_noise, beam.angle_noise_deg, beam.divergence_mrad, beam.diameter});
  std::map<int, std::string> classes, materials;
  for (std::size_t c = 1; c < kFaceClasses; ++c) classes[static_cast<int>(c)] = name_of(static_cast<FaceClass>(c));
  for (const SurfaceLabel& label : scan.stage.scene.surfaces)
    materials.emplace(1 + static_cast<int>(label.material), name_of(label.material));
  truth.classes(classes);
  truth.materials(materials);
  for (const StationParams& s : scan.stations)
    truth.add(TrueStation{s.id, s.position, s.step_horizontal_deg, s.step_vertical_deg});
  for (TruePlane plane : scan.stage.planes) {
    plane.points = PointTally::of(tally.planes, plane.id);
    truth.add(plane);
  }
  for (TrueElement element : scan.stage.elements) {
    if (element.ring.empty()) continue;
    element.points = PointTally::of(tally.elements, element.id);
    element.seen->rays = PointTally::of(rays, element.id);
    truth.add(element);
  }
  for (TrueOpening opening : scan.stage.openings) {
    opening.seen->rays = PointTally::of(rays, opening.element);
    truth.add(opening);
  }
  for (const TrueBuilding& building : scan.stage.buildings) truth.add(building);
}

}  // namespace

void fit_points(ModelScan& scan, std::uint64_t points) {
  scale_steps(scan, std::sqrt(pulses_of(scan) /
                              std::clamp(4.0 * static_cast<double>(points), kLeastPilotPulses, kPilotPulses)));
  std::uint64_t bytes = 0;
  scan_model(scan, [&](std::span<const std::byte> records) { bytes += records.size(); });
  const double seen = static_cast<double>(bytes / coloured_layout(scan.grid).record_length);
  if (seen == 0) throw Error("the scanners see nothing of the model");
  scale_steps(scan, std::sqrt(seen / static_cast<double>(points)));
}

std::vector<std::uint64_t> scan_model(const ModelScan& scan,
                                      const std::function<void(std::span<const std::byte>)>& take) {
  const ModelScanner scanner(scan);
  std::vector<std::uint64_t> rays;
  for (std::size_t first = 0; first < scanner.grains(); first += kGrainsAtOnce) {
    if (stop_requested()) throw Error("interrupted: nothing was written", ExitCode::interrupted);
    std::vector<ModelScanner::Result> batch(std::min(kGrainsAtOnce, scanner.grains() - first));
    parallel_for(batch.size(), [&](std::size_t i) { batch[i] = scanner.scan_grain(first + i); });
    for (const ModelScanner::Result& result : batch) {
      take(result.records);
      for (std::uint32_t e = 0; e < result.rays.size(); ++e)
        if (result.rays[e]) PointTally::count(rays, e, result.rays[e]);
    }
  }
  return rays;
}

ScanCounts write_model_scan(ModelScan& scan, const ModelInput& input, const ScanRequest& request) {
  if (request.points) fit_points(scan, *request.points);
  const RecordLayout layout = coloured_layout(scan.grid, scan.stage.place.origin);
  const std::unique_ptr<PointWriter> writer = create_cloud(request.output, cloud_spec(layout, scan.stage.place.crs));
  const std::string settings =
      fmt::format("\"model\":{},\"seed\":{}{}{}", nlohmann::json(input.path.filename().string()).dump(), request.seed,
                  request.values.json(), scanners_text(scan));
  TruthWriter truth(truth_path(request.output), settings, scan.stage.place);
  PointTally tally;
  const auto rays = scan_model(scan, [&](std::span<const std::byte> records) {
    writer->write(records);
    tally.add(records, layout);
    request.written(records.size() / layout.record_length);
  });
  if (tally.points == 0) throw Error("the scanners see nothing of the model; nothing was written");
  write_truth(truth, scan, tally, rays);
  ScanCounts counts{{"points", tally.points},
                    {"buildings", scan.stage.buildings.size()},
                    {"planes", scan.stage.planes.size()},
                    {"openings", scan.stage.openings.size()}};
  for (std::size_t c = 0; c < kFaceClasses; ++c)
    if (tally.classes[c])
      counts.emplace_back("points of " + std::string(name_of(static_cast<FaceClass>(c))), tally.classes[c]);
  writer->finish();
  if (!scan.stations.empty()) write_stations(stations_path(request.output), scan.stations, scan.stage.place.origin);
  truth.finish(counts);
  return counts;
}

}  // namespace ilot::scan
