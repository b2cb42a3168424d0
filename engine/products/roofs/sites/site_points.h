// SPDX-License-Identifier: Apache-2.0
// Which of the points around an outline are the building's, and how high the ground is there.
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
  double margin = 0.5;        // metres; points outside all outlines but so near to one are its own
  double ground_reach = 4;    // metres around the outline in which ground is looked for
  double ground_share = 0.1;  // of the ground's points there lie below the site's ground
  double clearance = 1;       // metres above measured ground; lower points of no class are not the building's
};

// Metres around an outline in which points and other outlines matter.
inline double reach_of(const SitePointsParams& params) {
  return params.ground_reach > 2 * params.margin ? params.ground_reach : 2 * params.margin;
}

// Where a point belongs, by its place alone.
enum class PointMembership : std::uint8_t {
  none,
  held,    // in the site's outline, or outside of all within the margin and nearest to it
  ground,  // classified as ground, outside of all outlines and within the ground's reach of the site's
};

// Decides point by point. outlines[own] is the site's, the others are all those within reach_of(params) of it, in the
// order of ids, seen from the same anchor. A point that an outline holds belongs to it (to both where two overlap),
// borders to one side; of the others those within the margin belong to the nearest outline, ties to the first.
class SiteFilter {
 public:
  SiteFilter(std::span<const SitePolygon> outlines, std::size_t own, const SitePointsParams& params = {});

  // O(corners of the outlines near the point).
  PointMembership of(Vec3 p, PointRole role) const;

  // Whether a point is within the margin of the site's own edges.
  bool at_edge(Vec3 p) const;

  const SitePointsParams& params() const { return params_; }

 private:
  // In metres. From the lower end to the upper one, so that neighbours see a common edge with the same bits.
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

// Which of the points that a site holds are the building's, and its ground.
struct SiteRule {
  double ground = 0;  // metres above the anchor; 0 without any point
  GroundSource ground_source = GroundSource::measured;
  bool by_class = true;       // false: no point had the building's class, those of no class are taken
  double lowest = -HUGE_VAL;  // of the building's points

  bool takes(PointRole role, double z) const {
    return role == (by_class ? PointRole::building : PointRole::unclassified) && z >= lowest;
  }
};

// Finds the rule from all points around a site, each added once, in any order. Of the points that the site holds those
// of the building's class are the building's; without one the unclassified ones, where ground was measured those that
// rise from it. The ground is a low quantile of ground points within reach outside of all outlines; without such the
// lowest point within the margin of the outline's edges, without such the lowest. Memory is bounded (value_counts.h).
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
