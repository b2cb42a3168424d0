// SPDX-License-Identifier: Apache-2.0
// A drawing of ours against the same drawing as a surveyor has corrected it. [Marchand 2018, II.5.3]
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engine/compare/control_points.h"
#include "engine/deliverables/drawings/drawing_layers.h"
#include "engine/deliverables/drawings/dxf_reader.h"

namespace ilot {

struct DrawingControlParams {
  double limit_m = 0.3;                          // vertices farther apart are not homologous
  DrawingLayers layers = preset_layers("ilot");  // which layers hold elements; the others are not judged
};

// A pair of homologous vertices.
struct VertexControl {
  double x = 0, z = 0;    // of the corrected one, in its drawing
  double dx = 0, dz = 0;  // ours less corrected
  double dd = 0;
};

struct LayerControl {
  std::string layer;                       // empty: all, whatever layers homologous vertices are on
  std::uint64_t corrected = 0;             // different vertices of the corrected drawing
  std::uint64_t paired = 0;                // that have a homologous one in ours
  std::uint64_t missed = 0;                // that have none: the surveyor drew them
  std::uint64_t removed = 0;               // of ours without one: the surveyor took them away
  std::uint64_t moved = 0;                 // paired, by more than a tenth of a millimetre
  MeanAndSpread dx_m, dz_m, dd_m;          // absolute, along and up, and distance; over those paired
  MeanAndSpread signed_dx_m, signed_dz_m;  // ours less corrected: what is off all over
  double largest_m = 0;
  std::vector<VertexControl> vertices;  // those moved, the farthest first
};

// The layer of each role from outline to completed that one of the drawings uses, in the order of roles, then all of
// them together. Vertices are ends of lines, corners of polylines and ends of arcs, each place once. One vertex serves
// one other, pairs in the order of their distance (ties: lower left first). Both drawings are in metres: a usage Error
// otherwise. O(n log n) for vertices spaced wider than the limit.
std::vector<LayerControl> compare_drawings(const DxfDrawing& ours, const DxfDrawing& corrected,
                                           const DrawingControlParams& params = {});

// A table of layers, then of the 20 vertices that moved farthest; as JSON all that moved, with their layers.
std::string drawing_control_text(const std::vector<LayerControl>& layers);
std::string drawing_control_json(const std::vector<LayerControl>& layers);

}  // namespace ilot
