// SPDX-License-Identifier: Apache-2.0
// What each measured ray tells of the wall: where it met it, went through it, or was stopped before it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <vector>

#include "engine/facades/facade_site.h"

namespace ilot {

// Closed, metres in the wall's axes.
struct Box2 {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  double width() const { return u1 - u0; }
  double height() const { return v1 - v0; }
  bool holds(Place2 p) const { return p.u >= u0 && p.u <= u1 && p.v >= v0 && p.v <= v1; }
  Box2 grown(double by) const { return {u0 - by, u1 + by, v0 - by, v1 + by}; }
};

enum class Met : std::uint8_t {
  solid,    // ends on the plane
  through,  // ends behind it: there is a hole
  before,   // ends in front of it: what is there is not known
};

// Points of a box of bins, row by row of bins, none of them copied: a forward range that its samples must outlive.
class NearPoints {
 public:
  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = std::uint32_t;
    using difference_type = std::ptrdiff_t;
    using pointer = const std::uint32_t*;
    using reference = const std::uint32_t&;

    Iterator() = default;
    explicit Iterator(const NearPoints& all) : all_(&all) { begin_row(); }
    reference operator*() const { return *at_; }
    Iterator& operator++() {
      if (++at_ == row_end_) {
        ++row_;
        begin_row();
      }
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    bool operator==(const Iterator& other) const { return at_ == other.at_; }

   private:
    // At the first point of the next row that has one; nowhere behind the last.
    void begin_row() {
      for (; row_ < all_->rows_; ++row_) {
        const std::uint32_t* bins = all_->first_ + row_ * all_->stride_;
        if (bins[0] == bins[all_->columns_]) continue;
        at_ = all_->order_ + bins[0];
        row_end_ = all_->order_ + bins[all_->columns_];
        return;
      }
      at_ = nullptr;
    }

    const NearPoints* all_ = nullptr;
    const std::uint32_t *at_ = nullptr, *row_end_ = nullptr;
    std::size_t row_ = 0;
  };

  // first: of each bin of the box's first row, and one more, where its points begin in `order`; rows of bins are
  // `stride` apart.
  NearPoints(const std::uint32_t* order, const std::uint32_t* first, std::size_t rows, std::size_t columns,
             std::size_t stride)
      : order_(order), first_(first), rows_(rows), columns_(columns), stride_(stride) {}

  Iterator begin() const { return Iterator(*this); }
  Iterator end() const { return {}; }

 private:
  const std::uint32_t *order_, *first_;
  std::size_t rows_, columns_, stride_;
};

// The rays of a facade's points, sorted by place. A point's ray comes from its own station where the site tells it, or
// from the one station there is; of several from the nearest whose ray does not go through the wall where it is seen to
// be solid. Without stations rays are taken to be square to the wall: an opening then is seen only as far as what lies
// behind it. 6 bytes a point.
class RaySamples {
 public:
  explicit RaySamples(const FacadeSite& site);

  const FacadeSite& site() const { return site_; }
  bool oblique() const { return !site_.stations.empty(); }
  // Whether some point's station was guessed among several.
  bool guessed() const { return guessed_; }

  // Where the point's ray crosses the plane w = depth.
  Place2 crossing(std::uint32_t point, double depth) const;
  // Where it was seen from; nothing where its ray is taken to be square to the wall.
  const Vec3* eye_of(std::uint32_t point) const;
  Met met(std::uint32_t point, double depth, double epsilon) const;
  // Within epsilon of the wall, or on a segment of it: real walls are not quite flat.
  bool on_wall(std::uint32_t point) const { return on_wall_[point] == kWall; }
  // On a segment along the wall and little behind it, as the backs of joints between stones are.
  bool in_joint(std::uint32_t point) const { return on_wall_[point] == kBack; }

  // Points whose rays cross the wall in the box, and more around it: in a fixed order.
  NearPoints near(const Box2& box) const;

  // Metres between neighbouring rays along u and along v at a place of the wall: of the station with the finest, else
  // as the wall's points lie in the mean.
  Place2 step_at(Place2 place) const;

 private:
  std::size_t bin_of(Place2 place) const;
  void find_wall();
  void choose_stations();
  void sort_into_bins();

  const FacadeSite& site_;
  enum Part : std::uint8_t { kNot, kWall, kBack };
  std::vector<SiteStation> station_;   // per point
  std::vector<std::uint8_t> on_wall_;  // per point
  bool guessed_ = false;
  std::int64_t columns_ = 0, rows_ = 0;
  double u0_ = 0, v0_ = 0;
  std::vector<std::uint32_t> first_, order_;
};

}  // namespace ilot
