// SPDX-License-Identifier: Apache-2.0
// Measures how often planes end at the borders of the cells in which they were searched, compared with other places.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "kernels/core/types.h"

namespace ilot {

// The cells of a run, as run.json states them: cubes of `edge` steps of `unit` (CRS units), aligned with the origin of
// the coordinates. A cell that has more than `points` points was cut into eight.
struct SeamCells {
  double unit = 0;
  std::int64_t edge = 0;
  std::uint64_t points = 0;
};

struct SeamParams {
  double stretch_m = 0.5;  // length of a stretch of a line
  double reach_m = 0.5;    // points farther from a line than this do not count for it
  double height_m = 0.1;   // a stretch counts where all points on both sides are so near each other in height
};

// Stretches on one smooth surface: all points on both sides are near each other in height. They are cut where the two
// points nearest to each other across the line have different planes. A neighbour without a plane counts as different.
struct CutCounts {
  std::uint64_t stretches = 0, cut = 0;
  std::optional<double> share() const;  // no value without stretches
};

// Pairs of neighbouring points that two runs over the same rows agree about: both say "the same plane", or both say
// "different planes".
struct PairCounts {
  std::uint64_t pairs = 0, equal = 0;
  std::uint64_t different = 0;        // pairs on different planes in the first run
  std::uint64_t different_other = 0;  // pairs on different planes in the other run
  std::optional<double> share() const;
};

struct Seams {
  SeamCells cells;
  CutCounts borders;    // along upright sides of the cells
  CutCounts elsewhere;  // along the same lines, shifted by 1/8 to 7/8 of the cell
  std::uint64_t points = 0, unlabelled = 0;
  std::uint32_t planes = 0;
  std::optional<PairCounts> pairs;  // only where another run is given
};

// The points of a result and their planes.
struct SeamPoints {
  std::vector<Index3> places;  // steps of the lattice
  std::vector<std::uint32_t> plane;
};

// Cuts lines into stretches and compares the nearest two points on the two sides of each. O(n log n).
Seams measure_seams(const SeamPoints& points, const SeamCells& cells, const SeamParams& params, double metres_per_unit);

// Compares each point with its `kPairNeighbours` nearest neighbours (within reach_m, and height_m in height) in two
// results over the same points. Unlabelled points are different from every other. O(n log n).
constexpr int kPairNeighbours = 4;
PairCounts compare_pairs(const SeamPoints& points, const std::vector<std::uint32_t>& other, double metres_per_step,
                         const SeamParams& params);

// Reads the labelled clouds and run.json of an output folder and measures them. With `other`, the output folder of a
// run over the same rows, for example of the cloud shifted by half of a cell, it also compares pairs. Throws Error
// where run.json does not state the cells.
Seams evaluate_seams(const std::filesystem::path& result, const std::optional<std::filesystem::path>& other,
                     const SeamParams& params = {});

std::string seams_text(const Seams& seams);
std::string seams_json(const Seams& seams);

}  // namespace ilot
