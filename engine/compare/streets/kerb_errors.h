// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "engine/compare/streets/error_sizes.h"
#include "engine/compare/truth.h"
#include "engine/model/street.h"

namespace ilot {

// Places along the true kerbs, with the points of the ground that a cloud has on both sides of each.
class KerbSight {
 public:
  KerbSight(std::span<const TrueKerb> kerbs, double metres_per_unit);

  // Adds a point of the ground.
  void add(Vec3 p);

  struct Place {
    Vec3 at;              // CRS
    double length_m = 0;  // of the kerb that it stands for
    double along_x = 1, along_y = 0;
    double height_m = 0;                // of the step
    std::uint64_t left = 0, right = 0;  // points on both sides
    bool is_seen() const;
  };
  const std::vector<Place>& places() const { return places_; }

 private:
  std::pair<std::int64_t, std::int64_t> cell_of(double x, double y) const;

  double metres_;
  std::vector<Place> places_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::size_t>> grid_;
};

struct KerbResult {
  double true_m = 0;           // metres of true kerb that are judged
  double unseen_m = 0;         // metres that are lower than 3 cm, or without points of the ground on a side: not judged
  double found_m = 0;          // metres of found kerb that was seen
  double complete = 0;         // share of true_m with a found kerb within half a metre
  double correct = 0;          // share of found_m with a true kerb (of any height) within half a metre
  double bridged_m = 0;        // metres of found kerb that was not seen
  double bridged_correct = 0;  // share of them, likewise
  ErrorSizes plan, height, elevation;  // of found places that were seen near judged ones, each 25 cm
};

// Judges kerbs at places each 25 cm of the lines.
KerbResult evaluate_kerbs(const KerbSight& sight, std::span<const TrueKerb> truth, std::span<const StreetKerb> found,
                          double metres_per_unit);

}  // namespace ilot
