// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/rays/ray_samples.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/products/facades/rays/ray_groups.h"

namespace ilot {
namespace {

// Choice: a bin has some hundreds of points; time alone depends on it.
constexpr double kBin = 0.25;  // metres
// Derived: a bound of memory.
constexpr double kMostBins = 1 << 17;               // the bins of a larger wall are larger
constexpr std::uint64_t kSortedTogether = 1 << 16;  // rays in memory at once
// Choice: elements reach beyond a wall by less; farther ones are not completed.
constexpr double kAround = 1;  // metres around the wall that bins cover
// Choice: the value of kSurround in arched_top.cpp.
constexpr double kLowRelief = 0.15;  // metres before the wall at which surrounds of openings end
// Choice: the value of kJoint in facade_labels.cpp.
constexpr double kJoint = 0.04;  // metres behind the wall at which joints of stone end

Place2 crossing_from(const Vec3& eye, const FacadePoint& p, double depth) {
  const double along = (eye.z - depth) / (eye.z - static_cast<double>(p.w));
  return {eye.x + (static_cast<double>(p.u) - eye.x) * along, eye.y + (static_cast<double>(p.v) - eye.y) * along};
}

// Cells that are covered on all sides by points of the wall, of low relief or of joints: no ray passes through them.
// One bit per cell.
class SolidCells {
 public:
  explicit SolidCells(const FacadeSite& site)
      : cell_(2 * site.step),
        nearest_(-std::max(site.epsilon, kJoint)),
        columns_(static_cast<std::int64_t>(site.width / cell_) + 1),
        rows_(static_cast<std::int64_t>(site.height / cell_) + 1),
        seen_(static_cast<std::size_t>(columns_ * rows_), false) {}
  void add(const FacadePoint& p) {
    if (p.w >= nearest_ && p.w <= kLowRelief && inside({p.u, p.v})) seen_[at({p.u, p.v})] = true;
  }
  bool covers(Place2 p) const {
    for (int dv = -1; dv <= 1; ++dv)
      for (int du = -1; du <= 1; ++du) {
        const Place2 q{p.u + du * cell_, p.v + dv * cell_};
        if (!inside(q) || !seen_[at(q)]) return false;
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
  double cell_, nearest_;
  std::int64_t columns_, rows_;
  std::vector<bool> seen_;
};

// The station of a ray whose station is not recorded: the nearest one that does not see it through the wall.
SiteStation guessed_station(const FacadeSite& site, const SolidCells& solid, const Ray& ray, bool on_wall) {
  const FacadePoint& p = ray.at;
  const Vec3 place{p.u, p.v, p.w};
  const std::size_t stations = std::min<std::size_t>(site.stations.size(), kStationNotInFront - 1);
  SiteStation best = 0;
  double nearest = INFINITY;
  for (std::size_t s = 0; s < stations; ++s) {
    const Vec3& eye = site.stations[s].position;
    const double far = norm(eye - place);
    if (!(far < nearest) || eye.z <= place.z) continue;
    if (!on_wall && place.z < -site.epsilon && solid.covers(crossing_from(eye, p, 0))) continue;
    nearest = far;
    best = static_cast<SiteStation>(s);
  }
  return best;
}

FacadePointSource points_of(const FacadeSite& site) {
  return [&site](const TakeFacadePoints& take) {
    const bool known = site.from.size() == site.points.size();
    take(site.points, known ? std::span<const SiteStation>(site.from) : std::span<const SiteStation>());
  };
}

}  // namespace

RaySamples::RaySamples(const FacadeSite& site) : site_(site) {
  make(points_of(site));
}

RaySamples::RaySamples(const FacadeSite& site, const FacadePointSource& source, RayRoom room, FarPointSource far)
    : site_(site), room_(std::move(room)), far_(std::move(far)) {
  make(source);
}

void RaySamples::make(const FacadePointSource& source) {
  segments_ = site_.wall;
  for (const ParallelPlane& p : site_.parallel) segments_.push_back(p.id);
  std::sort(segments_.begin(), segments_.end());
  segments_.erase(std::unique(segments_.begin(), segments_.end()), segments_.end());
  const double width = site_.width + 2 * kAround, height = site_.height + 2 * kAround;
  bin_ = std::max(kBin, std::sqrt(width * height / kMostBins));
  u0_ = v0_ = -kAround;
  columns_ = static_cast<std::int64_t>(width / bin_) + 1;
  rows_ = static_cast<std::int64_t>(height / bin_) + 1;
  bins_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, {});
  const RayColumn rays = taken(source);
  sort_by_place(rays);
  sort_by_segment(rays);
}

std::uint8_t RaySamples::part_of(const FacadePoint& p) const {
  const double w = p.w;
  if (std::abs(w) <= site_.epsilon || std::binary_search(site_.wall.begin(), site_.wall.end(), p.plane)) return kWall;
  const auto by_id = [](const ParallelPlane& a, const ParallelPlane& b) { return a.id < b.id; };
  const bool parallel =
      w < 0 && w > -kJoint &&
      std::binary_search(site_.parallel.begin(), site_.parallel.end(), ParallelPlane{p.plane, 0}, by_id);
  return parallel ? kBack : kNot;
}

// Takes all points as rays, in the order of the source.
RayColumn RaySamples::taken(const FacadePointSource& source) {
  constexpr SiteStation kStationUndecided = kStationNotInFront;  // this value is no index of a station
  const bool one_of_many = site_.stations.size() >= 2;
  std::optional<SolidCells> solid;
  if (one_of_many) solid.emplace(site_);
  RayColumn rays = new_column();
  source([&](std::span<const FacadePoint> points, std::span<const SiteStation> from) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      Ray ray{points[i], 0, part_of(points[i])};
      const bool known = !from.empty() && from[i] != kStationUnknown;
      if (known) ray.station = static_cast<SiteStation>(from[i] - 1);
      if (!known && one_of_many) ray.station = kStationUndecided, guessed_ = true;
      if (solid) solid->add(ray.at);
      points_on_wall_ += std::abs(static_cast<double>(ray.at.w)) <= site_.epsilon;
      rays.add(ray);
    }
  });
  rays.finish();
  if (!guessed_) return rays;
  std::vector<Ray> piece;
  for (std::uint64_t first = 0; first < rays.size(); first += piece.size()) {
    piece.resize(std::min<std::uint64_t>(1024, rays.size() - first));
    rays.read(first, piece);
    for (Ray& ray : piece)
      if (ray.station == kStationUndecided) ray.station = guessed_station(site_, *solid, ray, ray.part != kNot);
    rays.write(first, piece);
  }
  return rays;
}

const Vec3* RaySamples::eye_of(const Ray& ray) const {
  if (site_.stations.empty() || ray.station == kStationNotInFront - 1) return nullptr;
  return &site_.stations[ray.station].position;
}

Place2 RaySamples::crossing(const Ray& ray, double depth) const {
  const Vec3* eye = eye_of(ray);
  return eye != nullptr && static_cast<double>(ray.at.w) < eye->z ? crossing_from(*eye, ray.at, depth)
                                                                  : Place2{ray.at.u, ray.at.v};
}

RayOutcome RaySamples::met(const Ray& ray, double depth, double epsilon) const {
  if (depth == 0 && ray.part == kWall) return RayOutcome::solid;
  const double off = static_cast<double>(ray.at.w) - depth;
  if (std::abs(off) <= epsilon) return RayOutcome::solid;
  return off < 0 ? RayOutcome::through : RayOutcome::before;
}

std::size_t RaySamples::bin_of(Place2 place) const {
  const auto clamp = [&](double v, std::int64_t count) {
    return static_cast<std::int64_t>(std::clamp(std::floor(v / bin_), 0.0, static_cast<double>(count - 1)));
  };
  return static_cast<std::size_t>(clamp(place.v - v0_, rows_) * columns_ + clamp(place.u - u0_, columns_));
}

// Sorts the rays by bins. First it brings together the bins that are sorted together in memory.
void RaySamples::sort_by_place(const RayColumn& rays) {
  for (const Ray& ray : Rays(rays, {{0, rays.size()}})) {
    const std::size_t at = bin_of(crossing(ray, 0));
    ++bins_[at + 1].first;
    Bin& bin = bins_[at];
    bin.u0 = std::min(bin.u0, ray.at.u), bin.u1 = std::max(bin.u1, ray.at.u);
    bin.v0 = std::min(bin.v0, ray.at.v), bin.v1 = std::max(bin.v1, ray.at.v);
  }
  std::vector<std::size_t> begins;                     // first bin of each group
  std::vector<std::uint64_t> counts;                   // rays of each group
  std::vector<std::uint32_t> group(bins_.size() - 1);  // group of each bin
  for (std::size_t b = 0; b + 1 < bins_.size(); ++b) {
    const std::uint64_t count = bins_[b + 1].first;
    if (counts.empty() || counts.back() + count > kSortedTogether) begins.push_back(b), counts.push_back(0);
    counts.back() += count;
    group[b] = static_cast<std::uint32_t>(counts.size() - 1);
    bins_[b + 1].first += bins_[b].first;
  }
  sorted_ = grouped_rays(
      rays, counts, [&](const Ray& ray) { return group[bin_of(crossing(ray, 0))]; }, new_column());
  begins.push_back(bins_.size() - 1);
  std::vector<Ray> unsorted, sorted;
  std::vector<std::uint64_t> next;
  for (std::size_t g = 0; g < counts.size(); ++g) {
    if (begins[g + 1] - begins[g] == 1 || counts[g] == 0) continue;
    const std::uint64_t first = bins_[begins[g]].first;
    unsorted.resize(counts[g]), sorted.resize(counts[g]);
    sorted_.read(first, unsorted);
    next.clear();
    for (std::size_t b = begins[g]; b < begins[g + 1]; ++b) next.push_back(bins_[b].first - first);
    for (const Ray& ray : unsorted) sorted[next[bin_of(crossing(ray, 0)) - begins[g]]++] = ray;
    sorted_.write(first, sorted);
  }
}

void RaySamples::sort_by_segment(const RayColumn& rays) {
  const auto number_of = [&](const Ray& ray) {
    const auto at = std::lower_bound(segments_.begin(), segments_.end(), ray.at.plane);
    return at == segments_.end() || *at != ray.at.plane ? kNoGroup : static_cast<std::size_t>(at - segments_.begin());
  };
  std::vector<std::uint64_t> counts(segments_.size(), 0);
  for (const Ray& ray : Rays(rays, {{0, rays.size()}}))
    if (const std::size_t s = number_of(ray); s != kNoGroup) ++counts[s];
  std::uint64_t first = 0;
  for (const std::uint64_t count : counts) segment_runs_.push_back({std::exchange(first, first + count), count});
  by_segment_ = grouped_rays(rays, counts, number_of, new_column());
}

RayRun RaySamples::run_of(std::uint32_t segment) const {
  const auto at = std::lower_bound(segments_.begin(), segments_.end(), segment);
  if (at == segments_.end() || *at != segment) return {};
  return segment_runs_[static_cast<std::size_t>(at - segments_.begin())];
}

Rays RaySamples::near(const Box2& box) const {
  const std::size_t low = bin_of({box.u0, box.v0}), high = bin_of({box.u1, box.v1});
  const auto columns = static_cast<std::size_t>(columns_);
  std::vector<RayRun> runs;
  for (std::size_t row = low / columns; row <= high / columns; ++row) {
    const std::uint64_t first = bins_[row * columns + low % columns].first;
    const std::uint64_t end = bins_[row * columns + high % columns + 1].first;
    if (end > first) runs.push_back({first, end - first});
  }
  return {sorted_, std::move(runs)};
}

Rays RaySamples::at_places(const Box2& box) const {
  std::vector<RayRun> runs;
  for (std::size_t b = 0; b + 1 < bins_.size(); ++b) {
    const Bin& bin = bins_[b];
    if (bin.u0 > box.u1 || bin.u1 < box.u0 || bin.v0 > box.v1 || bin.v1 < box.v0) continue;
    const std::uint64_t count = bins_[b + 1].first - bin.first;
    if (!runs.empty() && runs.back().first + runs.back().count == bin.first)
      runs.back().count += count;
    else
      runs.push_back({bin.first, count});
  }
  return {sorted_, std::move(runs)};
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
