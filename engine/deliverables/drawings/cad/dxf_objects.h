// SPDX-License-Identifier: Apache-2.0
// What a DXF file has after its entities: layouts and the file of the raster under the drawing.
#pragma once
#include "engine/deliverables/drawings/cad/dxf_tags.h"
#include "engine/deliverables/drawings/drawing.h"

namespace ilot {

// Writes the section OBJECTS and the end of the file. The layout "Sheet" is the paper of the drawing, in millimetres.
void write_dxf_objects(DxfTags& tags, const Drawing& drawing);

}  // namespace ilot
