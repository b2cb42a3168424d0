// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/region_links.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "kernels/core/union_find.h"
#include "kernels/rasters/nearest.h"
#include "kernels/rasters/padded.h"
#include "kernels/rasters/where.h"

namespace ilot {
namespace {

// Two neighbours that are nearest to different regions, and the ends of the link through them, the first one first.
struct Meeting {
  std::uint32_t length, end_a, end_b, p, q;  // p on the side of end_a
  std::uint32_t zone_a, zone_b;              // ZoneNumbers
  auto order() const { return std::tie(length, end_a, end_b, p, q); }
};

template <class Key>
void forget_outside(const PaddedFrame& frame, const std::vector<std::uint8_t>& inside, NearestKeys<Key>& nearest) {
  for (std::uint32_t y = 0; y < frame.height; ++y) {
    const std::uint8_t* __restrict row = inside.data() + std::size_t{y} * frame.width;
    Key* __restrict keys = nearest.keys.data() + frame.row(y);
    for (std::size_t x = 0; x < frame.width; ++x) keys[x] = row[x] != 0 ? keys[x] : nearest.far;
  }
}

// Computes nearest_keys along paths around pixels that do not belong to the image. It works in waves: all pixels of one
// distance are known before the next wave begins.
template <class Key>
NearestKeys<Key> keys_by_fronts(const PaddedFrame& frame, const Image& heights, const std::vector<std::uint8_t>& outer,
                                std::uint32_t reach) {
  NearestKeys<Key> nearest = nearest_keys<Key>(heights, 0, 1);
  const Key step = Key{1} << nearest.bits;
  nearest.far = (static_cast<Key>(reach) + 1) << nearest.bits;
  const std::vector<std::uint8_t> inside = padded<std::uint8_t>(frame.width, frame.height, outer, 0);
  const auto steps = frame.steps();
  std::vector<std::uint32_t> front, next;
  for (std::uint32_t p = 0; p < frame.size(); ++p) {
    Key& key = nearest.keys[p];
    if (key < step)
      front.push_back(p);
    else
      key = nearest.far;
  }
  for (std::uint32_t d = 1; d <= reach && !front.empty(); ++d) {
    next.clear();
    for (const std::uint32_t p : front) {
      for (std::size_t s = 0; s < step_count(Adjacency::four); ++s) {
        const std::uint32_t q = p + steps[s];
        const Key through = nearest.keys[p] + step;
        if (inside[q] == 0 || nearest.keys[q] <= through) continue;
        if (nearest.keys[q] == nearest.far) next.push_back(q);
        nearest.keys[q] = through;
      }
    }
    front.swap(next);
  }
  return nearest;
}

template <class Key>
NearestKeys<Key> keys_of(const PaddedFrame& frame, const LinkWindow& window, std::uint32_t reach) {
  if (!window.straight) return keys_by_fronts<Key>(frame, window.heights, window.inside, reach);
  NearestKeys<Key> nearest = nearest_keys<Key>(window.heights, reach, 1);
  forget_outside(frame, window.inside, nearest);
  return nearest;
}

// Zones of a window, numbered from 0 in the order in which they are first requested. This is a hash table with open
// addressing, at least twice as long as its content. Its order has no effect on results.
class ZoneNumbers {
 public:
  std::uint32_t number(std::uint32_t zone) {
    std::size_t at = place_of(zone);
    if (places_[at].zone == zone) return places_[at].number;
    if (2 * (count_ + 1) > places_.size()) {
      grow();
      at = place_of(zone);
    }
    places_[at] = {zone, count_};
    return count_++;
  }
  std::uint32_t count() const { return count_; }

 private:
  struct Place {
    std::uint32_t zone = 0, number = 0;  // no zone has the value 0
  };
  // Returns the position of a zone, or the free position where it would be stored.
  std::size_t place_of(std::uint32_t zone) const {
    std::size_t at = zone * 0x9e3779b9u & (places_.size() - 1);
    while (places_[at].zone != 0 && places_[at].zone != zone) at = (at + 1) & (places_.size() - 1);
    return at;
  }
  void grow() {
    const std::vector<Place> old = std::exchange(places_, std::vector<Place>(2 * places_.size()));
    for (const Place& p : old)
      if (p.zone != 0) places_[place_of(p.zone)] = p;
  }
  std::vector<Place> places_ = std::vector<Place>(256);
  std::uint32_t count_ = 0;
};

template <class Key>
class Linking {
 public:
  Linking(const LinkWindow& window, const LinkRegionsParams& params)
      : window_(window),
        params_(params),
        frame_(window.heights.width, window.heights.height),
        steps_(frame_.steps()),
        nearest_(keys_of<Key>(frame_, window, (params.max_length + 1) / 2)) {}

  // Goes length by length, because shorter links have already joined the regions of most meetings.
  std::vector<RegionLink> run() {
    find_meetings();
    std::vector<std::uint32_t> parents(numbers_.count());
    UnionFind regions(parents);
    std::vector<RegionLink> links;
    for (std::vector<Meeting>& list : meetings_) {
      std::erase_if(list, [&](const Meeting& m) { return regions.same(m.zone_a, m.zone_b); });
      std::sort(list.begin(), list.end(), [](const Meeting& a, const Meeting& b) { return a.order() < b.order(); });
      for (const Meeting& m : list)
        if (regions.unite(m.zone_a, m.zone_b)) links.push_back(link(m));
    }
    return links;
  }

 private:
  void find_meetings() {
    meetings_.resize(std::size_t{params_.max_length} + 1);
    const std::uint32_t width = frame_.width - std::min(frame_.width, 2 * window_.halo);
    for (std::uint32_t y = window_.halo; y + window_.halo < frame_.height; ++y) {
      const auto first = static_cast<std::uint32_t>(frame_.row(y) + window_.halo);
      for (const std::uint32_t step : {1u, frame_.stride}) find_meetings(first, step, width);
    }
  }

  // Compares each of `width` pixels with the one a step on. It reports pairs with different ends, except pairs whose
  // ends are both the pixels themselves: neighbours with heights are of one region, or too far apart in height for a
  // link.
  void find_meetings(std::uint32_t first, std::uint32_t step, std::uint32_t width) {
    const Key *a = nearest_.keys.data() + first, *b = a + step;
    const Key pixel = (Key{1} << nearest_.bits) - 1, far = nearest_.far;
    for_each_where(
        width,
        [&](std::size_t x) {
          return (((a[x] ^ b[x]) & pixel) != 0) & (a[x] < far) & (b[x] < far) & ((a[x] | b[x]) > pixel);
        },
        [&](std::size_t x) {
          const auto p = first + static_cast<std::uint32_t>(x);
          meet(p, p + step);
        });
  }

  void meet(std::uint32_t p, std::uint32_t q) {
    const std::uint32_t a = nearest_.pixel(p), b = nearest_.pixel(q), zone_a = zone_of(a), zone_b = zone_of(b);
    if (zone_a == zone_b) return;
    const std::uint32_t length = nearest_.distance(p) + nearest_.distance(q);
    if (length > params_.max_length || std::abs(height_of(a) - height_of(b)) > params_.step) return;
    const std::uint32_t i = numbers_.number(zone_a), j = numbers_.number(zone_b);
    meetings_[length].push_back(a < b ? Meeting{length, a, b, p, q, i, j} : Meeting{length, b, a, q, p, j, i});
  }

  // Converts a pixel of the frame to its index in the window.
  std::size_t in_window(std::uint32_t p) const {
    return std::size_t{p / frame_.stride - 1} * frame_.width + p % frame_.stride - 1;
  }
  std::uint32_t zone_of(std::uint32_t p) const { return window_.zones[in_window(p)]; }
  Height height_of(std::uint32_t p) const { return window_.heights.values[in_window(p)]; }

  // Returns the path from p to its nearest end, step by step. Each step goes to the first neighbour that is one step
  // nearer to the same end.
  std::vector<std::uint32_t> way_home(std::uint32_t p) const {
    std::vector<std::uint32_t> way;
    const Key step = Key{1} << nearest_.bits;
    while (nearest_.keys[p] >= step) {
      way.push_back(p);
      std::uint32_t next = UINT32_MAX;
      for (std::size_t s = 0; s < step_count(Adjacency::four); ++s) {
        const std::uint32_t q = p + steps_[s];
        if (nearest_.keys[q] + step == nearest_.keys[p]) next = std::min(next, q);
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
    const std::int64_t from = height_of(m.end_a), to = height_of(m.end_b);
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
  NearestKeys<Key> nearest_;
  std::vector<std::vector<Meeting>> meetings_;  // by length
  ZoneNumbers numbers_;
};

}  // namespace

std::vector<RegionLink> links_in(const LinkWindow& window, const LinkRegionsParams& params) {
  const std::size_t pixels = PaddedFrame(window.heights.width, window.heights.height).size();
  return fit_nearest_keys(pixels, (params.max_length + 1) / 2) ? Linking<std::int32_t>(window, params).run()
                                                               : Linking<std::int64_t>(window, params).run();
}

}  // namespace ilot
