// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/facade_gathering.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/columns/colours_pass.h"
#include "engine/columns/stations_pass.h"
#include "engine/store/stretches.h"

namespace ilot {
namespace {

// Derived: 2 standard deviations contain 95 % of normal noise.
constexpr double kEpsilons = 2;  // times the noise, at least the epsilon of its segments: contains the points of a wall

// The part of a box that another box in CRS units contains, and one step more.
IndexBox within(const IndexBox& box, const Box3<Vec3>& part, double unit) {
  const auto clamped = [&](double at, std::int64_t least, std::int64_t most) {
    return static_cast<std::int64_t>(std::clamp(at / unit, static_cast<double>(least), static_cast<double>(most)));
  };
  const auto at = [&](Vec3 p) {
    return Index3{clamped(p.x, box.min.x, box.max.x), clamped(p.y, box.min.y, box.max.y),
                  clamped(p.z, box.min.z, box.max.z)};
  };
  return IndexBox{at(part.min), at(part.max)}.grown(1);
}

// The place around a wall from which points are taken. It is a box in the axes of the wall, which are inclined to those
// of the lattice.
class Slab {
 public:
  Slab(const FacadeWork& work, const WallGroup& wall)
      : into_(work, wall),
        metres_(work.store.unit() * work.metres_per_unit),
        axes_{wall.axes.right, wall.axes.up, wall.axes.out},
        low_{-work.beside, -work.beside, -work.behind},
        high_{wall.width + work.beside, wall.height + work.beside, work.before} {}
  Slab(const FacadeWork& work, const WallGroup& wall, const SpaceBox& box) : Slab(work, wall) {
    low_ = {box.low.x, box.low.y, box.low.z};
    high_ = {box.high.x, box.high.y, box.high.z};
  }

  // Whether some place of a box on the lattice may be in the slab.
  bool meets(const IndexBox& box) const {
    const Vec3 a = into_.of(box.min), b = into_.of(box.max), middle = 0.5 * (a + b);
    const Vec3 half = 0.5 * metres_ *
                      Vec3{static_cast<double>(box.max.x - box.min.x), static_cast<double>(box.max.y - box.min.y),
                           static_cast<double>(box.max.z - box.min.z)};
    const std::array<double, 3> at{middle.x, middle.y, middle.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& axis = axes_[k];
      const double reach = std::abs(axis.x) * half.x + std::abs(axis.y) * half.y + std::abs(axis.z) * half.z + metres_;
      if (at[k] + reach < low_[k] || at[k] - reach > high_[k]) return false;
    }
    return true;
  }

 private:
  LatticeAxes into_;
  double metres_;  // length of a lattice step
  std::array<Vec3, 3> axes_;
  std::array<double, 3> low_, high_;
};

View planned(const FacadeWork& work, const WallGroup& wall) {
  const Slab slab(work, wall);
  return plan_view(work.store, box_around(work, wall), {}, [&](const IndexBox& box) { return slab.meets(box); });
}

void read_points(const FacadeWork& work, const WallGroup& wall, std::span<const SiteStation> number_of,
                 const TakeFacadePoints& take) {
  const LatticeAxes into(work, wall);
  const double epsilon = epsilon_of(wall);
  std::vector<FacadePoint> points;
  std::vector<SiteStation> from;
  for_each_stretch(work.store, planned(work, wall).slices, [&](const Stretch& s) {
    points.clear(), from.clear();
    const auto planes = s.read(work.store, columns::kPlane);
    std::vector<StationNumber> stations;
    if (work.recorded) stations = s.read(work.store, columns::kStation);
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const Vec3 p = into.of(s.position(i));
      if (p.x < -work.beside || p.x > wall.width + work.beside || p.y < -work.beside ||
          p.y > wall.height + work.beside || p.z < -work.behind || p.z > work.before)
        continue;
      if (work.recorded) {
        const SiteStation number = number_of[stations[i]];
        if (number == kStationNotInFront && p.z < -epsilon) continue;  // its station does not see it through the wall
        from.push_back(number);
      }
      points.push_back(
          {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z), work.final_id[planes[i]]});
    }
    take(points, from);
  });
}

// The box on the lattice around a box in the axes of the wall.
IndexBox index_box(const FacadeWork& work, const WallGroup& wall, const SpaceBox& box) {
  const double units = 1 / work.metres_per_unit;
  Vec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  for (const double u : {box.low.x, box.high.x})
    for (const double v : {box.low.y, box.high.y})
      for (const double w : {box.low.z, box.high.z}) {
        const Vec3 p =
            wall.axes.origin + (u * units) * wall.axes.right + (v * units) * wall.axes.up + (w * units) * wall.axes.out;
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
  const auto at = [&](double v) { return static_cast<std::int64_t>(std::llround(v / work.store.unit())); };
  return {{at(low.x) - 1, at(low.y) - 1, at(low.z) - 1}, {at(high.x) + 1, at(high.y) + 1, at(high.z) + 1}};
}

// Reads the points in boxes before the wall, each once.
void read_far(const FacadeWork& work, const WallGroup& wall, std::span<const SiteStation> number_of,
              std::span<const SpaceBox> boxes, const TakeFacadePoints& take) {
  const LatticeAxes into(work, wall);
  std::vector<Slab> slabs;
  IndexBox all = IndexBox::none();
  for (const SpaceBox& box : boxes) {
    slabs.emplace_back(work, wall, box);
    all.add_box(index_box(work, wall, box));
  }
  const View view = plan_view(work.store, all, {}, [&](const IndexBox& box) {
    return std::any_of(slabs.begin(), slabs.end(), [&](const Slab& slab) { return slab.meets(box); });
  });
  std::vector<FacadePoint> points;
  std::vector<SiteStation> from;
  for_each_stretch(work.store, view.slices, [&](const Stretch& s) {
    points.clear(), from.clear();
    std::vector<StationNumber> stations;
    if (work.recorded) stations = s.read(work.store, columns::kStation);
    for (std::size_t i = 0; i < s.codes.size(); ++i) {
      const Vec3 p = into.of(s.position(i));
      const bool wanted = std::any_of(boxes.begin(), boxes.end(), [&](const SpaceBox& box) {
        return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y && p.z <= box.high.z;
      });
      if (!wanted || p.z <= work.before) continue;  // others of the same block depend on how the points are stored
      if (work.recorded) from.push_back(number_of[stations[i]]);
      points.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z), 0});
    }
    take(points, from);
  });
}

// The part of a ring between two places along the wall.
OutlineRing clipped(const OutlineRing& ring, double low, double high) {
  OutlineRing kept = ring;
  for (const double sign : {1.0, -1.0}) {
    const double limit = sign > 0 ? low : -high;
    const OutlineRing whole = std::move(kept);
    kept.clear();
    for (std::size_t i = 0; i < whole.size(); ++i) {
      const Place2 &a = whole[i], &b = whole[(i + 1) % whole.size()];
      const double from = sign * a.u - limit, to = sign * b.u - limit;
      if (from >= 0) kept.push_back(a);
      if ((from < 0) != (to < 0)) kept.push_back({sign * limit, a.v + (b.v - a.v) * from / (from - to)});
    }
  }
  return kept;
}

// Adds the outer rings of the segments of the wall, projected onto the wall. A segment may go on beyond the wall, where
// a house of its own begins.
void add_rings(const FacadeWork& work, const WallGroup& wall, FacadeSite& site) {
  const LatticeAxes into(work, wall);
  std::vector<std::uint32_t> numbers;
  for (const std::uint32_t id : wall.segments) {
    auto at = std::lower_bound(work.outline_numbers.begin(), work.outline_numbers.end(), OutlineNumber{id, 0});
    for (; at != work.outline_numbers.end() && at->plane == id; ++at) numbers.push_back(at->number);
  }
  std::sort(numbers.begin(), numbers.end());
  for (const std::uint32_t number : numbers) {
    for (const Outline::Part& part : work.outlines[number].parts) {
      OutlineRing ring;
      for (const Vec3& p : part[0]) {
        const Vec3 at = into.of_place(p);
        ring.push_back({at.x, at.y});
      }
      ring = clipped(ring, 0, wall.width);
      if (ring.size() >= 3) site.rings.push_back(std::move(ring));
    }
  }
}

// Returns the numbers that the stations of the run have in the site.
std::vector<SiteStation> add_stations(const FacadeWork& work, const WallGroup& wall, FacadeSite& site) {
  std::vector<SiteStation> number_of(work.stations.size() + 1, kStationNotInFront);
  number_of[0] = kStationUnknown;
  for (std::size_t i = 0; i < work.stations.size(); ++i) {
    FacadeStation station = work.steps[i];
    station.position = LatticeAxes(work, wall).of_place(work.stations[i]);
    if (!(station.position.z > work.before)) continue;
    site.stations.push_back(station);
    const bool numbered = site.stations.size() < kStationNotInFront;
    number_of[i + 1] = numbered ? static_cast<SiteStation>(site.stations.size()) : kStationUnknown;
  }
  return number_of;
}

}  // namespace

std::vector<OutlineNumber> numbers_of(std::span<const Outline> outlines) {
  std::vector<OutlineNumber> numbers;
  numbers.reserve(outlines.size());
  for (std::size_t i = 0; i < outlines.size(); ++i)
    numbers.push_back({outlines[i].plane_id, static_cast<std::uint32_t>(i)});
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

LatticeAxes::LatticeAxes(const FacadeWork& work, const WallGroup& wall)
    : axes_(wall.axes), metres_per_unit_(work.metres_per_unit), metres_(work.store.unit() * work.metres_per_unit) {
  const double unit = work.store.unit();
  anchor_ = {std::llround(axes_.origin.x / unit), std::llround(axes_.origin.y / unit),
             std::llround(axes_.origin.z / unit)};
  const auto rest = [&](std::int64_t whole, double at) { return static_cast<double>(whole) - at / unit; };
  rest_ = {rest(anchor_.x, axes_.origin.x), rest(anchor_.y, axes_.origin.y), rest(anchor_.z, axes_.origin.z)};
}

Vec3 LatticeAxes::of_place(Vec3 place) const {
  const Vec3 d = metres_per_unit_ * (place - axes_.origin);
  return {dot(d, axes_.right), dot(d, axes_.up), dot(d, axes_.out)};
}

double epsilon_of(const WallGroup& wall) {
  return std::max(wall.epsilon, kEpsilons * wall.rms);
}

IndexBox box_around(const FacadeWork& work, const WallGroup& wall) {
  return index_box(work, wall,
                   {{-work.beside, -work.beside, -work.behind},
                    {wall.width + work.beside, wall.height + std::max(work.beside, wall.above), work.before}});
}

std::uint64_t points_to_read(const FacadeWork& work, const WallGroup& wall) {
  return planned(work, wall).size;
}

GatheredFacade gather_facade(const FacadeWork& work, const WallGroup& wall) {
  GatheredFacade gathered;
  FacadeSite& site = gathered.site;
  site.axes = wall.axes;
  site.metres_per_unit = work.metres_per_unit;
  site.width = wall.width;
  site.height = wall.height;
  site.noise = wall.rms;
  site.epsilon = epsilon_of(wall);
  site.step = std::sqrt(wall.area_m2 / static_cast<double>(wall.points));
  site.wall = wall.segments;
  site.parallel = wall.parallel;
  std::sort(site.parallel.begin(), site.parallel.end(),
            [](const ParallelPlane& a, const ParallelPlane& b) { return a.id < b.id; });
  add_rings(work, wall, site);
  const std::vector<SiteStation> number_of = add_stations(work, wall, site);
  gathered.points = [&work, wall, number_of](const TakeFacadePoints& take) {
    read_points(work, wall, number_of, take);
  };
  gathered.far = [&work, wall, number_of](std::span<const SpaceBox> boxes, const TakeFacadePoints& take) {
    if (!boxes.empty()) read_far(work, wall, number_of, boxes, take);
  };
  return gathered;
}

PointSource points_around(const FacadeWork& work, const WallGroup& wall) {
  return [&work, around = box_around(work, wall)](const Box3<Vec3>& asked,
                                                  const std::function<void(std::span<const ImagePoint>)>& take) {
    const double unit = work.store.unit();
    const IndexBox box = within(around, asked, unit);
    std::vector<ImagePoint> points;
    for_each_stretch(work.store, plan_view(work.store, box, {}).slices, [&](const Stretch& s) {
      std::vector<StoredColour> colours(s.codes.size(), 0);
      if (work.store.has(s.block, columns::kColour)) colours = s.read(work.store, columns::kColour);
      points.clear();
      for (std::size_t i = 0; i < colours.size(); ++i) {
        const Index3 p = s.position(i);
        if (!box.contains(p)) continue;  // other points that are read with it depend on how the points are stored
        const auto channel = [&](int shift) { return static_cast<std::uint8_t>(colours[i] >> shift & 255); };
        points.push_back(
            {{static_cast<double>(p.x) * unit, static_cast<double>(p.y) * unit, static_cast<double>(p.z) * unit},
             {channel(16), channel(8), channel(0)}});
      }
      take(points);
    });
  };
}

}  // namespace ilot
