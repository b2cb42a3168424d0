// SPDX-License-Identifier: Apache-2.0
// How QGIS draws a layer, as its style files (QML) say it. The colours are those of the report.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ilot/cloud_info.h"

namespace ilot {

enum class StyleSymbol : std::uint8_t { fill, line, dashed_line, marker };

struct StyleClass {
  std::string value;  // of the attribute; for ranges the upper end
  std::string label;
  std::string colour;  // red,green,blue
};

struct LayerStyle {
  std::string name;  // for people: "quality"
  StyleSymbol symbol = StyleSymbol::fill;
  std::string attribute;  // empty: all features look like the first class
  bool ranges = false;    // classes are ranges of numbers, from 0 or the class before up to their value
  std::vector<StyleClass> classes;
};

// The styles of what runs write.
LayerStyle style_of_buildings();  // by quality
LayerStyle style_of_roof_faces();
LayerStyle style_of_planes();  // by root mean square distance
LayerStyle style_of_objects(StyleSymbol symbol, const std::map<PointLabel, std::string>& classes);  // by class
LayerStyle style_of_blocks();
LayerStyle style_of_gaps();
LayerStyle style_of_kerbs();       // by whether they were seen
LayerStyle style_of_road_edges();  // by whether they were seen
LayerStyle style_of_pavements();
LayerStyle style_of_carriageways();
LayerStyle style_of_pavement_widths();          // by what is free of objects
LayerStyle style_of_trees(StyleSymbol symbol);  // by whether a trunk was seen

// Returns the style as QML, symbols only. The same style gives the same bytes.
std::string layer_style_qml(const LayerStyle& style);

}  // namespace ilot
