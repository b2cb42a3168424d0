// SPDX-License-Identifier: Apache-2.0
// Reads the rays of a facade one after the other from a column, in pieces, whatever their number.
#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

#include "engine/products/facades/facade_site.h"
#include "engine/store/scratch_column.h"
#include "kernels/core/rng.h"

namespace ilot {

// The origin of a ray and what it met.
struct Ray {
  FacadePoint at;
  SiteStation station = 0;  // index in the site; kStationNotInFront - 1: none in front of the wall
  std::uint8_t part = 0;    // RaySamples::Part
  std::uint8_t unused = 0;  // padding that is written to disk
};

using RayColumn = ScratchColumn<Ray>;

// Consecutive rays of a column.
struct RayRun {
  std::uint64_t first = 0, count = 0;
};

// The rays of some runs, in their order. Only one loop at a time may go through the range. The column must outlive it.
// Needs 20 KB of memory.
class Rays {
 public:
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Ray;
    using difference_type = std::ptrdiff_t;
    using pointer = const Ray*;
    using reference = const Ray&;

    explicit Iterator(Rays* all = nullptr) : all_(all) {
      if (all_ != nullptr) next();
    }
    reference operator*() const { return *at_; }
    pointer operator->() const { return at_; }
    Iterator& operator++() {
      if (++at_ == end_) next();
      return *this;
    }
    void operator++(int) { ++*this; }
    bool operator==(const Iterator& other) const { return at_ == other.at_; }

   private:
    void next();  // reads the next piece; has no position after the last one
    Rays* all_ = nullptr;
    const Ray *at_ = nullptr, *end_ = nullptr;
  };

  Rays(const RayColumn& column, std::vector<RayRun> runs) : column_(&column), runs_(std::move(runs)) {
    for (const RayRun& run : runs_) count_ += run.count;
  }
  std::uint64_t size() const { return count_; }
  Iterator begin() {
    run_ = 0, done_ = 0;
    return Iterator(this);
  }
  Iterator end() const { return Iterator(); }

 private:
  const RayColumn* column_;
  std::vector<RayRun> runs_;
  std::uint64_t count_ = 0, done_ = 0;  // rays of the current run
  std::size_t run_ = 0;
  std::vector<Ray> buffer_;
};

// The level up to which a ray is kept when there are too many: each level keeps half of the rays of the level before.
// The rank depends only on the coordinates. Therefore neither the order of the points nor the way in which they are
// read changes it.
inline int rank_of(const Ray& ray) {
  const auto bits = [](float v) { return static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(v)); };
  return std::countr_zero(mix64(mix64(bits(ray.at.u) << 32 | bits(ray.at.v)) ^ bits(ray.at.w)));
}
inline bool is_kept(const Ray& ray, int level) {
  return level == 0 || rank_of(ray) >= level;
}

// Counts rays by rank and gives the first level that keeps few enough of them.
class RankCounts {
 public:
  void add(const Ray& ray) { ++counts_[static_cast<std::size_t>(rank_of(ray))]; }
  int level(std::uint64_t most) const {
    std::uint64_t kept = 0;
    for (std::size_t rank = counts_.size(); rank-- > 0;)
      if ((kept += counts_[rank]) > most) return static_cast<int>(rank) + 1;
    return 0;
  }

 private:
  std::array<std::uint64_t, 65> counts_{};
};

// The level at which at most `most` of the rays for which `counts` is true are kept. If there are no more rays than
// that, it is 0, which keeps all of them, and the rays are not read.
template <class Counts>
int thinning_level(Rays& rays, std::uint64_t most, const Counts& counts) {
  if (rays.size() <= most) return 0;
  RankCounts ranks;
  for (const Ray& ray : rays)
    if (counts(ray)) ranks.add(ray);
  return ranks.level(most);
}

}  // namespace ilot
