// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/banded_region.h"

#include <algorithm>
#include <cmath>

namespace ilot {
namespace {

constexpr std::size_t kEdgesPerBand = 4;

}  // namespace

BandedRegion::BandedRegion(std::span<const FlatEdge> edges) {
  if (edges.empty()) return;
  double low = INFINITY, high = -INFINITY;
  for (const auto& [a, b] : edges) low = std::min({low, a.y, b.y}), high = std::max({high, a.y, b.y});
  const std::size_t bands = edges.size() / kEdgesPerBand + 1;
  low_ = low;
  bands_per_unit_ = high > low ? static_cast<double>(bands) / (high - low) : 0;
  first_.assign(bands + 1, 0);
  const auto for_each_band = [&](const FlatEdge& e, const auto& visit) {
    const std::size_t last = band_of(std::max(e.a.y, e.b.y));
    for (std::size_t band = band_of(std::min(e.a.y, e.b.y)); band <= last; ++band) visit(band);
  };
  for (const FlatEdge& e : edges) for_each_band(e, [&](std::size_t band) { ++first_[band + 1]; });
  for (std::size_t band = 0; band < bands; ++band) first_[band + 1] += first_[band];
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  edges_.resize(first_.back());
  const auto goes_on = [&](std::size_t i) {
    return i > 0 && edges[i].a.x == edges[i - 1].b.x && edges[i].a.y == edges[i - 1].b.y;
  };
  std::size_t places = edges.size();
  for (std::size_t i = 0; i < edges.size(); ++i) places += !goes_on(i);
  places_.reserve(places);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!goes_on(i)) places_.push_back(edges[i].a);
    places_.push_back(edges[i].b);
    const auto at = static_cast<std::uint32_t>(places_.size() - 2);
    for_each_band(edges[i], [&](std::size_t band) { edges_[next[band]++] = at; });
  }
}

std::size_t BandedRegion::band_of(double y) const {
  return static_cast<std::size_t>(
      std::clamp((y - low_) * bands_per_unit_, 0.0, static_cast<double>(first_.size() - 2)));
}

bool BandedRegion::contains(FlatPoint p) const {
  if (first_.empty()) return false;
  const std::size_t band = band_of(p.y);
  bool inside = false;
  for (std::uint32_t i = first_[band]; i < first_[band + 1]; ++i) {
    inside ^= ray_crosses(p, places_[edges_[i]], places_[edges_[i] + 1]);
  }
  return inside;
}

}  // namespace ilot
