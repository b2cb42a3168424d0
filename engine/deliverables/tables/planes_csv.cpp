// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/tables/planes_csv.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <string>

#include "engine/error.h"
#include "engine/whole_file_writer.h"

namespace ilot {
namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',')
      cells.emplace_back();
    else if (c != '\r')
      cells.back() += c;
  }
  return cells;
}

double number_of(const std::string& cell, const std::string& place) {
  double value = 0;
  const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (code != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value))
    throw Error(place + ": '" + cell + "' is no number");
  return value;
}

std::uint64_t content_id_of(const std::string& cell, const std::string& place) {
  std::uint64_t id = 0;
  const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), id, 16);
  if (code != std::errc() || end != cell.data() + cell.size()) throw Error(place + ": bad content_id");
  return id;
}

}  // namespace

void write_planes_csv(const std::filesystem::path& path, std::span<const Segment> segments) {
  WholeFileWriter file(path);
  file.append(
      "plane_id,content_id,points,nx,ny,nz,d,epsilon_m,rms_m,centroid_x,centroid_y,centroid_z,min_x,min_y,"
      "min_z,max_x,max_y,max_z,area_m2,level_m,up_m,normal_spread_deg,confidence,colour_class,neighbours\n");
  for (const Segment& s : segments) {
    file.append(fmt::format("{},{:016x},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},", s.id, s.content_id, s.points,
                            s.plane.n.x, s.plane.n.y, s.plane.n.z, s.plane.d, s.epsilon_m, s.rms_m, s.centroid.x,
                            s.centroid.y, s.centroid.z, s.min.x, s.min.y, s.min.z, s.max.x, s.max.y, s.max.z));
    file.append(fmt::format("{},{},{},{},{},{},{}\n", s.area_m2, s.level_m, s.up_m, s.normal_spread_deg, s.confidence,
                            s.colour_class, s.neighbours));
  }
  file.finish();
}

std::vector<PlaneNeighbours> read_planes_neighbours_csv(const std::filesystem::path& path) {
  constexpr std::size_t kColumns = 12;
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) throw Error(path.string() + ": cannot be read");
  std::vector<PlaneNeighbours> pairs;
  for (std::size_t row = 2; std::getline(file, line); ++row) {
    const std::string place = fmt::format("{}:{}", path.string(), row);
    const std::vector<std::string> cells = split(line);
    if (cells.size() != kColumns)
      throw Error(fmt::format("{}: {} cells for {} columns", place, cells.size(), kColumns));
    const auto value = [&](std::size_t column) { return number_of(cells[column], place); };
    const double a = value(0), b = value(1);
    if (!(a >= 1 && a < b && b <= 4294967295.0)) throw Error(place + ": bad ids");
    pairs.push_back({static_cast<std::uint32_t>(a),
                     static_cast<std::uint32_t>(b),
                     cells[2] == "edge" ? Touching::edge : Touching::step,
                     value(3),
                     value(4),
                     value(5),
                     {value(6), value(7), value(8)},
                     {value(9), value(10), value(11)}});
  }
  return pairs;
}

void for_each_plane(const std::filesystem::path& path, const std::function<void(const Segment&)>& use) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) throw Error(path.string() + ": cannot be read");
  std::map<std::string, std::size_t> column;
  for (const std::string& name : split(line)) column.try_emplace(name, column.size());
  for (const char* name : {"plane_id", "nx", "ny", "nz", "d", "centroid_x", "centroid_y", "centroid_z"})
    if (!column.contains(name)) throw Error(fmt::format("{}:1: no column '{}'", path.string(), name));
  for (std::size_t row = 2; std::getline(file, line); ++row) {
    const std::string place = fmt::format("{}:{}", path.string(), row);
    const std::vector<std::string> cells = split(line);
    if (cells.size() != column.size())
      throw Error(fmt::format("{}: {} cells for {} columns", place, cells.size(), column.size()));
    const auto value = [&](const char* name) {
      const auto found = column.find(name);
      return found == column.end() ? 0 : number_of(cells[found->second], place);
    };
    Segment s;
    const double id = value("plane_id"), points = value("points");
    if (!(id >= 1 && id <= 4294967295.0) || !(points >= 0 && points < 1e15)) throw Error(place + ": bad id or count");
    s.id = static_cast<std::uint32_t>(id);
    s.points = static_cast<std::uint64_t>(points);
    if (const auto found = column.find("content_id"); found != column.end())
      s.content_id = content_id_of(cells[found->second], place);
    s.plane = {{value("nx"), value("ny"), value("nz")}, value("d")};
    s.centroid = {value("centroid_x"), value("centroid_y"), value("centroid_z")};
    s.min = {value("min_x"), value("min_y"), value("min_z")};
    s.max = {value("max_x"), value("max_y"), value("max_z")};
    s.rms_m = value("rms_m");
    s.epsilon_m = value("epsilon_m");
    s.area_m2 = value("area_m2");
    s.level_m = value("level_m");
    s.up_m = value("up_m");
    s.normal_spread_deg = value("normal_spread_deg");
    s.confidence = value("confidence");
    const double neighbours = value("neighbours"), colour = value("colour_class");
    if (!(neighbours >= 0 && neighbours <= 4294967295.0)) throw Error(place + ": bad count of neighbours");
    if (!(colour >= 0 && colour <= 255)) throw Error(place + ": bad colour class");
    s.colour_class = static_cast<std::uint32_t>(colour);
    s.neighbours = static_cast<std::uint32_t>(neighbours);
    use(s);
  }
}

std::vector<Segment> read_planes_csv(const std::filesystem::path& path) {
  std::vector<Segment> segments;
  for_each_plane(path, [&](const Segment& segment) { segments.push_back(segment); });
  return segments;
}

}  // namespace ilot
