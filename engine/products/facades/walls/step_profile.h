// SPDX-License-Identifier: Apache-2.0
// Finds where a wall steps back or forth along the street: houses of a row are planes that differ by some centimetres,
// often less than what the planes of a run tell apart.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/facades/facade_site.h"

namespace ilot {

// A plane over the wall: w = at + along * (u - u0) + up * (v - v0), in metres, about the place (u0, v0).
struct LocalPlane {
  double u0 = 0, v0 = 0, at = 0, along = 0, up = 0;
  double error = 0;  // one standard deviation of `at`; infinite where there are too few points
  double w(double u, double v) const { return at + along * (u - u0) + up * (v - v0); }
};

// A part of a wall between two steps or gaps, with the plane of its points and the planes of its ends.
struct WallStretch {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;  // metres: the box of its points
  std::uint64_t points = 0;
  double rms = 0;  // metres, from its plane
  LocalPlane plane, left, right;
  bool left_step = false, right_step = false;  // whether it ends at a step
  double share = 1;                            // of the points of all planes in its box
};

struct StepParams {
  // Half of the least set-back that is told apart, 2 cm.
  double least_step = 0.01;  // metres; a step and its error are beyond it
  double least_width = 2;    // metres on both sides of a step
  double least_height = 2;   // metres of the height along which both sides are seen
  double gap = 3;            // metres without a point that part a wall
};

// Sums points of one wall by cells of its width and height. Memory: 24 bytes a cell, 2^20 cells at most.
class StepProfile {
 public:
  // The wall covers u from 0 to `width` and v from 0 to `height`; `points` is about the number to come.
  StepProfile(double width, double height, std::uint64_t points);
  void add(const FacadePoint& p);
  // The memory of a profile.
  static std::uint64_t bytes(double width, double height, std::uint64_t points);
  // The places along the wall where it steps back or forth, from left to right. O(cells).
  std::vector<double> steps(const StepParams& params) const;
  // The stretches of the wall between steps and gaps, from left to right. `all` are the points of all planes near it.
  std::vector<WallStretch> stretches(const StepParams& params, std::span<const double> steps,
                                     const StepProfile& all) const;

 private:
  struct Cell {
    double count = 0, sum = 0, squares = 0;
  };
  struct Step {
    double at = 0, size = 0;
  };
  const Cell& cell(std::int64_t c, std::int64_t r) const { return cells_[static_cast<std::size_t>(c * rows_ + r)]; }
  Place2 middle(std::int64_t c, std::int64_t r) const;
  bool empty_column(std::int64_t c) const;
  double points_in(std::int64_t c0, std::int64_t c1, double v0, double v1) const;
  LocalPlane fit(std::int64_t c0, std::int64_t c1) const;
  double step_at(std::int64_t c, std::int64_t from, std::int64_t to, const StepParams& params) const;
  double far_step(std::int64_t c, std::int64_t from, std::int64_t to, const StepParams& params) const;
  bool persists(std::int64_t c, std::int64_t from, std::int64_t to, double step, const StepParams& params) const;
  std::int64_t sharpened(std::int64_t c, std::int64_t from, std::int64_t to) const;
  void split(std::int64_t from, std::int64_t to, const StepParams& params, std::vector<std::int64_t>& borders) const;
  WallStretch stretch(std::int64_t from, std::int64_t to) const;

  struct Sizes {
    double cell = 0;
    std::int64_t columns = 0, rows = 0;
  };
  static Sizes sizes(double width, double height, std::uint64_t points);

  double cell_ = 0.05, row_ = 1;
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<Cell> cells_;
  std::vector<std::array<float, 4>> extent_;  // per column: the ends of its points along u and v
};

}  // namespace ilot
