// SPDX-License-Identifier: Apache-2.0
#include "engine/streets/layer_split.h"

#include <algorithm>

namespace ilot {
namespace {

constexpr double kEvenSlope = 0.75;  // of its variance, what lies between its halves

using Pixels = std::vector<std::uint32_t>;

std::vector<Pixels> pixels_by_part(const PixelLabels& parts) {
  std::vector<Pixels> out(parts.count);
  for (std::size_t i = 0; i < parts.of.size(); ++i)
    if (parts.of[i] != 0) out[parts.of[i] - 1].push_back(static_cast<std::uint32_t>(i));
  return out;
}

// Where values of pixels fall into two classes: the least value of the upper one; kNoHeight where they are one class.
Height class_limit(std::vector<Height> values, std::uint32_t least) {
  if (values.size() < 2 * std::size_t{least}) return kNoHeight;
  std::sort(values.begin(), values.end());
  const auto n = static_cast<double>(values.size());
  double sum = 0, squares = 0;  // from the lowest on: whole numbers, exact
  for (const Height v : values) {
    const double above = v - values[0];
    sum += above, squares += above * above;
  }
  double below = 0, most = 0;
  Height best = kNoHeight;
  for (std::size_t i = 1; i < values.size(); ++i) {
    below += values[i - 1] - values[0];
    if (values[i] == values[i - 1] || i < least || values.size() - i < least) continue;
    const auto lower = static_cast<double>(i);
    const double apart = below / lower - (sum - below) / (n - lower), between = lower * (n - lower) * apart * apart;
    if (between > most) most = between, best = values[i];
  }
  return most > kEvenSlope * (squares * n - sum * sum) ? best : kNoHeight;
}

// Where each pixel of a part is low, its largest connected piece; the first of equally large ones.
class LargestPiece {
 public:
  explicit LargestPiece(const PixelLabels& parts) : width_(parts.width), open_(parts.of.size(), 0) {}

  Pixels of(const Pixels& pixels, const std::vector<Height>& values, Height limit) {
    for (std::size_t i = 0; i < pixels.size(); ++i) open_[pixels[i]] = values[i] < limit;
    Pixels largest;
    for (const std::uint32_t p : pixels)
      if (open_[p] != 0)
        if (Pixels piece = piece_from(p); piece.size() > largest.size()) largest.swap(piece);
    return largest;
  }

 private:
  Pixels piece_from(std::uint32_t start) {
    Pixels piece{start};
    open_[start] = 0;
    const std::int64_t w = width_, h = static_cast<std::int64_t>(open_.size()) / w;
    for (std::size_t next = 0; next < piece.size(); ++next) {
      const std::int64_t x = piece[next] % w, y = piece[next] / w;
      for (std::int64_t v = std::max<std::int64_t>(0, y - 1); v <= std::min(h - 1, y + 1); ++v)
        for (std::int64_t u = std::max<std::int64_t>(0, x - 1); u <= std::min(w - 1, x + 1); ++u) {
          const auto q = static_cast<std::size_t>(v * w + u);
          if (open_[q] == 0) continue;
          open_[q] = 0;
          piece.push_back(static_cast<std::uint32_t>(q));
        }
    }
    return piece;
  }

  std::uint32_t width_;
  std::vector<std::uint8_t> open_;
};

// The lower layer of a part; nothing where it is one.
Pixels lower_of(const Pixels& pixels, const Image& heights, std::uint32_t least, LargestPiece& largest) {
  std::vector<Height> values;
  for (const std::uint32_t p : pixels) values.push_back(heights.values[p]);
  const Height limit = class_limit(values, least);
  if (limit == kNoHeight) return {};
  Pixels lower = largest.of(pixels, values, limit);
  return lower.size() >= least ? lower : Pixels{};
}

}  // namespace

SplitLayers split_layers(const PixelLabels& parts, const Image& heights, std::uint32_t least) {
  SplitLayers out{{parts.width, parts.height, 0, std::vector<std::uint32_t>(parts.of.size(), 0)}, {}};
  LargestPiece largest(parts);
  for (const Pixels& pixels : pixels_by_part(parts)) {
    const std::uint32_t upper = ++out.labels.count;
    for (const std::uint32_t p : pixels) out.labels.of[p] = upper;
    const Pixels lower = lower_of(pixels, heights, std::max(1u, least), largest);
    if (lower.empty()) continue;
    ++out.labels.count;
    for (const std::uint32_t p : lower) out.labels.of[p] = out.labels.count;
    out.layers.emplace_back(upper, out.labels.count);
  }
  return out;
}

}  // namespace ilot
