// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/dxf_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>

#include "engine/deliverables/drawings/dxf_tags.h"
#include "engine/version.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

constexpr int kBulgeDecimals = 9;
constexpr unsigned kFirstHandle = 0x100;  // of layers and entities; lower ones belong to the skeleton

void write_header(DxfTags& tags, const Drawing& drawing, unsigned next_handle) {
  tags.words({{0, "SECTION"}, {2, "HEADER"}, {9, "$ACADVER"}, {1, "AC1015"}, {9, "$DWGCODEPAGE"}, {3, "ANSI_1252"}});
  const FlatBox box = extent_of(drawing);
  const auto corner = [&](const char* name, double x, double y, bool deep) {
    tags.add(9, name);
    deep ? tags.point3(10, x, y) : tags.point(10, x, y);
  };
  tags.words({{9, "$INSBASE"}});
  tags.point3(10, 0, 0);
  corner("$EXTMIN", box.min.x, box.min.y, true);
  corner("$EXTMAX", box.max.x, box.max.y, true);
  corner("$LIMMIN", drawing.sheet.min.x, drawing.sheet.min.y, false);
  corner("$LIMMAX", drawing.sheet.max.x, drawing.sheet.max.y, false);
  // The size of the paper, in metres of paper.
  const double paper = 1 / drawing.scale;
  corner("$PLIMMIN", 0, 0, false);
  corner("$PLIMMAX", paper * drawing.sheet.width(), paper * drawing.sheet.height(), false);
  // Lengths of patterns are in millimetres of paper.
  tags.add(9, "$LTSCALE");
  tags.number(40, drawing.paper_mm(1));
  tags.add(9, "$TEXTSIZE");
  tags.number(40, drawing.paper_mm(2.5));
  tags.words({{9, "$TEXTSTYLE"}, {7, "Standard"}, {9, "$CLAYER"}, {8, "0"}, {9, "$CELTYPE"}, {6, "ByLayer"}});
  const auto whole = [&](const char* name, int code, int value) {
    tags.add(9, name);
    tags.add(code, value);
  };
  whole("$CECOLOR", 62, 256);
  whole("$LUNITS", 70, 2);
  whole("$LUPREC", 70, 3);
  whole("$AUNITS", 70, 0);
  whole("$MEASUREMENT", 70, 1);
  whole("$INSUNITS", 70, 6);
  whole("$LWDISPLAY", 290, 1);
  whole("$CELWEIGHT", 370, -1);
  whole("$PDMODE", 70, 0);
  whole("$PSTYLEMODE", 290, 1);
  tags.add(9, "$HANDSEED");
  tags.handle(next_handle);
  tags.words({{0, "ENDSEC"}});
  tags.words({{0, "SECTION"},
              {2, "CLASSES"},
              {0, "CLASS"},
              {1, "ACDBDICTIONARYWDFLT"},
              {2, "AcDbDictionaryWithDefault"},
              {3, "ObjectDBX Classes"}});
  tags.add(90, 0);
  tags.add(280, 0);
  tags.add(281, 0);
  tags.words({{0, "ENDSEC"}});
}

void begin_table(DxfTags& tags, const char* name, unsigned handle, int entries) {
  tags.words({{0, "TABLE"}, {2, name}});
  tags.handle(handle);
  tags.words({{330, "0"}, {100, "AcDbSymbolTable"}});
  tags.add(70, entries);
}

void begin_record(DxfTags& tags, const char* type, unsigned handle, unsigned owner, const char* kind,
                  int handle_code = 5) {
  tags.add(0, type);
  tags.handle(handle, handle_code);
  tags.handle(owner, 330);
  tags.words({{100, "AcDbSymbolTableRecord"}, {100, kind}});
}

void write_view(DxfTags& tags, const Drawing& drawing) {
  begin_table(tags, "VPORT", 0x8, 1);
  begin_record(tags, "VPORT", 0x29, 0x8, "AcDbViewportTableRecord");
  tags.add(2, "*Active");
  tags.add(70, 0);
  const double width = std::max(drawing.sheet.width(), 1e-3), height = std::max(drawing.sheet.height(), 1e-3);
  tags.point(10, 0, 0);
  tags.point(11, 1, 1);
  tags.point(12, (drawing.sheet.min.x + drawing.sheet.max.x) / 2, (drawing.sheet.min.y + drawing.sheet.max.y) / 2);
  tags.point(13, 0, 0);
  tags.point(14, 0.5, 0.5);
  tags.point(15, 0.5, 0.5);
  tags.number(16, 0), tags.number(26, 0), tags.number(36, 1);
  tags.point3(17, 0, 0);
  tags.number(40, std::max(height, width * 0.6));
  tags.number(41, 1.6667);
  tags.number(42, 50);
  for (const int code : {43, 44, 50, 51}) tags.number(code, 0);
  for (const auto& [code, value] : {std::pair{71, 0}, {72, 1000}, {73, 1}, {74, 3}, {75, 0}, {76, 0}, {77, 0}, {78, 0}})
    tags.add(code, value);
  tags.words({{0, "ENDTAB"}});
}

// Lengths are in millimetres of paper; $LTSCALE converts them to metres. A negative length is a gap.
void write_patterns(DxfTags& tags) {
  struct Pattern {
    const char *name, *description;
    unsigned handle;
    std::vector<double> dashes;
  };
  begin_table(tags, "LTYPE", 0x5, 5);
  for (const Pattern& p :
       {Pattern{"ByBlock", "", 0x14, {}}, Pattern{"ByLayer", "", 0x15, {}},
        Pattern{"Continuous", "Solid line", 0x16, {}}, Pattern{"DASHED", "Dashed __ __ __", 0x17, {3, -1.5}},
        Pattern{"DOTTED", "Dotted _ _ _ _", 0x18, {0.5, -1}}}) {
    begin_record(tags, "LTYPE", p.handle, 0x5, "AcDbLinetypeTableRecord");
    tags.add(2, p.name);
    tags.add(70, 0);
    tags.add(3, p.description);
    tags.add(72, 65);
    tags.add(73, static_cast<int>(p.dashes.size()));
    double sum = 0;
    for (const double dash : p.dashes) sum += std::abs(dash);
    tags.number(40, sum);
    for (const double dash : p.dashes) {
      tags.number(49, dash);
      tags.add(74, 0);
    }
  }
  tags.words({{0, "ENDTAB"}});
}

const char* pattern_of(const DrawingLayer& layer) {
  return layer.pattern == LinePattern::dashed   ? "DASHED"
         : layer.pattern == LinePattern::dotted ? "DOTTED"
                                                : "Continuous";
}

int lineweight_of(const DrawingLayer& layer) {
  return static_cast<int>(std::lround(layer.lineweight_mm * 100));
}

// Writes layer 0 and the layers of all roles, each once, by name.
void write_layers(DxfTags& tags, const DrawingLayers& layers, unsigned& handle) {
  std::map<std::string, const DrawingLayer*> by_name;
  for (const DrawingLayer& layer : layers.of_role) by_name.try_emplace(layer.name, &layer);
  by_name.erase("0");
  begin_table(tags, "LAYER", 0x2, static_cast<int>(by_name.size()) + 1);
  // Layers that are not shown are frozen. A negative colour would mean switched off, but some programs read it as no
  // colour.
  const auto record = [&](unsigned own, const std::string& name, bool shown, int colour, const char* pattern, int pen) {
    begin_record(tags, "LAYER", own, 0x2, "AcDbLayerTableRecord");
    tags.add(2, name);
    tags.add(70, shown ? 0 : 1);
    tags.add(62, colour);
    tags.add(6, pattern);
    tags.add(370, pen);
    tags.handle(0xF, 390);
  };
  record(0x10, "0", true, 7, "Continuous", -3);
  for (const auto& [name, layer] : by_name)
    record(handle++, name, layer->shown, layer->colour, pattern_of(*layer), lineweight_of(*layer));
  tags.words({{0, "ENDTAB"}});
}

void write_other_tables(DxfTags& tags) {
  begin_table(tags, "STYLE", 0x3, 1);
  begin_record(tags, "STYLE", 0x11, 0x3, "AcDbTextStyleTableRecord");
  tags.add(2, "Standard");
  tags.add(70, 0);
  tags.number(40, 0), tags.number(41, 1), tags.number(50, 0);
  tags.add(71, 0);
  tags.number(42, 0.125);
  tags.words({{3, "arial.ttf"}, {4, ""}, {0, "ENDTAB"}});
  begin_table(tags, "VIEW", 0x6, 0);
  tags.words({{0, "ENDTAB"}});
  begin_table(tags, "UCS", 0x7, 0);
  tags.words({{0, "ENDTAB"}});
  begin_table(tags, "APPID", 0x9, 1);
  begin_record(tags, "APPID", 0x12, 0x9, "AcDbRegAppTableRecord");
  tags.add(2, "ACAD");
  tags.add(70, 0);
  tags.words({{0, "ENDTAB"}});
  begin_table(tags, "DIMSTYLE", 0xA, 1);
  tags.words({{100, "AcDbDimStyleTable"}});
  begin_record(tags, "DIMSTYLE", 0x27, 0xA, "AcDbDimStyleTableRecord", 105);
  tags.add(2, "Standard");
  tags.add(70, 0);
  tags.handle(0x11, 340);
  tags.words({{0, "ENDTAB"}});
  begin_table(tags, "BLOCK_RECORD", 0x1, 2);
  begin_record(tags, "BLOCK_RECORD", 0x1F, 0x1, "AcDbBlockTableRecord");
  tags.add(2, "*Model_Space");
  tags.handle(0x22, 340);
  begin_record(tags, "BLOCK_RECORD", 0x1B, 0x1, "AcDbBlockTableRecord");
  tags.add(2, "*Paper_Space");
  tags.handle(0x1E, 340);
  tags.words({{0, "ENDTAB"}, {0, "ENDSEC"}});
}

void write_block(DxfTags& tags, const char* name, unsigned begin, unsigned record, bool paper) {
  tags.add(0, "BLOCK");
  tags.handle(begin);
  tags.handle(record, 330);
  tags.add(100, "AcDbEntity");
  if (paper) tags.add(67, 1);
  tags.words({{8, "0"}, {100, "AcDbBlockBegin"}, {2, name}});
  tags.add(70, 0);
  tags.point3(10, 0, 0);
  tags.words({{3, name}, {1, ""}, {0, "ENDBLK"}});
  tags.handle(begin + 1);
  tags.handle(record, 330);
  tags.add(100, "AcDbEntity");
  if (paper) tags.add(67, 1);
  tags.words({{8, "0"}, {100, "AcDbBlockEnd"}});
}

class Entities {
 public:
  Entities(const DrawingLayers& layers, unsigned first_handle) : layers_(layers), handle_(first_handle) {}

  void add(const DrawingLine& line) {
    std::vector<DrawingCorner> corners;
    for (const DrawingCorner& c : line.corners)
      if (corners.empty() || !same_place(corners.back(), c))
        corners.push_back(c);
      else
        corners.back().bulge = c.bulge;
    if (line.closed)
      while (corners.size() > 1 && same_place(corners.front(), corners.back())) corners.pop_back();
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
  void add(const DrawingArc& arc) {
    if (decimal(arc.radius, kCoordinateDecimals) == decimal(0, kCoordinateDecimals)) return;
    begin("ARC", "AcDbCircle", arc.role);
    tags_.point3(10, arc.x, arc.y);
    tags_.number(40, arc.radius);
    tags_.add(100, "AcDbArc");
    tags_.number(50, arc.from_deg);
    tags_.number(51, arc.to_deg);
  }
  void add(const DrawingPoint& point) {
    begin("POINT", "AcDbPoint", point.role);
    tags_.point3(10, point.x, point.y);
  }
  void add(const DrawingText& text) {
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
  const std::string& text() const { return tags_.text(); }
  unsigned next_handle() const { return handle_; }

 private:
  static bool same_place(const DrawingCorner& a, const DrawingCorner& b) {
    return decimal(a.x, kCoordinateDecimals) == decimal(b.x, kCoordinateDecimals) &&
           decimal(a.y, kCoordinateDecimals) == decimal(b.y, kCoordinateDecimals);
  }
  void begin(const char* type, const char* kind, DrawingRole role, bool is_sample = false) {
    tags_.add(0, type);
    tags_.handle(handle_++);
    tags_.words({{330, "1F"}, {100, "AcDbEntity"}});
    tags_.add(8, layers_[is_sample ? DrawingRole::title : role].name);
    if (is_sample) {
      tags_.add(6, pattern_of(layers_[role]));
      tags_.add(62, layers_[role].colour);
      tags_.add(370, lineweight_of(layers_[role]));
    }
    tags_.add(100, kind);
  }
  const DrawingLayers& layers_;
  DxfTags tags_;
  unsigned handle_;
};

void begin_object(DxfTags& tags, const char* type, const char* handle, const char* owner) {
  tags.words({{0, type}, {5, handle}, {102, "{ACAD_REACTORS"}, {330, owner}, {102, "}"}, {330, owner}});
}

void begin_dictionary(DxfTags& tags, const char* handle, const char* owner) {
  begin_object(tags, "DICTIONARY", handle, owner);
  tags.add(100, "AcDbDictionary");
  tags.add(281, 1);
}

void write_layout(DxfTags& tags, const Drawing& drawing, const char* handle, const char* name, bool paper) {
  begin_object(tags, "LAYOUT", handle, "1A");
  tags.words({{100, "AcDbPlotSettings"}, {1, ""}, {2, "none_device"}, {4, ""}, {6, ""}});
  for (int code = 40; code <= 49; ++code) tags.number(code, 0, 1);
  for (const auto& [code, value] : {std::pair{140, 0}, {141, 0}, {142, 1}, {143, 1}}) tags.number(code, value, 1);
  for (const auto& [code, value] : {std::pair{70, paper ? 688 : 1712}, {72, 0}, {73, 0}, {74, paper ? 5 : 0}})
    tags.add(code, value);
  tags.add(7, "");
  for (const auto& [code, value] : {std::pair{75, paper ? 16 : 0}, {76, 0}, {77, 2}, {78, 300}}) tags.add(code, value);
  for (const auto& [code, value] : {std::pair{147, 1}, {148, 0}, {149, 0}}) tags.number(code, value, 1);
  tags.words({{100, "AcDbLayout"}, {1, name}});
  tags.add(70, 1);
  tags.add(71, paper ? 1 : 0);
  const FlatBox box = paper ? FlatBox{{0, 0}, {12, 9}} : drawing.sheet;
  tags.point(10, box.min.x, box.min.y);
  tags.point(11, box.max.x, box.max.y);
  tags.point3(12, 0, 0);
  tags.point3(14, box.min.x, box.min.y);
  tags.point3(15, box.max.x, box.max.y);
  tags.number(146, 0);
  tags.point3(13, 0, 0);
  tags.point3(16, 1, 0);
  tags.point3(17, 0, 1);
  tags.add(76, 0);
  tags.add(330, paper ? "1B" : "1F");
  if (!paper) tags.add(331, "29");
}

void write_objects(DxfTags& tags, const Drawing& drawing) {
  tags.words({{0, "SECTION"}, {2, "OBJECTS"}, {0, "DICTIONARY"}, {5, "C"}, {330, "0"}, {100, "AcDbDictionary"}});
  tags.add(281, 1);
  tags.words({{3, "ACAD_GROUP"},
              {350, "D"},
              {3, "ACAD_LAYOUT"},
              {350, "1A"},
              {3, "ACAD_PLOTSETTINGS"},
              {350, "19"},
              {3, "ACAD_PLOTSTYLENAME"},
              {350, "E"}});
  begin_dictionary(tags, "D", "C");
  begin_dictionary(tags, "1A", "C");
  tags.words({{3, "Layout1"}, {350, "1E"}, {3, "Model"}, {350, "22"}});
  begin_dictionary(tags, "19", "C");
  begin_object(tags, "ACDBDICTIONARYWDFLT", "E", "C");
  tags.add(100, "AcDbDictionary");
  tags.add(281, 1);
  tags.words({{3, "Normal"}, {350, "F"}, {100, "AcDbDictionaryWithDefault"}, {340, "F"}});
  write_layout(tags, drawing, "1E", "Layout1", true);
  write_layout(tags, drawing, "22", "Model", false);
  begin_object(tags, "ACDBPLACEHOLDER", "F", "E");
  tags.words({{0, "ENDSEC"}, {0, "EOF"}});
}

}  // namespace

std::string drawing_dxf(const Drawing& drawing, const DrawingLayers& layers) {
  unsigned handle = kFirstHandle;
  DxfTags tables;
  tables.words({{0, "SECTION"}, {2, "TABLES"}});
  write_view(tables, drawing);
  write_patterns(tables);
  write_layers(tables, layers, handle);
  write_other_tables(tables);
  tables.words({{0, "SECTION"}, {2, "BLOCKS"}});
  write_block(tables, "*Model_Space", 0x20, 0x1F, false);
  write_block(tables, "*Paper_Space", 0x1C, 0x1B, true);
  tables.words({{0, "ENDSEC"}, {0, "SECTION"}, {2, "ENTITIES"}});
  Entities entities(layers, handle);
  for (const DrawingLine& line : drawing.lines) entities.add(line);
  for (const DrawingArc& arc : drawing.arcs) entities.add(arc);
  for (const DrawingPoint& point : drawing.points) entities.add(point);
  for (const DrawingText& text : drawing.texts) entities.add(text);
  DxfTags head, tail;
  head.add(999, "ilot " + version());
  write_header(head, drawing, entities.next_handle());
  tail.words({{0, "ENDSEC"}});
  write_objects(tail, drawing);
  return head.text() + tables.text() + entities.text() + tail.text();
}

void write_drawing_dxf(const std::filesystem::path& path, const Drawing& drawing, const DrawingLayers& layers) {
  write_whole_file(path, drawing_dxf(drawing, layers));
}

}  // namespace ilot
