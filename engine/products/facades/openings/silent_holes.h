// SPDX-License-Identifier: Apache-2.0
// Holes in the points of a wall: openings that gave no echo, and places that no ray reached.
#pragma once
#include <optional>
#include <vector>

#include "engine/products/facades/openings/wall_cells.h"
#include "engine/products/facades/rays/ray_samples.h"

namespace ilot {

// A part of the wall without points that the wall or something before it surrounds.
struct WallHole {
  CellRegion region;
  CellBox box;            // as box_of() gives it
  bool straight = false;  // its sides are straight: it may be an opening
  bool empty = false;     // nothing was seen in most of it, not even something before the wall
  bool crossed = false;   // rays crossed it, and few of them came back: nothing stood before it
  bool open = false;      // the same, but what stood before it may have been cut out of the cloud
  // The part that rays are known to have crossed, in cells, where this is not all of it.
  std::optional<CellBox> shown;

  // False for a cell outside of that part.
  bool shows(std::int64_t cell, std::int64_t columns) const {
    const std::int64_t c = cell % columns, r = cell / columns;
    return !shown || (c >= shown->c0 && c <= shown->c1 && r >= shown->r0 && r <= shown->r1);
  }
};

// A hole that is no known opening: it is drawn as not seen.
struct UnseenArea {
  std::vector<Place2> ring;  // counter-clockwise, metres in the axes of the wall
  bool straight = false;     // the ring is a rectangle, which may be an opening
  bool hidden = false;       // a part of an opening most of which may be hidden
  double error = 0;          // of its sides, metres
};

// Finds the holes in which a square of four fifths of `least_size` fits and in most of which no point of the wall or
// behind it lies, except for those that end at a side or at the top of the wall. First come those that are crossed and
// straight, whole or cut off by what stands before them, then the others.
//
// Rays of a station crossed a hole when this station fired on all its sides, whatever its rays met there: the scanner
// turned through the hole on its way from one to the other. Holes that only bars divide are looked at as one, too
// (barred_holes.h). How many rays there were follows from the density of the points on the wall beside the hole. Of the
// cells of the hole, those are taken off before which a point of this station lies, near the wall or anywhere up
// to the station (RaySamples::far_points). Where points of the street are missing from the cloud, what stood there may
// be missing too; then a hole is crossed only if some rays ended in it behind the wall, on its reveals, or if the rays
// of two stations crossed it. Where no station is known, all rays are taken to be of one that nothing else is known of:
// then rays that ended behind the wall must show it. Where they are spread over most of a hole and end on a line far
// from one of its sides, the hole is one up to this line. O(points).
//
// `open`, where given, gets the straight holes that would be crossed, had nothing been cut out of the cloud: each is a
// pane if it makes one window with a pane that was found (panes.h). They are among the other holes, too.
std::vector<WallHole> find_holes(const RaySamples& samples, const WallCells& cells, double least_size,
                                 std::vector<WallHole>* open = nullptr);

// Internal to find_holes (shown_part.cpp): the part of a hole that is known to be crossed, where only rays that ended
// behind the wall show that it is: up to straight ends of these rays that are far from the sides of the hole. `behind`
// says for each cell of the box of the hole, row by row, whether such a ray crossed it; `cell` is the side of a cell in
// metres. Nothing where these rays are not spread over the hole, as those that ended on its reveals. O(cells).
std::optional<CellBox> shown_part(const CellBox& hole, const std::vector<bool>& behind, double cell);

// The outer ring of the cells of a hole, or its box where it is straight.
UnseenArea area_of(const WallHole& hole, const WallCells& cells);

}  // namespace ilot
