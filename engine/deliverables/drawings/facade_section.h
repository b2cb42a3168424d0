// SPDX-License-Identifier: Apache-2.0
// Sections through a facade: the cut of a horizontal or vertical plane through its wall, its elements and its points.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "engine/deliverables/drawings/drawing.h"
#include "engine/deliverables/drawings/facade_drawing.h"
#include "engine/model/facade.h"
#include "kernels/outlines/plane_section.h"

namespace ilot {

// Returns the plane at a height of the CRS, seen from above: u runs along the facade, v into the wall.
SectionPlane level_section(const Facade& facade, double height);

// Returns the vertical plane through two places. u runs from the first to the second, v is up. Throws a usage Error
// when one place is above the other.
SectionPlane upright_section(Vec3 from, Vec3 to);

// Returns the surfaces of a facade. The wall is given by its outline elements, or else by the rectangle around all
// elements; it has a hole for each opening with a known place. An element with a depth gives its end and the sides that
// stand off the wall.
std::vector<SectionFace> facade_faces(const Facade& facade, double metres_per_unit = 1);

// The points near a section, one for each cell: as many as paper can show. Memory grows with the cells that contain a
// point.
class SectionPoints {
 public:
  // Takes points at most `half_m` from the plane. The size of a cell is `cell_m`.
  SectionPoints(const SectionPlane& plane, double half_m, double cell_m, double metres_per_unit = 1);
  void add(std::span<const Vec3> points);  // CRS; in any order
  std::vector<FlatPoint> places() const;   // metres, in the axes of the plane; the middles of cells, by row

 private:
  SectionPlane plane_;
  double half_, cell_, metres_;
  std::vector<std::pair<std::int64_t, std::int64_t>> cells_;  // sorted up to sorted_, then by arrival
  std::size_t sorted_ = 0;
  void sort_unique();
};

// Returns a sheet with the cut (joined within a tenth of a millimetre) and the points, in the axes of the section's
// plane. `where` names the section in the title block: "Section at 4.50".
Drawing section_drawing(const Facade& facade, const SectionPlane& plane, std::span<const SectionFace> faces,
                        std::span<const FlatPoint> points, const std::string& where,
                        const FacadeDrawingParams& params = {});

}  // namespace ilot
