// SPDX-License-Identifier: Apache-2.0
// The entities of a DXF file.
#pragma once
#include <string>

#include "engine/deliverables/drawings/cad/dxf_tags.h"
#include "engine/deliverables/drawings/drawing.h"
#include "engine/deliverables/drawings/drawing_layers.h"

namespace ilot {

// Handles of the skeleton that entities and tables refer to.
constexpr unsigned kDxfModelSpace = 0x1F, kDxfPaperSpace = 0x1B, kDxfTextStyle = 0x11, kDxfImageList = 0x30,
                   kDxfImageFile = 0x31, kDxfImageReactor = 0x32, kDxfRasterVariables = 0x33, kDxfDimensionStyle = 0x34,
                   kDxfPaperView = 0x35, kDxfWindow = 0x36, kDxfViewLayer = 0x37, kDxfImage = 0x38;
constexpr const char *kDxfDimensionStyleName = "ILOT", *kDxfViewLayerName = "Defpoints";

// Where entities are: the block record that owns them, and whether that is the paper space.
struct DxfSpace {
  unsigned owner = kDxfModelSpace;
  bool paper = false;
};

const char* pattern_of(const DrawingLayer& layer);  // the name of its line type
int lineweight_of(const DrawingLayer& layer);       // in hundredths of a millimetre

// Writes entities of one space. Handles are taken from a counter that all spaces share.
class DxfEntities {
 public:
  DxfEntities(const DrawingLayers& layers, DxfSpace space, unsigned& handle)
      : layers_(layers), space_(space), handle_(handle) {}

  // Lines of fewer than two different corners, arcs without a radius and empty texts are left out.
  void add(const DrawingLine& line);
  void add(const DrawingArc& arc);
  void add(const DrawingPoint& point);
  void add(const DrawingText& text);

  // A reference to a block, with the attributes of the piece below each other, each `height` high and not shown.
  void add_insert(const DrawingBlock& block, const std::string& name, double height);
  // What a block says of its attributes. The block's own place is the origin.
  void add_definitions(const DrawingBlock& block, double height);
  void add_dimension(const DrawingDimension& dimension, const std::string& block);
  // The edge of the paper, on a layer that is never printed: a print of everything has the scale of the sheet.
  void add_paper(const FlatBox& sheet);
  void add_image(const DrawingImage& image);
  // The view of the paper itself, and a viewport that shows the whole sheet of the drawing at its scale, in millimetres
  // of paper.
  void add_viewports(const Drawing& drawing);

  const std::string& text() const { return tags_.text(); }

 private:
  void begin(const char* type, const char* kind, DrawingRole role, bool is_sample = false);
  void begin_on(const char* type, unsigned handle, const std::string& layer);
  void viewport(unsigned handle, int number, const FlatBox& box, FlatPoint middle, double height);

  const DrawingLayers& layers_;
  DxfSpace space_;
  unsigned& handle_;
  DxfTags tags_;
};

}  // namespace ilot
