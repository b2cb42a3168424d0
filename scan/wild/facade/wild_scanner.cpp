// SPDX-License-Identifier: Apache-2.0
#include "scan/wild/facade/wild_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/error.h"
#include "engine/pass/stop.h"
#include "kernels/core/parallel.h"
#include "scan/optics/exact_math.h"
#include "scan/scanners/scene_truth.h"

namespace ilot::scan {
namespace {

constexpr std::uint64_t kGrainPulses = 1 << 16, kGrainsAtOnce = 24;
constexpr double kFirstSecond = 200000, kRadians = 3.14159265358979323846 / 180;
constexpr double kIntensityRange = 8;    // metres: at this range a white, perpendicular surface fills the scale
constexpr double kMostBias = 9;          // the bias grows with the squared tangent of the incidence up to this
constexpr double kPilotPulses = 150000;  // of the sparse scan that is counted
constexpr double kLeastRange = 0.8, kStrayRange = 30;  // metres: echoes from the air lie between

// The registration error of a station or a head.
struct Misfit {
  Vec3 shift, turn;  // metres; radians about each axis
};

struct WildGrain {
  std::size_t sweep = 0;
  std::uint64_t first = 0, count = 0;  // lines
};

class WildScanner {
 public:
  explicit WildScanner(const WildScan& scan)
      : scan_(scan), layout_(wild_layout(scan)), scene_(scan.scene.model.parts, reach()) {
    if (scan.drive)
      for (int head : {1, 2}) sweeps_.emplace_back(*scan.drive, head);
    else
      for (const StationParams& station : scan.scene.stations) sweeps_.emplace_back(station);
    for (const WildPulses& sweep : sweeps_) {
      Rng rng(mix64(scan.seed ^ 0x6d6973666974ull), sweep.id());
      const auto three = [&](double size) {
        const double x = gaussian(rng), y = gaussian(rng), z = gaussian(rng);
        return size * Vec3{x, y, z};
      };
      const Vec3 shift = three(scan.faults.shift);
      misfits_.push_back({shift, three(scan.faults.turn_deg * kRadians)});
    }
  }

  std::vector<WildGrain> grains() const {
    std::vector<WildGrain> all;
    for (std::size_t s = 0; s < sweeps_.size(); ++s) {
      const std::uint64_t lines = sweeps_[s].lines();
      const std::uint64_t width =
          std::max<std::uint64_t>(1, kGrainPulses / std::max<std::uint64_t>(1, sweeps_[s].pulses()));
      for (std::uint64_t first = 0; first < lines; first += width)
        all.push_back({s, first, std::min(width, lines - first)});
    }
    return all;
  }

  std::vector<std::byte> scan_grain(const WildGrain& grain) const {
    const WildPulses& sweep = sweeps_[grain.sweep];
    BeamTracer tracer(scan_.scene.model, scene_, scan_.beam);
    std::vector<Echo> echoes;
    std::vector<std::byte> records;
    for (std::uint64_t line = grain.first; line < grain.first + grain.count; ++line)
      sweep.each(line, [&](const WildPulse& pulse) {
        Rng rng(mix64(scan_.seed ^ 0x77696c64ull) + sweep.id(), pulse.key);
        Rng luck(mix64(scan_.seed ^ 0x6c75636bull) + sweep.id(), pulse.key);
        if (luck.uniform() < scan_.faults.dropouts) return;
        tracer.trace(pulse.origin, pulse.aim, rng, echoes);
        if (luck.uniform() < scan_.faults.strays) stray(luck, echoes);
        const std::size_t kept =
            scan_.faults.returns == WildReturns::first ? std::min<std::size_t>(1, echoes.size()) : echoes.size();
        for (std::size_t i = 0; i < kept; ++i) add_point(grain.sweep, pulse, echoes, i, rng, records);
      });
    return records;
  }

 private:
  double reach() const {
    const Box3<Vec3> all = bounds_of(scan_.scene.model.parts);
    const double furthest = std::min(kMaxRange, 2 * norm(all.max - all.min));
    return 1.1 * footprint_radius(scan_.beam, furthest);
  }

  // Dust, rain and birds return the pulse before it meets anything.
  static void stray(Rng& luck, std::vector<Echo>& echoes) {
    const double most = echoes.empty() ? kStrayRange : echoes[0].range;
    if (!(most > kLeastRange)) return;
    Echo echo{kLeastRange + (most - kLeastRange) * luck.uniform(), 0.02, kNoSurface, 0, 1, {}};
    echo.surface_range = echo.range;
    echoes.assign(1, echo);
  }

  Vec3 misplaced(std::size_t sweep, const WildPulse& pulse, Vec3 way) const {
    const Misfit& misfit = misfits_[sweep];
    return pulse.origin + way + cross(misfit.turn, way) + misfit.shift;
  }

  void add_point(std::size_t sweep, const WildPulse& pulse, const std::vector<Echo>& echoes, std::size_t i, Rng& rng,
                 std::vector<std::byte>& records) const {
    const WildFaults& faults = scan_.faults;
    const Echo& echo = echoes[i];
    const double cosine2 = echo.cosine * echo.cosine;
    const double tangent2 = cosine2 > 0 ? std::min(kMostBias, (1 - cosine2) / cosine2) : kMostBias;
    const double noise = scan_.beam.range_noise * gaussian(rng);
    const Vec3 way = (echo.range + faults.incidence_bias * tangent2 + noise) * pulse.aim.axis;
    if (!scan_.crop.contains(pulse.origin + way)) return;
    const bool mixed = std::abs(echo.range - echo.surface_range) > std::max(scan_.beam.range_noise, scan_.grid);
    if (mixed && faults.filtered) return;
    ColouredPoint point;
    point.place = misplaced(sweep, pulse, way);
    const SurfaceLabel label = echo.surface == kNoSurface ? SurfaceLabel{scan_.stray_class, 0, 0, Material::cloth, 0}
                                                          : scan_.scene.model.surfaces[echo.surface];
    point.material = static_cast<std::uint8_t>(1 + static_cast<std::uint8_t>(label.material));
    point.rgb = rgb_of(label, pulse.origin + echo.surface_range * pulse.aim.axis);
    point.intensity = intensity_of(echo, rng);
    if (faults.returns != WildReturns::unnumbered) {
      point.return_number = static_cast<std::uint8_t>(i + 1);
      point.return_count = static_cast<std::uint8_t>(faults.returns == WildReturns::first ? 1 : echoes.size());
    }
    if (faults.source_id) point.source = sweeps_[sweep].id();
    if (faults.gps_time) point.gps_time = kFirstSecond + pulse.second;
    if (!mixed) {
      point.true_class = label.true_class;
      point.true_plane = label.plane;
      point.true_element = label.element;
    }
    append_record(records, point, layout_);
  }

  std::uint16_t intensity_of(const Echo& echo, Rng& rng) const {
    const WildFaults& faults = scan_.faults;
    if (faults.intensity == WildIntensity::missing) return 0;
    const bool corrected = faults.intensity == WildIntensity::corrected;
    const double share = corrected ? echo.energy / std::max(0.05, echo.cosine)
                                   : echo.energy * kIntensityRange * kIntensityRange / (echo.range * echo.range);
    const double speckled = share * std::max(0.0, 1 + faults.intensity_noise * gaussian(rng));
    return static_cast<std::uint16_t>(65535 * std::min(1.0, speckled));
  }

  // A tone makes the colour lighter or darker and moves it between red and blue.
  Rgb16 rgb_of(const SurfaceLabel& label, Vec3 place) const {
    if (scan_.faults.colour == WildColour::missing) return {};
    Rgb16 rgb = colour(label.material, place);
    if (label.tone != 0) {
      const double light = 0.55 + 0.6 * (label.tone % 16) / 15.0, warm = 0.25 * ((label.tone / 16) / 15.0 - 0.5);
      const std::array<double, 3> by{light * (1 + warm), light, light * (1 - warm)};
      for (std::size_t c = 0; c < 3; ++c) rgb[c] = static_cast<std::uint16_t>(std::min(65535.0, rgb[c] * by[c]));
    }
    if (scan_.faults.colour == WildColour::eight_bit)
      for (std::uint16_t& c : rgb) c = static_cast<std::uint16_t>(c >> 8);
    return rgb;
  }

  static constexpr SurfaceId kNoSurface = ~SurfaceId{0};
  const WildScan& scan_;
  RecordLayout layout_;
  PartScene scene_;
  std::vector<WildPulses> sweeps_;
  std::vector<Misfit> misfits_;
};

void scale_wild(WildScan& scan, double factor) {
  for (StationParams& station : scan.scene.stations) {
    station.step_horizontal_deg *= factor;
    station.step_vertical_deg *= factor;
  }
  if (scan.drive) {
    scan.drive->step_deg *= factor;
    scan.drive->profiles /= factor;
  }
}

double pulses_of(const WildScan& scan) {
  double pulses = 0;
  const auto add = [&](const WildPulses& sweep) {
    pulses += static_cast<double>(sweep.lines()) * static_cast<double>(sweep.pulses());
  };
  if (scan.drive)
    for (int head : {1, 2}) add(WildPulses(*scan.drive, head));
  else
    for (const StationParams& station : scan.scene.stations) add(WildPulses(station));
  return pulses;
}

// Returns the median over the area of the walls that are seen of their points per square metre.
double median_density(const WildScan& scan, const PointTally& tally) {
  std::vector<std::pair<double, double>> walls;  // density, area
  double area = 0;
  for (const TruePlane& plane : scan.scene.planes) {
    if (plane.surface_class != "facade" || !(plane.area > 0) || PointTally::of(tally.planes, plane.id) == 0) continue;
    walls.emplace_back(static_cast<double>(PointTally::of(tally.planes, plane.id)) / plane.area, plane.area);
    area += plane.area;
  }
  std::sort(walls.begin(), walls.end());
  double below = 0;
  for (const auto& [density, own] : walls) {
    below += own;
    if (below >= area / 2) return density;
  }
  return 0;
}

}  // namespace

bool WildCrop::contains(Vec3 p) const {
  const Vec3 d = p - origin;
  const double x = dot(along, d), o = dot(out, d);
  return x >= x0 && x <= x1 && o >= out0 && o <= out1 && d.z >= z0 && d.z <= z1;
}

WildScan draw_scanner(Draws& draws, std::uint64_t seed) {
  WildScan scan;
  scan.seed = seed;
  scan.beam = {draws.number("range_noise"), draws.number("angle_noise"), draws.number("divergence"),
               draws.number("beam_diameter"), draws.number("separation")};
  scan.faults.incidence_bias = draws.number("incidence_bias");
  scan.faults.filtered = draws.is("mixed_pixels", "filtered");
  scan.faults.shift = draws.number("registration_shift");
  scan.faults.turn_deg = draws.number("registration_turn");
  scan.faults.strays = draws.number("stray_points");
  scan.faults.dropouts = draws.number("dropouts");
  scan.faults.returns = static_cast<WildReturns>(draws.whole("returns"));
  scan.faults.intensity = static_cast<WildIntensity>(draws.whole("intensity"));
  scan.faults.intensity_noise = draws.number("intensity_noise");
  scan.faults.gps_time = draws.is("gps_time", "present");
  scan.faults.source_id = draws.is("source_id", "present");
  scan.faults.colour = static_cast<WildColour>(draws.whole("colour"));
  scan.knowledge = static_cast<StationKnowledge>(draws.whole("station_knowledge"));
  scan.steps_given = draws.is("station_steps", "given");
  scan.grid = draws.is("coordinate_grid", "mm") ? 0.001 : 0.0001;
  scan.density = draws.number("density");
  return scan;
}

RecordLayout wild_layout(const WildScan& scan) {
  return scan.faults.colour == WildColour::missing ? uncoloured_layout(scan.grid) : coloured_layout(scan.grid);
}

void scan_wild(const WildScan& scan, const std::function<void(std::span<const std::byte>)>& take) {
  const WildScanner scanner(scan);
  const std::vector<WildGrain> grains = scanner.grains();
  for (std::size_t first = 0; first < grains.size(); first += kGrainsAtOnce) {
    if (stop_requested()) throw Error("interrupted: nothing was written", ExitCode::interrupted);
    std::vector<std::vector<std::byte>> batch(std::min<std::size_t>(kGrainsAtOnce, grains.size() - first));
    parallel_for(batch.size(), [&](std::size_t i) { batch[i] = scanner.scan_grain(grains[first + i]); });
    for (const std::vector<std::byte>& records : batch) take(records);
  }
}

double fit_density(WildScan& scan, std::uint64_t most, std::optional<std::uint64_t> points) {
  scale_wild(scan, std::sqrt(pulses_of(scan) / kPilotPulses));
  const RecordLayout layout = wild_layout(scan);
  PointTally tally;
  scan_wild(scan, [&](std::span<const std::byte> records) { tally.add(records, layout); });
  const double seen = median_density(scan, tally);
  if (tally.points == 0 || !(seen > 0)) throw Error("the scanner sees nothing of the walls of this scene");
  const auto total = static_cast<double>(tally.points);
  double more =
      points ? static_cast<double>(*points) / total : std::min(scan.density / seen, static_cast<double>(most) / total);
  scale_wild(scan, std::sqrt(1 / more));
  return seen * more;
}

}  // namespace ilot::scan
