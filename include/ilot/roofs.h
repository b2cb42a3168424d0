// SPDX-License-Identifier: Apache-2.0
// The buildings that a run modelled, read back from its folder. Coordinates in the CRS of the inputs and its units;
// names that end in _m, _m2, _m3 and _deg are metres, their powers and degrees whatever the CRS.
//
//   for (const ilot::BuildingModel& building : ilot::read_roofs("out")) {
//     const auto height = building.number("h_roof_max");
//     if (height) std::printf("%s: up to %g\n", building.id.c_str(), *height);
//   }
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "ilot/geometry.h"

namespace ilot {

enum class SurfaceKind : std::uint8_t { roof, wall, ground };

// A flat face: the first ring is its outline, counter-clockwise seen from outside, the others are holes, clockwise.
// Rings are numbers of vertices and not closed.
struct BuildingSurface {
  SurfaceKind kind = SurfaceKind::roof;
  std::uint32_t plane_id = 0;  // 0 = none
  std::vector<std::vector<std::uint32_t>> rings;
};

using AttributeValue = std::variant<std::int64_t, double, std::string, bool>;

// A building as one closed solid. Coordinates in the CRS of the inputs.
struct Building {
  std::string id;  // unique within a model
  std::string lod = "2.2";
  std::vector<Vec3> vertices;
  std::vector<BuildingSurface> surfaces;
  std::vector<std::pair<std::string, AttributeValue>> attributes;
};

struct SurfaceShape {
  double area_m2 = 0;
  double slope_deg = 0;     // between the surface and the level, 0 to 90 for roofs
  double azimuth_deg = -1;  // where it looks, clockwise from north; -1 for level surfaces
};

// Of a face in space, holes taken off. Zeros for faces without an area. O(corners).
SurfaceShape surface_shape(const Building& building, const BuildingSurface& surface, double metres_per_unit);

// What a closed solid encloses. O(corners).
double volume_m3(const Building& building, double metres_per_unit);

// A building as a run wrote it.
struct BuildingModel {
  std::string id;                // the footprint's, or of the place of the building
  std::vector<Building> levels;  // lowest level of detail first: "0", the outline on the ground, "1.2", "1.3", "2.2"

  // In both styles of names (settings.roofs.attribute_style) as the file has them. Units and meanings: docs/outputs.md.
  //   status: lod22, lod12 or footprint_only; reason: in words, why not lod22
  //   points; unit_id: of its points in the labelled clouds; roof_faces; roof_type
  //   h_ground, h_roof_min, h_roof_50, h_roof_70, h_roof_max: CRS units; area_m2 of the outline
  //   volume_lod12_m3, volume_lod13_m3, volume_lod22_m3; party_wall_m2, exterior_wall_m2: of its walls
  //   rmse_m: root mean square distance of the points from their faces; coverage: share of the outline with points
  std::vector<std::pair<std::string, AttributeValue>> attributes;

  std::optional<double> number(const std::string& name) const;     // nullopt: there is none, or it is no number
  std::optional<std::string> text(const std::string& name) const;  // nullopt: there is none, or it is no text
};

// Reads roofs/roofs.city.jsonl of a run with the product roofs, in its order. Vertices are as written, to 0.1 mm. All
// is held in memory, about what the file takes. O(bytes). Several threads may read at once. Error (usage) when there
// are no roofs in the folder; a damaged file is an Error that names the file and the line.
std::vector<BuildingModel> read_roofs(const std::filesystem::path& run_folder);

}  // namespace ilot
