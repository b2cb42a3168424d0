// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/roofs_obj.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>

#include "engine/model/building_geometry.h"
#include "engine/model/face_triangles.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

constexpr const char* kMaterials =
    "newmtl roof\nKd 0.72 0.30 0.22\nnewmtl wall\nKd 0.82 0.80 0.76\nnewmtl ground\nKd 0.45 0.45 0.45\n";

const char* material_of(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::roof:
      return "roof";
    case SurfaceKind::wall:
      return "wall";
    default:
      return "ground";
  }
}

std::filesystem::path materials_of(std::filesystem::path path) {
  return path.replace_extension(".mtl");
}

// Words of a line end at blanks, so blanks are replaced.
std::string one_word(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) <= 32) c = '_';
  return text.empty() ? "_" : text;
}

using VertexSteps = std::array<std::int64_t, 3>;

struct NumberedVertices {
  std::string lines;
  LatticeVertices places;              // of the building's vertices, as written
  std::vector<std::uint64_t> numbers;  // of the building's vertices, from 1
  std::uint64_t fresh = 0;
};

// Returns the number of decimals that represent a step exactly.
int decimals_of(double step) {
  int decimals = 0;
  for (double s = step; s < 0.99 && decimals < 9; s *= 10) ++decimals;
  return decimals;
}

NumberedVertices number_vertices(const Building& building, const RoofsObjParams& params, std::uint64_t before) {
  NumberedVertices out;
  std::map<VertexSteps, std::uint64_t> known;
  const int decimals = decimals_of(params.step);
  out.places.step = params.step;
  for (const Vec3& v : building.vertices) {
    const Vec3 d = v - params.origin;
    const VertexSteps steps{std::llround(d.x / params.step), std::llround(d.y / params.step),
                            std::llround(d.z / params.step)};
    const auto [entry, fresh] = known.try_emplace(steps, before + out.fresh + 1);
    out.numbers.push_back(entry->second);
    out.places.points.push_back({steps[0], steps[1], steps[2]});
    if (!fresh) continue;
    ++out.fresh;
    const auto at = [&](double origin, std::int64_t s) { return origin + static_cast<double>(s) * params.step; };
    out.lines += fmt::format("v {:.{}f} {:.{}f} {:.{}f}\n", at(params.origin.x, steps[0]), decimals,
                             at(params.origin.y, steps[1]), decimals, at(params.origin.z, steps[2]), decimals);
  }
  return out;
}

template <class Corners>
std::string face_line(const Corners& corners, const std::vector<std::uint64_t>& numbers) {
  std::string line = "f";
  for (const std::uint32_t i : corners) line += fmt::format(" {}", numbers[i]);
  return line + "\n";
}

// OBJ has no holes. Such faces become the same triangles as in the test of the validity of solids.
std::string face_lines(const BuildingSurface& surface, const NumberedVertices& vertices) {
  if (surface.rings.size() == 1) return face_line(surface.rings[0], vertices.numbers);
  std::string lines;
  for (const auto& triangle : triangulate_face(vertices.places, surface.rings))
    lines += face_line(triangle, vertices.numbers);
  return lines;
}

}  // namespace

RoofsObj::RoofsObj(const std::filesystem::path& path, const RoofsObjParams& params) : file_(path), params_(params) {
  const std::string head = fmt::format("mtllib {}\n", materials_of(path).filename().string());
  file_.append(std::as_bytes(std::span(head)));
}

void RoofsObj::add(std::span<const Building> levels) {
  const Building* building = finest_solid(levels);
  if (!building) return;
  const NumberedVertices vertices = number_vertices(*building, params_, vertices_);
  vertices_ += vertices.fresh;
  std::string text = "g " + one_word(building->id) + "\n" + vertices.lines;
  for (const SurfaceKind kind : {SurfaceKind::roof, SurfaceKind::wall, SurfaceKind::ground}) {
    std::string faces;
    for (const BuildingSurface& surface : building->surfaces)
      if (surface.kind == kind) faces += face_lines(surface, vertices);
    if (!faces.empty()) text += fmt::format("usemtl {}\n{}", material_of(kind), faces);
  }
  file_.append(std::as_bytes(std::span(text)));
}

void RoofsObj::finish() {
  write_whole_file(materials_of(file_.path()), kMaterials);
  file_.commit();
}

}  // namespace ilot
