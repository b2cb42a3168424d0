// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/link_regions.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "kernels/core/union_find.h"
#include "kernels/rasters/flat_zones.h"
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
// Waves: all of one distance are known before the next begins.
struct Nearest {
  std::vector<std::uint32_t> distance, end;
};

Nearest nearest_ends(const PaddedFrame& frame, const std::vector<Height>& heights, std::uint32_t reach) {
  Nearest nearest{std::vector<std::uint32_t>(frame.size(), kFar), std::vector<std::uint32_t>(frame.size(), kFar)};
  std::vector<std::uint32_t> wave, next;
  std::vector<std::uint8_t> inside(frame.size(), 0);
  for (std::uint32_t y = 0; y < frame.height; ++y) {
    for (std::size_t p = frame.row(y); p < frame.row(y) + frame.width; ++p) {
      inside[p] = 1;
      if (heights[p] == kNoHeight) continue;
      nearest.distance[p] = 0;
      nearest.end[p] = static_cast<std::uint32_t>(p);
      wave.push_back(static_cast<std::uint32_t>(p));
    }
  }
  const auto steps = frame.steps();
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

class Linking {
 public:
  Linking(const Image& image, const LinkRegionsParams& params)
      : params_(params),
        frame_(image.width, image.height),
        steps_(frame_.steps()),
        heights_(padded(image, kNoHeight)),
        zones_(
            padded<std::uint32_t>(image.width, image.height, flat_zones(image, params.step, Adjacency::eight).of, 0)),
        nearest_(nearest_ends(frame_, heights_, params.max_length)) {}

  Image run() {
    std::vector<std::uint32_t> parents(*std::max_element(zones_.begin(), zones_.end()) + 1);
    UnionFind regions(parents);
    std::vector<Height> out = heights_;
    for (const Meeting& m : meetings())
      if (regions.unite(zones_[m.end_a], zones_[m.end_b])) draw(m, out);
    return {frame_.width, frame_.height, unpadded<Height>(frame_, out)};
  }

 private:
  std::vector<Meeting> meetings() const {
    std::vector<Meeting> list;
    for (std::uint32_t y = 0; y < frame_.height; ++y)
      for (std::size_t p = frame_.row(y); p < frame_.row(y) + frame_.width; ++p)
        for (const std::uint32_t q : {static_cast<std::uint32_t>(p + 1), static_cast<std::uint32_t>(p + frame_.stride)})
          meet(static_cast<std::uint32_t>(p), q, list);
    std::sort(list.begin(), list.end(), [](const Meeting& a, const Meeting& b) { return a.order() < b.order(); });
    return list;
  }

  void meet(std::uint32_t p, std::uint32_t q, std::vector<Meeting>& list) const {
    const std::uint32_t a = nearest_.end[p], b = nearest_.end[q];
    if (a == kFar || b == kFar || zones_[a] == zones_[b]) return;
    const std::uint32_t length = nearest_.distance[p] + nearest_.distance[q];
    if (length > params_.max_length || std::abs(heights_[a] - heights_[b]) > params_.step) return;
    list.push_back(a < b ? Meeting{length, a, b, p, q} : Meeting{length, b, a, q, p});
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

  void draw(const Meeting& m, std::vector<Height>& out) const {
    std::vector<std::uint32_t> way = way_home(m.p);
    std::reverse(way.begin(), way.end());
    const std::vector<std::uint32_t> rest = way_home(m.q);
    way.insert(way.end(), rest.begin(), rest.end());
    const std::int64_t from = heights_[m.end_a], to = heights_[m.end_b];
    const auto steps = static_cast<std::int64_t>(way.size()) + 1;
    for (std::size_t i = 0; i < way.size(); ++i) {
      const auto at = static_cast<std::int64_t>(i) + 1;
      if (out[way[i]] == kNoHeight) out[way[i]] = static_cast<Height>((from * (steps - at) + to * at) / steps);
    }
  }

  LinkRegionsParams params_;
  PaddedFrame frame_;
  std::array<std::uint32_t, 8> steps_;
  std::vector<Height> heights_;
  std::vector<std::uint32_t> zones_;
  Nearest nearest_;
};

}  // namespace

Image link_regions(const Image& image, const LinkRegionsParams& params) {
  if (image.size() == 0) return image;
  return Linking(image, params).run();
}

}  // namespace ilot
