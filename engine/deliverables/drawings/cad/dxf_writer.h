// SPDX-License-Identifier: Apache-2.0
// A drawing as DXF (AutoCAD R2000, ASCII), in metres in model space.
//
// ilot has its own writer because GDAL 3.6, the only available library, turns arcs into chords (a half circle became a
// polyline of 46 corners without a bulge), sets layer tables only through a template, and writes no switched-off
// layers, text styles or line patterns. CAD programs are known to open GDAL's skeleton of header, tables, blocks and
// objects. So this writer has the same records in the same order under the same handles.
#pragma once
#include <filesystem>
#include <string>

#include "engine/deliverables/drawings/drawing.h"
#include "engine/deliverables/drawings/drawing_layers.h"

namespace ilot {

// Closed lines are closed LWPOLYLINEs with bulges, arcs are ARCs, dimensions are DIMENSIONs with their picture, blocks
// are INSERTs with attributes (those of one shape share a definition), the image is an IMAGE below everything, and the
// paper space has a viewport at the scale of the drawing; everything else is LWPOLYLINE, POINT or TEXT. Colour, pen and
// pattern are those of the layer, except for samples, which are on the layer of titles. Every layer is declared. Text
// beyond ASCII is written as \U+XXXX, which every program reads with any code page. Text that would be a control
// sequence of the format is broken up. Coordinates are given to a hundredth of a millimetre. There are no time stamps:
// the same drawing gives the same bytes. Lines of fewer than two different corners are left out. Throws Error for a
// coordinate that is not finite.
std::string drawing_dxf(const Drawing& drawing, const DrawingLayers& layers);
void write_drawing_dxf(const std::filesystem::path& path, const Drawing& drawing, const DrawingLayers& layers);

}  // namespace ilot
