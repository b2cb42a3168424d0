// SPDX-License-Identifier: Apache-2.0
// The approximate place of the inputs, found quickly, for decisions before they are read.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/cloud/area.h"
#include "engine/formats/reader.h"

namespace ilot {

struct PlaceBox {
  double min_x = 0, min_y = 0, max_x = 0, max_y = 0;
  Vec3 one;  // one place of the sample

  bool touches(const PlaceBox& other) const {
    return min_x <= other.max_x && other.min_x <= max_x && min_y <= other.max_y && other.min_y <= max_y;
  }
  // Returns for example "x 84,871 to 85,063, y 447,388 to 447,616".
  std::string text() const;
};

// Returns the box of up to 500 rows of each reader: at ten places of files with random access, else at their beginning.
// nullopt: no row has usable coordinates. When a file gives a hundred rows, the smallest and largest hundredth of them
// are left out, so that a stray does not determine the box.
std::optional<PlaceBox> sampled_box(const std::vector<std::unique_ptr<PointReader>>& readers);

// Returns a sentence that says that all points were rejected. If the area is the reason, it says where the inputs are
// and whether x and y are exchanged.
std::string why_no_point(const std::optional<Area>& area, const std::vector<std::unique_ptr<PointReader>>& readers);

// Returns the box with a margin of its own size, because a sample may have missed points.
PlaceBox widened(const PlaceBox& box);

}  // namespace ilot
