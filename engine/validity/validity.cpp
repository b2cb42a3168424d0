// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/validity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/validity/validate_solid.h"

namespace ilot {
namespace {

struct CodeName {
  int code;
  const char* name;
};

constexpr CodeName kCodes[] = {{101, "TOO_FEW_POINTS"},
                               {102, "CONSECUTIVE_POINTS_SAME"},
                               {103, "RING_NOT_CLOSED"},
                               {104, "RING_SELF_INTERSECTION"},
                               {201, "INTERSECTION_RINGS"},
                               {202, "DUPLICATED_RINGS"},
                               {203, "NON_PLANAR_POLYGON_DISTANCE_PLANE"},
                               {204, "NON_PLANAR_POLYGON_NORMALS_DEVIATION"},
                               {205, "POLYGON_INTERIOR_DISCONNECTED"},
                               {206, "INNER_RING_OUTSIDE"},
                               {207, "INNER_RINGS_NESTED"},
                               {208, "ORIENTATION_RINGS_SAME"},
                               {301, "TOO_FEW_POLYGONS"},
                               {302, "SHELL_NOT_CLOSED"},
                               {303, "NON_MANIFOLD_CASE"},
                               {305, "MULTIPLE_CONNECTED_COMPONENTS"},
                               {306, "SHELL_SELF_INTERSECTION"},
                               {307, "POLYGON_WRONG_ORIENTATION"},
                               {401, "INTERSECTION_SHELLS"},
                               {402, "DUPLICATED_SHELLS"},
                               {403, "INNER_SHELL_OUTSIDE"},
                               {405, "WRONG_ORIENTATION_SHELL"},
                               {501, "INTERSECTION_SOLIDS"},
                               {502, "DUPLICATED_SOLIDS"},
                               {503, "DISCONNECTED_SOLIDS"},
                               {601, "BUILDINGPARTS_OVERLAP"},
                               {901, "INVALID_INPUT_FILE"},
                               {902, "EMPTY_PRIMITIVE"},
                               {903, "WRONG_INPUT_PARAMETERS"}};

constexpr double kFarthest = 1e12;  // CRS units: beyond it a double does not resolve a tenth of a millimetre

bool overlap(const std::vector<SolidBoundary>& a, const std::vector<SolidBoundary>& b) {
  for (const SolidBoundary& s : a)
    for (const SolidBoundary& t : b)
      if (relate_solids(s, t).interiors_overlap()) return true;
  return false;
}

bool takes_room(const Primitive& p) {
  return p.kind == PrimitiveKind::solid || p.kind == PrimitiveKind::composite_solid;
}

// Checks for overlaps the solids of one level of detail of a building and its parts, all of which are valid.
Faults check_overlaps(const CityObject& object, const std::vector<CheckedPrimitive>& checked) {
  Faults faults;
  const std::vector<Primitive>& all = object.primitives;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = i + 1; k < all.size(); ++k)
      if (takes_room(all[i]) && takes_room(all[k]) && all[i].lod == all[k].lod &&
          overlap(checked[i].solids, checked[k].solids))
        faults.push_back({601, fmt::format("geometries {} and {}, lod {}", i, k, all[i].lod)});
  return faults;
}

std::string name_of(const CityObject& object, std::size_t i) {
  const Primitive& p = object.primitives[i];
  std::string name = p.owner.empty() || p.owner == object.id ? "" : p.owner;
  if (object.primitives.size() > 1) name += fmt::format("{}geometry {}", name.empty() ? "" : ", ", i);
  if (!p.lod.empty()) name += fmt::format("{}lod {}", name.empty() ? "" : ", ", p.lod);
  return name;
}

}  // namespace

const char* validity_code_name(int code) {
  for (const CodeName& known : kCodes)
    if (known.code == code) return known.name;
  return "UNKNOWN_ERROR";
}

std::vector<int> codes_of(const Faults& faults) {
  std::vector<int> codes;
  for (const Fault& fault : faults) codes.push_back(fault.code);
  std::sort(codes.begin(), codes.end());
  codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
  return codes;
}

Faults validate_object(const CityObject& object, const ValidityParams& params) {
  const auto far = [](const Vec3& v) { return !(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) < kFarthest); };
  if (std::any_of(object.vertices.begin(), object.vertices.end(), far)) return {{901, "a vertex without a place"}};
  const ValidityLattice lattice = lattice_of(object.vertices);
  Faults faults;
  std::vector<CheckedPrimitive> checked;
  for (std::size_t i = 0; i < object.primitives.size(); ++i) {
    checked.push_back(check_primitive(object.vertices, object.primitives[i], lattice, params, name_of(object, i)));
    faults.insert(faults.end(), checked.back().faults.begin(), checked.back().faults.end());
  }
  return faults.empty() && object.type == "Building" ? check_overlaps(object, checked) : faults;
}

Faults validate_building(const Building& building, Vec3 origin, double step, const ValidityParams& params) {
  CityObject object{building.id, "Building", {}, {}};
  for (const Vec3& v : building.vertices) {
    const Vec3 p = v - origin;
    object.vertices.push_back(origin +
                              step * Vec3{std::round(p.x / step), std::round(p.y / step), std::round(p.z / step)});
  }
  SolidShell shell;
  for (const BuildingSurface& surface : building.surfaces) shell.push_back({surface.rings, ""});
  const PrimitiveKind kind = building.lod.starts_with('0') ? PrimitiveKind::multi_surface : PrimitiveKind::solid;
  object.primitives.push_back({kind, building.lod, building.id, {{std::move(shell)}}});
  return validate_object(object, params);
}

}  // namespace ilot
