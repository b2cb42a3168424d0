// SPDX-License-Identifier: Apache-2.0
// What an office reads of why an edge or a face of a facade is believed.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engine/deliverables/drawings/drawing_svg.h"
#include "engine/deliverables/drawings/facade_plan.h"
#include "engine/model/facade.h"

namespace ilot {

// How much speaks for a line: points alone, not what regularisation says.
enum class EvidenceGrade : std::uint8_t {
  good,  // seen, by points
  weak,  // completed, or half of it without points, or seen by no station
  none,  // no point supports it
};
EvidenceGrade evidence_grade(const FacadeEdge& edge);

// Where an edge of a ring lies: "bottom", "right", "top" or "left", by the way that it looks.
const char* side_of(const DrawingCorner& from, const DrawingCorner& to);

// "5 window, left: 143 points, 2.1 mm RMS, along 98 % of it, 12 % occluded, within 4.0 mm, seen". An edge that may be a
// chord of an arc is said with all of it.
std::string words_of(const FacadeElement& element, const char* side, const FacadeEdge& edge);

// Every edge of the elements, to lie over a drawing.
std::vector<SvgNote> edge_notes(const FacadeElement& element, const FlatElement& flat);

// Rows of a table of edges and faces: element, kind, which, status, points, RMS and error in mm, covered and occluded
// in percent. At most so many; returns how many there are.
std::size_t add_evidence_rows(const FacadeElement& element, const FlatElement& flat, std::size_t most,
                              std::string& rows);

}  // namespace ilot
