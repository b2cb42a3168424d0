// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/part_joins.h"

#include <algorithm>
#include <map>
#include <utility>

namespace ilot {
namespace {

struct Side {
  Height top = kNoHeight;
  double pixels = 0;
  std::map<std::uint32_t, Height> passes;  // passes to its neighbours; below 0: minus the gap in pixels
};
using Sides = std::map<std::uint32_t, Side>;

double ratio_of(Height pass, const Side& a, const Side& b) {
  return static_cast<double>(pass) / std::min(a.top, b.top);
}

// Adds pairs of parts with ground between them. The search starts from every pixel on the edge of a part.
void add_gaps(const PixelLabels& labels, std::int64_t reach, Sides& sides) {
  const auto w = std::int64_t{labels.width}, h = std::int64_t{labels.height};
  if (labels.count < 2) return;
  for (std::int64_t y = 1; y + 1 < h; ++y)
    for (std::int64_t x = 1; x + 1 < w; ++x) {
      const auto i = static_cast<std::size_t>(y * w + x);
      const std::uint32_t a = labels.of[i];
      const auto row = static_cast<std::size_t>(w);
      if (a == 0 ||
          (labels.of[i - 1] != 0 && labels.of[i + 1] != 0 && labels.of[i - row] != 0 && labels.of[i + row] != 0))
        continue;
      for (std::int64_t v = std::max<std::int64_t>(0, y - reach - 1); v <= std::min(h - 1, y + reach + 1); ++v)
        for (std::int64_t u = std::max<std::int64_t>(0, x - reach - 1); u <= std::min(w - 1, x + reach + 1); ++u) {
          const std::uint32_t b = labels.of[static_cast<std::size_t>(v * w + u)];
          if (b == 0 || b == a) continue;
          const auto gap = static_cast<Height>(-std::max(std::abs(u - x), std::abs(v - y)));
          for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
            Height& known = sides[from].passes.try_emplace(to, gap).first->second;
            known = std::max(known, gap);
          }
        }
    }
}

// Collects the parts and the passes where they touch.
Sides sides_of(const PixelLabels& labels, const Image& heights) {
  Sides sides;
  const std::size_t w = labels.width;
  for (std::size_t i = 0; i < labels.of.size(); ++i) {
    const std::uint32_t a = labels.of[i];
    if (a == 0) continue;
    Side& side = sides[a];
    side.top = std::max(side.top, heights.values[i]);
    ++side.pixels;
    for (const std::size_t q : {i + 1, i + w - 1, i + w, i + w + 1}) {
      const std::uint32_t b = labels.of[q];
      if (b == 0 || b == a) continue;
      const Height pass = std::min(heights.values[i], heights.values[q]);
      for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
        Height& known = sides[from].passes.try_emplace(to, pass).first->second;
        known = std::max(known, pass);
      }
    }
  }
  return sides;
}

double highest_pass(const Sides& sides, const Side& side) {
  double highest = 0;
  for (const auto& [b, pass] : side.passes) highest = std::max(highest, ratio_of(pass, side, sides.at(b)));
  return highest;
}

// The pair whose pass is highest relative to the lower top, among pairs with together no more than `largest` pixels. If
// there is none, a = 0.
Join best_join(const Sides& sides, double largest) {
  Join best;
  double highest = -1;
  for (const auto& [a, side] : sides)
    for (const auto& [b, pass] : side.passes) {
      if (b < a || side.pixels + sides.at(b).pixels > largest) continue;
      const double ratio = ratio_of(pass, side, sides.at(b));
      if (ratio > highest) highest = ratio, best = {a, b, ratio};
    }
  return best;
}

// The join of a column with the rest of the part from which it was cut. The pass is 0 where the two do not touch.
Join cut_join(const Sides& sides, std::uint32_t rest, std::uint32_t column) {
  const Side& side = sides.at(rest);
  const auto pass = side.passes.find(column);
  return {rest, column, pass == side.passes.end() ? 0 : ratio_of(pass->second, side, sides.at(column))};
}

// Replaces the two candidates of a join by their union, which has `number` from now on.
const Side& join(const Join& pair, std::uint32_t number, Sides& sides) {
  Side whole = sides.at(pair.a);
  const Side& other = sides.at(pair.b);
  whole.top = std::max(whole.top, other.top);
  whole.pixels += other.pixels;
  for (const auto& [c, pass] : other.passes) {
    Height& known = whole.passes.try_emplace(c, pass).first->second;
    known = std::max(known, pass);
  }
  whole.passes.erase(pair.a), whole.passes.erase(pair.b);
  sides.erase(pair.a), sides.erase(pair.b);
  for (const auto& [c, pass] : whole.passes) {
    Side& beside = sides.at(c);
    beside.passes.erase(pair.a), beside.passes.erase(pair.b);
    beside.passes[number] = pass;
  }
  return sides[number] = std::move(whole);
}

}  // namespace

Joins joins_of(const PixelLabels& labels, const Image& heights, std::uint32_t reach, double largest,
               std::span<const ColumnCut> cuts) {
  Sides sides = sides_of(labels, heights);
  add_gaps(labels, reach, sides);
  Joins joins{{}, std::vector<double>(std::size_t{labels.count} + 1, 0)};
  for (const auto& [a, side] : sides) joins.outer[a] = highest_pass(sides, side);
  std::uint32_t next = labels.count;
  const auto add = [&](const Join& pair) {
    joins.list.push_back(pair);
    joins.outer.push_back(highest_pass(sides, join(pair, ++next, sides)));
  };
  std::map<std::uint32_t, std::uint32_t> together;  // the current join of a part and its columns
  for (const ColumnCut& cut : cuts) {
    const std::uint32_t rest = together.try_emplace(cut.rest, cut.rest).first->second;
    add(cut_join(sides, rest, together.try_emplace(cut.column, cut.column).first->second));
    together[cut.rest] = next;
  }
  for (Join best = best_join(sides, largest); best.a != 0; best = best_join(sides, largest)) add(best);
  return joins;
}

}  // namespace ilot
