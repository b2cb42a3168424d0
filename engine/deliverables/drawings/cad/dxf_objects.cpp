// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/cad/dxf_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "engine/deliverables/drawings/cad/dxf_entities.h"

namespace ilot {
namespace {

constexpr const char* kSheet = "Sheet";  // name of the layout

constexpr unsigned kRoot = 0xC, kLayouts = 0x1A;  // dictionaries

void begin_object(DxfTags& tags, const char* type, unsigned handle, unsigned owner) {
  tags.add(0, type);
  tags.handle(handle);
  tags.add(102, "{ACAD_REACTORS");
  tags.handle(owner, 330);
  tags.add(102, "}");
  tags.handle(owner, 330);
}

void begin_dictionary(DxfTags& tags, unsigned handle, unsigned owner) {
  begin_object(tags, "DICTIONARY", handle, owner);
  tags.add(100, "AcDbDictionary");
  tags.add(281, 1);
}

// The paper as a printer is asked for it: "ISO_full_bleed_A3_(420.00_x_297.00_MM)".
std::string name_of_paper(double width, double height) {
  constexpr std::array<std::pair<const char*, double>, 5> kPapers{
      {{"A4", 210}, {"A3", 297}, {"A2", 420}, {"A1", 594}, {"A0", 841}}};
  const auto found = std::find_if(kPapers.begin(), kPapers.end(), [&](const auto& size) {
    return std::abs(std::min(width, height) - size.second) < 0.5;
  });
  return fmt::format("{}_({}_x_{}_MM)",
                     found == kPapers.end() ? std::string("USER") : std::string("ISO_full_bleed_") + found->first,
                     decimal(width, 2), decimal(height, 2));
}

// Settings for printing. Of a sheet: its paper, one millimetre of it is one on paper.
void write_plot_settings(DxfTags& tags, const FlatBox& box, bool paper) {
  tags.add(100, "AcDbPlotSettings");
  tags.add(1, "");
  tags.add(2, paper ? "DWG To PDF.pc3" : "none_device");
  tags.add(4, paper ? name_of_paper(box.width(), box.height()) : "");
  tags.add(6, "");
  for (int code = 40; code <= 49; ++code)
    tags.number(code, paper && code == 44 ? box.width() : paper && code == 45 ? box.height() : 0, 1);
  for (const auto& [code, value] : {std::pair{140, 0}, {141, 0}, {142, 1}, {143, 1}}) tags.number(code, value, 1);
  for (const auto& [code, value] :
       {std::pair{70, paper ? 688 : 1712}, {72, paper ? 1 : 0}, {73, 0}, {74, paper ? 5 : 0}})
    tags.add(code, value);
  tags.add(7, "");
  for (const auto& [code, value] : {std::pair{75, paper ? 16 : 0}, {76, 0}, {77, 2}, {78, 300}}) tags.add(code, value);
  for (const auto& [code, value] : {std::pair{147, 1}, {148, 0}, {149, 0}}) tags.number(code, value, 1);
}

struct DxfLayout {
  const char* name;
  int tab;
  unsigned handle, space, view;  // view 0: none
  FlatBox box;                   // of a sheet in millimetres of its paper
};

void write_layout(DxfTags& tags, const DxfLayout& layout) {
  const FlatBox& box = layout.box;
  begin_object(tags, "LAYOUT", layout.handle, kLayouts);
  write_plot_settings(tags, box, layout.tab > 0);
  tags.words({{100, "AcDbLayout"}, {1, layout.name}});
  tags.add(70, 1);
  tags.add(71, layout.tab);
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
  tags.handle(layout.space, 330);
  if (layout.view != 0) tags.handle(layout.view, 331);
}

void write_layouts(DxfTags& tags, const Drawing& drawing) {
  constexpr unsigned kModel = 0x22, kPaper = 0x1E, kModelView = 0x29;
  const double mm = drawing.paper_mm(1);
  const FlatBox paper{{0, 0}, {drawing.sheet.width() / mm, drawing.sheet.height() / mm}};
  const bool has_view = paper.width() > 0 && paper.height() > 0;
  begin_dictionary(tags, kLayouts, kRoot);
  for (const auto& [name, handle] : {std::pair{"Model", kModel}, {kSheet, kPaper}}) {
    tags.add(3, name);
    tags.handle(handle, 350);
  }
  write_layout(tags, {"Model", 0, kModel, kDxfModelSpace, kModelView, drawing.sheet});
  write_layout(tags, {kSheet, 1, kPaper, kDxfPaperSpace, has_view ? kDxfPaperView : 0, paper});
}

// The file of the raster under the drawing.
void write_image_objects(DxfTags& tags, const DrawingImage& image) {
  begin_dictionary(tags, kDxfImageList, kRoot);
  tags.add(3, dxf_text(image.file));
  tags.handle(kDxfImageFile, 350);
  begin_object(tags, "RASTERVARIABLES", kDxfRasterVariables, kRoot);
  tags.add(100, "AcDbRasterVariables");
  constexpr int kMetres = 3;
  for (const auto& [code, value] : {std::pair{90, 0}, {70, 0}, {71, 1}, {72, kMetres}}) tags.add(code, value);
  tags.words({{0, "IMAGEDEF"}});
  tags.handle(kDxfImageFile);
  tags.words({{102, "{ACAD_REACTORS"}});
  tags.handle(kDxfImageList, 330);
  tags.handle(kDxfImageReactor, 330);
  tags.words({{102, "}"}});
  tags.handle(kDxfImageList, 330);
  tags.add(100, "AcDbRasterImageDef");
  tags.add(90, 0);
  tags.add(1, dxf_text(image.file));
  tags.point(10, image.width, image.height);
  constexpr int kPixelDecimals = 12;
  tags.number(11, image.place.width() / image.width, kPixelDecimals);
  tags.number(21, image.place.height() / image.height, kPixelDecimals);
  tags.add(280, 1);
  tags.add(281, 0);
  tags.words({{0, "IMAGEDEF_REACTOR"}});
  tags.handle(kDxfImageReactor);
  tags.handle(kDxfImage, 330);
  tags.add(100, "AcDbRasterImageDefReactor");
  tags.add(90, 2);
  tags.handle(kDxfImage, 330);
}

}  // namespace

void write_dxf_objects(DxfTags& tags, const Drawing& drawing) {
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
  if (drawing.image) {
    tags.add(3, "ACAD_IMAGE_DICT");
    tags.handle(kDxfImageList, 350);
    tags.add(3, "ACAD_IMAGE_VARS");
    tags.handle(kDxfRasterVariables, 350);
  }
  begin_dictionary(tags, 0xD, kRoot);
  begin_dictionary(tags, 0x19, kRoot);
  begin_object(tags, "ACDBDICTIONARYWDFLT", 0xE, kRoot);
  tags.add(100, "AcDbDictionary");
  tags.add(281, 1);
  tags.words({{3, "Normal"}, {350, "F"}, {100, "AcDbDictionaryWithDefault"}, {340, "F"}});
  write_layouts(tags, drawing);
  begin_object(tags, "ACDBPLACEHOLDER", 0xF, 0xE);
  if (drawing.image) write_image_objects(tags, *drawing.image);
  tags.words({{0, "ENDSEC"}, {0, "EOF"}});
}

}  // namespace ilot
