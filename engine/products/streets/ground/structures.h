// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/products/streets/ground/cells.h"
#include "engine/products/streets/ground/standing_form.h"
#include "ilot/settings.h"

namespace ilot {

struct StructureParams {
  double least_height = 2.5;     // metres above the terrain; buildings and crowns are higher
  double least_wall = 1.8;       // metres above the terrain; walls of buildings are higher, also where the cloud is cut
  double around = 1.2;           // metres; cells within it vote
  double line = 4;               // metres; window in which upright cells are on a line; they fill half of it
  double least_length = 3;       // metres; a building is longer
  double height_of_house = 4.5;  // metres; a building that is lower is as long as `length_of_house`
  double length_of_cut_wall = 7;  // metres; the same where all is lower than least_height; longer than a van
  double length_of_house = 15;    // metres; longer than a lorry
};

// Finds buildings and crowns before objects are sought. Reads the layers "shape" (StandingForm) and "top" (units above
// the terrain) of cells, writes "structure" (Structure).
//  - A wall is a line of cells with upright pixels; cells that touch it belong to it.
//  - An overhang is what is high near a wall, seen from the street: a balcony, an awning. Below it is the street.
//  - A roof is where cells on planes outnumber those of volumes around a cell.
//  - A crown is where cells of volumes outnumber those on planes.
//  - Walls and roofs that are connected are a building. What is smaller than a house, as a lorry, a kiosk or a shed, is
//    none: it is left to the search for objects.
void find_structures(const Cells& cells, StreetView view, const StructureParams& params = {});

}  // namespace ilot
