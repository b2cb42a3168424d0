// SPDX-License-Identifier: Apache-2.0
// roofs.obj: one group for each building, with materials roof, wall and ground, which roofs.mtl beside it describes.
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>

#include "engine/formats/file.h"
#include "engine/model/building.h"

namespace ilot {

struct RoofsObjParams {
  Vec3 origin;           // coordinates are whole steps from this place, written in full
  double step = 0.0001;  // CRS units
};

// Buildings are written in the order in which they are added, each at the last of its levels that is a solid. A
// building without a solid is left out. Faces are polygons; faces with holes, which OBJ does not support, are written
// as triangles. Within a building, vertices on the same step become one. The file appears under its name at finish() or
// not at all. Throws Error.
class RoofsObj {
 public:
  RoofsObj(const std::filesystem::path& path, const RoofsObjParams& params);
  void add(std::span<const Building> levels);
  void finish();

  std::uint64_t bytes() const { return file_.position(); }  // written so far

 private:
  OutputFile file_;
  RoofsObjParams params_;
  std::uint64_t vertices_ = 0;  // written so far
};

}  // namespace ilot
