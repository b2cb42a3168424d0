// SPDX-License-Identifier: Apache-2.0
#include "scan/models/model_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/deliverables/solids/model_file.h"
#include "engine/error.h"
#include "engine/formats/crs.h"
#include "kernels/geometry/ring.h"

namespace ilot::scan {
namespace {

constexpr double kLeastExtent = 0.1, kMostExtent = 4000;  // metres; above, boxes of Embree round too coarsely
constexpr double kMostCoordinate = 1e8;                   // metres; no CRS of the Earth goes beyond
constexpr double kUpright = 0.1;                          // |z| of the unit normal of a wall is smaller
constexpr double kFloorHeight = 0.1;                      // metres above the lowest vertex

std::string shown(Vec3 p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z);
}

double metres_of(const std::string& unit) {
  const std::map<std::string, double> units{
      {"m", 1}, {"ft", 0.3048}, {"us-ft", 1200.0 / 3937}, {"cm", 0.01}, {"mm", 0.001}};
  const auto found = units.find(unit);
  if (found == units.end())
    throw Error("scan: --unit takes m, ft, us-ft, cm or mm, not '" + unit + "'", ExitCode::usage);
  return found->second;
}

Box3<Vec3> box_of(const ModelFile& file) {
  Box3<Vec3> box = Box3<Vec3>::none();
  for (const PolygonModel& model : file.models)
    for (const Vec3& v : model.vertices) box.add(v);
  return box;
}

// Degrees of longitude and latitude: the model would be higher than it is long.
bool looks_like_degrees(const Box3<Vec3>& box) {
  const double wide = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
  const bool in_range = std::abs(box.min.x) <= 180 && std::abs(box.max.x) <= 180 && std::abs(box.min.y) <= 90 &&
                        std::abs(box.max.y) <= 90;
  return in_range && wide < 0.05 && box.max.z - box.min.z > 20 * wide;
}

// The factor to metres. Sets the CRS of the scene: it is kept where its unit is the metre.
double scale_of(const ModelInput& input, const ModelFile& file, const Box3<Vec3>& box, ScannedModel& model) {
  const std::string where = input.path.string();
  const std::string text = input.crs.empty() ? file.crs : input.crs;
  Crs crs;
  if (!text.empty()) crs = crs_from_text(text);
  if (crs.geographic || (text.empty() && input.unit.empty() && looks_like_degrees(box)))
    throw Error(fmt::format("{}: coordinates such as {} are degrees{}; a scanner needs metres: convert the model to a "
                            "projected coordinate system first (cjio reproject, ogr2ogr), or give --crs and --unit",
                            where, shown(box.min), crs.geographic ? " (" + text + ")" : ""),
                ExitCode::usage);
  constexpr double kSameUnit = 1e-4;  // international and US survey foot differ less
  if (std::abs(crs.metres_per_unit_z / crs.metres_per_unit - 1) > kSameUnit)
    throw Error(fmt::format("{}: heights of {} are in another unit than x and y; bring the model into one unit first",
                            where, text),
                ExitCode::usage);
  const double scale = !input.unit.empty() ? metres_of(input.unit) : crs.metres_per_unit;
  if (std::abs(scale - 1) > 1e-9) {
    model.notes.push_back(
        fmt::format("coordinates are multiplied by {:.9g}: the scan is in metres and has no coordinate "
                    "system",
                    scale));
    crs = Crs{};
  } else if (text.empty()) {
    model.notes.push_back("the model says no coordinate system: metres are assumed (--unit, --crs)");
  }
  model.place.crs = crs;
  return scale;
}

void check_extent(const ModelInput& input, const Box3<Vec3>& box, double scale) {
  const std::string where = input.path.string();
  const double extent = scale * norm(box.max - box.min);
  const Vec3 far{std::max(std::abs(box.min.x), std::abs(box.max.x)), std::max(std::abs(box.min.y), std::abs(box.max.y)),
                 std::max(std::abs(box.min.z), std::abs(box.max.z))};
  if (!(scale * std::max({far.x, far.y, far.z}) <= kMostCoordinate))
    throw Error(
        fmt::format("{}: coordinates reach {}: no place on Earth in metres; is --unit right?", where, shown(far)));
  if (extent > kMostExtent)
    throw Error(
        fmt::format("{}: the model spans {:.0f} m, more than the {:.0f} m of one scan; cut it into parts, or give "
                    "--unit mm or cm if these are its units",
                    where, extent, kMostExtent));
  if (extent < kLeastExtent)
    throw Error(fmt::format("{}: the model spans only {:.3g} m: is it in other units (--unit)?", where, extent));
}

// Faces that nothing describes: by where they are and how they lean, as roof_faces() does.
FaceClass class_by_geometry(const ScannedFace& face, double low) {
  const bool at_bottom =
      std::all_of(face.rings[0].begin(), face.rings[0].end(), [&](const Vec3& p) { return p.z < low + kFloorHeight; });
  if (std::abs(face.normal.z) < kUpright) return FaceClass::facade;
  return at_bottom ? FaceClass::floor : FaceClass::roof;
}

class Builder {
 public:
  // With a `common` name all models are parts of one building.
  Builder(ScannedModel& model, double scale, const ModelInput& input, std::string common)
      : model_(model), scale_(scale), input_(input), common_(std::move(common)) {}

  void add(const PolygonModel& source) {
    const auto first_surface = static_cast<std::uint32_t>(model_.surfaces.size());
    std::vector<FaceMeaning> meanings;
    for (const ModelSurface& s : source.surfaces) {
      meanings.push_back(meaning_of(s));
      ScannedSurface surface{meanings.back().face_class, !s.type.empty(), {}};
      if (s.parent >= 0) surface.parent = first_surface + static_cast<std::uint32_t>(s.parent);
      model_.surfaces.push_back(surface);
    }
    const std::uint32_t building = building_of(source, meanings);
    double low = INFINITY;
    for (const Vec3& v : source.vertices) low = std::min(low, local(v).z);
    for (const PolygonFace& face : source.faces) {
      const auto at = static_cast<std::size_t>(std::max(0, face.surface));
      if (meanings.empty() || (meanings[at].absent && !input_.closures)) {
        ++closures_;
        continue;
      }
      ScannedFace made = face_of(source, face);
      if (made.triangles.empty()) {
        ++flat_;
        continue;
      }
      made.building = building;
      made.surface = first_surface + static_cast<std::uint32_t>(at);
      made.face_class = meanings[at].known ? meanings[at].face_class : class_by_geometry(made, low);
      const bool named = meanings[at].known && !source.surfaces[at].material.empty();
      made.material = named ? meanings[at].material : usual_material(made.face_class, building);
      for (const Vec3& p : made.rings[0]) model_.box.add(p);
      model_.faces.push_back(std::move(made));
    }
  }

  void finish() {
    if (closures_)
      model_.notes.push_back(
          fmt::format("{} closure surfaces left open; scene.closures=1 builds walls there", closures_));
    if (flat_) model_.notes.push_back(fmt::format("{} faces without area left out", flat_));
  }

 private:
  Vec3 local(Vec3 v) const {
    const Vec3 up = input_.y_up ? Vec3{v.x, -v.z, v.y} : v;
    return scale_ * up - model_.place.origin;
  }

  // Terrain, roads and plants are no buildings. A file of groups without words is one building a group.
  std::uint32_t building_of(const PolygonModel& source, const std::vector<FaceMeaning>& meanings) {
    const bool no_building = !meanings.empty() && std::all_of(meanings.begin(), meanings.end(), [](const auto& m) {
      return m.known && (m.face_class == FaceClass::ground || m.face_class == FaceClass::vegetation);
    });
    const bool city_furniture = !source.surfaces.empty() && !source.surfaces[0].object_type.empty() &&
                                std::none_of(source.surfaces.begin(), source.surfaces.end(), [](const auto& s) {
                                  return s.object_type.starts_with("Building") || s.object_type == "Bridge";
                                });
    if (no_building || city_furniture) return 0;
    if (!common_.empty() && !model_.buildings.empty()) return 1;
    model_.buildings.push_back(common_.empty() ? source.name : common_);
    return static_cast<std::uint32_t>(model_.buildings.size());
  }

  ScannedFace face_of(const PolygonModel& source, const PolygonFace& face) const {
    PolygonModel moved{"", {}, {}};
    PolygonFace same{face.rings, face.kind, 0, -1};
    for (auto& ring : same.rings)
      for (std::uint32_t& i : ring) {
        moved.vertices.push_back(local(source.vertices[i]));
        i = static_cast<std::uint32_t>(moved.vertices.size() - 1);
      }
    ScannedFace made;
    for (const auto& ring : same.rings) {
      made.rings.emplace_back();
      for (const std::uint32_t i : ring) made.rings.back().push_back(moved.vertices[i]);
    }
    std::vector<Triangle3> triangles;
    append_triangles(moved, same, triangles);
    Vec3 sum;
    for (const Triangle3& t : triangles) {
      const Vec3 area = cross(t.b - t.a, t.c - t.a);
      if (!(norm(area) > 0)) continue;
      made.area += norm(area) / 2;
      made.triangles.push_back(t);
    }
    sum = doubled_area(made.rings[0]);
    if (norm(sum) > 0)
      made.normal = (1 / norm(sum)) * sum;
    else
      made.triangles.clear();
    return made;
  }

  ScannedModel& model_;
  double scale_;
  const ModelInput& input_;
  std::string common_;
  std::uint64_t closures_ = 0, flat_ = 0;
};

// Groups of an OBJ are buildings, unless their names say that they are walls, windows and so on: then the file is one.
std::string common_name(const ModelInput& input, const ModelFile& file) {
  const bool parts = std::any_of(file.models.begin(), file.models.end(), [](const PolygonModel& m) {
    return std::any_of(m.surfaces.begin(), m.surfaces.end(), [&](const ModelSurface& s) {
      return s.object_type.empty() && meaning_of({"", m.name, -1, "", ""}).known;
    });
  });
  return parts ? input.path.stem().string() : "";
}

}  // namespace

ScannedModel read_scanned_model(const ModelInput& input) {
  const ModelFile file = read_models(input.path, {input.lod, true});
  ScannedModel model;
  model.notes = file.warnings;
  const Box3<Vec3> box = box_of(file);
  if (box.is_empty()) throw Error(input.path.string() + ": contains no face that could be scanned");
  const double scale = scale_of(input, file, box, model);
  check_extent(input, box, scale);
  const Vec3 low = input.y_up ? Vec3{box.min.x, -box.max.z, box.min.y} : box.min;
  model.place.origin = {std::floor(scale * low.x), std::floor(scale * low.y), std::floor(scale * low.z)};
  Builder builder(model, scale, input, common_name(input, file));
  for (const PolygonModel& source : file.models) builder.add(source);
  builder.finish();
  if (model.faces.empty()) throw Error(input.path.string() + ": no face of it has an area");
  return model;
}

}  // namespace ilot::scan
