// SPDX-License-Identifier: Apache-2.0
// What a draughtsman changed in a drawing of ours, as a table of edits.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engine/deliverables/drawings/cad/dxf_reader.h"
#include "engine/deliverables/drawings/drawing_layers.h"
#include "engine/model/edit.h"
#include "engine/model/facade.h"
#include "kernels/geometry/flat_box.h"

namespace ilot {

// An opening of a drawing: a block, or a closed line on the layer of openings.
struct DrawnOpening {
  FlatBox box;          // metres in the drawing
  std::string kind;     // KIND of its block; else empty
  std::string id;       // ID of its block; else empty
  bool certain = true;  // false: a closed line on the layer of completed elements, which also has what is no opening
};

struct DrawnOpenings {
  std::vector<DrawnOpening> openings;
  std::uint64_t loose = 0;  // lines on the layer of openings that close no outline
};

// The openings of a drawing. Lines and polylines that meet end to end within a millimetre are one outline. Openings
// that were drawn twice count once. O(n log n), and O(loose lines^2).
DrawnOpenings drawn_openings(const DxfDrawing& drawing, const DrawingLayers& layers);

struct DrawingEdits {
  std::vector<Edit> edits;
  std::uint64_t unchanged = 0, loose = 0;
};

// The edits that make our drawing of a facade the corrected one. An opening of ours is paired with the corrected one
// that lies as it does, else with the one that has most of its area in common with it, else with the block of its ID.
// What differs by at most a tenth of a millimetre is unchanged. Both drawings must be in metres, otherwise a usage
// Error is thrown.
DrawingEdits drawing_edits(const DxfDrawing& ours, const DxfDrawing& corrected, const Facade& facade,
                           const DrawingLayers& layers);

}  // namespace ilot
