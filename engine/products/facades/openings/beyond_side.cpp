// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/beyond_side.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "kernels/core/quantile.h"

namespace ilot {
namespace {

// Choice: the board below a shop window is half a metre high; a blind that is down covers half of a window of 2 m.
constexpr double kFarthest = 1.2;  // metres beyond the side that are looked at
// Derived: at least one row of rays.
constexpr double kBandSteps = 1.5, kLeastBand = 0.1;  // steps, and metres
// Choice: rounded arrises and mixed pixels within 4 cm; piers and surrounds are as narrow as 25 cm.
constexpr double kBesideFrom = 0.04, kBesideTo = 0.25;  // metres beside the opening where its wall is measured
// Choice: the height of a plinth.
constexpr double kAlong = 0.6;   // metres of the wall beside the opening itself
constexpr double kInset = 0.05;  // Choice: as kBesideFrom; metres of the opening's own ends that are left out
// Choice: a board stands up to 6 cm before the panes, and twice the noise of 2 cm is added; balconies reach farther.
constexpr double kNearWall = 0.12;  // metres before and behind the wall
// Derived: three standard deviations; medians scatter by 1.25 times as much as means.
constexpr double kCertain = 3 * 1.25;
// Choice: joints, plaster and stones are uneven by 3 mm.
constexpr double kLeastOff = 0.004;  // metres
// Choice: walls bow by a centimetre from one window to the next.
constexpr double kLeastOffAlone = 0.01;  // metres, where no wall is seen beside the panel
// Choice: fewer points may be strays.
constexpr std::size_t kFewestInBand = 4, kFewestBeside = 8;
// Choice: sills and lintels stand out too, and are lower.
constexpr double kLeastBefore = 0.25;  // metres high: what stands before the wall and is lower is no panel
// Derived: of five points that a place should have, none is there by chance once in 150 times.
constexpr double kExpected = 5;       // points of the wall in a band
constexpr double kLeastUnseen = 0.2;  // Choice: two cells of most walls; metres

struct Strips {
  double band = 0;                            // metres
  std::vector<std::vector<double>> middle;    // distances from the wall, band by band
  std::array<std::vector<double>, 2> beside;  // of what is beside it, at the two ends of the side
  std::array<std::vector<double>, 2> along;   // of what is beside the opening itself
};

Strips strips_beyond(const RaySamples& samples, const Box2& box, Side side) {
  const bool u = along_u(side);
  const double at = side == Side::left ? box.u0 : side == Side::right ? box.u1 : side == Side::top ? box.v1 : box.v0;
  const double s0 = u ? box.v0 : box.u0, s1 = u ? box.v1 : box.u1;
  Strips out;
  out.band = std::max(kLeastBand, kBandSteps * samples.site().step);
  out.middle.resize(static_cast<std::size_t>(std::ceil(kFarthest / out.band)));
  Box2 strip = box;
  (side == Side::left    ? strip.u0
   : side == Side::right ? strip.u1
   : side == Side::top   ? strip.v1
                         : strip.v0) += outwards(side) * kFarthest;
  for (const Ray& ray : samples.near(strip.grown(kBesideTo))) {
    const Place2 p = samples.crossing(ray, 0);
    const double t = outwards(side) * ((u ? p.u : p.v) - at), s = u ? p.v : p.u, w = ray.at.w;
    if (t < -kAlong || t >= out.band * static_cast<double>(out.middle.size()) || std::abs(w) > kNearWall) continue;
    if (t >= 0 && s > s0 + kInset && s < s1 - kInset) out.middle[static_cast<std::size_t>(t / out.band)].push_back(w);
    if (s < s0 - kBesideFrom && s > s0 - kBesideTo) (t < 0 ? out.along : out.beside)[0].push_back(w);
    if (s > s1 + kBesideFrom && s < s1 + kBesideTo) (t < 0 ? out.along : out.beside)[1].push_back(w);
  }
  return out;
}

// What lies beside a panel: the medians of the strips that have enough points.
struct Beside {
  std::vector<double> levels;
  std::size_t fewest = 0;
  double moved = 0;  // the largest difference between what is beside the panel and what is beside the opening
};

Beside beside_of(Strips& strips) {
  Beside out;
  for (std::size_t k = 0; k < strips.beside.size(); ++k) {
    if (strips.beside[k].size() < kFewestBeside) continue;
    out.fewest = out.levels.empty() ? strips.beside[k].size() : std::min(out.fewest, strips.beside[k].size());
    out.levels.push_back(upper_median(strips.beside[k]));
    if (strips.along[k].size() < kFewestBeside) continue;
    out.moved = std::max(out.moved, std::abs(out.levels.back() - upper_median(strips.along[k])));
  }
  return out;
}

enum class Seen : std::uint8_t { wall, panel_behind, panel_before };

// What the points of one band show.
Seen seen_in(double middle, std::size_t points, const Beside& beside, double wall_depth, double noise) {
  const double share =
      1 / static_cast<double>(points) + (beside.fewest > 0 ? 1 / static_cast<double>(beside.fewest) : 0);
  const double sure = std::max(kLeastOff, kCertain * noise * std::sqrt(share)), off = middle - wall_depth;
  const bool differs = std::all_of(beside.levels.begin(), beside.levels.end(),
                                   [&](double level) { return std::abs(middle - level) > sure; });
  const bool off_wall = std::abs(off) > (beside.levels.empty() ? std::max(sure, kLeastOffAlone) : sure);
  if (!differs || (!off_wall && beside.moved <= sure)) return Seen::wall;
  return off > sure ? Seen::panel_before : Seen::panel_behind;
}

// How many points of the wall a band has where nothing hides it.
double expected_in(const Strips& strips, const RaySamples& samples, const Box2& box, Side side) {
  const double length = (along_u(side) ? box.height() : box.width()) - 2 * kInset, step = samples.site().step;
  return std::max(0.0, length) * strips.band / (step * step);
}

// Metres from the side to the end of the wall in that direction.
double to_end_of_wall(const FacadeSite& site, const Box2& box, Side side) {
  if (side == Side::left) return box.u0;
  if (side == Side::bottom) return box.v0;
  return side == Side::right ? site.width - box.u1 : site.height - box.v1;
}

}  // namespace

double panel_beyond(const RaySamples& samples, const Box2& box, double wall_depth, Side side) {
  Strips strips = strips_beyond(samples, box, side);
  const Beside beside = beside_of(strips);
  const double within = to_end_of_wall(samples.site(), box, side);
  const bool expected = expected_in(strips, samples, box, side) >= kExpected;
  double reach = 0, unseen = 0;
  bool before = false;
  for (std::size_t k = 0; k < strips.middle.size(); ++k) {
    std::vector<double>& band = strips.middle[k];
    const double end = strips.band * static_cast<double>(k + 1);
    if (end > within && band.empty()) break;
    if (band.size() < kFewestInBand) {
      if (expected && band.empty()) unseen += strips.band;
      continue;
    }
    const Seen seen = seen_in(upper_median(band), band.size(), beside, wall_depth, samples.site().noise);
    if (seen == Seen::wall) {
      if (unseen >= kLeastUnseen) reach = end;
      break;
    }
    before |= seen == Seen::panel_before;
    reach = end;
  }
  return before && (side != Side::bottom || reach < kLeastBefore) ? 0 : reach;
}

}  // namespace ilot
