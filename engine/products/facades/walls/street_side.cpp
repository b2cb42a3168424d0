// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/street_side.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

// Choice: a third of a window; what is seen in one bin says little about the next.
constexpr double kBin = 0.25;  // metres along the wall
// Choice: ground is looked for as near to the wall as narrow crops keep it; a kerb is farther away or lower.
constexpr double kGroundReach = 1.5;  // metres off the wall
// Derived: two cubes of the sample, one beside the other: a pane at the foot of the wall is one cube deep, ground more.
constexpr double kGroundDepth = 0.12, kGroundFlat = 0.15;  // metres off the wall, and upwards
// Choice: thresholds and floors are higher above the street.
constexpr double kGroundUp = 0.3;  // metres above the lowest points around
// Choice: the lowest points of 2 m on both sides, on slopes of a tenth, are those of the ground.
constexpr std::size_t kAroundBins = 8;
// Choice: streets rise by less; steeper ones lose ground at the lower end.
constexpr double kSlope = 0.1;
// Choice: yards and basements that are seen past the wall lie lower.
constexpr double kDeepest = 3;  // metres below the foot of the wall: lower points are no street before it
// Choice: a storey is higher, and the ground falls by less in the depth of a sample.
constexpr double kHanging = 1;  // metres: level points with something that far below them are the underside of a storey
// Choice: lower than most sills; doors are open there.
constexpr double kFootHeight = 0.6;  // metres
// Choice: roots of plants and dirt hide less of a foot.
constexpr double kClosed = 0.7;  // share of the foot of a bin that is solid
// Choice: eaves and balconies stand out less than roofs reach back.
constexpr double kRoofFrom = 0.8, kRoofUp = 0.15;  // metres off the wall; above its top
// Choice: panes, reveals and frames are nearer; what is farther behind was often seen past the wall.
constexpr double kNear = 0.5;  // metres off the wall
// Choice: walls of the same house that meet it at a corner, and downpipes, are no evidence.
constexpr double kEnd = 0.3;              // metres from the ends of the wall
constexpr std::size_t kMostTested = 512;  // points on each side: a bound of time
// Choice: tripods and vehicles stand so; a scanner on a roof is not among them. Places for stations: shares of the
// width along the wall, metres above its foot, metres off it.
constexpr std::array kAlong{-1.0, -0.5, -0.25, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.25, 1.5, 2.0};
constexpr std::array kUp{0.5, 1.7, 3.0};
constexpr std::array kOut{2.5, 4.0, 6.5, 10.0, 16.0, 30.0};
// Measured: logistic regression without a constant on 140 walls of wild scenes (facade-wild 0 to 39, row-wild and
// court-wild 0 to 9), L2 penalty 0.02.
constexpr double kGroundWeight = 2.22, kBeyondWeight = 1.7, kBlockedWeight = 2.23;
// Choice: shares below these floors are a few bins or points, by chance.
constexpr double kShareFloor = 0.1, kBlockedFloor = 0.03;

// Choice: hardly anything; a street has ground, and its reliefs cover the wall. The odds are those of twenty to one.
constexpr double kOneSided = 0.95, kLittleGround = 0.2, kLittleBlocked = 0.3, kOneSidedOdds = 3;
// Choice: a few stray points; the most that lay before a wall of a wild street, without anything behind it, was 97 %.
constexpr double kAllBehind = 0.985;

using Bins = std::array<std::vector<double>, 2>;  // a value per bin along the wall and side; side 0 has w > 0

std::size_t side_of(const Vec3& p) {
  return p.z > 0 ? 0 : 1;
}

struct Profile {
  std::vector<double> foot, top;  // metres; infinite where the wall has no points
  std::size_t bins() const { return foot.size(); }
  std::size_t at(double u) const { return std::min(bins() - 1, static_cast<std::size_t>(u / kBin)); }
};

Profile profile_of(const WallSample& s) {
  const auto bins = static_cast<std::size_t>(s.width / kBin) + 1;
  Profile p{std::vector<double>(bins, INFINITY), std::vector<double>(bins, -INFINITY)};
  for (std::int64_t r = 0; r < s.rows; ++r)
    for (std::int64_t c = 0; c < s.columns; ++c) {
      if (!s.seen(r, c)) continue;
      const std::size_t b = p.at((static_cast<double>(c) + 0.5) * s.cell);
      p.foot[b] = std::min(p.foot[b], static_cast<double>(r) * s.cell);
      p.top[b] = std::max(p.top[b], static_cast<double>(r + 1) * s.cell);
    }
  return p;
}

bool along_wall(const WallSample& s, const Vec3& p) {
  return p.x >= 0 && p.x < s.width;
}

// The height up to which points may be ground, per bin: a little above the lowest points around it.
std::vector<double> ground_limit(const WallSample& s, const Profile& profile) {
  std::vector<double> low = profile.foot, limit = profile.foot;
  for (const Vec3& p : s.off)
    if (along_wall(s, p) && std::abs(p.z) < kGroundReach && p.y > -kDeepest)
      low[profile.at(p.x)] = std::min(low[profile.at(p.x)], p.y);
  for (std::size_t b = 0; b < low.size(); ++b)
    for (std::size_t k = b - std::min(b, kAroundBins); k < std::min(low.size(), b + kAroundBins + 1); ++k) {
      const double away = static_cast<double>(std::max(b, k) - std::min(b, k)) * kBin;
      limit[b] = std::min(limit[b], low[k] + kSlope * away);
    }
  for (double& l : limit) l += kGroundUp;
  return limit;
}

// Whether the wall is closed where it meets the ground, per bin: what lies behind it there cannot be seen.
std::vector<std::uint8_t> closed_feet(const WallSample& s, const Profile& profile) {
  std::vector<std::size_t> solid(profile.bins(), 0), all(profile.bins(), 0);
  for (std::int64_t c = 0; c < s.columns; ++c) {
    const double u = (static_cast<double>(c) + 0.5) * s.cell;
    const std::size_t b = profile.at(u);
    for (double v = profile.foot[b] + s.cell; v < profile.foot[b] + kFootHeight; v += s.cell) {
      ++all[b];
      solid[b] += s.solid(u, v);
    }
  }
  std::vector<std::uint8_t> closed(profile.bins(), 0);
  for (std::size_t b = 0; b < closed.size(); ++b)
    closed[b] = static_cast<double>(solid[b]) >= kClosed * static_cast<double>(all[b]) && all[b] > 0;
  return closed;
}

// The share of the bins where low points lie level and reach away from the closed wall, for each side.
std::array<double, 2> ground_shares(const WallSample& s, const Profile& profile) {
  const std::vector<double> limit = ground_limit(s, profile);
  const auto each = [&](double value) {
    return Bins{std::vector<double>(profile.bins(), value), std::vector<double>(profile.bins(), value)};
  };
  Bins lowest = each(INFINITY), near = each(INFINITY), far = each(-INFINITY);
  const auto low_points = [&](const auto& take) {
    for (const Vec3& p : s.off)
      if (along_wall(s, p) && std::abs(p.z) < kGroundReach && p.y < limit[profile.at(p.x)])
        take(side_of(p), profile.at(p.x), p);
  };
  low_points([&](std::size_t side, std::size_t b, const Vec3& p) {
    if (std::abs(p.z) < kGroundReach * 2 / 3) lowest[side][b] = std::min(lowest[side][b], p.y);
  });
  low_points([&](std::size_t side, std::size_t b, const Vec3& p) {
    if (p.y > lowest[side][b] + kGroundFlat || !(lowest[side][b] < INFINITY)) return;
    near[side][b] = std::min(near[side][b], std::abs(p.z));
    far[side][b] = std::max(far[side][b], std::abs(p.z));
  });
  Bins deepest = each(INFINITY);
  for (const Vec3& p : s.off)
    if (along_wall(s, p)) deepest[side_of(p)][profile.at(p.x)] = std::min(deepest[side_of(p)][profile.at(p.x)], p.y);
  std::array<double, 2> share{};
  const std::vector<std::uint8_t> closed = closed_feet(s, profile);
  const double bins = std::accumulate(closed.begin(), closed.end(), 0.0);
  for (std::size_t side = 0; side < 2; ++side)
    for (std::size_t b = 0; b < profile.bins(); ++b)
      share[side] += (closed[b] != 0 && far[side][b] - near[side][b] > kGroundDepth &&
                      deepest[side][b] > lowest[side][b] - kHanging) /
                     std::max(1.0, bins);
  return share;
}

// The share of the bins where something rises above the wall behind it, if the street is on the side.
std::array<double, 2> beyond_shares(const WallSample& s, const Profile& profile) {
  std::array<std::vector<std::uint8_t>, 2> rises{std::vector<std::uint8_t>(profile.bins(), 0),
                                                 std::vector<std::uint8_t>(profile.bins(), 0)};
  for (const Vec3& p : s.off) {
    if (!along_wall(s, p) || std::abs(p.z) < kRoofFrom) continue;
    const std::size_t b = profile.at(p.x);
    if (profile.foot[b] < INFINITY && p.y > profile.top[b] + kRoofUp) rises[1 - side_of(p)][b] = 1;
  }
  std::array<double, 2> share{};
  for (std::size_t side = 0; side < 2; ++side) {
    for (const std::uint8_t r : rises[side]) share[side] += r;
    share[side] /= static_cast<double>(profile.bins());
  }
  return share;
}

// How much of the points a station at the place could not have seen, in halves: a ray past an end of the wall or over
// it may have met a neighbour.
std::uint64_t blocked_from(const WallSample& s, std::span<const Vec3> points, const Vec3& eye) {
  std::uint64_t halves = 0;
  for (const Vec3& p : points) {
    const double along = eye.z / (eye.z - p.z);
    const double u = eye.x + along * (p.x - eye.x), v = eye.y + along * (p.y - eye.y);
    if (v < 0 || s.solid(u, v))
      halves += 2;
    else if (u < 0 || u > s.width || v > s.height)
      halves += 1;
  }
  return halves;
}

// The share of the points behind the wall that the best place for a station on one side leaves blocked.
double blocked_share(const WallSample& s, std::size_t street) {
  std::vector<Vec3> behind;
  for (const Vec3& p : s.off)
    if (p.x >= kEnd && p.x < s.width - kEnd && p.y <= s.height && std::abs(p.z) < kNear && side_of(p) != street)
      behind.push_back(p);
  if (behind.empty()) return 0;
  if (behind.size() > kMostTested) {
    for (std::size_t i = 0; i < kMostTested; ++i) behind[i] = behind[i * behind.size() / kMostTested];
    behind.resize(kMostTested);
  }
  std::uint64_t least = 2 * behind.size();
  for (const double u : kAlong)
    for (const double v : kUp)
      for (const double w : kOut)
        least = std::min(least, blocked_from(s, behind, {u * s.width, v, street == 0 ? w : -w}));
  return static_cast<double>(least) / (2 * static_cast<double>(behind.size()));
}

// The share of all points off the wall that lie behind it, if the street is on the side.
std::array<double, 2> behind_shares(const WallSample& s) {
  double count[2] = {0, 0};
  for (const Vec3& p : s.off)
    if (along_wall(s, p) && p.y >= 0 && p.y <= s.height) count[1 - side_of(p)] += 1;
  const double all = std::max(1.0, count[0] + count[1]);
  return {count[0] / all, count[1] / all};
}

}  // namespace

SideEvidence side_evidence(const WallSample& sample) {
  const Profile profile = profile_of(sample);
  SideEvidence e;
  e.ground = ground_shares(sample, profile);
  e.beyond = beyond_shares(sample, profile);
  e.blocked = {blocked_share(sample, 0), blocked_share(sample, 1)};
  e.behind = behind_shares(sample);
  return e;
}

double street_log_odds(const SideEvidence& e) {
  const auto ratio = [](double a, double b, double floor) { return natural_log((a + floor) / (b + floor)); };
  // An object that was scanned all around, or a cloud that was cut to the wall: all that is not wall lies behind it.
  const auto one_sided = [&](std::size_t street) {
    return e.behind[street] >= kOneSided && e.ground[1 - street] < kLittleGround && e.blocked[street] < kLittleBlocked;
  };
  // Nothing at all before the wall: what is behind it was seen from all around, not through it.
  for (const std::size_t street : {0, 1})
    if (e.behind[street] >= kAllBehind && e.ground[1 - street] < kLittleGround)
      return street == 0 ? kOneSidedOdds : -kOneSidedOdds;
  const double alone = kOneSidedOdds * (one_sided(0) - one_sided(1));
  return alone + kGroundWeight * ratio(e.ground[0], e.ground[1], kShareFloor) +
         kBeyondWeight * ratio(e.beyond[0], e.beyond[1], kShareFloor) +
         kBlockedWeight * ratio(e.blocked[1], e.blocked[0], kBlockedFloor);
}

}  // namespace ilot
