// SPDX-License-Identifier: Apache-2.0
// What the record of a point says of an echo, and how the points of true planes, elements and classes are counted.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scan/scanners/beam.h"
#include "scan/scanners/scan_record.h"

namespace ilot::scan {

// The value of true_class of points between two surfaces. They have no plane and no element.
constexpr std::uint8_t kMixedClass = 0;

// Returns intensity, returns, material, colour and truth of the echo `number` (from 0) of a pulse along `ray`. A white,
// perpendicular surface at the distance `full_range` in metres fills the scale of intensities. A point whose range is
// mixed by more than `unmixed` metres is of class kMixedClass.
ColouredPoint echo_point(const std::vector<Echo>& echoes, std::size_t number, const SurfaceLabel& label, const Ray& ray,
                         double full_range, double unmixed);

// Counts points per plane, element and class, by id.
struct PointTally {
  std::vector<std::uint64_t> planes, elements, classes = std::vector<std::uint64_t>(256);
  std::uint64_t points = 0;

  void add(const RecordTruth& truth);
  void add(std::span<const std::byte> records, const RecordLayout& layout);
  static void count(std::vector<std::uint64_t>& list, std::uint32_t id, std::uint64_t by = 1);
  static std::uint64_t of(const std::vector<std::uint64_t>& list, std::uint32_t id) {
    return id < list.size() ? list[id] : 0;
  }
};

}  // namespace ilot::scan
