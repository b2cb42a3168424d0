// SPDX-License-Identifier: Apache-2.0
// Finds the planes that are facades: large upright planes, joined along the street.
#pragma once
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "engine/model/facade.h"
#include "engine/model/segment.h"
#include "engine/products/facades/facade_site.h"

namespace ilot {

struct WallParams {
  double least_width = 2, least_height = 2;      // metres; smaller walls are parts of other structures
  double least_area = 4;                         // m2 that its points cover
  double lean_deg = 5;                           // greatest angle to the vertical
  double bias = 0.03;                            // metres; walls whose planes differ by at most this are one wall
  double gap = 3;                                // metres between two parts of a wall
  double relief_front = 1.5, relief_behind = 1;  // metres; a segment along a wall within this is a part of it
  double large_part = 1;                         // m2; a smaller piece beside the plane of the wall is relief
  double least_step = 0.01;                      // metres; walls that differ by more and by their errors are two
  double metres_per_unit = 1;
};

// The plane at one end of a segment along its wall, in CRS units.
struct EndPlane {
  Vec3 place, normal;   // the middle of the end; unit length
  double height_m = 0;  // of the segment at its end
  double error_m = 0;   // one standard deviation of the place along the normal
  bool step = false;    // the wall steps back or forth there
};

// What is known of the ends of a segment that is as high as a wall. `wide`: it is as large as a wall in all, so that it
// may be one; smaller pieces only continue one. `stray`: most points of its stretch are those of other planes; a plane
// that follows several houses takes such points of the houses between them.
struct SegmentEnds {
  bool known = false, wide = false, stray = false;
  EndPlane left, right;
};

// A part of a wall beyond its planes, in the axes of the wall, in metres.
struct SparsePart {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  double step = 0;  // between its points
  // The wall bows: its distance from its plane at the lower and the upper end of u (upright) or of v.
  double w0 = 0, w1 = 0;
  bool upright = true;
};

struct WallGroup {
  FacadeAxes axes;
  double width = 0, height = 0, area_m2 = 0, epsilon = 0, rms = 0;
  double core0 = 0, core1 = 0;  // metres along the wall: the extent of its parts whose ends are known
  std::uint64_t points = 0;
  std::vector<std::uint32_t> segments;  // ids of the segments of the wall
  std::vector<ParallelPlane> parallel;  // ids of the segments before and behind the wall
  double above = 0;                     // metres above the wall that its dormers reach
  // The natural logarithm of the odds that `out` points to the street; infinite where a station decides.
  double side_odds = INFINITY;
  std::vector<SparsePart> sparse;  // where the wall goes on with too few points for a plane
};

// What is known of the side of walls: the stations, or else the log odds that the street is on the side of the normal
// of a segment (by id; empty or 0: not known), or else the middle of all points.
struct StreetSides {
  std::span<const Vec3> stations;
  Vec3 middle;
  std::span<const double> odds = {};
};

// Gives the walls in the order of their area, the largest first (ties: the smaller id). `up` is the steepest line in
// the wall. The street side is where most stations are; each station counts with one over its squared distance. Without
// stations it is the side that the odds say. Where these say nothing it is the side of a larger wall in line, or else
// the side away from the middle. Segments without an area (no outline) are left out. Each wall looks only at the
// segments around it, and without stations also at the walls found so far.
// With the ends of the segments (one each, in order) a house that steps back or forth by `params.least_step` is a wall
// of its own, and so is a wall beside another one that stands farther back or forth: relief has its wall on both sides.
std::vector<WallGroup> find_walls(std::span<const Segment> segments, const StreetSides& sides, const WallParams& params,
                                  std::span<const SegmentEnds> ends = {});

// Gives walls of at least half the width and half the height that are in none of `walls` and are no relief of one of
// them: a low storey that is set back is such a wall. All else is as in find_walls.
std::vector<WallGroup> small_walls(std::span<const WallGroup> walls, std::span<const Segment> segments,
                                   const StreetSides& sides, WallParams params, std::span<const SegmentEnds> ends = {});

struct DormerFrontParams {
  double least_width = 0.6, least_height = 0.5, most_width = 6;  // metres; wider fronts are storeys that are set back
  double behind = 3;                                             // metres; greatest distance behind the wall
  double reach = 6;                                              // metres above the top of the wall that they reach
  double gap = 0.3;                                              // metres between parts of one front
};

// Finds upright planes in the roof of a wall: along the wall, above its top, behind it, and in none of `walls`. A plane
// just behind or before a larger one is left out: it fills the window of the larger one or stands before it. The
// openings of the fronts decide which are dormers (add_dormers). The segments must outlive this object.
class DormerFronts {
 public:
  DormerFronts(std::span<const WallGroup> walls, std::span<const Segment> segments, WallParams params,
               const DormerFrontParams& dormers = {});
  ~DormerFronts();

  // The fronts of one wall, from left to right. O(segments around it), and O(fronts^2).
  std::vector<WallGroup> of(const WallGroup& wall);

 private:
  std::vector<std::size_t> candidates(const WallGroup& wall) const;
  struct State;
  std::unique_ptr<State> state_;
};

inline std::vector<WallGroup> find_dormer_fronts(const WallGroup& wall, std::span<const WallGroup> walls,
                                                 std::span<const Segment> segments, WallParams params,
                                                 const DormerFrontParams& dormers = {}) {
  return DormerFronts(walls, segments, params, dormers).of(wall);
}

// The wall without elements on it: its rectangle is its only element.
Facade bare_facade(const WallGroup& wall, double metres_per_unit);

}  // namespace ilot
