// SPDX-License-Identifier: Apache-2.0
// A drawing as DXF (AutoCAD R2000, ASCII), metres in model space.
//
// Why a writer of our own: GDAL 3.6, the one library at hand, turns arcs into chords (a half circle came out as a
// polyline of 46 corners without a bulge), sets layer tables only through a template and writes no switched-off layers,
// text styles or line patterns. What CAD programs are known to open is GDAL's skeleton of header, tables, blocks and
// objects, so this one has the same records in the same order under the same handles.
#pragma once
#include <filesystem>
#include <string>

#include "engine/deliverables/drawings/drawing.h"
#include "engine/deliverables/drawings/drawing_layers.h"

namespace ilot {

// Closed lines are closed LWPOLYLINEs with bulges, arcs ARCs, all else LWPOLYLINE, POINT and TEXT. Colour, pen and
// pattern are those of the layer, but of samples, which lie on the layer of titles; every layer is declared. Text
// beyond ASCII is written as \U+XXXX, which every program reads whatever its code page; what would be a control
// sequence of the format is taken apart. Coordinates to a hundredth of a millimetre. No time stamps: the same drawing
// gives the same bytes. Lines of fewer than two different corners are left out. Throws Error for a coordinate that is
// no number.
std::string drawing_dxf(const Drawing& drawing, const DrawingLayers& layers);
void write_drawing_dxf(const std::filesystem::path& path, const Drawing& drawing, const DrawingLayers& layers);

}  // namespace ilot
