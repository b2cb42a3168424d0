// SPDX-License-Identifier: Apache-2.0
// Sections through a facade: what a level or upright plane cuts of its wall, its elements and its points.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "engine/deliverables/drawings/drawing.h"
#include "engine/deliverables/drawings/facade_drawing.h"
#include "engine/model/facade.h"
#include "kernels/outlines/plane_section.h"

namespace ilot {

// The plane at a height of the CRS, seen from above: u runs along the facade, v into the wall.
SectionPlane level_section(const Facade& facade, double height);

// The upright plane through two places; u runs from the first to the second, v is up. A usage Error when they stand one
// above the other.
SectionPlane upright_section(Vec3 from, Vec3 to);

// The surfaces of a facade: the wall (its outline elements, else the rectangle about all of them) with a hole for each
// opening of known place, and of every element with a depth the end and the sides that stand off the wall.
std::vector<SectionFace> facade_faces(const Facade& facade, double metres_per_unit = 1);

// Points near a section, one a cell: as many as paper can show. Memory grows with the cells that hold one.
class SectionPoints {
 public:
  // Points at most `half_m` from the plane; cells of `cell_m`.
  SectionPoints(const SectionPlane& plane, double half_m, double cell_m, double metres_per_unit = 1);
  void add(std::span<const Vec3> points);  // CRS; in any order
  std::vector<FlatPoint> places() const;   // metres, in the plane's axes, middles of cells, by row

 private:
  SectionPlane plane_;
  double half_, cell_, metres_;
  std::vector<std::pair<std::int64_t, std::int64_t>> cells_;  // sorted up to sorted_, later ones as they came
  std::size_t sorted_ = 0;
  void sort_unique();
};

// A sheet with the cut (joined within a tenth of a millimetre) and the points, in the axes of the section's plane.
// `where` names it in the title block: "Section at 4.50".
Drawing section_drawing(const Facade& facade, const SectionPlane& plane, std::span<const SectionFace> faces,
                        std::span<const FlatPoint> points, const std::string& where,
                        const FacadeDrawingParams& params = {});

}  // namespace ilot
