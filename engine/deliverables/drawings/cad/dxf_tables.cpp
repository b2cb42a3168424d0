// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/cad/dxf_tables.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "engine/deliverables/drawings/cad/dxf_entities.h"
#include "engine/deliverables/drawings/dimension_style.h"

namespace ilot {
namespace {

// Sizes of dimensions, which some programs take from here and some from the style.
void write_dimension_variables(DxfTags& tags, const Drawing& drawing) {
  tags.words({{9, "$DIMSTYLE"}, {2, kDxfDimensionStyleName}});
  const auto number = [&](const char* name, double value) {
    tags.add(9, name);
    tags.number(40, value);
  };
  number("$DIMSCALE", drawing.paper_mm(1));
  number("$DIMASZ", kDimensionText);
  number("$DIMTXT", kDimensionText);
  number("$DIMTSZ", kDimensionTick);
  number("$DIMEXO", kDimensionOffset);
  number("$DIMEXE", kDimensionBeyond);
  number("$DIMGAP", kDimensionGap);
  number("$DIMLFAC", 1);
  for (const auto& [name, value] : {std::pair{"$DIMTIH", 0},
                                    {"$DIMTOH", 0},
                                    {"$DIMTAD", 1},
                                    {"$DIMZIN", 0},
                                    {"$DIMDEC", 2},
                                    {"$DIMLUNIT", 2},
                                    {"$DIMDSEP", drawing.decimal_comma ? ',' : '.'}}) {
    tags.add(9, name);
    tags.add(70, value);
  }
}

void write_classes(DxfTags& tags, const Drawing& drawing) {
  struct Class {
    const char *name, *kind, *application;
    int flags, is_entity;
  };
  tags.words({{0, "SECTION"}, {2, "CLASSES"}});
  const auto add = [&](const Class& c) {
    tags.words({{0, "CLASS"}, {1, c.name}, {2, c.kind}, {3, c.application}});
    tags.add(90, c.flags);
    tags.add(280, 0);
    tags.add(281, c.is_entity);
  };
  add({"ACDBDICTIONARYWDFLT", "AcDbDictionaryWithDefault", "ObjectDBX Classes", 0, 0});
  if (drawing.image) {
    add({"RASTERVARIABLES", "AcDbRasterVariables", "ISM", 0, 0});
    add({"IMAGE", "AcDbRasterImage", "ISM", 127, 1});
    add({"IMAGEDEF", "AcDbRasterImageDef", "ISM", 0, 0});
    add({"IMAGEDEF_REACTOR", "AcDbRasterImageDefReactor", "ISM", 1, 0});
  }
  tags.words({{0, "ENDSEC"}});
}

}  // namespace

void write_dxf_header(DxfTags& tags, const Drawing& drawing, unsigned next_handle) {
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
  // Lines in a viewport have the patterns of the model space.
  tags.words({{9, "$PSLTSCALE"}});
  tags.add(70, 0);
  tags.add(9, "$LTSCALE");
  tags.number(40, drawing.paper_mm(1));
  tags.add(9, "$TEXTSIZE");
  tags.number(40, drawing.paper_mm(2.5));
  tags.words({{9, "$TEXTSTYLE"}, {7, "Standard"}, {9, "$CLAYER"}, {8, "0"}, {9, "$CELTYPE"}, {6, "ByLayer"}});
  const auto whole = [&](const char* name, int code, int value) {
    tags.add(9, name);
    tags.add(code, value);
  };
  write_dimension_variables(tags, drawing);
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
  write_classes(tags, drawing);
}

namespace {

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

// Writes layer 0 and the layers of all roles, each once, by name.
void write_layers(DxfTags& tags, const DrawingLayers& layers, unsigned& handle) {
  std::map<std::string, const DrawingLayer*> by_name;
  for (const DrawingLayer& layer : layers.of_role) by_name.try_emplace(layer.name, &layer);
  for (const char* own : {"0", kDxfViewLayerName}) by_name.erase(own);
  begin_table(tags, "LAYER", 0x2, static_cast<int>(by_name.size()) + 2);
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
  // This layer is never printed.
  begin_record(tags, "LAYER", kDxfViewLayer, 0x2, "AcDbLayerTableRecord");
  tags.add(2, kDxfViewLayerName);
  tags.add(70, 0);
  tags.words({{62, "7"}, {6, "Continuous"}, {290, "0"}, {370, "-3"}});
  tags.handle(0xF, 390);
  tags.words({{0, "ENDTAB"}});
}

void write_dimension_styles(DxfTags& tags, const Drawing& drawing) {
  begin_table(tags, "DIMSTYLE", 0xA, 2);
  tags.words({{100, "AcDbDimStyleTable"}});
  begin_record(tags, "DIMSTYLE", 0x27, 0xA, "AcDbDimStyleTableRecord", 105);
  tags.add(2, "Standard");
  tags.add(70, 0);
  tags.handle(kDxfTextStyle, 340);
  begin_record(tags, "DIMSTYLE", kDxfDimensionStyle, 0xA, "AcDbDimStyleTableRecord", 105);
  tags.add(2, kDxfDimensionStyleName);
  tags.add(70, 0);
  for (const auto& [code, value] : {std::pair{40, drawing.paper_mm(1)},
                                    {41, kDimensionText},
                                    {42, kDimensionOffset},
                                    {44, kDimensionBeyond},
                                    {140, kDimensionText},
                                    {142, kDimensionTick},
                                    {144, 1.0},
                                    {147, kDimensionGap}})
    tags.number(code, value);
  for (const auto& [code, value] : {std::pair{73, 0},
                                    {74, 0},
                                    {77, 1},
                                    {78, 0},
                                    {172, 1},
                                    {271, 2},
                                    {277, 2},
                                    {278, drawing.decimal_comma ? ',' : '.'},
                                    {279, 2}})
    tags.add(code, value);
  tags.handle(kDxfTextStyle, 340);
  tags.words({{0, "ENDTAB"}});
}

void write_other_tables(DxfTags& tags, const Drawing& drawing, const std::vector<DxfBlockName>& blocks) {
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
  write_dimension_styles(tags, drawing);
  begin_table(tags, "BLOCK_RECORD", 0x1, static_cast<int>(blocks.size()) + 2);
  begin_record(tags, "BLOCK_RECORD", 0x1F, 0x1, "AcDbBlockTableRecord");
  tags.add(2, "*Model_Space");
  tags.handle(0x22, 340);
  begin_record(tags, "BLOCK_RECORD", 0x1B, 0x1, "AcDbBlockTableRecord");
  tags.add(2, "*Paper_Space");
  tags.handle(0x1E, 340);
  for (const DxfBlockName& block : blocks) {
    begin_record(tags, "BLOCK_RECORD", block.record, 0x1, "AcDbBlockTableRecord");
    tags.add(2, block.name);
    tags.add(340, "0");
  }
  tags.words({{0, "ENDTAB"}, {0, "ENDSEC"}});
}

}  // namespace

void write_dxf_tables(DxfTags& tags, const Drawing& drawing, const DrawingLayers& layers,
                      const std::vector<DxfBlockName>& blocks, unsigned& handle) {
  tags.words({{0, "SECTION"}, {2, "TABLES"}});
  write_view(tags, drawing);
  write_patterns(tags);
  write_layers(tags, layers, handle);
  write_other_tables(tags, drawing, blocks);
}

}  // namespace ilot
