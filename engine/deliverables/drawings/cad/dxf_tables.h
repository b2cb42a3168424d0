// SPDX-License-Identifier: Apache-2.0
// What a DXF file has before its blocks and entities: variables, classes and tables.
#pragma once
#include <string>
#include <vector>

#include "engine/deliverables/drawings/cad/dxf_tags.h"
#include "engine/deliverables/drawings/drawing.h"
#include "engine/deliverables/drawings/drawing_layers.h"

namespace ilot {

struct DxfBlockName {
  std::string name;
  unsigned record = 0;  // handle of its record
};

// Writes the sections HEADER and CLASSES.
void write_dxf_header(DxfTags& tags, const Drawing& drawing, unsigned next_handle);

// Writes the section TABLES. Layers take their handles from the counter.
void write_dxf_tables(DxfTags& tags, const Drawing& drawing, const DrawingLayers& layers,
                      const std::vector<DxfBlockName>& blocks, unsigned& handle);

}  // namespace ilot
