// SPDX-License-Identifier: Apache-2.0
// Which of the points around an outline are the building's, and how high the ground is there.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/roofs/roof_site.h"

namespace ilot {

// What a class code means to buildings.
enum class PointRole : std::uint8_t {
  unclassified,  // never classified: may be anything
  building,
  ground,
  other,  // classified as something else
};

// By class code. 0 (never classified), 1 (unclassified) and 12 (overlap of old formats) may be anything.
std::array<PointRole, 256> point_roles(std::span<const int> building, std::span<const int> ground);

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

struct SitePoints {
  std::vector<std::uint32_t> building;  // indices of the surroundings, ascending
  double ground = 0;                    // metres above the anchor; 0 without any point
  GroundSource ground_source = GroundSource::measured;
  bool by_class = true;  // false: no point had the building's class, those of no class were taken
};

// outlines[own] is the site's, the others are all those within reach_of(params) of it, in the order of ids, seen from
// the same anchor. A point that an outline holds belongs to it (to both where two overlap), borders to one side; of the
// others those within the margin belong to the nearest outline, ties to the first. Of these the points of the
// building's class are the building's; without one the unclassified ones, where ground was measured those that rise
// from it. The ground is a low quantile of ground points within reach outside of all outlines; without such the lowest
// point within the margin of the outline's edges, without such the lowest. O(points x corners).
SitePoints choose_points(const Surroundings& around, std::span<const SitePolygon> outlines, std::size_t own,
                         const SitePointsParams& params = {});

}  // namespace ilot
