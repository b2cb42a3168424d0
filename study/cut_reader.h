// SPDX-License-Identifier: Apache-2.0
// A cloud without some of its points: those high above the ground, as some scans are cut for privacy or to save space,
// those of the ground, which some scans come without, or all but a share of them. Or with points of the ground below
// its objects, as flight lines give that saw the place with and without a car.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/formats/reader.h"

namespace ilot {

// The plane a x + b y + c z + d = 0 in the units of the cloud.
struct CutPlane {
  double a = 0, b = 0, c = 1, d = 0;
};

// Returns a reader of the points of another reader. Points more than `height` above the plane are rejected.
std::unique_ptr<PointReader> cut_above(std::unique_ptr<PointReader> reader, const CutPlane& plane, double height);

// Returns a reader of one in `of` points of another reader, drawn at random by their number. The others are rejected.
std::unique_ptr<PointReader> thinned(std::unique_ptr<PointReader> reader, std::uint32_t of);

// Which points of a street are left out, or added.
struct Leaving {
  double cut = 0;              // metres above the road; higher points are left out; 0: none
  std::uint32_t one_in = 1;    // one point in so many is kept
  bool ground = false;         // points whose true class is the ground are left out
  std::uint32_t floor = 0;     // one point of objects in so many has one of the ground below it; 0: none
  std::string name() const;    // empty where the street is as it is
  std::string option() const;  // of a command, with a blank before it
};

// The options of commands: --cut H, --bare H (cut, and without the ground), --thin N, --floor N.
bool is_leaving(const std::string& word);
Leaving leaving_of(const std::string& word, const std::string& value);

// Returns the plane of the road: the ground with the most points in the truth beside a cloud. Throws where there is
// none.
CutPlane road_plane(const std::filesystem::path& cloud);

// Returns a reader of the points of another reader that are not of the ground, by the field `true_class`.
std::unique_ptr<PointReader> without_ground(std::unique_ptr<PointReader> reader);

// Opens a cloud with a truth beside it, without the points that are left out. A second reader has the points that are
// added, where there are any.
std::vector<std::unique_ptr<PointReader>> open_street(const std::filesystem::path& cloud, const Leaving& leaving);

}  // namespace ilot
