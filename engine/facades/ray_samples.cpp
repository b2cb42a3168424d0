// SPDX-License-Identifier: Apache-2.0
#include "engine/facades/ray_samples.h"

#include <algorithm>
#include <cmath>

namespace ilot {
namespace {

constexpr double kBin = 0.25;        // metres
constexpr double kAround = 1;        // metres around the wall that bins cover
constexpr double kLowRelief = 0.15;  // metres before the wall, where surrounds of openings end
constexpr double kJoint = 0.04;      // metres behind it, where joints of stone end

Place2 crossing_from(const Vec3& eye, const FacadePoint& p, double depth) {
  const double along = (eye.z - depth) / (eye.z - static_cast<double>(p.w));
  return {eye.x + (static_cast<double>(p.u) - eye.x) * along, eye.y + (static_cast<double>(p.v) - eye.y) * along};
}

// Cells that points of the wall, of what stands out a little, or of its joints cover on all sides: a ray does not pass
// there.
class SolidCells {
 public:
  explicit SolidCells(const FacadeSite& site) : cell_(2 * site.step) {
    columns_ = static_cast<std::int64_t>(site.width / cell_) + 1;
    rows_ = static_cast<std::int64_t>(site.height / cell_) + 1;
    seen_.assign(static_cast<std::size_t>(columns_ * rows_), 0);
    for (const FacadePoint& p : site.points)
      if (p.w >= -std::max(site.epsilon, kJoint) && p.w <= kLowRelief && inside({p.u, p.v})) seen_[at({p.u, p.v})] = 1;
  }
  bool covers(Place2 p) const {
    for (int dv = -1; dv <= 1; ++dv)
      for (int du = -1; du <= 1; ++du) {
        const Place2 q{p.u + du * cell_, p.v + dv * cell_};
        if (!inside(q) || seen_[at(q)] == 0) return false;
      }
    return true;
  }

 private:
  bool inside(Place2 p) const {
    return p.u >= 0 && p.v >= 0 && p.u < static_cast<double>(columns_) * cell_ &&
           p.v < static_cast<double>(rows_) * cell_;
  }
  std::size_t at(Place2 p) const {
    return static_cast<std::size_t>(static_cast<std::int64_t>(p.v / cell_) * columns_ +
                                    static_cast<std::int64_t>(p.u / cell_));
  }
  double cell_;
  std::int64_t columns_, rows_;
  std::vector<std::uint8_t> seen_;
};

}  // namespace

RaySamples::RaySamples(const FacadeSite& site) : site_(site) {
  find_wall();
  choose_stations();
  sort_into_bins();
}

void RaySamples::find_wall() {
  on_wall_.reserve(site_.points.size());
  std::vector<std::uint32_t> parallel;
  for (const ParallelPlane& p : site_.parallel) parallel.push_back(p.id);
  for (const FacadePoint& p : site_.points) {
    const double w = p.w;
    if (std::abs(w) <= site_.epsilon || std::binary_search(site_.wall.begin(), site_.wall.end(), p.plane))
      on_wall_.push_back(kWall);
    else
      on_wall_.push_back(w < 0 && w > -kJoint && std::binary_search(parallel.begin(), parallel.end(), p.plane) ? kBack
                                                                                                               : kNot);
  }
}

void RaySamples::choose_stations() {
  const std::size_t points = site_.points.size();
  const std::size_t stations = std::min<std::size_t>(site_.stations.size(), kStationAside - 1);
  station_.assign(points, 0);
  const bool told = site_.from.size() == points;
  for (std::size_t i = 0; told && i < points; ++i)
    if (site_.from[i] != kStationUnknown) station_[i] = static_cast<SiteStation>(site_.from[i] - 1);
  if (stations < 2) return;
  guessed_ = !told || std::find(site_.from.begin(), site_.from.end(), kStationUnknown) != site_.from.end();
  if (!guessed_) return;
  const SolidCells solid(site_);
  for (std::size_t i = 0; i < points; ++i) {
    if (told && site_.from[i] != kStationUnknown) continue;
    const FacadePoint& p = site_.points[i];
    const Vec3 place{p.u, p.v, p.w};
    double nearest = INFINITY;
    for (std::size_t s = 0; s < stations; ++s) {
      const Vec3& eye = site_.stations[s].position;
      const double far = norm(eye - place);
      if (!(far < nearest) || eye.z <= place.z) continue;
      if (on_wall_[i] == kNot && place.z < -site_.epsilon && solid.covers(crossing_from(eye, p, 0))) continue;
      nearest = far;
      station_[i] = static_cast<SiteStation>(s);
    }
  }
}

const Vec3* RaySamples::eye_of(std::uint32_t point) const {
  if (site_.stations.empty() || station_[point] == kStationAside - 1) return nullptr;
  return &site_.stations[station_[point]].position;
}

Place2 RaySamples::crossing(std::uint32_t point, double depth) const {
  const FacadePoint& p = site_.points[point];
  const Vec3* eye = eye_of(point);
  return eye != nullptr && static_cast<double>(p.w) < eye->z ? crossing_from(*eye, p, depth) : Place2{p.u, p.v};
}

Met RaySamples::met(std::uint32_t point, double depth, double epsilon) const {
  if (depth == 0 && on_wall_[point] == kWall) return Met::solid;
  const double off = static_cast<double>(site_.points[point].w) - depth;
  if (std::abs(off) <= epsilon) return Met::solid;
  return off < 0 ? Met::through : Met::before;
}

std::size_t RaySamples::bin_of(Place2 place) const {
  const auto clamp = [](double v, std::int64_t count) {
    return static_cast<std::int64_t>(std::clamp(std::floor(v / kBin), 0.0, static_cast<double>(count - 1)));
  };
  return static_cast<std::size_t>(clamp(place.v - v0_, rows_) * columns_ + clamp(place.u - u0_, columns_));
}

void RaySamples::sort_into_bins() {
  u0_ = v0_ = -kAround;
  columns_ = static_cast<std::int64_t>((site_.width + 2 * kAround) / kBin) + 1;
  rows_ = static_cast<std::int64_t>((site_.height + 2 * kAround) / kBin) + 1;
  first_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  const auto count = static_cast<std::uint32_t>(site_.points.size());
  for (std::uint32_t i = 0; i < count; ++i) ++first_[bin_of(crossing(i, 0)) + 1];
  for (std::size_t b = 1; b < first_.size(); ++b) first_[b] += first_[b - 1];
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  order_.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) order_[next[bin_of(crossing(i, 0))]++] = i;
}

NearPoints RaySamples::near(const Box2& box) const {
  const std::size_t low = bin_of({box.u0, box.v0}), high = bin_of({box.u1, box.v1});
  const auto columns = static_cast<std::size_t>(columns_);
  return {order_.data(), first_.data() + low, high / columns - low / columns + 1, high % columns - low % columns + 1,
          columns};
}

Place2 RaySamples::step_at(Place2 place) const {
  Place2 finest{INFINITY, INFINITY};
  for (const FacadeStation& s : site_.stations) {
    if (!(s.azimuth_step > 0) || !(s.elevation_step > 0)) continue;
    const double across = s.position.z, along = place.u - s.position.x, up = place.v - s.position.y;
    const double level2 = across * across + along * along, level = std::sqrt(level2);
    finest.u = std::min(finest.u, s.azimuth_step * level2 / across);
    finest.v = std::min(finest.v, s.elevation_step * (level2 + up * up) / level);
  }
  return finest.u < INFINITY ? finest : Place2{site_.step, site_.step};
}

}  // namespace ilot
