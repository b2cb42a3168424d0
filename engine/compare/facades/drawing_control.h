// SPDX-License-Identifier: Apache-2.0
// Compares a drawing of ours with the same drawing after a surveyor has corrected it. [Marchand 2018, II.5.3]
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engine/compare/facades/control_points.h"
#include "engine/deliverables/drawings/cad/dxf_reader.h"
#include "engine/deliverables/drawings/drawing_layers.h"

namespace ilot {

struct DrawingControlParams {
  double limit_m = 0.3;                          // vertices farther apart are not homologous
  DrawingLayers layers = preset_layers("ilot");  // the layers that contain elements; other layers are not judged
};

// A pair of homologous vertices.
struct VertexControl {
  double x = 0, z = 0;    // position of the corrected vertex in its drawing
  double dx = 0, dz = 0;  // ours minus corrected
  double dd = 0;
};

struct LayerControl {
  std::string layer;                       // empty: all layers, where homologous vertices may be on different layers
  std::uint64_t corrected = 0;             // different vertices of the corrected drawing
  std::uint64_t paired = 0;                // corrected vertices with a homologous one in ours
  std::uint64_t missed = 0;                // corrected vertices without one: the surveyor drew them
  std::uint64_t removed = 0;               // our vertices without one: the surveyor removed them
  std::uint64_t moved = 0;                 // paired vertices that moved by more than a tenth of a millimetre
  MeanAndSpread dx_m, dz_m, dd_m;          // absolute differences along and up, and distances; over the paired vertices
  MeanAndSpread signed_dx_m, signed_dz_m;  // ours minus corrected: the systematic difference
  double largest_m = 0;
  std::vector<VertexControl> vertices;  // moved vertices, the farthest first
};

// Returns the layer of each role from outline to completed that one of the drawings uses, in the order of roles, then
// all of them together. Vertices are ends of lines, corners of polylines and ends of arcs; each position counts once.
// Each vertex serves at most one other. Pairs are made in the order of their distance (ties: lower left first). Both
// drawings must be in metres, otherwise a usage Error is thrown. O(n log n) for vertices spaced wider than the limit.
std::vector<LayerControl> compare_drawings(const DxfDrawing& ours, const DxfDrawing& corrected,
                                           const DrawingControlParams& params = {});

// Throws a usage Error that names the drawing when it is not in metres.
void check_drawing_units(const DxfDrawing& drawing, const char* which);

// The text is a table of layers, then of the 20 vertices that moved farthest. The JSON has all moved vertices with
// their layers.
std::string drawing_control_text(const std::vector<LayerControl>& layers);
std::string drawing_control_json(const std::vector<LayerControl>& layers);

}  // namespace ilot
