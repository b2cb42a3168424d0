// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/profile.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

#include "kernels/core/quantile.h"
#include "kernels/morphology/h_maxima.h"
#include "kernels/morphology/watershed.h"

namespace ilot {
namespace {

// Calls take(step, height) for the pixels near the line that have a height. step counts from the point of the line that
// is nearest to the first pixel of the image.
template <typename Take>
void for_steps(const Image& image, const ImageLine& line, double half_width, const Take& take) {
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const Height v = image.values[std::size_t{y} * image.width + x];
      const double across = line.nx * x + line.ny * y + line.d;
      if (v != kNoHeight && std::abs(across) <= half_width)
        take(static_cast<std::int64_t>(std::floor(line.ny * x - line.nx * y + 0.5)), v);
    }
  }
}

Height highest(const std::vector<Height>& profile, std::size_t from, std::size_t to) {
  return *std::max_element(profile.begin() + static_cast<std::ptrdiff_t>(from),
                           profile.begin() + static_cast<std::ptrdiff_t>(to));
}

// Returns the cut between the blocks [before, at) and [at, after).
ProfileCut cut_at(const std::vector<Height>& profile, std::size_t before, std::size_t at, std::size_t after) {
  const Height top = std::min(highest(profile, before, at), highest(profile, at, after));
  ProfileCut cut{static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at),
                 std::min(profile[at - 1], profile[at]), kAboveAll};
  if (cut.floor != kNoHeight) cut.depth = top - cut.floor;
  const Height half = cut.floor == kNoHeight ? kNoHeight : cut.floor + cut.depth / 2;
  while (cut.from > before && profile[cut.from - 1] <= half) --cut.from;
  while (cut.to + 1 < after && profile[cut.to + 1] <= half) ++cut.to;
  return cut;
}

}  // namespace

LineProfile profile_along(const Image& image, const ImageLine& line, double half_width) {
  std::int64_t first = INT64_MAX, last = INT64_MIN;
  for_steps(image, line, half_width, [&](std::int64_t step, Height) {
    first = std::min(first, step);
    last = std::max(last, step);
  });
  LineProfile profile{0, 0, line.ny, -line.nx, {}};
  if (first > last) return profile;
  const auto along = static_cast<double>(first);
  profile.x = -line.d * line.nx + along * profile.dx;
  profile.y = -line.d * line.ny + along * profile.dy;
  profile.heights.assign(static_cast<std::size_t>(last - first + 1), kNoHeight);
  for_steps(image, line, half_width, [&](std::int64_t step, Height v) {
    Height& entry = profile.heights[static_cast<std::size_t>(step - first)];
    entry = std::max(entry, v);
  });
  return profile;
}

std::vector<Height> running_median(const std::vector<Height>& profile, std::uint32_t half_window) {
  std::vector<Height> out(profile.size()), window;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const std::size_t from = i - std::min<std::size_t>(i, half_window);
    const std::size_t to = std::min(profile.size(), i + half_window + 1);
    window.assign(profile.begin() + static_cast<std::ptrdiff_t>(from),
                  profile.begin() + static_cast<std::ptrdiff_t>(to));
    out[i] = nth_smallest(window, (window.size() - 1) / 2);
  }
  return out;
}

std::vector<ProfileCut> profile_cuts(const std::vector<Height>& profile, Height depth) {
  const auto n = static_cast<std::uint32_t>(profile.size());
  const Image image{n, n > 0 ? 1u : 0u, profile};
  const PixelLabels tops = regional_maxima(h_maxima(image, depth, Adjacency::four), Adjacency::four);
  Image relief = image;
  for (Height& v : relief.values) v = ~v;
  const PixelLabels blocks = watershed(relief, tops, Adjacency::four);
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < blocks.of.size(); ++i)
    if (i == 0 || blocks.of[i] != blocks.of[i - 1]) starts.push_back(i);
  starts.push_back(n);
  std::vector<ProfileCut> cuts;
  for (std::size_t b = 1; b + 1 < starts.size(); ++b)
    cuts.push_back(cut_at(profile, starts[b - 1], starts[b], starts[b + 1]));
  return cuts;
}

}  // namespace ilot
