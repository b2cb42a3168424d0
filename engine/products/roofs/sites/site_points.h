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
  double margin = 0.5;        // metres; points outside the outline and this near to it may lie on its roof
  double ground_reach = 4;    // metres around the outline in which ground is searched
  double ground_share = 0.1;  // share of the ground points there that lie below the site's ground
  double clearance = 1;       // metres above measured ground; lower unclassified points do not belong to the building
};

// The distance in metres around an outline within which points matter.
inline double reach_of(const SitePointsParams& params) {
  return params.ground_reach > params.margin ? params.ground_reach : params.margin;
}

// Where a point lies, by its position alone.
enum class PointMembership : std::uint8_t {
  none,
  held,    // in the site's outline
  beside,  // outside of it, within the margin
  ground,  // classified as ground, outside of the outline and within ground_reach of it
};

// Decides point by point. Only the site's own outline counts: other outlines of the run change nothing, so that a
// choice of footprints gives the same buildings as all of them. A point on a border of two outlines is inside one of
// them.
class SiteFilter {
 public:
  explicit SiteFilter(const SitePolygon& outline, const SitePointsParams& params = {});

  // O(corners of the outline if the point is near).
  PointMembership of(Vec3 p, PointRole role) const;

  // Returns the distance to the outline's edges in plan, in metres; infinite when it is surely beyond reach.
  double distance(Vec3 p, double reach) const;

  // Returns true where a point is within the margin of the outline's edges.
  bool at_edge(Vec3 p) const;

  // Returns 0 in the outline, else from 1 at its edges to 255 at the margin and beyond.
  std::uint8_t away(Vec3 p) const;

  const SitePointsParams& params() const { return params_; }

 private:
  bool near(Vec3 p, double reach) const;
  bool contains(Vec3 p) const;
  double distance2(Vec3 p, double reach) const;

  // Metres. Each edge runs from its lower end to its upper one, so that neighbours see a common edge with the same
  // bits.
  std::vector<FlatEdge> edges_;
  FlatBox box_ = FlatBox::none();
  SitePointsParams params_;
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

// Finds the rule from all points around a site, each added once, in any order. Of the points in the outline and beside
// it, those with the class of buildings may belong to the building. Where the outline contains none, the unclassified
// ones are taken; where ground was measured, only those that rise above it. The ground is a low quantile of the ground
// points outside of the outline and within reach. Without such points it is the lowest point within the margin of the
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
  std::vector<std::uint32_t> building, beside;  // in the outline and beside it: indices of the surroundings, ascending
  SiteRule rule;
};

// The same for points in memory.
SitePoints choose_points(const Surroundings& around, const SitePolygon& outline, const SitePointsParams& params = {});

}  // namespace ilot
