// SPDX-License-Identifier: Apache-2.0
// Which sections of a facade are asked for, and their names.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "engine/model/facade.h"
#include "ilot/settings.h"
#include "kernels/outlines/plane_section.h"

namespace ilot {

// A section and its names: "section-level-4.50" is a part of the file name, "Section at 4.50" is in the title block.
struct NamedSection {
  std::string file, title;
  SectionPlane plane;
};

struct SectionRequests {
  std::vector<double> levels;    // heights, CRS units
  std::vector<double> uprights;  // x of the facade's drawing, metres: vertical sections perpendicular to the wall
  std::vector<double> lines;     // x0, y0, x1, y1 of each, CRS units: vertical sections between these two places
};

// Returns the sections that a facade has: every level, and of the others those that meet its wall or something on it. A
// vertical section at an x has the street on its right and x = 0 on the wall. A section along a line has x = 0 at its
// first place and is seen from its right-hand side. Lines are numbered in the order in which they are given. Throws as
// check_section_lines does.
std::vector<NamedSection> named_sections(const Facade& facade, const SectionRequests& requests, double metres_per_unit,
                                         SheetLanguage language = SheetLanguage::english);

// Throws a usage Error when a line lacks numbers or has no length.
void check_section_lines(std::span<const double> lines);

}  // namespace ilot
