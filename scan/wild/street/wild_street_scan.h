// SPDX-License-Identifier: Apache-2.0
// The scene `street-wild`: a street that is drawn from wide distributions, seen from a vehicle, from tripods or from
// the air.
#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "scan/scanners/airborne.h"
#include "scan/scenes.h"
#include "scan/wild/street/wild_tracer.h"

namespace ilot::scan {

std::span<const SceneOption> wild_street_options();
extern const std::array<std::string_view, 1> kWildStreetGroups;

// How the street is seen.
struct WildStreetScanner {
  Platform platform = Platform::vehicle;
  WildBeam beam;
  double density =
      500;  // points per square metre of the road below the scanner, or pulses per square metre from the air
  // vehicle
  double lane = -1.5, height = 2.3, turned_deg = 40, blind_deg = 20, speed = 7, shape = 1;
  int heads = 2, passes = 1;
  double pass_shift = 0, wander = 0;  // metres
  // tripod
  std::vector<Vec3> stations;
  double sweep = 240;  // seconds
  // air
  AirborneParams flight;
  // What is left of the points.
  std::optional<double> cut;  // metres above the street
  bool colour = true, intensity = true, classes = true;
  double wrong_classes = 0, stray = 0;
  double s0 = 0, s1 = 0, half_width = 60;
};

struct WildStreetScan {
  WildStreet street;
  std::vector<WildObject> objects;
  WildStreetModel model;
  WildStreetScanner scanner;
  std::uint64_t seed = 0;
};

// Draws a street and how it is scanned. `points` is the most that the cloud should have.
WildStreetScan plan_wild_street_scan(Draws& draws, std::uint64_t seed, std::uint64_t points);

// Scales the density so that the scan has about this number of points, if it has more, or if `exactly`.
void fit_wild_points(WildStreetScan& scan, std::uint64_t points, bool exactly);

std::vector<WildMotion> motions_of(const WildStreetScan& scan);

// The pulses in grains of bounded size that can be made in any order.
class StreetPulses {
 public:
  explicit StreetPulses(const WildStreetScan& scan);
  ~StreetPulses();
  std::size_t grains() const;
  void visit(std::size_t grain, const std::function<void(StreetPulse&)>& visit) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Passes records of coloured_layout(0.001) to `take`. Grains are made in parallel, in batches of bounded size. The
// result does not depend on the threads.
void scan_wild_street(const WildStreetScan& scan, const std::function<void(std::span<const std::byte>)>& take);

// Returns for each object the share of the rays from the scanner to it that something hides.
std::vector<double> hidden_shares(const WildStreetScan& scan);

// Writes the cloud and NAME.truth.json.
ScanCounts scan_wild_street_scene(const ScanRequest& request);

}  // namespace ilot::scan
