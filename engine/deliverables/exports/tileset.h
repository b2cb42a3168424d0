// SPDX-License-Identifier: Apache-2.0
// 3D Tiles 1.1 [OGC 22-025r4]: tileset.json, files of subtrees, and a GLB file for each tile.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "engine/deliverables/exports/tile_content.h"
#include "engine/deliverables/exports/tile_tree.h"

namespace ilot {

// A quadtree by implicit tiling: names of files follow from the squares, and subtrees say which there are. Boxes and
// errors of tiles are metadata of the subtrees: models reach beyond their square, and the error of a tile is the size
// of the largest model that only its children show. All models are held in memory until finish().
class Tileset {
 public:
  // `folder` is made. With a CRS the root stands on the earth; otherwise it has no transform and its extras say so.
  Tileset(const std::filesystem::path& folder, const ExportFrame& frame, double geoid_m);
  void add(const BuildingModel& building);  // one without a solid is left out
  void add(const StreetObject& object);
  void finish();

  bool on_earth() const { return placement_.on_earth(); }

 private:
  void add_model(TileModel model);
  nlohmann::ordered_json asset() const;
  nlohmann::ordered_json whole(const ModelTree& tree) const;  // tileset.json

  std::filesystem::path folder_;
  ExportFrame frame_;
  double geoid_m_ = 0;
  Placement placement_;
  std::vector<TileModel> models_;
  std::vector<TileItem> items_;
};

}  // namespace ilot
