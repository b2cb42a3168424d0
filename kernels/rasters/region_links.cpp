// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/region_links.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <span>

#include "kernels/core/union_find.h"
#include "kernels/rasters/nearest.h"
#include "kernels/rasters/padded.h"

namespace ilot {
namespace {

constexpr std::uint32_t kFar = 0xffffffffu;

// Two neighbours that are nearest to different regions; the ends of the link through them, the first one first.
struct Meeting {
  std::uint32_t length, end_a, end_b, p, q;  // p on the side of end_a
  auto order() const { return std::tie(length, end_a, end_b, p, q); }
};

// Distance in steps from side to side to the nearest pixel with a height, and which: 0 and itself where there is one.
struct Nearest {
  std::vector<std::uint32_t> distance, end;
};

// Ways go around what does not belong to the image. Waves: all of one distance are known before the next begins.
Nearest ends_by_waves(const PaddedFrame& frame, const std::vector<Height>& heights,
                      const std::vector<std::uint8_t>& inside, std::uint32_t reach) {
  Nearest nearest{std::vector<std::uint32_t>(frame.size(), kFar), std::vector<std::uint32_t>(frame.size(), kFar)};
  std::vector<std::uint32_t> wave, next;
  const auto steps = frame.steps();
  for (std::uint32_t p = 0; p < frame.size(); ++p) {
    if (heights[p] == kNoHeight) continue;
    nearest.distance[p] = 0;
    nearest.end[p] = p;
    bool open = false;
    for (std::size_t s = 0; s < step_count(Adjacency::four); ++s)
      open |= inside[p + steps[s]] != 0 && heights[p + steps[s]] == kNoHeight;
    if (open) wave.push_back(p);
  }
  for (std::uint32_t d = 1; d <= reach && !wave.empty(); ++d) {
    next.clear();
    for (const std::uint32_t p : wave) {
      for (std::size_t s = 0; s < step_count(Adjacency::four); ++s) {
        const std::uint32_t q = p + steps[s];
        if (inside[q] == 0 || nearest.distance[q] < d) continue;
        if (nearest.distance[q] == kFar) next.push_back(q);
        nearest.distance[q] = d;
        nearest.end[q] = std::min(nearest.end[q], nearest.end[p]);
      }
    }
    wave.swap(next);
  }
  return nearest;
}

Nearest nearest_ends(const PaddedFrame& frame, const std::vector<Height>& heights,
                     const std::vector<std::uint8_t>& inside, bool straight, std::uint32_t reach) {
  if (!straight) return ends_by_waves(frame, heights, inside, reach);
  NearestPixels nearest = nearest_pixels({frame.stride, frame.height + 2, heights}, reach);
  for (std::size_t p = 0; p < inside.size(); ++p)
    if (inside[p] == 0 || nearest.pixel[p] == kNoNearest) nearest.pixel[p] = nearest.distance[p] = kFar;
  return {std::move(nearest.distance), std::move(nearest.pixel)};
}

// Zones of a window, numbered anew from 0 as they are asked for.
class Regions {
 public:
  explicit Regions(const std::vector<std::uint32_t>& zones) : sorted_(zones) {
    std::sort(sorted_.begin(), sorted_.end());
    sorted_.erase(std::unique(sorted_.begin(), sorted_.end()), sorted_.end());
    parents_.resize(sorted_.size());
    sets_.emplace(parents_);
  }
  bool unite(std::uint32_t a, std::uint32_t b) { return sets_->unite(number(a), number(b)); }

 private:
  std::uint32_t number(std::uint32_t zone) const {
    return static_cast<std::uint32_t>(std::lower_bound(sorted_.begin(), sorted_.end(), zone) - sorted_.begin());
  }
  std::vector<std::uint32_t> sorted_, parents_;
  std::optional<UnionFind> sets_;
};

class Linking {
 public:
  Linking(const LinkWindow& window, const LinkRegionsParams& params)
      : window_(window),
        params_(params),
        frame_(window.heights.width, window.heights.height),
        steps_(frame_.steps()),
        heights_(padded(window.heights, kNoHeight)),
        nearest_(nearest_ends(frame_, heights_, padded<std::uint8_t>(frame_.width, frame_.height, window.inside, 0),
                              window.straight, (params.max_length + 1) / 2)) {}

  std::vector<RegionLink> run() const {
    std::vector<Meeting> list = meetings();
    std::vector<std::uint32_t> met;
    for (const Meeting& m : list) met.insert(met.end(), {zone_of(m.end_a), zone_of(m.end_b)});
    Regions regions(met);
    std::vector<RegionLink> links;
    for (const Meeting& m : list)
      if (regions.unite(zone_of(m.end_a), zone_of(m.end_b))) links.push_back(link(m));
    return links;
  }

 private:
  std::vector<Meeting> meetings() const {
    std::vector<Meeting> list;
    const std::uint32_t width = frame_.width - std::min(frame_.width, 2 * window_.halo);
    std::vector<std::uint8_t> differ(std::size_t{width} + 8);
    for (std::uint32_t y = window_.halo; y + window_.halo < frame_.height; ++y) {
      const auto first = static_cast<std::uint32_t>(frame_.row(y) + window_.halo);
      for (const std::uint32_t step : {1u, frame_.stride}) {
        find_differing(first, step, width, differ.data());
        for (std::uint32_t x = 0; x < width; x += 8) {
          std::uint64_t eight;
          std::memcpy(&eight, differ.data() + x, 8);
          for (std::uint32_t i = 0; eight != 0 && i < 8; ++i)
            if (differ[x + i] != 0) meet(first + x + i, first + x + i + step, list);
        }
      }
    }
    std::sort(list.begin(), list.end(), [](const Meeting& a, const Meeting& b) { return a.order() < b.order(); });
    return list;
  }

  // differ[x] = 1 where pixel first + x and the one a step on have different ends, not both themselves: neighbours with
  // heights are of one region, or too far apart in height for a link.
  void find_differing(std::uint32_t first, std::uint32_t step, std::uint32_t width,
                      std::uint8_t* __restrict differ) const {
    const std::uint32_t *a = nearest_.end.data() + first, *b = a + step;
    const std::uint32_t *da = nearest_.distance.data() + first, *db = da + step;
    for (std::uint32_t x = 0; x < width; ++x)
      differ[x] = static_cast<std::uint8_t>((a[x] != b[x]) & (a[x] != kFar) & (b[x] != kFar) & ((da[x] | db[x]) != 0));
  }

  void meet(std::uint32_t p, std::uint32_t q, std::vector<Meeting>& list) const {
    const std::uint32_t a = nearest_.end[p], b = nearest_.end[q];
    if (zone_of(a) == zone_of(b)) return;
    const std::uint32_t length = nearest_.distance[p] + nearest_.distance[q];
    if (length > params_.max_length || std::abs(heights_[a] - heights_[b]) > params_.step) return;
    list.push_back(a < b ? Meeting{length, a, b, p, q} : Meeting{length, b, a, q, p});
  }

  std::uint32_t zone_of(std::uint32_t p) const {
    return window_.zones[std::size_t{p / frame_.stride - 1} * frame_.width + p % frame_.stride - 1];
  }

  // From p to its nearest end, step by step, each time to the first neighbour that is one nearer to the same end.
  std::vector<std::uint32_t> way_home(std::uint32_t p) const {
    std::vector<std::uint32_t> way;
    while (nearest_.distance[p] > 0) {
      way.push_back(p);
      std::uint32_t next = kFar;
      for (std::size_t s = 0; s < step_count(Adjacency::four); ++s) {
        const std::uint32_t q = p + steps_[s];
        if (nearest_.distance[q] + 1 == nearest_.distance[p] && nearest_.end[q] == nearest_.end[p])
          next = std::min(next, q);
      }
      p = next;
    }
    return way;
  }

  std::uint64_t in_whole(std::uint32_t p) const {
    const std::int64_t x = p % frame_.stride - 1 + window_.x, y = p / frame_.stride - 1 + window_.y;
    return static_cast<std::uint64_t>(y * window_.whole_width + x);
  }

  RegionLink link(const Meeting& m) const {
    std::vector<std::uint32_t> way = way_home(m.p);
    std::reverse(way.begin(), way.end());
    const std::vector<std::uint32_t> rest = way_home(m.q);
    way.insert(way.end(), rest.begin(), rest.end());
    RegionLink link{m.length,      in_whole(m.end_a), in_whole(m.end_b), in_whole(m.p),
                    in_whole(m.q), zone_of(m.end_a),  zone_of(m.end_b)};
    const std::int64_t from = heights_[m.end_a], to = heights_[m.end_b];
    const auto steps = static_cast<std::int64_t>(way.size()) + 1;
    for (std::size_t i = 0; i < way.size(); ++i) {
      const auto at = static_cast<std::int64_t>(i) + 1;
      link.way.push_back({in_whole(way[i]), static_cast<Height>((from * (steps - at) + to * at) / steps)});
    }
    return link;
  }

  const LinkWindow& window_;
  LinkRegionsParams params_;
  PaddedFrame frame_;
  std::array<std::uint32_t, 8> steps_;
  std::vector<Height> heights_;
  Nearest nearest_;
};

}  // namespace

std::vector<RegionLink> links_in(const LinkWindow& window, const LinkRegionsParams& params) {
  return Linking(window, params).run();
}

}  // namespace ilot
