// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/against.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "engine/deliverables/layers/gpkg_readers.h"
#include "engine/deliverables/report/html.h"
#include "engine/deliverables/tables/facade_json.h"
#include "engine/deliverables/tables/planes_csv.h"
#include "engine/error.h"
#include "engine/model/point_label.h"
#include "engine/report/progress.h"

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;
using Cell = std::array<std::int64_t, 3>;

constexpr std::size_t kMostNamedUnits = 40;

Cell cell_of(Vec3 p, double reach) {
  return {static_cast<std::int64_t>(std::floor(p.x / reach)), static_cast<std::int64_t>(std::floor(p.y / reach)),
          static_cast<std::int64_t>(std::floor(p.z / reach))};
}

// Takes units with equal keys as pairs, the first with the first.
void pair_keys(const std::vector<ComparedUnit>& now, const std::vector<ComparedUnit>& before, UnitChanges& changes,
               std::vector<bool>& taken_now, std::vector<bool>& taken_before) {
  std::multimap<std::pair<std::string, std::string>, std::size_t> by_key;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (!before[i].key.empty()) by_key.emplace(std::pair(before[i].kind, before[i].key), i);
  for (std::size_t i = 0; i < now.size(); ++i) {
    const auto found = now[i].key.empty() ? by_key.end() : by_key.find({now[i].kind, now[i].key});
    if (found == by_key.end()) continue;
    changes.same.emplace_back(i, found->second);
    taken_now[i] = taken_before[found->second] = true;
    by_key.erase(found);
  }
}

void pair_places(const std::vector<ComparedUnit>& now, const std::vector<ComparedUnit>& before, double reach,
                 UnitChanges& changes, std::vector<bool>& taken_now, std::vector<bool>& taken_before) {
  std::map<Cell, std::vector<std::size_t>> cells;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (!taken_before[i]) cells[cell_of(before[i].middle, reach)].push_back(i);
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (taken_now[i]) continue;
    const Cell middle = cell_of(now[i].middle, reach);
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy)
        for (std::int64_t dz = -1; dz <= 1; ++dz) {
          const auto cell = cells.find({middle[0] + dx, middle[1] + dy, middle[2] + dz});
          if (cell == cells.end()) continue;
          for (const std::size_t k : cell->second) {
            const double distance = norm(now[i].middle - before[k].middle);
            if (distance <= reach && now[i].kind == before[k].kind) pairs.emplace_back(distance, i, k);
          }
        }
  }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [distance, i, k] : pairs) {
    if (taken_now[i] || taken_before[k]) continue;
    taken_now[i] = taken_before[k] = true;
    changes.same.emplace_back(i, k);
  }
}

std::string json_text(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.is_null() ? std::string("not set") : value.dump();
}

std::string settings_differences(const ResultFolder& now, const ResultFolder& before) {
  HtmlTable table({{"what"}, {"this result"}, {"the other"}});
  const auto row = [&](const std::string& name, const Json& a, const Json& b) {
    if (a != b) table.add({"<code>" + html_text(name) + "</code>", html_text(json_text(a)), html_text(json_text(b))});
  };
  for (const char* key : {"version", "git_hash", "products", "parameters_hash", "result_hash"})
    row(key, now.run.value(key, Json()), before.run.value(key, Json()));
  const Json a = now.run.value("parameters", Json::object()), b = before.run.value("parameters", Json::object());
  for (const auto& [key, value] : a.items()) row(key, value, b.value(key, Json()));
  for (const auto& [key, value] : b.items())
    if (!a.contains(key)) row(key, Json(), value);
  std::map<std::string, std::pair<Json, Json>> chosen;
  for (const Json& c : now.run.value("chosen", Json::array()))
    chosen[c.value("key", "")].first = c.value("value", Json());
  for (const Json& c : before.run.value("chosen", Json::array()))
    chosen[c.value("key", "")].second = c.value("value", Json());
  for (const auto& [key, values] : chosen) row(key + " (chosen)", values.first, values.second);
  return table.empty() ? html_note("Version, settings and result are the same.") : table.html();
}

std::string count_differences(const ResultFolder& now, const ResultFolder& before) {
  HtmlTable table({{"count"}, {"this result", true}, {"the other", true}});
  const Json a = now.run.value("counts", Json::object()).flatten(),
             b = before.run.value("counts", Json::object()).flatten();
  std::map<std::string, std::pair<std::string, std::string>> rows;
  const auto shown = [](const Json& v) {
    return v.is_number_unsigned() ? grouped(v.get<std::uint64_t>()) : json_text(v);
  };
  for (const auto& [key, value] : a.items()) rows[key].first = shown(value);
  for (const auto& [key, value] : b.items()) rows[key].second = shown(value);
  for (const auto& [key, values] : rows)
    if (values.first != values.second)
      table.add({html_text(key.empty() ? key : key.substr(1)), html_text(values.first), html_text(values.second)});
  return table.empty() ? html_note("All counts are the same.") : table.html();
}

std::vector<ComparedUnit> compared_buildings(const std::vector<BuildingRow>& rows) {
  std::vector<ComparedUnit> units;
  for (const BuildingRow& row : rows)
    units.push_back(
        {row.id, row.id, "building",
         fmt::format("{}, {}, {} faces, RMSE {} m", row.status, row.quality, row.faces, number_text(row.rmse_m, 2)),
         row.middle});
  return units;
}

std::vector<ComparedUnit> compared_planes(const ResultFolder& result, const SceneFrame& frame) {
  std::vector<ComparedUnit> units;
  if (result.has("planes.csv"))
    for_each_plane(result.path / "planes.csv", [&](const Segment& s) {
      units.push_back({std::to_string(s.id), fmt::format("{:016x}", s.content_id), "plane",
                       fmt::format("{:016x}, {} points, {} m²", s.content_id, s.points, number_text(s.area_m2, 1)),
                       frame.at(s.centroid)});
    });
  return units;
}

std::vector<ComparedUnit> compared_objects(const ResultFolder& result, const SceneFrame& frame) {
  std::vector<ComparedUnit> units;
  if (!result.has("streets/objects.gpkg")) return units;
  for (const StreetObject& o : read_objects_gpkg(result.path / "streets/objects.gpkg")) {
    units.push_back({std::to_string(o.id), "", "object", o.class_name, frame.at(o.base)});
  }
  return units;
}

std::vector<ComparedUnit> compared_facades(const ResultFolder& result, const SceneFrame& frame) {
  std::vector<ComparedUnit> units;
  for (const ResultRecord& file : result.files) {
    if (!file.path.starts_with("facades/facade-") || !file.path.ends_with(".json")) continue;
    const Facade f = read_facade_json(result.path / file.path);
    const Vec3 middle = frame.at(f.origin) + (f.width_m / 2) * f.right + (f.height_m / 2) * f.up;
    units.push_back({std::to_string(f.id), "", "facade",
                     fmt::format("{} elements, {} x {} m", f.elements.size(), number_text(f.width_m, 2),
                                 number_text(f.height_m, 2)),
                     middle});
  }
  return units;
}

std::string names_of(const std::vector<ComparedUnit>& units, const std::vector<std::size_t>& which, const char* kind) {
  std::string text;
  for (std::size_t i = 0; i < std::min(which.size(), kMostNamedUnits); ++i) {
    const std::string& id = units[which[i]].id;
    text += kind == nullptr ? html_text(id) + " "
                            : fmt::format("<a href=\"#{}/{}\">{}</a> ", kind, url_of_path(id), html_text(id));
  }
  return text + (which.size() > kMostNamedUnits ? "..." : "");
}

std::string unit_differences(const char* title, const char* kind, const std::vector<ComparedUnit>& now,
                             const std::vector<ComparedUnit>& before, double reach) {
  if (now.empty() && before.empty()) return {};
  const UnitChanges changes = compare_units(now, before, reach);
  std::vector<std::pair<std::size_t, std::size_t>> changed, moved;
  constexpr double kMoved = 0.01;  // metres: what the scene's whole centimetres show
  for (const auto& [a, b] : changes.same) {
    if (now[a].state != before[b].state)
      changed.emplace_back(a, b);
    else if (norm(now[a].middle - before[b].middle) > kMoved)
      moved.emplace_back(a, b);
  }
  std::string html = fmt::format("<h3>{}</h3>\n<p>{} the same, {} changed, {} moved, {} came, {} went.</p>\n", title,
                                 grouped(changes.same.size() - changed.size() - moved.size()), grouped(changed.size()),
                                 grouped(moved.size()), grouped(changes.came.size()), grouped(changes.went.size()));
  if (!changes.came.empty()) html += "<p>Came: " + names_of(now, changes.came, kind) + "</p>\n";
  if (!changes.went.empty())
    html += "<p>Went (numbers of the other result): " + names_of(before, changes.went, nullptr) + "</p>\n";
  HtmlTable table({{"unit"}, {"this result"}, {"the other"}, {"moved, m", true}}, true);
  for (const auto* list : {&changed, &moved})
    for (std::size_t i = 0; i < std::min(list->size(), kMostNamedUnits); ++i) {
      const auto& [a, b] = (*list)[i];
      table.add({names_of(now, {a}, kind), html_text(now[a].state), html_text(before[b].state),
                 number_text(norm(now[a].middle - before[b].middle), 2)});
    }
  return table.empty() ? html : html + table.html();
}

}  // namespace

UnitChanges compare_units(const std::vector<ComparedUnit>& now, const std::vector<ComparedUnit>& before, double reach) {
  UnitChanges changes;
  std::vector<bool> taken_now(now.size()), taken_before(before.size());
  pair_keys(now, before, changes, taken_now, taken_before);
  pair_places(now, before, reach, changes, taken_now, taken_before);
  std::sort(changes.same.begin(), changes.same.end());
  for (std::size_t i = 0; i < now.size(); ++i)
    if (!taken_now[i]) changes.came.push_back(i);
  for (std::size_t i = 0; i < before.size(); ++i)
    if (!taken_before[i]) changes.went.push_back(i);
  return changes;
}

std::string against_section(const ResultFolder& now, const std::vector<BuildingRow>& rows, const SceneFrame& frame,
                            const std::filesystem::path& other) {
  const ResultFolder before = open_result(other);
  if (std::abs(before.metres_per_unit / now.metres_per_unit - 1) > 1e-9)
    throw Error(other.string() + ": its coordinates have another unit than those of " + now.path.string(),
                ExitCode::usage);
  // Choices: a third of a narrow house, two cars' middles, a bay's width.
  constexpr double kBuildings = 2, kPlanes = 0.5, kObjects = 1, kFacades = 2;  // metres
  return html_section(
      "against", "Against " + other.filename().string(),
      settings_differences(now, before) + "<h3>Counts</h3>\n" + count_differences(now, before) +
          unit_differences("Buildings", "building", compared_buildings(rows),
                           compared_buildings(building_rows(before, frame)), kBuildings) +
          unit_differences("Facades", "facade", compared_facades(now, frame), compared_facades(before, frame),
                           kFacades) +
          unit_differences("Objects on the street", "object", compared_objects(now, frame),
                           compared_objects(before, frame), kObjects) +
          unit_differences("Planes", "plane", compared_planes(now, frame), compared_planes(before, frame), kPlanes));
}

}  // namespace ilot
