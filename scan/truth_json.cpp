// SPDX-License-Identifier: Apache-2.0
#include "scan/truth_json.h"

#include <fmt/format.h>

#include <vector>

#include "scan/scanners/cell_scan.h"
#include "scan/scanners/scan_record.h"

namespace ilot::scan {
namespace {

const char* name_of(Surface surface) {
  switch (surface) {
    case Surface::ground:
      return "ground";
    case Surface::roof:
      return "roof";
    case Surface::wall:
      return "wall";
    default:
      return "vegetation";
  }
}

std::string plane_text(std::uint32_t id, Surface surface, const Plane& plane, std::uint64_t points) {
  const double d = plane.d - dot(plane.n, kSceneOrigin);
  return fmt::format(R"({{"id":{},"class":"{}","plane":[{},{},{},{}],"points":{},"polygons":[)", id, name_of(surface),
                     plane.n.x, plane.n.y, plane.n.z, d, points);
}

std::string ring_text(std::span<const Vec3> ring) {
  std::string text = "[";
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3 p = ring[i] + kSceneOrigin;
    text += fmt::format("{}[{:.4f},{:.4f},{:.4f}]", i ? "," : "", p.x, p.y, p.z);
  }
  return text + "]";
}

}  // namespace

TruthJson::TruthJson(const std::filesystem::path& path, const std::string& settings) : file_(path) {
  append(fmt::format("{{\"scan\":{{{}}},\n\"crs\":\"EPSG:2154\",\n\"planes\":[\n", settings));
}

void TruthJson::append(const std::string& text) {
  file_.append(std::as_bytes(std::span(text)));
}

void TruthJson::add_cell(const Cell& cell, std::uint32_t first_plane, std::uint32_t first_building,
                         std::span<const std::uint64_t> points) {
  std::vector<std::string> planes(cell.plane_count);
  for (std::size_t face = 0; face < cell.faces.size(); ++face) {
    const std::uint32_t p = cell.face_plane[face];
    std::string& text = planes[p];
    if (text.empty())
      text = plane_text(first_plane + p, cell.faces[face].surface, cell.faces[face].plane, points[p]);
    else
      text += ",";
    text += fmt::format(R"({{"building":{},"ring":{}}})", first_building + cell.face_building[face],
                        ring_text(cell.faces[face].ring));
  }
  for (const std::string& text : planes) {
    append((first_ ? "" : ",\n") + text + "]}");
    first_ = false;
  }
}

void TruthJson::add_ground(const Ground& ground, const Rect& area, std::uint64_t points) {
  const auto corner = [&](double x, double y) { return Vec3{x, y, ground.height(x, y)}; };
  const std::vector<Vec3> ring{corner(area.x0, area.y0), corner(area.x1, area.y0), corner(area.x1, area.y1),
                               corner(area.x0, area.y1)};
  append((first_ ? "" : ",\n") + plane_text(kGroundPlane, Surface::ground, ground.plane(), points) +
         fmt::format(R"({{"building":0,"ring":{}}}]}})", ring_text(ring)));
  first_ = false;
}

void TruthJson::finish(std::uint64_t points, std::uint64_t buildings) {
  append(fmt::format("\n],\n\"points\":{},\n\"buildings\":{}}}\n", points, buildings));
  file_.commit();
}

}  // namespace ilot::scan
