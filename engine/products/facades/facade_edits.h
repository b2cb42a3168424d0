// SPDX-License-Identifier: Apache-2.0
// Makes corrections by hand on facades. It is a step of its own after everything that measures or regularises, so that
// nothing moves what a person drew, and what he drew moves nothing else.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/model/edit.h"
#include "engine/model/facade.h"
#include "engine/products/facades/walls/wall_groups.h"
#include "engine/products/product_edits.h"

namespace ilot {

// The tolerances with which an edit finds its partner.
struct FacadeEditParams {
  // Choice: the limit of homologous vertices of corrected drawings [Marchand 2018, II.5.3]; parts of a wall that lie
  // closer together than this are told apart by their rectangles alone.
  double plane_m = 0.3;   // from the corners of an edit to the wall
  double beyond_m = 0.5;  // Choice: how far beyond the rectangle of the wall an element may be; eaves reach so far
  double same_area =
      0.5;                // Derived: more than half in common; of two openings that do not overlap only one can have it
  double same_m = 0.001;  // Choice: the last digit of a drawing; a side that moved less keeps what was measured
  double metres_per_unit = 1;
};

// Moves, adds, deletes and renames elements, in the order of the edits; edits of sides are left out. An edit belongs to
// the element of its kind that has most of its rectangle in common with it, where it was found or where an earlier edit
// has put it. What was edited has the status by_hand, and so have the edges that moved: they state no error. The ids
// are dense again. Throws a usage Error for two edits that contradict each other. Where two edits were drawn on two
// openings that are one now and would change it differently, the later edit is without a partner. O(edits x elements).
std::vector<EditResult> edit_facades(std::span<const Edit* const> edits, std::span<Facade* const> facades,
                                     const FacadeEditParams& params);

// Throws a usage Error for two edits that contradict each other, whatever a run finds.
void check_facade_edits(std::span<const Edit> edits, double metres_per_unit);

// Turns the walls whose street side the edits name. Returns the number of the wall of each edit of a side, or nothing.
std::vector<std::optional<std::size_t>> edit_sides(std::span<const Edit* const> edits, std::span<WallGroup> walls,
                                                   const FacadeEditParams& params);

}  // namespace ilot
