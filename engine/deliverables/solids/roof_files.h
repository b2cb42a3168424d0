// SPDX-License-Identifier: Apache-2.0
// All files in which models of buildings are delivered.
#pragma once
#include <filesystem>
#include <memory>
#include <span>

#include "engine/deliverables/layers/roofs_gpkg.h"
#include "engine/deliverables/solids/city_json.h"
#include "engine/deliverables/solids/roofs_obj.h"

namespace ilot {

struct RoofFilesParams {
  CityJsonParams city_json;
  std::uint64_t largest_object = 256u << 20;  // bytes of roofs.city.json; a larger one is left out
  Columns further = {};                       // of roofs.gpkg: attributes of the footprints
};

// Writes folder/roofs.city.jsonl, roofs.city.json, roofs.obj with roofs.mtl, and roofs.gpkg: the same buildings in the
// same order, on the same steps. The files are complete after finish(). Throws Error.
class RoofFiles {
 public:
  RoofFiles(const std::filesystem::path& folder, const RoofFilesParams& params, const Crs& crs);
  // Adds one building with its levels of detail, see CityJsonWriter.
  void add(std::span<const Building> levels);
  void finish();

 private:
  std::uint64_t largest_object_;
  CityJsonWriter sequence_;
  std::unique_ptr<CityJsonWriter> object_;
  RoofsObj obj_;
  RoofsGpkg gpkg_;
};

}  // namespace ilot
