// SPDX-License-Identifier: Apache-2.0
// Which sections of a facade are asked for, and what they are called.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "engine/model/facade.h"
#include "kernels/outlines/plane_section.h"

namespace ilot {

// A cut and what to call it: "section-level-4.50" is a part of a file's name, "Section at 4.50" of the title block.
struct NamedSection {
  std::string file, title;
  SectionPlane plane;
};

struct SectionRequests {
  std::vector<double> levels;    // heights, CRS units
  std::vector<double> uprights;  // x of the facade's drawing, metres: square to the wall, upright
  std::vector<double> lines;     // x0, y0, x1, y1 of each, CRS units: upright, between these two places
};

// Those that a facade has: every level, and of the others those that meet its wall or something on it. An upright one
// has the street at its right, x = 0 on the wall; one along a line x = 0 at its first place and is seen from its
// right-hand side. Lines are numbered as they are given. Throws as check_section_lines.
std::vector<NamedSection> named_sections(const Facade& facade, const SectionRequests& requests, double metres_per_unit);

// A usage Error where a line lacks numbers or has no length.
void check_section_lines(std::span<const double> lines);

}  // namespace ilot
