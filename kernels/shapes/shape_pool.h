// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "kernels/shapes/shape.h"

namespace ilot {

// Candidates of one kind, with the highest bound on top (ties: the earlier draw). A bound is exact when it was counted
// after points were last removed.
class ShapePool {
 public:
  struct Candidate {
    Shape shape;
    std::uint32_t bound = 0;
    std::uint64_t draw = 0;
    std::uint64_t counted = 0;  // epoch of the count; 0 = never
  };

  bool empty() const { return heap_.empty(); }
  const Candidate& top() const { return heap_.front(); }
  void push(Candidate c) {
    heap_.push_back(std::move(c));
    std::push_heap(heap_.begin(), heap_.end(), below);
  }
  Candidate pop() {
    std::pop_heap(heap_.begin(), heap_.end(), below);
    Candidate c = std::move(heap_.back());
    heap_.pop_back();
    return c;
  }
  // Drops candidates with a bound below `least`, and all but the best `most` once there are more than twice as many.
  void prune(std::uint32_t least, std::size_t most) {
    std::erase_if(heap_, [&](const Candidate& c) { return c.bound < least; });
    if (heap_.size() > 2 * most) {
      std::nth_element(heap_.begin(), heap_.begin() + static_cast<std::ptrdiff_t>(most), heap_.end(),
                       [](const Candidate& a, const Candidate& b) { return below(b, a); });
      heap_.resize(most);
    }
    std::make_heap(heap_.begin(), heap_.end(), below);
  }

  static bool below(const Candidate& a, const Candidate& b) {
    return a.bound != b.bound ? a.bound < b.bound : a.draw > b.draw;
  }

 private:
  std::vector<Candidate> heap_;
};

}  // namespace ilot
