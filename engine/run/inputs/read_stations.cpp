// SPDX-License-Identifier: Apache-2.0
#include "engine/run/inputs/read_stations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "engine/error.h"
#include "engine/formats/remote_file.h"
#include "engine/formats/tables/lines.h"
#include "engine/report/counted.h"

namespace ilot {
namespace {

constexpr std::array<std::string_view, 10> kNames{
    "x", "y", "z", "azimuth_step_deg", "elevation_step_deg", "axis_x", "axis_y", "axis_z", "name", "point_source_id"};
constexpr std::size_t kName = 8, kSource = 9, kMostStations = 100000;
constexpr double kRadians = 0.017453292519943295, kMostDegrees = 5;

using StationFields = std::vector<std::string_view>;

// Gives for each column its index in kNames.
using ColumnOrder = std::vector<std::size_t>;

[[noreturn]] void refuse_stations(const std::string& where, const std::string& what) {
  throw Error(where + ": " + what, ExitCode::usage);
}

bool is_header(const StationFields& fields) {
  return std::find(kNames.begin(), kNames.end(), fields[0]) != kNames.end();
}

ColumnOrder order_of(const StationFields& header, const std::string& where) {
  ColumnOrder order;
  for (const std::string_view field : header) {
    const auto at = std::find(kNames.begin(), kNames.end(), field);
    if (at == kNames.end()) refuse_stations(where, "\"" + std::string(field) + "\" is no column of a stations file");
    order.push_back(static_cast<std::size_t>(at - kNames.begin()));
    if (std::count(order.begin(), order.end(), order.back()) > 1)
      refuse_stations(where, "the column \"" + std::string(field) + "\" comes twice");
  }
  const auto has = [&](std::size_t name) { return std::find(order.begin(), order.end(), name) != order.end(); };
  if (!has(0) || !has(1) || !has(2)) refuse_stations(where, "the columns x, y and z are needed");
  if (has(3) != has(4)) refuse_stations(where, "azimuth_step_deg and elevation_step_deg go together");
  if (has(5) != has(6) || has(6) != has(7)) refuse_stations(where, "axis_x, axis_y and axis_z go together");
  return order;
}

// Without a header: x y z, then both steps, then the axis; a name comes before them when the first field is not a
// number.
ColumnOrder usual_order(const StationFields& first, const std::string& where) {
  double number = 0;
  const bool named = !parse_number(first[0], number);
  const std::size_t columns = first.size() - (named ? 1 : 0);
  if (columns != 3 && columns != 5 && columns != 8)
    refuse_stations(where, "has " + counted(first.size(), "column") + ", read as " +
                               (named ? "a name (\"" + std::string(first[0]) + "\") and " : "") +
                               counted(columns, "number") +
                               "; expected are x y z (3), with two angular steps (5), with the axis too (8), a name "
                               "before them if wanted, or a header that names the columns (name,x,y,z)");
  ColumnOrder order;
  if (named) order.push_back(kName);
  for (std::size_t i = 0; i < columns; ++i) order.push_back(i);
  return order;
}

// Returns a whole number from 1 to 65535, else 0.
std::uint16_t source_id(std::string_view text) {
  double number = 0;
  if (!parse_number(text, number) || !(number >= 1 && number <= 65535)) return 0;
  const auto whole = static_cast<std::uint16_t>(number);
  return static_cast<double>(whole) == number ? whole : std::uint16_t{0};
}

Station station_of(const StationFields& fields, const ColumnOrder& order, const std::string& where) {
  if (fields.size() != order.size())
    refuse_stations(where, "has " + std::to_string(fields.size()) + " fields, not " + std::to_string(order.size()));
  std::array<double, 8> v{0, 0, 0, 0, 0, 0, 0, 1};
  bool steps = false, numbered = false;
  Station station;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (order[i] == kName) {
      station.name = fields[i];
      continue;
    }
    if (order[i] == kSource) {
      station.source_id = source_id(fields[i]);
      numbered = true;
      if (station.source_id == 0)
        refuse_stations(where,
                        "\"" + std::string(fields[i]) + "\" is no point_source_id, a whole number from 1 to 65535");
      continue;
    }
    if (!parse_number(fields[i], v[order[i]]) || !std::isfinite(v[order[i]]))
      refuse_stations(where, "\"" + std::string(fields[i]) + "\" is not a number");
    steps |= order[i] == 3;
  }
  if (!numbered) station.source_id = source_id(station.name);
  if (steps && !(v[3] > 0 && v[3] <= kMostDegrees && v[4] > 0 && v[4] <= kMostDegrees))
    refuse_stations(where, "angular steps must lie above 0 and be 5 degrees at most");
  station.position = {v[0], v[1], v[2]};
  station.azimuth_step = v[3] * kRadians;
  station.elevation_step = v[4] * kRadians;
  const double length = norm(Vec3{v[5], v[6], v[7]});
  if (!(length > 0)) refuse_stations(where, "the axis has no length");
  station.axis = (1 / length) * Vec3{v[5], v[6], v[7]};
  return station;
}

}  // namespace

std::vector<Station> read_stations(const std::filesystem::path& path) {
  if (!is_remote(path) && !std::filesystem::exists(path)) refuse_stations(path.string(), "there is no such file");
  const InputFile file(path);
  LineReader lines(file, 0);
  std::vector<Station> stations;
  std::string_view line;
  StationFields fields;
  ColumnOrder order;
  for (std::size_t number = 1; lines.next(line); ++number) {
    const std::string where = path.string() + ":" + std::to_string(number);
    if (line.find('\0') != std::string_view::npos)
      refuse_stations(path.string(), "is no text; a stations file has a line x y z for each station");
    split_fields(line, kNames.size() + 1, fields);
    if (fields.empty() || fields[0].empty() || fields[0].front() == '#') continue;
    if (order.empty() && is_header(fields)) {
      order = order_of(fields, where);
      continue;
    }
    if (order.empty()) order = usual_order(fields, where);
    stations.push_back(station_of(fields, order, where));
    if (stations.back().name.empty()) stations.back().name = "station " + std::to_string(stations.size());
    if (stations.size() > kMostStations) refuse_stations(where, "more stations than 100000");
  }
  if (stations.empty()) refuse_stations(path.string(), "contains no station");
  return stations;
}

}  // namespace ilot
