// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/city_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <span>

#include "engine/error.h"

namespace ilot {
namespace {

constexpr double kFarthestStep = 0x1p53;  // steps; beyond it JSON readers round whole numbers

// Whether JSON writes a text between quotation marks as it is.
bool is_plain(const std::string& text) {
  return std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; });
}

std::string quoted(const std::string& text) {
  if (is_plain(text)) return '"' + text + '"';
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// The members of the metadata. The specification allows further ones beside its own.
std::string metadata_text(const CityJsonParams& p) {
  std::string text;
  const auto add = [&](const char* name, const std::string& value) {
    text += fmt::format("{}\"{}\":{}", text.empty() ? "" : ",", name, value);
  };
  if (p.epsg > 0) add("referenceSystem", fmt::format("\"https://www.opengis.net/def/crs/EPSG/0/{}\"", p.epsg));
  if (p.extent) {
    const auto& e = *p.extent;
    add("geographicalExtent",
        fmt::format("[{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f}]", e[0], e[1], e[2], e[3], e[4], e[5]));
  }
  if (!p.title.empty()) add("title", quoted(p.title));
  if (!p.software.empty()) add("software", quoted(p.software));
  if (!p.parameters.empty()) add("parameters", p.parameters);
  if (!p.sources.empty()) add("sources", p.sources);
  return text;
}

std::string head_text(const CityJsonParams& p) {
  std::string text = fmt::format(
      R"({{"type":"CityJSON","version":"2.0","transform":{{"scale":[{0},{0},{0}],"translate":[{1},{2},{3}]}})", p.step,
      p.origin.x, p.origin.y, p.origin.z);
  const std::string metadata = metadata_text(p);
  return metadata.empty() ? text : text + R"(,"metadata":{)" + metadata + "}";
}

// How real numbers are written: measured ones to the thousandth, those of a footprint as they were given.
enum class Digits { three, all };

std::string value_text(const AttributeValue& value, Digits digits) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *whole);
  if (const auto* text = std::get_if<std::string>(&value)) return quoted(*text);
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  const double number = std::get<double>(value);
  if (!std::isfinite(number)) return "null";
  return digits == Digits::all ? fmt::format("{}", number) : fmt::format("{:.3f}", number);
}

std::string attributes_text(const Attributes& attributes) {
  std::string text;
  for (const auto& [name, value] : attributes)
    text += (text.empty() ? "" : ",") + quoted(name) + ":" +
            value_text(value, is_measured(name) ? Digits::three : Digits::all);
  return text;
}

std::string semantic_text(const Building& building, const BuildingSurface& surface, const CityJsonParams& params) {
  std::string text = fmt::format(R"({{"type":"{}")", surface_type(surface.kind));
  if (surface.plane_id > 0) text += fmt::format(R"(,"plane_id":{})", surface.plane_id);
  if (surface.kind == SurfaceKind::roof)
    text += "," + attributes_text(face_attributes(building, surface, params.style, params.metres_per_unit));
  return text + "}";
}

std::string rings_text(const BuildingSurface& surface, std::span<const std::uint32_t> numbers) {
  std::string text;
  for (const auto& ring : surface.rings) {
    text += text.empty() ? "[" : ",[";
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (i != 0) text += ',';
      text += fmt::format_int(numbers[ring[i]]).c_str();
    }
    text += "]";
  }
  return "[" + text + "]";
}

std::string geometry_text(const Building& building, std::span<const std::uint32_t> numbers,
                          const CityJsonParams& params) {
  std::string faces, semantics, values;
  for (std::size_t i = 0; i < building.surfaces.size(); ++i) {
    const BuildingSurface& surface = building.surfaces[i];
    const char* comma = i ? "," : "";
    faces += comma + rings_text(surface, numbers);
    semantics += comma + semantic_text(building, surface, params);
    values += fmt::format("{}{}", comma, i);
  }
  const bool flat = building.lod.starts_with('0');
  const char *type = flat ? "MultiSurface" : "Solid", *open = flat ? "" : "[", *close = flat ? "" : "]";
  return fmt::format(
      R"({{"type":"{}","lod":"{}","boundaries":{}[{}]{},"semantics":{{"surfaces":[{}],"values":{}[{}]{}}}}})", type,
      building.lod, open, faces, close, semantics, open, values, close);
}

std::string object_text(std::span<const Building> levels, std::span<const std::vector<std::uint32_t>> numbers,
                        const CityJsonParams& params) {
  std::string geometry;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (levels[i].surfaces.empty()) continue;
    geometry += (geometry.empty() ? "" : ",") + geometry_text(levels[i], numbers[i], params);
  }
  return fmt::format(R"({}:{{"type":"Building","attributes":{{{}}},"geometry":[{}]}})", quoted(levels[0].id),
                     attributes_text(styled_attributes(levels[0].attributes, params.style)), geometry);
}

template <class Steps>
std::string vertices_text(const std::vector<Steps>& vertices) {
  std::string text = "[";
  for (std::size_t i = 0; i < vertices.size(); ++i)
    text += fmt::format("{}[{},{},{}]", i ? "," : "", vertices[i][0], vertices[i][1], vertices[i][2]);
  return text + "]";
}

}  // namespace

const char* surface_type(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::roof:
      return "RoofSurface";
    case SurfaceKind::wall:
      return "WallSurface";
    default:
      return "GroundSurface";
  }
}

CityJsonWriter::CityJsonWriter(const std::filesystem::path& path, const CityJsonParams& params)
    : file_(path), params_(params), sequence_(path.extension() == ".jsonl") {
  append(head_text(params) + (sequence_ ? R"(,"CityObjects":{},"vertices":[]})"
                                          "\n"
                                        : ",\n\"CityObjects\":{\n"));
}

void CityJsonWriter::append(const std::string& text) {
  file_.append(std::as_bytes(std::span(text)));
}

// Returns the numbers of the building's vertices among `vertices`, to which new vertices are added.
std::vector<std::uint32_t> CityJsonWriter::number_vertices(const Building& building,
                                                           std::vector<Steps>& vertices) const {
  std::map<Steps, std::uint32_t> known;
  std::vector<std::uint32_t> numbers;
  for (Vec3 p : building.vertices) {
    const Vec3 offset = p - params_.origin;
    Steps steps;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double value = (axis == 0 ? offset.x : axis == 1 ? offset.y : offset.z) / params_.step;
      if (!(std::abs(value) < kFarthestStep))
        throw Error(file_.path().string() + ": building " + building.id + " lies too far from the model's origin");
      steps[axis] = std::llround(value);
    }
    const auto [entry, fresh] = known.try_emplace(steps, static_cast<std::uint32_t>(vertices.size()));
    if (fresh) vertices.push_back(steps);
    numbers.push_back(entry->second);
  }
  return numbers;
}

void CityJsonWriter::add(std::span<const Building> levels) {
  std::vector<Steps> own;
  std::vector<std::vector<std::uint32_t>> numbers;
  for (const Building& level : levels) numbers.push_back(number_vertices(level, sequence_ ? own : vertices_));
  if (sequence_) {
    append(fmt::format(R"({{"type":"CityJSONFeature","id":{},"CityObjects":{{{}}},"vertices":{}}})",
                       quoted(levels[0].id), object_text(levels, numbers, params_), vertices_text(own)) +
           "\n");
    return;
  }
  append((first_ ? "" : ",\n") + object_text(levels, numbers, params_));
  first_ = false;
}

void CityJsonWriter::finish() {
  if (!sequence_) append("},\n\"vertices\":" + vertices_text(vertices_) + "}\n");
  file_.commit();
}

}  // namespace ilot
