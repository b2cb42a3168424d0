// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/columns.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace ilot {
namespace {

constexpr std::int64_t kTouching = 2;  // pixels: the sampling step

// Connected pixels, and the bins in which any of them has a point.
struct Group {
  std::vector<std::size_t> pixels;
  Occupancy bins = 0;
  std::int64_t x0 = INT64_MAX, y0 = INT64_MAX, x1 = 0, y1 = 0;

  std::int64_t side() const { return std::max(x1 - x0, y1 - y0); }
};

class Columns {
 public:
  Columns(const std::vector<Occupancy>& occupancy, std::uint32_t width, std::uint32_t height, const RasterScale& scale,
          const ColumnParams& params)
      : occupancy_(occupancy),
        widest_(scale.pixels(params.widest)),
        least_(static_cast<std::uint32_t>(params.least_run / scale.bin() + 0.5)),
        free_(free_bins(occupancy, width, height, {widest_, widest_ + std::max(1u, scale.pixels(params.apart))})),
        seen_(occupancy.size(), 0),
        out_{width, height, 0, std::vector<std::uint32_t>(occupancy.size(), 0)} {}

  PixelLabels find() {
    for (std::size_t i = 0; i < free_.size(); ++i) {
      if (free_[i] == 0 || seen_[i] != 0) continue;
      const Group core = group_from({i}, free_, ~Occupancy{0}, out_.of.size());
      for (const std::size_t p : core.pixels) seen_[p] = 1;
      const BinRun run = longest_run(core.bins);
      if (run.length < least_) continue;
      std::vector<std::size_t> first;
      for (const std::size_t p : core.pixels)
        if ((free_[p] & run.bins()) != 0) first.push_back(p);
      const Group whole = group_from(first, occupancy_, run.bins(), widest_);
      if (whole.side() > widest_) continue;
      ++out_.count;
      for (const std::size_t p : whole.pixels) out_.of[p] = out_.count;
    }
    return std::move(out_);
  }

 private:
  // The pixels connected to the pixels of `first` in the wanted bins. The search stops once the group is longer than
  // `most`.
  Group group_from(const std::vector<std::size_t>& first, const std::vector<Occupancy>& bins, Occupancy wanted,
                   std::size_t most) const {
    Group group;
    std::set<std::size_t> taken(first.begin(), first.end());
    group.pixels = first;
    const auto w = std::int64_t{out_.width}, h = std::int64_t{out_.height};
    for (std::size_t next = 0; next < group.pixels.size() && group.side() <= static_cast<std::int64_t>(most); ++next) {
      const std::size_t p = group.pixels[next];
      const auto x = static_cast<std::int64_t>(p) % w, y = static_cast<std::int64_t>(p) / w;
      group.bins |= bins[p] & wanted;
      group.x0 = std::min(group.x0, x), group.x1 = std::max(group.x1, x);
      group.y0 = std::min(group.y0, y), group.y1 = std::max(group.y1, y);
      for (std::int64_t v = std::max<std::int64_t>(0, y - kTouching); v <= std::min(h - 1, y + kTouching); ++v)
        for (std::int64_t u = std::max<std::int64_t>(0, x - kTouching); u <= std::min(w - 1, x + kTouching); ++u) {
          const auto q = static_cast<std::size_t>(v * w + u);
          if ((bins[q] & bins[p] & wanted) != 0 && taken.insert(q).second) group.pixels.push_back(q);
        }
    }
    return group;
  }

  const std::vector<Occupancy>& occupancy_;
  std::uint32_t widest_, least_;
  std::vector<Occupancy> free_;
  std::vector<std::uint8_t> seen_;
  PixelLabels out_;
};

}  // namespace

PixelLabels columns_of(const std::vector<Occupancy>& occupancy, std::uint32_t width, std::uint32_t height,
                       const RasterScale& scale, const ColumnParams& params) {
  return Columns(occupancy, width, height, scale, params).find();
}

std::vector<ColumnCut> cut_columns(const PixelLabels& columns, std::uint32_t least, PixelLabels& parts) {
  std::vector<ColumnCut> cuts;
  if (columns.count == 0) return cuts;
  std::vector<std::uint32_t> left(std::size_t{parts.count} + 1, 0);
  std::vector<std::map<std::uint32_t, std::uint32_t>> held(std::size_t{columns.count} + 1);  // pixels, by part
  for (std::size_t i = 0; i < parts.of.size(); ++i) {
    ++left[parts.of[i]];
    if (columns.of[i] != 0 && parts.of[i] != 0) ++held[columns.of[i]][parts.of[i]];
  }
  std::vector<std::uint32_t> becomes(held.size(), 0);
  for (std::size_t c = 1; c < held.size(); ++c) {
    const auto most = std::max_element(held[c].begin(), held[c].end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most == held[c].end() || left[most->first] - most->second < least) continue;
    becomes[c] = ++parts.count;
    cuts.push_back({most->first, becomes[c]});
    for (auto& [part, pixels] : held[c]) {
      if (left[part] - pixels < least) pixels = 0;  // stays with its part
      left[part] -= pixels;
    }
  }
  for (std::size_t i = 0; i < parts.of.size(); ++i) {
    const std::uint32_t c = columns.of[i];
    if (c != 0 && parts.of[i] != 0 && becomes[c] != 0 && held[c].at(parts.of[i]) != 0) parts.of[i] = becomes[c];
  }
  return cuts;
}

}  // namespace ilot
