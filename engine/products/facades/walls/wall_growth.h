// SPDX-License-Identifier: Apache-2.0
// How far a wall goes on beyond the planes that were found of it, where its points are sparse.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/facades/rays/ray_samples.h"
#include "engine/products/facades/walls/wall_groups.h"

namespace ilot {

// The room beside a wall and above it in which it may go on, in metres.
struct GrowthRoom {
  double left = 0, right = 0, top = 0;
};

// The room of each wall: at most `reach` metres, and no farther than to where another wall along it begins. Each wall
// looks only at those around it.
std::vector<GrowthRoom> growth_rooms(std::span<const WallGroup> walls, double reach, const WallParams& params);

// Counts the points near the plane of a wall by cells and by their distance from it. A strip of cells beyond an end of
// the wall continues it where most points are at one distance, more than chance explains, and spread over its length:
// those of a plant, of a wall across or of a roof are not. Walls bow and lean, so that the distance may change by half
// of epsilon each metre, and by ten centimetres in all. Memory: bytes().
class WallGrowth {
 public:
  // The wall covers u from 0 to `width` and v from 0 to `height`; its points are within `epsilon` of it.
  WallGrowth(double width, double height, const GrowthRoom& room, double epsilon);
  static std::uint64_t bytes(double width, double height, const GrowthRoom& room, double epsilon);
  // How far from the plane points are counted, in metres.
  static double depth(double epsilon);

  void add(const FacadePoint& p);
  // The parts beyond the wall: on the right, on the left, then above all of it. They are no longer than four metres
  // each, so that the density within one of them is even. O(cells).
  std::vector<SparsePart> parts() const;

 private:
  struct Span {
    std::int64_t first = 0, last = 0;  // both included
    std::int64_t count() const { return last - first + 1; }
  };
  // The strips that continue a wall at one end, outwards; between them are strips that do not.
  struct Strip {
    std::int64_t line = 0, level = 0;  // the first bin of its points
    double on = 0;
  };
  std::uint32_t at(std::int64_t c, std::int64_t r, std::int64_t bin) const {
    return bins_[static_cast<std::size_t>((r * columns_ + c) * levels_ + bin)];
  }
  bool continues(std::int64_t line, const Span& across, bool upright, Strip& strip) const;
  Strip strip_at(std::int64_t line, std::int64_t level, std::int64_t reach, const Span& across, bool upright) const;
  std::vector<Strip> grown(std::int64_t from, std::int64_t way, const Span& across, bool upright) const;
  void add_parts(double from, double to, const std::vector<Strip>& strips, const Span& across, bool upright,
                 const Box2& whole, std::vector<SparsePart>& parts) const;
  double distance(std::int64_t level) const;

  double width_, height_, epsilon_, left_;
  std::int64_t columns_ = 0, rows_ = 0, levels_ = 0;
  std::vector<std::uint32_t> bins_;              // of each cell
  std::vector<double> low_u_, high_u_, high_v_;  // of all points, by column and by row
};

// The box of a wall with its sparse parts, in its axes.
Box2 grown_box(const WallGroup& wall);

// Two walls that end apart may both have grown into the place between them: it belongs to the larger one. The walls are
// in the order of their area. Each wall looks only at those around it.
void share_growth(std::span<WallGroup> walls, double reach, const WallParams& params);

}  // namespace ilot
