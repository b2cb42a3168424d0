// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "engine/formats/file.h"
#include "scan/districts/district.h"

namespace ilot::scan {

// Writes NAME.truth.json while the scan runs. There is one plane per line, so memory does not grow with the number of
// planes. Each plane has its id as in true_plane, its class, its equation a x + b y + c z + d = 0 in world coordinates,
// the number of points that carry the id, and its polygons with the buildings that they belong to. The file appears
// under its name at finish(), or not at all.
class TruthJson {
 public:
  // `settings` is the body of a JSON object that describes how the scan was made.
  TruthJson(const std::filesystem::path& path, const std::string& settings);

  // Adds the planes of one cell. Their ids start at first_plane, and the ids of the buildings start at first_building.
  // `points` has one count for each plane of the cell.
  void add_cell(const Cell& cell, std::uint32_t first_plane, std::uint32_t first_building,
                std::span<const std::uint64_t> points);
  void add_ground(const Ground& ground, const Rect& area, std::uint64_t points);
  void finish(std::uint64_t points, std::uint64_t buildings);

 private:
  void append(const std::string& text);

  OutputFile file_;
  bool first_ = true;
};

}  // namespace ilot::scan
