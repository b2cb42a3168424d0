// SPDX-License-Identifier: Apache-2.0
// The scanner of the wild scenes: pulses with a footprint from tripods or a vehicle, and everything that spoils a scan
// between the wall and the file.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scan/scanners/scan_record.h"
#include "scan/scanners/terrestrial.h"
#include "scan/wild/draws.h"
#include "scan/wild/facade/wild_pulses.h"

namespace ilot::scan {

enum class WildColour : std::uint8_t { sixteen_bit, eight_bit, missing };
enum class WildIntensity : std::uint8_t { received, corrected, missing };
enum class WildReturns : std::uint8_t { all, first, unnumbered };
enum class StationKnowledge : std::uint8_t { known, near, unknown };

// What happens to points on their way into the file.
struct WildFaults {
  double incidence_bias = 0;  // metres at 45 degrees of incidence
  bool filtered = false;      // points between two surfaces are removed
  double shift = 0;           // metres: standard deviation of a station's place along each axis
  double turn_deg = 0;        // standard deviation of its rotation about each axis
  double strays = 0;          // share of pulses with one echo from the air in front of what they would meet
  double dropouts = 0;        // share of pulses that are lost
  WildReturns returns = WildReturns::all;
  WildIntensity intensity = WildIntensity::received;
  double intensity_noise = 0;  // standard deviation in shares of the intensity
  bool gps_time = true, source_id = true;
  WildColour colour = WildColour::sixteen_bit;
};

// A box with the directions of a frame. Points outside are removed, as an office cuts a part out of its scan.
struct WildCrop {
  Vec3 origin, along{1, 0, 0}, out{0, -1, 0};
  double x0 = 0, x1 = 0, out0 = 0, out1 = 0, z0 = -6, z1 = 60;
  bool contains(Vec3 p) const;
};

struct WildScan {
  TerrestrialScene
      scene;  // `keep` is not used; its stations are those of the scan; none when a vehicle carries the scanner
  WildCrop crop;
  std::optional<WildDrive> drive;
  BeamParams beam;
  WildFaults faults;
  StationKnowledge knowledge = StationKnowledge::known;
  bool steps_given = true;
  std::uint8_t stray_class = 0;
  double density = 1000;  // points per square metre of wall that are wished for
  double grid = 0.0001;
  std::uint64_t seed = 0;
  TrueDraws drawn;
};

// Returns a scan with all that rows of the group `scanner` decide. The scene, its stations or drive are added by the
// caller.
WildScan draw_scanner(Draws& draws, std::uint64_t seed);

// Scans in grains of fixed size on the threads of the calling arena, and passes the records of wild_layout() to `take`
// in order. The result does not depend on the number of threads.
void scan_wild(const WildScan& scan, const std::function<void(std::span<const std::byte>)>& take);

RecordLayout wild_layout(const WildScan& scan);

// Scales the angular steps (and the profiles of a vehicle) so that the median density over the walls that are seen
// (planes of the class `facade` with an area) is scan.density, but at most `most` points are expected, or about
// `points` points where this is given. Returns the density that the scan will have. A sparse scan of the same scene is
// counted to do so.
double fit_density(WildScan& scan, std::uint64_t most, std::optional<std::uint64_t> points);

}  // namespace ilot::scan
