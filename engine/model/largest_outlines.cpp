// SPDX-License-Identifier: Apache-2.0
#include "engine/model/largest_outlines.h"

#include <algorithm>
#include <numeric>

namespace ilot {
namespace {

std::size_t corners_of(const Outline& outline) {
  std::size_t corners = 0;
  for (const Outline::Part& part : outline.parts)
    for (const Outline::Ring& ring : part) corners += ring.size();
  return corners;
}

}  // namespace

void LargestOutlines::add(const Outline& outline, double area) {
  const std::size_t corners = corners_of(outline);
  if (most_corners_ == 0 || corners == 0) return;
  outlines_.push_back(outline);
  areas_.push_back(area);
  corners_ += corners;
  if (corners_ > most_corners_) drop_smallest();
}

void LargestOutlines::drop_smallest() {
  std::vector<std::size_t> order(outlines_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return areas_[a] > areas_[b]; });
  std::vector<Outline> kept;
  std::vector<double> areas;
  corners_ = 0;
  for (const std::size_t i : order) {
    const std::size_t corners = corners_of(outlines_[i]);
    if (corners_ + corners > most_corners_ / 2) break;
    corners_ += corners;
    kept.push_back(std::move(outlines_[i]));
    areas.push_back(areas_[i]);
  }
  dropped_ += outlines_.size() - kept.size();
  outlines_ = std::move(kept);
  areas_ = std::move(areas);
}

}  // namespace ilot
