// SPDX-License-Identifier: Apache-2.0
// The evidence for the edges and faces of a facade, in words that an office reads.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engine/deliverables/drawings/drawing_svg.h"
#include "engine/deliverables/drawings/facade_plan.h"
#include "engine/model/facade.h"

namespace ilot {

// How strong the evidence for a line is. Only points count, not the result of regularisation.
enum class EvidenceGrade : std::uint8_t {
  good,  // seen, and supported by points
  weak,  // completed, or half of it has no points or is occluded
  none,  // no point supports it
};
EvidenceGrade evidence_grade(const FacadeEdge& edge);

// Returns on which side of a ring an edge is: "bottom", "right", "top" or "left", from the direction that the edge
// faces.
const char* side_of(const DrawingCorner& from, const DrawingCorner& to);

// Returns for example "5 window, left: 143 points, 2.1 mm RMS, along 98 % of it, 12 % occluded, within 4.0 mm, seen".
// For an edge that stands for an arc, the values are those of the whole arc.
std::string words_of(const FacadeElement& element, const char* side, const FacadeEdge& edge);

// Returns a note for every edge of the elements, to be put over a drawing.
std::vector<SvgNote> edge_notes(const FacadeElement& element, const FlatElement& flat);

// Adds rows to a table of edges and faces: element, kind, which, status, points, RMS and error in mm, covered and
// occluded share in percent. Adds at most the given number of rows and returns how many there are.
std::size_t add_evidence_rows(const FacadeElement& element, const FlatElement& flat, std::size_t most,
                              std::string& rows);

}  // namespace ilot
