// SPDX-License-Identifier: Apache-2.0
// The rays of a facade one after the other, however many they are: read from a column in pieces.
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

// What a ray came from and met.
struct Ray {
  FacadePoint at;
  SiteStation station = 0;  // index of the site's, kStationNotInFront - 1: none that is in front of the wall
  std::uint8_t part = 0;    // RaySamples::Part
  std::uint8_t unused = 0;  // written to disk
};

using RayColumn = ScratchColumn<Ray>;

// Consecutive rays of a column.
struct RayRun {
  std::uint64_t first = 0, count = 0;
};

// The rays of some runs in their order: a range to be gone through once at a time, which the column must outlive. 20 KB
// of memory.
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
    void next();  // piece; nowhere behind the last
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
  std::uint64_t count_ = 0, done_ = 0;  // of the run
  std::size_t run_ = 0;
  std::vector<Ray> buffer_;
};

// How late a ray is left out when there are too many: of each level half stay on for the next. By its coordinates
// alone, so that neither the order of the points nor the way they are read matters.
inline int rank_of(const Ray& ray) {
  const auto bits = [](float v) { return static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(v)); };
  return std::countr_zero(mix64(mix64(bits(ray.at.u) << 32 | bits(ray.at.v)) ^ bits(ray.at.w)));
}
inline bool is_kept(const Ray& ray, int level) {
  return level == 0 || rank_of(ray) >= level;
}

// Counts by rank, and the first level that keeps few enough.
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

// The level at which no more than `most` of the rays are kept that `counts` says yes to; 0, which keeps all, without
// reading them where they are no more.
template <class Counts>
int thinning_level(Rays& rays, std::uint64_t most, const Counts& counts) {
  if (rays.size() <= most) return 0;
  RankCounts ranks;
  for (const Ray& ray : rays)
    if (counts(ray)) ranks.add(ray);
  return ranks.level(most);
}

}  // namespace ilot
