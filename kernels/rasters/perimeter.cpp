// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/perimeter.h"

#include "kernels/core/union_find.h"
#include "kernels/rasters/padded.h"
#include "kernels/rasters/radix_heap.h"

namespace ilot {
namespace {

constexpr std::uint32_t kDry = 0xffffffffu, kOutside = 0xfffffffeu;

class Flood {
 public:
  Flood(const Image& image, Adjacency adjacency)
      : frame_(image.width, image.height),
        perimeter_{image.width, image.height},
        neighbours_(step_count(adjacency)),
        steps_(frame_.steps()),
        level_(padded(image, kAboveAll)),
        basin_(
            padded<std::uint32_t>(image.width, image.height, std::vector<std::uint32_t>(image.size(), kDry), kOutside)),
        passed_(frame_.size(), 0),
        parents_(perimeter_.size()),
        trees_(parents_) {}

  std::vector<SpillEdge> run() {
    for (std::uint32_t i = 0; i < perimeter_.size(); ++i) {
      const auto [x, y] = perimeter_.place(i);
      const auto p = static_cast<std::uint32_t>(frame_.row(y) + x);
      basin_[p] = i;
      shores_.push(level_[p], p);
    }
    while (!shores_.empty()) {
      const RadixHeap::Item item = shores_.pop();
      under_water_.push_back(item.pixel);
      while (!under_water_.empty()) {
        const std::uint32_t p = under_water_.back();
        under_water_.pop_back();
        pass(p, item.height());
      }
    }
    return std::move(edges_);
  }

 private:
  // Levels of passed pixels never fall from one call to the next.
  void pass(std::uint32_t p, Height level) {
    passed_[p] = 1;
    for (std::size_t s = 0; s < neighbours_; ++s) {
      const std::uint32_t q = p + steps_[s];
      if (basin_[q] == kDry) {
        basin_[q] = basin_[p];
        if (level_[q] <= level) {
          under_water_.push_back(q);
        } else {
          shores_.push(level_[q], q);
        }
      } else if (basin_[q] != basin_[p] && passed_[q] != 0 && trees_.unite(basin_[p], basin_[q])) {
        edges_.push_back({basin_[p], basin_[q], level});
      }
    }
  }

  PaddedFrame frame_;
  Perimeter perimeter_;
  std::size_t neighbours_;
  std::array<std::uint32_t, 8> steps_;
  std::vector<Height> level_;
  std::vector<std::uint32_t> basin_;
  std::vector<std::uint8_t> passed_;
  std::vector<std::uint32_t> parents_;
  UnionFind trees_;
  RadixHeap shores_;
  std::vector<std::uint32_t> under_water_;
  std::vector<SpillEdge> edges_;
};

}  // namespace

std::vector<SpillEdge> spill_tree(const Image& image, Adjacency adjacency) {
  if (image.size() == 0) return {};
  return Flood(image, adjacency).run();
}

}  // namespace ilot
