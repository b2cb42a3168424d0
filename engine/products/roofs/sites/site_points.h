// SPDX-License-Identifier: Apache-2.0
// Decides which of the points around an outline belong to the building, and how high the ground is there.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/columns/point_roles.h"
#include "engine/products/roofs/sites/roof_site.h"
#include "engine/units/value_counts.h"
#include "kernels/geometry/flat.h"
#include "kernels/geometry/flat_box.h"

namespace ilot {

struct Surroundings {
  std::vector<Vec3> points;  // metres from the site's anchor, in global order
  std::vector<PointRole> roles;
};

struct SitePointsParams {
  double margin = 0.5;        // metres; points outside all outlines and this near to one belong to it
  double ground_reach = 4;    // metres around the outline in which ground is searched
  double ground_share = 0.1;  // share of the ground points there that lie below the site's ground
  double clearance = 1;       // metres above measured ground; lower unclassified points do not belong to the building
};

// The distance in metres around an outline within which points and other outlines matter.
inline double reach_of(const SitePointsParams& params) {
  return params.ground_reach > 2 * params.margin ? params.ground_reach : 2 * params.margin;
}

// Where a point belongs, by its position alone.
enum class PointMembership : std::uint8_t {
  none,
  held,    // in the site's outline, or outside of all outlines, within the margin, and nearest to this one
  ground,  // classified as ground, outside of all outlines and within ground_reach of the site's outline
};

// Decides point by point. outlines[own] is the site's outline. The others are all outlines within reach_of(params) of
// it, in the order of ids, seen from the same anchor. A point inside an outline belongs to it, and to both where two
// outlines overlap; a point on a border counts for one side. A point outside of all outlines belongs to the nearest one
// if it is within the margin (ties: the first).
class SiteFilter {
 public:
  SiteFilter(std::span<const SitePolygon> outlines, std::size_t own, const SitePointsParams& params = {});

  // O(corners of the outlines near the point).
  PointMembership of(Vec3 p, PointRole role) const;

  // Returns the distance to the site's own edges in plan, in metres; infinite when it is surely beyond reach.
  double distance(Vec3 p, double reach) const;

  // Returns true where a point is within the margin of the site's own edges.
  bool at_edge(Vec3 p) const;

  const SitePointsParams& params() const { return params_; }

 private:
  // The edges are in metres. Each runs from its lower end to its upper one, so that neighbours see a common edge with
  // the same bits.
  struct EdgeSet {
    std::vector<FlatEdge> edges;
    FlatBox box = FlatBox::none();

    explicit EdgeSet(const SitePolygon& polygon);
    bool near(Vec3 p, double reach) const;
    bool contains(Vec3 p) const;
    double distance2(Vec3 p, double reach) const;
  };
  bool is_nearest(Vec3 p, double d2) const;

  std::size_t own_;
  SitePointsParams params_;
  std::vector<EdgeSet> sets_;
};

// Decides which points of a site belong to the building, and gives the ground of the site.
struct SiteRule {
  double ground = 0;  // metres above the anchor; 0 without any point
  GroundSource ground_source = GroundSource::measured;
  bool by_class = true;       // false: no point has the class of buildings, and the unclassified points are taken
  double lowest = -HUGE_VAL;  // metres above the anchor; lower points do not belong to the building

  bool takes(PointRole role, double z) const {
    return role == (by_class ? PointRole::building : PointRole::unclassified) && z >= lowest;
  }
};

// Finds the rule from all points around a site, each added once, in any order. Of the points that belong to the site's
// outline, those with the class of buildings belong to the building. Without such points the unclassified ones are
// taken; where ground was measured, only those that rise above it. The ground is a low quantile of the ground points
// within reach and outside of all outlines. Without such points it is the lowest point within the margin of the
// outline's edges, and without these the lowest point. Memory is bounded (value_counts.h).
class SiteMeasure {
 public:
  explicit SiteMeasure(const SiteFilter& filter) : filter_(filter) {}
  void add(Vec3 p, PointRole role, PointMembership membership);
  SiteRule rule();

 private:
  const SiteFilter& filter_;
  ValueCounts ground_;
  bool any_building_ = false;
  double lowest_ = HUGE_VAL, lowest_at_edge_ = HUGE_VAL;
};

struct SitePoints {
  std::vector<std::uint32_t> building;  // indices of the surroundings, ascending
  SiteRule rule;
};

// The same for points in memory.
SitePoints choose_points(const Surroundings& around, std::span<const SitePolygon> outlines, std::size_t own,
                         const SitePointsParams& params = {});

}  // namespace ilot
