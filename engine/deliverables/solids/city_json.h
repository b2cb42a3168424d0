// SPDX-License-Identifier: Apache-2.0
// CityJSON 2.0 (cityjson.org/specs/2.0.1): buildings as solids with roof, wall and ground surfaces, or as flat
// outlines.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/deliverables/solids/building_fields.h"
#include "engine/formats/file.h"
#include "engine/model/building.h"

namespace ilot {

// Returns "RoofSurface", "WallSurface" or "GroundSurface", the names that CityJSON and CityGML have.
const char* surface_type(SurfaceKind kind);

struct CityJsonParams {
  int epsg = 0;          // 0 = unknown
  Vec3 origin;           // near the buildings: coordinates are whole steps from this place
  double step = 0.0001;  // CRS units. Flat faces stay flat within 0.87 steps
  AttributeStyle style = AttributeStyle::plain;
  double metres_per_unit = 1;
  // Of the metadata; parameters and sources are objects of JSON; empty: none.
  std::string title = {}, software = {}, parameters = {}, sources = {};
  std::optional<std::array<double, 6>> extent = {};  // lowest x, y, z and highest x, y, z; CRS units
};

// Writes one building after the other as they arrive. The extension selects the form: .jsonl is a CityJSONSeq with one
// feature a line, which needs no memory; anything else is one object, for which the vertices are kept until the end (12
// bytes each). Vertices on the same step become one. The file appears under its name at finish() or not at all. Throws
// Error.
class CityJsonWriter {
 public:
  CityJsonWriter(const std::filesystem::path& path, const CityJsonParams& params);

  void add(const Building& building) { add(std::span(&building, 1)); }

  // Adds one building with at least one level of detail. Its id and attributes are those of the first level. A level of
  // 0 to 0.9 becomes a MultiSurface, others a Solid. A level without surfaces is left out.
  void add(std::span<const Building> levels);
  void finish();

  std::uint64_t bytes() const { return file_.position(); }  // written so far

 private:
  using Steps = std::array<std::int64_t, 3>;
  std::vector<std::uint32_t> number_vertices(const Building& building, std::vector<Steps>& vertices) const;
  void append(const std::string& text);

  OutputFile file_;
  CityJsonParams params_;
  bool sequence_ = false, first_ = true;
  std::vector<Steps> vertices_;  // for the single object
};

}  // namespace ilot
