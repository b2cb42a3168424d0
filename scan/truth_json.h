// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "engine/formats/file.h"
#include "scan/districts/district.h"

namespace ilot::scan {

// Writes NAME.truth.json as the scan goes: one plane per line, so that any number needs no memory. Each has
// its id as in true_plane, class, equation a x + b y + c z + d = 0 in world coordinates, the number of points
// that carry it, and its polygons with the buildings they belong to. Appears under its name at finish() or
// not at all.
class TruthJson {
 public:
  // `settings` is the body of a JSON object that tells how the scan was made.
  TruthJson(const std::filesystem::path& path, const std::string& settings);

  // The planes of one cell: ids from first_plane on, buildings from first_building on; points per plane of
  // the cell.
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
