// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/layer_style.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/markup.h"
#include "engine/model/object_colours.h"
#include "engine/model/point_label.h"

namespace ilot {
namespace {

constexpr const char* kBlue = "43,131,198";
constexpr const char* kYellow = "239,184,31";
constexpr const char* kRed = "198,58,18";
constexpr const char* kGrey = "139,147,160";
constexpr const char* kInk = "27,35,48,255";

using Properties = std::vector<std::pair<const char*, std::string>>;

// Newer versions read <Option>, older ones <prop>.
std::string symbol_layer(const char* kind, const Properties& properties) {
  std::string options, old;
  for (const auto& [key, value] : properties) {
    options += fmt::format("<Option name=\"{}\" type=\"QString\" value=\"{}\"/>", key, value);
    old += fmt::format("<prop k=\"{}\" v=\"{}\"/>", key, value);
  }
  return fmt::format(
      "<layer class=\"{}\" enabled=\"1\" locked=\"0\" pass=\"0\"><Option type=\"Map\">{}</Option>{}</layer>", kind,
      options, old);
}

std::string symbol_qml(StyleSymbol symbol, std::size_t number, const std::string& colour) {
  const auto whole = [&](const char* type, const std::string& layer) {
    return fmt::format("<symbol type=\"{}\" name=\"{}\" alpha=\"1\" clip_to_extent=\"1\" force_rhr=\"0\">{}</symbol>\n",
                       type, number, layer);
  };
  if (symbol == StyleSymbol::fill)
    return whole("fill", symbol_layer("SimpleFill", {{"color", colour + ",150"},
                                                     {"style", "solid"},
                                                     {"outline_color", colour + ",255"},
                                                     {"outline_style", "solid"},
                                                     {"outline_width", "0.2"},
                                                     {"outline_width_unit", "MM"}}));
  if (symbol == StyleSymbol::marker)
    return whole("marker", symbol_layer("SimpleMarker", {{"name", "circle"},
                                                         {"color", colour + ",255"},
                                                         {"outline_color", kInk},
                                                         {"outline_width", "0.1"},
                                                         {"size", "2"},
                                                         {"size_unit", "MM"}}));
  return whole("line", symbol_layer("SimpleLine", {{"line_color", colour + ",255"},
                                                   {"line_style", symbol == StyleSymbol::line ? "solid" : "dash"},
                                                   {"line_width", symbol == StyleSymbol::line ? "0.7" : "0.4"},
                                                   {"line_width_unit", "MM"}}));
}

std::string renderer_qml(const LayerStyle& style) {
  std::string symbols, list;
  for (std::size_t i = 0; i < style.classes.size(); ++i) {
    const StyleClass& one = style.classes[i];
    symbols += symbol_qml(style.symbol, i, one.colour);
    if (style.ranges)
      list += fmt::format("<range lower=\"{}\" upper=\"{}\" label=\"{}\" symbol=\"{}\" render=\"true\"/>\n",
                          i == 0 ? "0" : style.classes[i - 1].value, one.value, escaped_markup(one.label), i);
    else
      list += fmt::format("<category value=\"{}\" label=\"{}\" symbol=\"{}\" render=\"true\" type=\"string\"/>\n",
                          escaped_markup(one.value), escaped_markup(one.label), i);
  }
  const auto whole = [&](const std::string& kind, const std::string& content) {
    return fmt::format(
        "<renderer-v2 type=\"{}\" symbollevels=\"0\" enableorderby=\"0\" forceraster=\"0\"{}>\n{}<symbols>\n{}"
        "</symbols>\n</renderer-v2>\n",
        kind, style.attribute.empty() ? "" : " attr=\"" + style.attribute + "\"", content, symbols);
  };
  if (style.attribute.empty()) return whole("singleSymbol", "");
  return style.ranges ? whole("graduatedSymbol", "<ranges>\n" + list + "</ranges>\n")
                      : whole("categorizedSymbol", "<categories>\n" + list + "</categories>\n");
}

}  // namespace

LayerStyle style_of_buildings() {
  return {"quality",
          StyleSymbol::fill,
          "quality",
          false,
          {{"good", "good", kBlue},
           {"check", "check", kYellow},
           {"bad", "bad or outline only", kRed},
           {"", "not judged", kGrey}}};
}

LayerStyle style_of_roof_faces() {
  return {"roof faces", StyleSymbol::fill, "", false, {{"", "", "193,120,87"}}};
}

LayerStyle style_of_planes() {
  return {"RMS",
          StyleSymbol::fill,
          "rms_m",
          true,
          {{"0.01", "up to 1 cm", kBlue}, {"0.03", "1 to 3 cm", kYellow}, {"1000000", "more than 3 cm", kRed}}};
}

LayerStyle style_of_objects(StyleSymbol symbol, const std::map<PointLabel, std::string>& classes) {
  LayerStyle style{"class", symbol, "class", false, {}};
  for (const auto& [label, name] : classes)
    style.classes.push_back({name, name, fmt::format("{}", fmt::join(object_colour(label), ","))});
  return style;
}

LayerStyle style_of_blocks() {
  return {"blocks", StyleSymbol::line, "", false, {{"", "", "90,101,119"}}};
}

LayerStyle style_of_gaps() {
  return {"gaps", StyleSymbol::dashed_line, "", false, {{"", "", "216,130,90"}}};
}

LayerStyle style_of_kerbs() {
  return {"seen", StyleSymbol::line, "seen", false, {{"1", "kerb", "178,34,96"}, {"0", "not seen", "226,150,186"}}};
}

LayerStyle style_of_road_edges() {
  return {"seen",
          StyleSymbol::line,
          "seen",
          false,
          {{"1", "edge of the road", "90,101,119"}, {"0", "not seen", "178,186,200"}}};
}

LayerStyle style_of_pavements() {
  return {"pavements", StyleSymbol::fill, "", false, {{"", "", "214,206,190"}}};
}

LayerStyle style_of_carriageways() {
  return {"carriageways", StyleSymbol::fill, "", false, {{"", "", "196,199,204"}}};
}

LayerStyle style_of_pavement_widths() {
  return {"passable",
          StyleSymbol::line,
          "passable_m",
          true,
          {{"0.9", "less than 0.9 m free", kRed}, {"1.5", "0.9 to 1.5 m", kYellow}, {"1000000", "more", kBlue}}};
}

LayerStyle style_of_trees(StyleSymbol symbol) {
  return {"trunk", symbol, "trunk_seen", false, {{"1", "trunk seen", "47,125,50"}, {"0", "crown only", "139,195,74"}}};
}

std::string layer_style_qml(const LayerStyle& style) {
  return "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n<qgis version=\"3.22\" "
         "styleCategories=\"Symbology\">\n" +
         renderer_qml(style) + "</qgis>\n";
}

}  // namespace ilot
