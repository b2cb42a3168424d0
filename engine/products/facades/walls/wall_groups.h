// SPDX-License-Identifier: Apache-2.0
// Which planes are facades: large upright ones, joined along the street.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "engine/model/facade.h"
#include "engine/model/segment.h"
#include "engine/products/facades/facade_site.h"

namespace ilot {

struct WallParams {
  double least_width = 2, least_height = 2;      // metres; smaller walls are parts of something else
  double least_area = 4;                         // m2 of points
  double lean_deg = 5;                           // farthest from upright
  double bias = 0.03;                            // metres; walls on one plane within this are one
  double gap = 3;                                // metres between two parts of a wall
  double relief_front = 1.5, relief_behind = 1;  // metres; what lies so far from a wall along it is a part of it
  double metres_per_unit = 1;
};

struct WallGroup {
  FacadeAxes axes;
  double width = 0, height = 0, area_m2 = 0, epsilon = 0, rms = 0;
  std::uint64_t points = 0;
  std::vector<std::uint32_t> segments;  // ids
  std::vector<ParallelPlane> parallel;  // ids of what stands before and behind it
  double above = 0;                     // metres above it that its dormers go up to
};

// Walls in the order of their area, the largest first (ties: the smaller id). `up` is the steepest line in the wall;
// the street side is where most stations stand (each by one over its squared distance), else the side away from
// `middle`, the middle of all points, or that of a larger wall in line. Segments without an area (no outline) are left
// out. Each wall asks the segments around it alone; without stations also the walls that there are.
std::vector<WallGroup> find_walls(std::span<const Segment> segments, std::span<const Vec3> stations, Vec3 middle,
                                  const WallParams& params);

// Walls of at least half the width and height that are in none of `walls`, nor relief of one: a low storey that stands
// back is one. Otherwise as find_walls.
std::vector<WallGroup> small_walls(std::span<const WallGroup> walls, std::span<const Segment> segments,
                                   std::span<const Vec3> stations, Vec3 middle, WallParams params);

struct DormerFrontParams {
  double least_width = 0.6, least_height = 0.5, most_width = 6;  // metres; wider ones are storeys that stand back
  double behind = 3;                                             // metres that they stand back, at most
  double reach = 6;                                              // metres above the wall's top that they go up to
  double gap = 0.3;                                              // metres between parts of one front
};

// Upright planes in the roof of a wall: along it, above its top, behind it, of none of `walls`; what is behind or
// before a larger one fills its window or stands before it. Which of them are dormers their openings tell
// (add_dormers). The segments must outlive it.
class DormerFronts {
 public:
  DormerFronts(std::span<const WallGroup> walls, std::span<const Segment> segments, WallParams params,
               const DormerFrontParams& dormers = {});
  ~DormerFronts();

  // Those of one wall, from left to right. O(segments around it), and fronts^2.
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

// The wall with nothing on it: its rectangle is its one element.
Facade bare_facade(const WallGroup& wall, double metres_per_unit);

}  // namespace ilot
