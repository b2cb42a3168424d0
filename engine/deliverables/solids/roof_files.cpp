// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/roof_files.h"

namespace ilot {

RoofFiles::RoofFiles(const std::filesystem::path& folder, const RoofFilesParams& params, const Crs& crs)
    : largest_object_(params.largest_object),
      sequence_(folder / "roofs.city.jsonl", params.city_json),
      object_(std::make_unique<CityJsonWriter>(folder / "roofs.city.json", params.city_json)),
      obj_(folder / "roofs.obj", {params.city_json.origin, params.city_json.step}),
      gpkg_(folder / "roofs.gpkg", crs, params.city_json.style, params.city_json.metres_per_unit, params.further) {}

void RoofFiles::add(std::span<const Building> levels) {
  sequence_.add(levels);
  if (object_) object_->add(levels);
  if (object_ && object_->bytes() > largest_object_) object_.reset();
  obj_.add(levels);
  gpkg_.add(levels);
}

void RoofFiles::finish() {
  sequence_.finish();
  if (object_) object_->finish();
  obj_.finish();
  gpkg_.finish();
}

}  // namespace ilot
