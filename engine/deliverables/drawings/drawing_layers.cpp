// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/drawing_layers.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>

#include "engine/error.h"

namespace ilot {
namespace {

constexpr std::uintmax_t kMaxMappingBytes = 1u << 20;
constexpr std::array<const char*, 3> kPatterns{"continuous", "dashed", "dotted"};
constexpr std::array<const char*, 3> kPresets{"ilot", "aia", "iso13567"};
// The pens of the exchange format, in hundredths of a millimetre.
constexpr std::array<int, 24> kPens{0,  5,  9,  13, 15, 18,  20,  25,  30,  35,  40,  50,
                                    53, 60, 70, 80, 90, 100, 106, 120, 140, 158, 200, 211};

// Colours and pens are the same in all presets; names differ. AIA: discipline A, major group ELEV, minor groups of the
// U.S. National CAD Standard. ISO 13567: agent B- (building surveyor), element by CI/SfB table 1 (21 external walls, 31
// openings in them, 34 balustrades, 41 finishes), presentation E graphics, T text, D dimensions, H hatching.
struct Preset {
  DrawingRole role;
  std::array<const char*, 3> names;  // ilot, aia, iso13567
  int colour;
  double lineweight_mm;
  LinePattern pattern;
  bool shown;
};
constexpr LinePattern kContinuous = LinePattern::continuous, kDashed = LinePattern::dashed,
                      kDotted = LinePattern::dotted;
using R = DrawingRole;
constexpr std::array<Preset, kDrawingRoles> kTable{{
    {R::outline, {"FAC-OUTLINE", "A-ELEV-OTLN", "B-21----E-"}, 7, 0.50, kContinuous, true},
    {R::opening, {"FAC-OPENING", "A-ELEV-OPNG", "B-31----E-"}, 7, 0.35, kContinuous, true},
    {R::sill, {"FAC-SILL", "A-ELEV-SILL", "B-31S---E-"}, 3, 0.25, kContinuous, true},
    {R::lintel, {"FAC-LINTEL", "A-ELEV-HEAD", "B-31L---E-"}, 3, 0.25, kContinuous, true},
    {R::balcony, {"FAC-BALCONY", "A-ELEV-BALC", "B-34----E-"}, 5, 0.25, kContinuous, true},
    {R::band, {"FAC-BAND", "A-ELEV-MLDG", "B-41B---E-"}, 5, 0.25, kContinuous, true},
    {R::bulge, {"FAC-BULGE", "A-ELEV-BULG", "B-21I---E-"}, 6, 0.18, kDashed, true},
    {R::irregularity, {"FAC-IRREGULAR", "A-ELEV-IRRG", "B-21U---E-"}, 6, 0.13, kDashed, false},
    {R::stone, {"FAC-STONE", "A-ELEV-PATT", "B-41S---E-"}, 8, 0.18, kContinuous, true},
    {R::joint, {"FAC-JOINT", "A-ELEV-JONT", "B-41J---E-"}, 8, 0.13, kContinuous, true},
    {R::detail, {"FAC-DETAIL", "A-ELEV-FNSH", "B-41----E-"}, 8, 0.18, kContinuous, true},
    {R::hidden, {"FAC-HIDDEN", "A-ELEV-BHND", "B-21B---E-"}, 8, 0.13, kDashed, true},
    {R::completed, {"FAC-COMPLETED", "A-ELEV-CMPL", "B-21C---E-"}, 30, 0.25, kDashed, true},
    {R::occluded, {"FAC-OCCLUDED", "A-ELEV-HIDN", "B-21O---E-"}, 8, 0.18, kDotted, true},
    {R::shadow, {"FAC-NODATA", "A-ELEV-NODT", "B-21O---H-"}, 9, 0.13, kContinuous, true},
    {R::possible, {"FAC-POSSIBLE", "A-ELEV-PSBL", "B-31O---E-"}, 30, 0.18, kDashed, true},
    {R::error, {"FAC-ERROR", "A-ELEV-ERRR", "B-21E---E-"}, 1, 0.09, kContinuous, false},
    {R::ground, {"FAC-GROUND", "A-ELEV-GRND", "B-11----E-"}, 7, 0.70, kContinuous, true},
    {R::number, {"FAC-TEXT", "A-ELEV-IDEN", "B-31----T-"}, 7, 0.18, kContinuous, true},
    {R::level, {"FAC-LEVEL", "A-ELEV-LEVL", "B-21L---T-"}, 5, 0.13, kContinuous, true},
    {R::dimension, {"FAC-DIM", "A-ELEV-DIMS", "B-21----D-"}, 5, 0.13, kContinuous, true},
    {R::mark, {"FAC-MARK", "A-ANNO-SYMB", "B-21Y---T-"}, 1, 0.35, kContinuous, true},
    {R::frame, {"FAC-FRAME", "A-ANNO-TTLB", "B-------E-"}, 7, 0.35, kContinuous, true},
    {R::title, {"FAC-TITLE", "A-ANNO-TEXT", "B-------T-"}, 7, 0.18, kContinuous, true},
    {R::section, {"FAC-SECTION", "A-SECT-MCUT", "B-21X---E-"}, 1, 0.50, kContinuous, true},
    {R::section_points, {"FAC-POINTS", "A-SECT-PNTS", "B-21P---E-"}, 8, 0.18, kContinuous, true},
    {R::image, {"FAC-IMAGE", "A-ELEV-IMAG", "B-21G---E-"}, 9, 0, kContinuous, true},
}};

template <std::size_t n>
std::string listed(const std::array<const char*, n>& names) {
  std::string list;
  for (const char* name : names) list += (list.empty() ? "" : ", ") + std::string(name);
  return list;
}

bool is_pen(double mm) {
  return std::any_of(kPens.begin(), kPens.end(), [&](int pen) { return std::abs(mm * 100 - pen) < 1e-6; });
}

bool is_layer_name(const std::string& name) {
  const auto legal = [](char c) {
    return c >= 32 && c < 127 && std::string_view("<>/\\\":;?*|,=`").find(c) == std::string_view::npos;
  };
  return !name.empty() && name.size() <= 255 && name.front() != ' ' && name.back() != ' ' &&
         std::all_of(name.begin(), name.end(), legal);
}

// Reads one table of a mapping file; `place` is its place in the file, for messages.
struct LayerReader {
  const toml::table& table;
  std::string place;

  [[noreturn]] void fail(const std::string& what) const { throw Error(place + ": " + what, ExitCode::usage); }

  void read(DrawingLayer& layer) const {
    for (const auto& [key, node] : table) {
      const std::string name(key.str());
      if (name == "name")
        read_name(node, layer);
      else if (name == "colour")
        read_colour(node, layer);
      else if (name == "lineweight_mm")
        read_pen(node, layer);
      else if (name == "pattern")
        read_pattern(node, layer);
      else if (name == "shown")
        read_shown(node, layer);
      else
        fail("unknown key '" + name + "': name, colour, lineweight_mm, pattern or shown");
    }
  }
  void read_name(const toml::node& node, DrawingLayer& layer) const {
    const auto text = node.value_exact<std::string>();
    if (!text || !is_layer_name(*text)) fail("name needs 1 to 255 ASCII characters, none of <>/\\\":;?*|,=`");
    layer.name = *text;
  }
  void read_colour(const toml::node& node, DrawingLayer& layer) const {
    const auto colour = node.value_exact<std::int64_t>();
    if (!colour || *colour < 1 || *colour > 255) fail("colour needs a colour index from 1 to 255");
    layer.colour = static_cast<int>(*colour);
  }
  void read_pen(const toml::node& node, DrawingLayer& layer) const {
    const auto mm = node.value<double>();
    if (!mm || !is_pen(*mm))
      fail("lineweight_mm needs a pen: 0, 0.05, 0.09, 0.13, 0.15, 0.18, 0.2, 0.25, 0.3, 0.35...");
    layer.lineweight_mm = *mm;
  }
  void read_pattern(const toml::node& node, DrawingLayer& layer) const {
    const auto text = node.value_exact<std::string>();
    const auto found = text ? std::find(kPatterns.begin(), kPatterns.end(), *text) : kPatterns.end();
    if (found == kPatterns.end()) fail("pattern is one of " + listed(kPatterns));
    layer.pattern = static_cast<LinePattern>(found - kPatterns.begin());
  }
  void read_shown(const toml::node& node, DrawingLayer& layer) const {
    const auto shown = node.value_exact<bool>();
    if (!shown) fail("shown is true or false");
    layer.shown = *shown;
  }
};

std::string upper(std::string name) {
  for (char& c : name)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return name;
}

// Layers are the same when their names differ only in case.
void check_shared_layers(const DrawingLayers& layers, const std::string& name) {
  std::map<std::string, std::size_t> first;
  for (std::size_t i = 0; i < kDrawingRoles; ++i) {
    const DrawingLayer& layer = layers.of_role[i];
    const auto [entry, fresh] = first.try_emplace(upper(layer.name), i);
    const DrawingLayer& other = layers.of_role[entry->second];
    if (fresh ||
        (other.name == layer.name && other.colour == layer.colour && other.lineweight_mm == layer.lineweight_mm &&
         other.pattern == layer.pattern && other.shown == layer.shown))
      continue;
    throw Error(
        fmt::format("{}: {} and {} share the layer '{}' and do not agree on its name, colour, pen or pattern", name,
                    name_of(static_cast<DrawingRole>(entry->second)), name_of(static_cast<DrawingRole>(i)), layer.name),
        ExitCode::usage);
  }
}

void read_roles(const toml::table& roles, const std::string& name, DrawingLayers& layers) {
  for (const auto& [key, node] : roles) {
    std::size_t role = 0;
    while (role < kDrawingRoles && key.str() != name_of(static_cast<DrawingRole>(role))) ++role;
    const std::string place = fmt::format("{}:{}: layers.{}", name, node.source().begin.line, key.str());
    if (role == kDrawingRoles) {
      std::string known;
      for (std::size_t i = 0; i < kDrawingRoles; ++i)
        known += (i ? ", " : "") + std::string(name_of(static_cast<DrawingRole>(i)));
      throw Error(place + ": nothing of this name is drawn; there are " + known, ExitCode::usage);
    }
    if (!node.is_table()) throw Error(place + ": needs a table", ExitCode::usage);
    LayerReader{*node.as_table(), place}.read(layers.of_role[role]);
  }
}

}  // namespace

const char* name_of(LinePattern pattern) {
  return kPatterns.at(static_cast<std::size_t>(pattern));
}

DrawingLayers preset_layers(std::string_view name) {
  const auto found = std::find(kPresets.begin(), kPresets.end(), name);
  if (found == kPresets.end())
    throw Error("'" + std::string(name) + "' is no set of layers: " + listed(kPresets) + " or a file", ExitCode::usage);
  DrawingLayers layers;
  for (const Preset& p : kTable)
    layers.of_role[static_cast<std::size_t>(p.role)] = {p.names[static_cast<std::size_t>(found - kPresets.begin())],
                                                        p.colour, p.lineweight_mm, p.pattern, p.shown};
  return layers;
}

DrawingLayers parse_layers(std::string_view text, const std::string& name) {
  // The result of the parser for some characters beyond ASCII is undefined, and no layer needs one.
  if (std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; }))
    throw Error(name + ": layers are written in ASCII", ExitCode::usage);
  try {
    const toml::table table = toml::parse(text, name);
    std::string preset = "ilot";
    for (const auto& [key, node] : table) {
      if (key.str() == "preset" && node.is_string()) preset = node.as_string()->get();
      if (key.str() != "preset" && !(key.str() == "layers" && node.is_table()))
        throw Error(fmt::format("{}:{}: '{}': a mapping has `preset` and tables [layers.ROLE]", name,
                                node.source().begin.line, key.str()),
                    ExitCode::usage);
    }
    DrawingLayers layers = preset_layers(preset);
    if (const toml::table* roles = table["layers"].as_table()) read_roles(*roles, name, layers);
    check_shared_layers(layers, name);
    return layers;
  } catch (const toml::parse_error& fault) {
    throw Error(fmt::format("{}:{}: {}", name, fault.source().begin.line, fault.description()), ExitCode::usage);
  }
}

DrawingLayers read_layers(const std::string& preset_or_file) {
  if (std::find(kPresets.begin(), kPresets.end(), preset_or_file) != kPresets.end())
    return preset_layers(preset_or_file);
  std::error_code missing;
  const std::uintmax_t bytes = std::filesystem::file_size(preset_or_file, missing);
  if (missing)
    throw Error("'" + preset_or_file + "' is neither a set of layers (" + listed(kPresets) + ") nor a file",
                ExitCode::usage);
  if (bytes > kMaxMappingBytes) throw Error(preset_or_file + ": too large for a mapping of layers", ExitCode::usage);
  std::ifstream file(preset_or_file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file.is_open() || file.bad()) throw Error(preset_or_file + ": cannot be read", ExitCode::usage);
  return parse_layers(text, preset_or_file);
}

std::array<std::uint8_t, 3> colour_on_paper(int colour) {
  constexpr std::array<std::array<std::uint8_t, 3>, 10> kFirst{{{0, 0, 0},
                                                                {255, 0, 0},
                                                                {200, 180, 0},
                                                                {0, 150, 60},
                                                                {0, 160, 190},
                                                                {0, 60, 200},
                                                                {190, 0, 190},
                                                                {0, 0, 0},
                                                                {110, 110, 110},
                                                                {165, 165, 165}}};
  if (colour < 10) return kFirst[static_cast<std::size_t>(std::max(colour, 0))];
  if (colour >= 250) {
    const auto grey = static_cast<std::uint8_t>(40 + (colour - 250) * 34);
    return {grey, grey, grey};
  }
  // There are 24 hues of ten shades each. The first shade is the pure one; the third, fifth and so on are darker; odd
  // ones are half as strong.
  const int hue = (colour - 10) / 10, shade = (colour - 10) % 10;
  constexpr std::array<double, 5> kValue{1, 0.8, 0.6, 0.5, 0.3};
  const double value = kValue[static_cast<std::size_t>(shade / 2)], pale = shade % 2 ? 0.5 : 0;
  const auto channel = [&](int offset) {
    const int turn = ((hue - offset) % 24 + 24) % 24, away = std::min(turn, 24 - turn);
    const double share = std::clamp((8 - away) / 4.0, 0.0, 1.0);
    return static_cast<std::uint8_t>(std::lround(255 * value * (share + pale * (1 - share))));
  };
  return {channel(0), channel(8), channel(16)};
}

}  // namespace ilot
