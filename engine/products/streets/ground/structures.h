// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/products/streets/ground/cells.h"
#include "engine/products/streets/ground/standing_form.h"
#include "engine/products/streets/ground/structure_model.h"
#include "ilot/settings.h"

namespace ilot {

struct StructureParams {
  double least_height = 2.5;  // metres above the terrain; buildings and crowns are higher
  double least_wall = 1.8;    // metres above the terrain; walls of buildings are higher, seen from the air
  // The same from the street, where clouds are cut low: higher than planters, bins and benches.
  double least_learnt_wall = kLeastDecided;  // metres
  double around = 1.2;                       // metres; cells within it vote
  double least_length = 3;                   // metres; a building is longer
  double height_of_house = 4.5;              // metres; a building that is lower is as long as `length_of_house`
  double length_of_cut_wall = 7;             // metres; the same where all is lower than least_height; longer than a van
  double length_of_house = 15;               // metres; longer than a lorry
  // The same from the street, where a lorry is an object by the trees: a wall that is cut below 4.5 m has gaps.
  double length_of_learnt_house = 9;  // metres
};

// What a cell of a building is where it has points above 2.5 m and these bins. Where nothing is between 2 and 2.5 m,
// and something below, as the street, a bench or a pedestrian, the building hangs over: a sill, a balcony, a storey
// that stands out, eaves. A wall and what is fixed to one have points there. A wall becomes an overhang and a roof
// eaves.
Structure where_free_below(Structure of_cell, HeightBins bins);

// Finds buildings and crowns before objects are sought. Reads the layers "shape" (StandingForm) and "top" (units above
// the terrain) of cells, from the street also the other measures of cells (standing_features.h). Writes "structure"
// (Structure).
//  - From the street trees that were learnt say of each cell that is as high as a wall whether it is of a facade, a
//    roof, a crown or an object (structure_model.h). Cells lower than least_wall are walls only where nothing nearby
//    reaches least_height, as in a cloud that is cut. A cell of a facade is a wall where it has upright pixels or is
//    low, or where no pixel nearby is upright (a sparse cloud), and else an overhang: what is high near a wall, as a
//    balcony or an awning. Below it is the street. So it is where a wall or a roof is free below (where_free_below).
//  - From the air a wall is what is upright, a roof is where cells on planes outnumber those of volumes around a cell,
//    and a crown is where cells of volumes outnumber those on planes.
//  - Walls and roofs that are connected are a building. What is smaller than a house, as a lorry, a kiosk or a shed, is
//    none: it is left to the search for objects.
void find_structures(const Cells& cells, StreetView view, const StructureParams& params = {});

}  // namespace ilot
