// SPDX-License-Identifier: Apache-2.0
// Gathers the points of one building from the store, wherever they are and however many.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/products/roofs/edits/class_edits.h"
#include "engine/products/roofs/edits/face_merges.h"
#include "engine/products/roofs/sites/misalignment.h"
#include "engine/products/roofs/sites/outline_map.h"
#include "engine/products/roofs/sites/site_plan.h"
#include "engine/products/roofs/sites/site_points.h"
#include "engine/store/store.h"
#include "engine/units/unit_sample.h"
#include "kernels/geometry/box3.h"

namespace ilot {

// The greatest number of points from which a building is modelled. Of more points a thinned sample is taken
// (units/thinning.h). An airborne cloud of 60 points per square metre has this many on a roof of 2,200 m2, a cloud of
// 15 on 8,700 m2. This many points at kBytesOfSitePoint take 32 MiB, so that a run of one thread with --memory 96M has
// room for them beside the memory of the program itself.
constexpr std::size_t kMostSitePoints = 1u << 17;

// The data that all sites of a run share. The store has the column "role" (PointRole).
struct SiteWork {
  const Store& store;
  std::span<const PlannedSite> sites;
  const OutlineMap& map;  // map of the outlines of the sites
  SitePointsParams params;
  double metres_per_unit = 1;
  std::size_t most_points = kMostSitePoints;
  const ClassEdits* class_edits = nullptr;    // those that were made on the column "role"
  std::span<const PlannedMerge> merges = {};  // of faces, by hand
};

struct GatheredSite {
  RoofSite site;                    // with all points of the building and beside it, or a sample
  std::vector<StorePlace> places;   // per point of the site
  std::vector<StorePlace> beside;   // per point beside it
  bool by_class = true;             // see SiteRule
  bool thinned = false;             // the site has a sample
  std::uint64_t points = 0;         // of the building and beside it
  std::uint64_t points_around = 0;  // points of any class over the outline and within reach of it
  std::uint64_t by_hand = 0;        // those of them whose class a person has set and that count for the building
};

// A point around a site, as SiteMeasure and SiteRule use it.
struct AroundPoint {
  StorePlace place;
  Vec3 at;  // metres from the site's anchor; heights from 0 of the CRS
  PointRole role{};
  PointMembership membership{};
};

// How far in metres around an outline points of the store may change its building: ground is searched that far.
double farthest_points(const SitePointsParams& params);

// The number of points around the site, which is the cost of reading it. 0 without an outline.
std::uint64_t points_to_read(const SiteWork& work, std::size_t site);

// Reads the points of a site that has an outline. The results do not depend on blocks.
class SiteReader {
 public:
  SiteReader(const SiteWork& work, std::size_t site);

  // Reads the columns over the outline once, or three times where the building has more points than work.most_points.
  GatheredSite gather();

  // Returns the points that gather() examines, of any role, in global order, at most `most` of them. Of more points it
  // returns every second, every third and so on.
  std::vector<AroundPoint> points_around(std::size_t most) const;

  // Calls visit(block, points, at) for all points of the building in global order, with some thousands of points of one
  // block at a time: their numbers in the block, and their positions as in RoofSite. Call it after gather().
  using Visit =
      std::function<void(std::uint32_t block, std::span<const std::uint32_t> points, std::span<const Vec3> at)>;
  void for_each_stretch(const Visit& visit) const;

  // Returns the points of all buildings around the site, thinned where there are too many.
  UnitSample buildings_around() const;

  // See SiteFilter::away().
  std::uint8_t away(Vec3 p) const { return filter_.away(p); }

  // The position of a point relative to the site's anchor; heights from 0 of the CRS.
  Vec3 metres(Index3 p) const { return {x_.metres(p.x), y_.metres(p.y), static_cast<double>(p.z) * x_.step}; }

 private:
  // One axis of the lattice as seen from the site's anchor.
  struct Axis {
    std::int64_t from = 0;      // lattice coordinate nearest to the anchor
    double rest = 0, step = 1;  // metres; `rest`: position of `from` relative to the anchor; `step`: a lattice unit

    Axis(std::int64_t anchor_mm, double unit_metres);
    double metres(std::int64_t v) const { return static_cast<double>(v - from) * step + rest; }
  };

  static bool may_be_of_building(PointMembership m) {
    return m == PointMembership::held || m == PointMembership::beside;
  }
  // Argument for sample_unit(): decides which points of a stretch belong to the building or lie beside it.
  auto building_points() const {
    return [this](const Stretch& s) {
      return [this, roles = s.read(work_.store, columns::kRole)](const StretchPoint& p) {
        const Vec3 at = metres(p.position);
        const PointRole role = roles[p.number];
        return rule_.takes(role, at.z) && may_be_of_building(filter_.of(at, role));
      };
    };
  }
  // Calls visit(AroundPoint, position on the lattice) for all points over the outline and within reach of it.
  template <class Visit>
  void for_each_around(const Visit& visit) const {
    for_each_stretch_in(work_.store, box_, [&](const Stretch& s, std::span<const StretchPoint> inside) {
      const auto roles = s.read(work_.store, columns::kRole);
      for (const StretchPoint& p : inside) {
        const Vec3 at = metres(p.position);
        const PointRole role = roles[p.number];
        visit(AroundPoint{place_of(s, p), at, role, filter_.of(at, role)}, p.position);
      }
    });
  }
  UnitSample sample(GatheredSite& gathered);
  bool by_hand(Index3 position) const;
  void find_nearby_ground();

  const SiteWork& work_;
  std::size_t number_;
  const PlannedSite& planned_;
  IndexBox box_;
  Axis x_, y_;
  SiteFilter filter_;
  SiteRule rule_;
  double anchor_z_ = 0;
  std::vector<std::size_t> class_edits_;  // near the site
};

// Counts, for a raster of shifts of the outlines, the points of buildings around the site that lie inside.
ShiftCounts shifts_around(const SiteWork& work, std::size_t site);

}  // namespace ilot
