// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/cad/dxf_entities.h"

#include <cmath>
#include <vector>

namespace ilot {
namespace {

constexpr int kBulgeDecimals = 9;
constexpr double kLineOfAttributes = 1.6;  // in heights of their letters
constexpr int kNotShown = 1;               // flag of attributes

bool same_place(const DrawingCorner& a, const DrawingCorner& b) {
  return decimal(a.x, kCoordinateDecimals) == decimal(b.x, kCoordinateDecimals) &&
         decimal(a.y, kCoordinateDecimals) == decimal(b.y, kCoordinateDecimals);
}

std::vector<DrawingCorner> different_corners(const DrawingLine& line) {
  std::vector<DrawingCorner> corners;
  for (const DrawingCorner& c : line.corners)
    if (corners.empty() || !same_place(corners.back(), c))
      corners.push_back(c);
    else
      corners.back().bulge = c.bulge;
  if (line.closed)
    while (corners.size() > 1 && same_place(corners.front(), corners.back())) corners.pop_back();
  return corners;
}

}  // namespace

const char* pattern_of(const DrawingLayer& layer) {
  return layer.pattern == LinePattern::dashed   ? "DASHED"
         : layer.pattern == LinePattern::dotted ? "DOTTED"
                                                : "Continuous";
}

int lineweight_of(const DrawingLayer& layer) {
  return static_cast<int>(std::lround(layer.lineweight_mm * 100));
}

void DxfEntities::begin_on(const char* type, unsigned handle, const std::string& layer) {
  tags_.add(0, type);
  tags_.handle(handle);
  tags_.handle(space_.owner, 330);
  tags_.add(100, "AcDbEntity");
  if (space_.paper) tags_.add(67, 1);
  tags_.add(8, layer);
}

void DxfEntities::begin(const char* type, const char* kind, DrawingRole role, bool is_sample) {
  begin_on(type, handle_++, layers_[is_sample ? DrawingRole::title : role].name);
  if (is_sample) {
    tags_.add(6, pattern_of(layers_[role]));
    tags_.add(62, layers_[role].colour);
    tags_.add(370, lineweight_of(layers_[role]));
  }
  tags_.add(100, kind);
}

void DxfEntities::add(const DrawingLine& line) {
  const std::vector<DrawingCorner> corners = different_corners(line);
  if (corners.size() < 2) return;
  begin("LWPOLYLINE", "AcDbPolyline", line.role, line.is_sample);
  tags_.add(90, static_cast<int>(corners.size()));
  tags_.add(70, line.closed ? 1 : 0);
  tags_.number(43, 0);
  for (const DrawingCorner& c : corners) {
    tags_.point(10, c.x, c.y);
    if (c.bulge != 0) tags_.number(42, c.bulge, kBulgeDecimals);
  }
}

void DxfEntities::add(const DrawingArc& arc) {
  if (decimal(arc.radius, kCoordinateDecimals) == decimal(0, kCoordinateDecimals)) return;
  begin("ARC", "AcDbCircle", arc.role);
  tags_.point3(10, arc.x, arc.y);
  tags_.number(40, arc.radius);
  tags_.add(100, "AcDbArc");
  tags_.number(50, arc.from_deg);
  tags_.number(51, arc.to_deg);
}

void DxfEntities::add(const DrawingPoint& point) {
  begin("POINT", "AcDbPoint", point.role);
  tags_.point3(10, point.x, point.y);
}

void DxfEntities::add(const DrawingText& text) {
  const std::string written = dxf_text(text.text);
  if (written.find_first_not_of(' ') == std::string::npos) return;
  begin("TEXT", "AcDbText", text.role);
  tags_.point3(10, text.x, text.y);
  tags_.number(40, text.height);
  tags_.add(1, written);
  if (text.rotation_deg != 0) tags_.number(50, text.rotation_deg);
  tags_.add(7, "Standard");
  if (text.anchor != TextAnchor::left) {
    tags_.add(72, text.anchor == TextAnchor::middle ? 1 : 2);
    tags_.point3(11, text.x, text.y);
  }
  tags_.add(100, "AcDbText");
}

void DxfEntities::add_insert(const DrawingBlock& block, const std::string& name, double height) {
  begin("INSERT", "AcDbBlockReference", DrawingRole::opening);
  if (!block.attributes.empty()) tags_.add(66, 1);
  tags_.add(2, name);
  tags_.point3(10, block.place.x, block.place.y);
  if (block.attributes.empty()) return;
  double y = block.place.y;
  for (const DrawingAttribute& attribute : block.attributes) {
    begin("ATTRIB", "AcDbText", DrawingRole::number);
    tags_.point3(10, block.place.x, y);
    tags_.number(40, height);
    tags_.add(1, dxf_text(attribute.value));
    tags_.add(7, "Standard");
    tags_.words({{100, "AcDbAttribute"}, {2, attribute.tag.c_str()}});
    tags_.add(70, kNotShown);
    y += kLineOfAttributes * height;
  }
  begin_on("SEQEND", handle_++, layers_[DrawingRole::opening].name);
}

void DxfEntities::add_definitions(const DrawingBlock& block, double height) {
  double y = 0;
  for (const DrawingAttribute& attribute : block.attributes) {
    begin("ATTDEF", "AcDbText", DrawingRole::number);
    tags_.point3(10, 0, y);
    tags_.number(40, height);
    tags_.words({{1, ""}, {7, "Standard"}, {100, "AcDbAttributeDefinition"}});
    tags_.add(3, attribute.tag);
    tags_.add(2, attribute.tag);
    tags_.add(70, kNotShown);
    y += kLineOfAttributes * height;
  }
}

void DxfEntities::add_dimension(const DrawingDimension& d, const std::string& block) {
  constexpr int kOwnBlock = 32, kOwnPlaceOfText = 128, kMiddleOfText = 5;
  begin("DIMENSION", "AcDbDimension", DrawingRole::dimension);
  tags_.add(2, block);
  tags_.add(3, kDxfDimensionStyleName);
  const double up = d.text.height / 2;
  tags_.point3(10, d.upright ? d.at : d.to.x, d.upright ? d.to.y : d.at);
  tags_.point3(11, d.text.x - (d.upright ? up : 0), d.text.y + (d.upright ? 0 : up));
  tags_.add(70, kOwnBlock | kOwnPlaceOfText);
  tags_.add(71, kMiddleOfText);
  tags_.number(42, std::abs(d.upright ? d.to.y - d.from.y : d.to.x - d.from.x));
  tags_.words({{1, ""}, {100, "AcDbAlignedDimension"}});
  tags_.point3(13, d.from.x, d.from.y);
  tags_.point3(14, d.to.x, d.to.y);
  tags_.number(50, d.upright ? 90 : 0);
  tags_.add(100, "AcDbRotatedDimension");
}

void DxfEntities::add_image(const DrawingImage& image) {
  constexpr int kShown = 1 | 2, kTransparent = 8;
  begin_on("IMAGE", kDxfImage, layers_[DrawingRole::image].name);
  tags_.add(100, "AcDbRasterImage");
  tags_.add(90, 0);
  const double wide = image.width, high = image.height;
  tags_.point3(10, image.place.min.x, image.place.min.y);
  constexpr int kPixelDecimals = 12;
  tags_.number(11, image.place.width() / wide, kPixelDecimals), tags_.number(21, 0), tags_.number(31, 0);
  tags_.number(12, 0), tags_.number(22, image.place.height() / high, kPixelDecimals), tags_.number(32, 0);
  tags_.point(13, wide, high);
  tags_.handle(kDxfImageFile, 340);
  tags_.add(70, kShown | kTransparent);
  for (const auto& [code, value] : {std::pair{280, 0}, {281, 50}, {282, 50}, {283, 0}}) tags_.add(code, value);
  tags_.handle(kDxfImageReactor, 360);
  tags_.add(71, 1);
  tags_.add(91, 2);
  tags_.point(14, -0.5, -0.5);
  tags_.point(14, wide - 0.5, high - 0.5);
}

void DxfEntities::add_paper(const FlatBox& sheet) {
  if (!(sheet.width() > 0 && sheet.height() > 0)) return;
  begin_on("LWPOLYLINE", handle_++, kDxfViewLayerName);
  tags_.add(100, "AcDbPolyline");
  tags_.add(90, 4);
  tags_.add(70, 1);
  tags_.number(43, 0);
  for (const FlatPoint& p :
       {sheet.min, FlatPoint{sheet.max.x, sheet.min.y}, sheet.max, FlatPoint{sheet.min.x, sheet.max.y}})
    tags_.point(10, p.x, p.y);
}

void DxfEntities::viewport(unsigned handle, int number, const FlatBox& box, FlatPoint middle, double height) {
  begin_on("VIEWPORT", handle, kDxfViewLayerName);
  tags_.add(100, "AcDbViewport");
  tags_.point3(10, (box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2);
  tags_.number(40, box.width());
  tags_.number(41, box.height());
  tags_.add(68, number);
  tags_.add(69, number);
  tags_.point(12, middle.x, middle.y);
  tags_.point(13, 0, 0);
  tags_.point(14, 10, 10);
  tags_.point(15, 10, 10);
  tags_.number(16, 0), tags_.number(26, 0), tags_.number(36, 1);
  tags_.point3(17, 0, 0);
  tags_.number(42, 50);
  tags_.number(43, 0), tags_.number(44, 0);
  tags_.number(45, height);
  tags_.number(50, 0), tags_.number(51, 0);
  tags_.add(72, 100);
  constexpr int kUsual = 0x8060, kLocked = 0x4000;  // its scale does not change with the wheel of the mouse
  tags_.add(90, number == 1 ? kUsual : kUsual | kLocked);
  tags_.add(1, "");
  for (const auto& [code, value] : {std::pair{281, 0}, {71, 0}, {74, 0}}) tags_.add(code, value);
  tags_.point3(110, 0, 0);
  tags_.point3(111, 1, 0);
  tags_.point3(112, 0, 1);
  tags_.add(79, 0);
  tags_.number(146, 0);
}

void DxfEntities::add_viewports(const Drawing& drawing) {
  const double mm = drawing.paper_mm(1);
  const FlatBox paper{{0, 0}, {drawing.sheet.width() / mm, drawing.sheet.height() / mm}};
  viewport(kDxfPaperView, 1, paper, paper.middle(), paper.height());
  viewport(kDxfWindow, 2, paper, drawing.sheet.middle(), drawing.sheet.height());
}

}  // namespace ilot
