// SPDX-License-Identifier: Apache-2.0
// Where the inputs are, roughly and at once: for decisions that must fall before they are read.
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
  Vec3 one;  // a place of the sample

  bool touches(const PlaceBox& other) const {
    return min_x <= other.max_x && other.min_x <= max_x && min_y <= other.max_y && other.min_y <= max_y;
  }
  // "x 84,871 to 85,063, y 447,388 to 447,616"
  std::string text() const;
};

// The box of up to 500 rows of each reader: at ten places of files that can be read anywhere, else at their beginning.
// nullopt: no row has usable coordinates. The least and largest hundredth of the rows of a file are left out where it
// gives a hundred, so that a stray does not decide.
std::optional<PlaceBox> sampled_box(const std::vector<std::unique_ptr<PointReader>>& readers);

// A sentence: all points were rejected, and if it is for the area, where the inputs are and whether x and y are
// exchanged.
std::string why_no_point(const std::optional<Area>& area, const std::vector<std::unique_ptr<PointReader>>& readers);

// The box and its own size around it: what a sample may have missed.
PlaceBox widened(const PlaceBox& box);

}  // namespace ilot
