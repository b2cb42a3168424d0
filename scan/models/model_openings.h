// SPDX-License-Identifier: Apache-2.0
// The outlines of windows, doors and installations of a model.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "scan/models/model_input.h"
#include "scan/models/outward.h"
#include "scan/truth_writer.h"

namespace ilot::scan {

struct ElementOutlines {
  std::vector<TrueElement> elements;  // numbered from 1, as element_of_faces() does
  std::vector<TrueOpening> openings;  // of windows and doors
  std::vector<Vec3> normals;          // of the walls, outward; one for each opening
  std::vector<char> flush;            // for each element
  std::vector<Vec3> outward;          // for each element
};

// The wall of an element is a wall or roof of its building that is parallel to it within 15 degrees and contains its
// middle: of those within 1 m the nearest, preferably one of its parent surface. Without one it is the plane of its own
// largest face. The outline is the outer ring of the union of all its faces, projected on the wall; if the largest
// piece is less than four fifths of this union, it is the convex hull. `depth` is the mean distance of the faces
// parallel to the wall from it, weighted by area. Facades are numbered by building and plane of the wall. Elements
// without area there have no ring.
ElementOutlines element_outlines(const ScannedModel& model, std::span<const std::uint32_t> elements,
                                 const Outward& outward);

}  // namespace ilot::scan
