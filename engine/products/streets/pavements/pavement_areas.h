// SPDX-License-Identifier: Apache-2.0
// Areas of pavement from the widths along kerbs.
#pragma once
#include <span>
#include <vector>

#include "ilot/streets.h"

namespace ilot {

struct PavementAreasParams {
  double same_width = 0.3;       // metres between widths that confirm each other
  std::uint32_t neighbours = 2;  // places on both sides whose widths may confirm one
};

// Makes the ends unsure that no neighbour on the kerb confirms: an object before a wall, or a gap in a fence. `widths`
// are ordered by kerb and number. O(n).
void mark_unsure_widths(std::span<PavementWidth> widths, const PavementAreasParams& params = {});

// Joins consecutive widths that have a sure end to areas, numbered from 1. An area ends where the kerb turns so much
// that widths meet. O(n).
std::vector<Pavement> join_pavements(std::span<const PavementWidth> widths, double metres_per_unit);

}  // namespace ilot
