// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/streets/kerb_errors.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ilot {
namespace {

constexpr double kStep = 0.25;             // metres between places
constexpr double kNear = 0.5;              // metres between partners
constexpr double kLeastStep = 0.03;        // metres; lower kerbs are not judged
constexpr std::uint64_t kLeastOfSide = 5;  // Choice: with fewer points nobody can tell a step

// A place on a polyline, and the nearest of several.
struct OnLine {
  Vec3 at;
  double share = 0;  // of the way from vertex `segment` to the next
  std::size_t segment = 0;
};

template <class Take>
void for_places(const std::vector<Vec3>& line, double metres, const Take& take) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec3 d = line[i + 1] - line[i];
    const double length = std::hypot(d.x, d.y) * metres;
    const auto steps = static_cast<std::size_t>(std::ceil(length / kStep));
    for (std::size_t k = 0; k < steps; ++k) {
      const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(steps);
      take(OnLine{line[i] + share * d, share, i}, length / static_cast<double>(steps), d);
    }
  }
}

// The nearest place of lines to a point in plan, within kNear.
template <class Lines, class LineOf>
std::optional<std::pair<std::size_t, OnLine>> nearest(const Lines& lines, const LineOf& line_of, Vec3 p,
                                                      double metres) {
  std::optional<std::pair<std::size_t, OnLine>> best;
  double least = kNear / metres;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const std::vector<Vec3>* line = line_of(lines[l]);
    for (std::size_t i = 0; line != nullptr && i + 1 < line->size(); ++i) {
      const Vec3 a = (*line)[i], d = (*line)[i + 1] - a;
      const double square = d.x * d.x + d.y * d.y;
      const double t = square > 0 ? std::clamp(((p.x - a.x) * d.x + (p.y - a.y) * d.y) / square, 0.0, 1.0) : 0;
      const Vec3 at = a + t * d;
      const double distance = std::hypot(at.x - p.x, at.y - p.y);
      if (distance <= least) least = distance, best = {l, {at, t, i}};
    }
  }
  return best;
}

}  // namespace

KerbSight::KerbSight(std::span<const TrueKerb> kerbs, double metres_per_unit) : metres_(metres_per_unit) {
  for (const TrueKerb& kerb : kerbs)
    for_places(kerb.line, metres_, [&](const OnLine& on, double length_m, Vec3 d) {
      const double length = std::max(1e-12, std::hypot(d.x, d.y));
      grid_[cell_of(on.at.x, on.at.y)].push_back(places_.size());
      places_.push_back({on.at, length_m, d.x / length, d.y / length, kerb.height_m});
    });
}

std::pair<std::int64_t, std::int64_t> KerbSight::cell_of(double x, double y) const {
  return {static_cast<std::int64_t>(std::floor(x * metres_ / kNear)),
          static_cast<std::int64_t>(std::floor(y * metres_ / kNear))};
}

bool KerbSight::Place::is_seen() const {
  return height_m >= kLeastStep && std::min(left, right) >= kLeastOfSide;
}

void KerbSight::add(Vec3 p) {
  const auto [u, v] = cell_of(p.x, p.y);
  for (std::int64_t b = v - 1; b <= v + 1; ++b)
    for (std::int64_t a = u - 1; a <= u + 1; ++a)
      if (const auto found = grid_.find({a, b}); found != grid_.end())
        for (const std::size_t i : found->second) {
          Place& place = places_[i];
          const double dx = (p.x - place.at.x) * metres_, dy = (p.y - place.at.y) * metres_;
          if (dx * dx + dy * dy > kNear * kNear) continue;
          ++(place.along_x * dy - place.along_y * dx > 0 ? place.left : place.right);
        }
}

KerbResult evaluate_kerbs(const KerbSight& sight, std::span<const TrueKerb> truth, std::span<const StreetKerb> found,
                          double metres_per_unit) {
  KerbResult result;
  const auto seen_line = [](const StreetKerb& k) { return k.seen ? &k.line : nullptr; };
  const auto true_line = [](const TrueKerb& k) { return &k.line; };
  double complete = 0, correct = 0, bridged = 0;
  std::vector<double> plan, height, elevation;
  for (const KerbSight::Place& place : sight.places()) {
    if (!place.is_seen()) {
      result.unseen_m += place.length_m;
      continue;
    }
    result.true_m += place.length_m;
    complete += nearest(found, seen_line, place.at, metres_per_unit) ? place.length_m : 0;
  }
  for (const StreetKerb& kerb : found)
    for_places(kerb.line, metres_per_unit, [&](const OnLine& on, double length, Vec3) {
      const auto partner = nearest(truth, true_line, on.at, metres_per_unit);
      (kerb.seen ? result.found_m : result.bridged_m) += length;
      if (!partner) return;
      (kerb.seen ? correct : bridged) += length;
      const TrueKerb& t = truth[partner->first];
      if (!kerb.seen || t.height_m < kLeastStep) return;
      const Vec3 at = partner->second.at;
      plan.push_back(std::hypot(at.x - on.at.x, at.y - on.at.y) * metres_per_unit);
      elevation.push_back((at.z - on.at.z) * metres_per_unit);
      const double h =
          kerb.heights_m[on.segment] + on.share * (kerb.heights_m[on.segment + 1] - kerb.heights_m[on.segment]);
      height.push_back(h - t.height_m);
    });
  result.complete = result.true_m > 0 ? complete / result.true_m : 0;
  result.correct = result.found_m > 0 ? correct / result.found_m : 0;
  result.bridged_correct = result.bridged_m > 0 ? bridged / result.bridged_m : 0;
  result.plan = sizes_of(plan), result.height = sizes_of(height), result.elevation = sizes_of(elevation);
  return result;
}

}  // namespace ilot
