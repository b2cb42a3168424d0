// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/scene_buildings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "engine/deliverables/report/packed.h"
#include "engine/deliverables/solids/roofs_reader.h"

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kRoofsFile = "roofs/roofs.city.jsonl";
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// Both styles of names are read: ours, then the other one.
double number_of(const BuildingModel& model, const char* name, const char* other) {
  return model.number(name).value_or(model.number(other).value_or(kUnknown));
}

std::uint64_t whole_of(const BuildingModel& model, const char* name, const char* other) {
  const double value = number_of(model, name, other);
  return value > 0 ? static_cast<std::uint64_t>(value) : 0;
}

BuildingRow row_of(const BuildingModel& model, const SceneFrame& frame) {
  BuildingRow row;
  row.id = model.id;
  row.status = model.text("status").value_or("");
  row.quality = model.text("quality").value_or("");
  if (row.status == "footprint_only") row.quality = "none";
  row.reason = model.text("reason").value_or("");
  if (row.reason.empty()) row.reason = model.text("quality_reason").value_or("");
  row.unit = static_cast<std::uint32_t>(whole_of(model, "unit_id", "unit_id"));
  row.points = whole_of(model, "points", "points");
  row.faces = whole_of(model, "roof_faces", "rf_roof_planes");
  row.rmse_m = number_of(model, "rmse_m", "rf_rmse_lod22");
  row.p95_m = number_of(model, "p95_m", "p95_m");
  row.explained = number_of(model, "explained", "explained");
  row.area_m2 = number_of(model, "area_m2", "area_m2");
  row.coverage = number_of(model, "coverage", "coverage");
  row.height_m = frame.metres_per_unit *
                 (number_of(model, "h_roof_max", "rf_h_roof_max") - number_of(model, "h_ground", "rf_h_ground"));
  if (model.levels.empty()) return row;
  const Building& finest = model.levels.back();
  row.shape = packed_shape(finest, frame);
  for (const Vec3& v : finest.vertices) row.middle = row.middle + frame.at(v);
  if (!finest.vertices.empty()) row.middle = (1.0 / static_cast<double>(finest.vertices.size())) * row.middle;
  return row;
}

// The corners that the faces use, in the order of their first use.
std::vector<std::uint32_t> used_corners(const Building& building, std::vector<std::uint32_t>& number_of_corner) {
  constexpr std::uint32_t kNone = ~0u;
  std::vector<std::uint32_t> used;
  number_of_corner.assign(building.vertices.size(), kNone);
  for (const BuildingSurface& s : building.surfaces)
    for (const auto& ring : s.rings)
      for (const std::uint32_t v : ring)
        if (number_of_corner[v] == kNone) {
          number_of_corner[v] = static_cast<std::uint32_t>(used.size());
          used.push_back(v);
        }
  return used;
}

Json rounded(const std::vector<BuildingRow>& rows, double BuildingRow::*field, double per_unit) {
  Json values = Json::array();
  for (const BuildingRow& row : rows) {
    const double value = row.*field;
    values.push_back(std::isfinite(value) ? Json(std::llround(value * per_unit)) : Json());
  }
  return values;
}

// Texts that repeat are stored once: the list of different ones, and a number for each row.
Json indexed(const std::vector<BuildingRow>& rows, std::string BuildingRow::*field) {
  std::map<std::string, std::size_t> numbers;
  for (const BuildingRow& row : rows) numbers.emplace(row.*field, 0);
  Json words = Json::array(), of_rows = Json::array();
  for (auto& [word, number] : numbers) {
    number = words.size();
    words.push_back(word);
  }
  for (const BuildingRow& row : rows) of_rows.push_back(numbers.at(row.*field));
  return {{"words", words}, {"rows", of_rows}};
}

}  // namespace

std::vector<BuildingRow> building_rows(const ResultFolder& result, const SceneFrame& frame) {
  std::vector<BuildingRow> rows;
  if (!result.has(kRoofsFile)) return rows;
  for_each_roof(result.path / kRoofsFile, [&](const BuildingModel& model) { rows.push_back(row_of(model, frame)); });
  return rows;
}

std::string packed_shape(const Building& building, const SceneFrame& frame) {
  std::vector<std::uint32_t> number;
  const std::vector<std::uint32_t> used = used_corners(building, number);
  std::string bytes;
  put_whole(bytes, used.size());
  std::array<std::int64_t, 3> last{};
  for (const std::uint32_t v : used) {
    const Vec3 at = frame.at(building.vertices[v]);
    const std::array<std::int64_t, 3> cm{std::llround(100 * at.x), std::llround(100 * at.y), std::llround(100 * at.z)};
    for (std::size_t i = 0; i < 3; ++i) put_signed(bytes, cm[i] - last[i]);
    last = cm;
  }
  put_whole(bytes, building.surfaces.size());
  for (const BuildingSurface& s : building.surfaces) {
    put_whole(bytes, static_cast<std::uint64_t>(s.kind));
    put_whole(bytes, s.rings.size());
    for (const auto& ring : s.rings) {
      put_whole(bytes, ring.size());
      for (const std::uint32_t v : ring) put_whole(bytes, number[v]);
    }
  }
  return bytes;
}

Building unpacked_shape(std::string_view bytes, const SceneFrame& frame) {
  Building building;
  std::size_t at = 0;
  building.vertices.resize(take_whole(bytes, at));
  std::array<std::int64_t, 3> cm{};
  for (Vec3& v : building.vertices) {
    for (std::int64_t& c : cm) c += take_signed(bytes, at);
    const Vec3 scene{static_cast<double>(cm[0]), static_cast<double>(cm[1]), static_cast<double>(cm[2])};
    v = frame.origin + (0.01 / frame.metres_per_unit) * scene;
  }
  building.surfaces.resize(take_whole(bytes, at));
  for (BuildingSurface& s : building.surfaces) {
    s.kind = static_cast<SurfaceKind>(take_whole(bytes, at));
    s.rings.resize(take_whole(bytes, at));
    for (auto& ring : s.rings) {
      ring.resize(take_whole(bytes, at));
      for (std::uint32_t& v : ring) v = static_cast<std::uint32_t>(take_whole(bytes, at));
    }
  }
  return building;
}

Json building_columns(const std::vector<BuildingRow>& rows) {
  Json ids = Json::array(), units = Json::array(), points = Json::array(), faces = Json::array();
  for (const BuildingRow& row : rows) {
    ids.push_back(row.id), units.push_back(row.unit);
    points.push_back(row.points), faces.push_back(row.faces);
  }
  return {{"id", ids},
          {"unit", units},
          {"points", points},
          {"faces", faces},
          {"status", indexed(rows, &BuildingRow::status)},
          {"quality", indexed(rows, &BuildingRow::quality)},
          {"reason", indexed(rows, &BuildingRow::reason)},
          {"rmse_mm", rounded(rows, &BuildingRow::rmse_m, 1000)},
          {"p95_mm", rounded(rows, &BuildingRow::p95_m, 1000)},
          {"explained_pm", rounded(rows, &BuildingRow::explained, 1000)},
          {"coverage_pm", rounded(rows, &BuildingRow::coverage, 1000)},
          {"area_dm2", rounded(rows, &BuildingRow::area_m2, 100)},
          {"height_cm", rounded(rows, &BuildingRow::height_m, 100)}};
}

}  // namespace ilot
