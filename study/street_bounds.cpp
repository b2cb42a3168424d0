// SPDX-License-Identifier: Apache-2.0
#include "study/street_bounds.h"

#include <algorithm>

namespace ilot {
namespace {

using PointsOf = std::map<std::uint32_t, std::uint64_t>;  // points by object; 0 is what is no object

// Points of the pixels that belong to each object, and how many of them are its own.
struct Owned {
  PointsOf all, own;

  // Gives a pixel to who has most points in it; of equal ones to the lowest number.
  void add(const PointsOf& pixel, bool with_others) {
    std::uint32_t owner = 0;
    std::uint64_t most = 0, points = 0;
    for (const auto& [object, n] : pixel) {
      if (object == 0 && !with_others) continue;
      points += n;
      if (n > most) most = n, owner = object;
    }
    if (owner == 0) return;
    all[owner] += points;
    own[owner] += most;
  }

  double overlap(std::uint32_t object, std::uint64_t points) const {
    const auto found = all.find(object);
    if (found == all.end()) return 0;
    const std::uint64_t common = own.at(object);
    return static_cast<double>(common) / static_cast<double>(found->second + points - common);
  }
};

}  // namespace

void StreetBounds::add(const PlacedPoint& p) {
  if (p.object != 0) {
    ObjectBounds& o = objects_[p.object];
    ++o.points;
    ++o.places[static_cast<std::size_t>(p.place)];
  }
  if (p.place == PointPlace::ground) return;
  Standing& pixel = pixels_[{p.x, p.y}];
  ++pixel.all[p.object];
  if (p.place != PointPlace::overhead) ++pixel.seen[p.object];
}

std::map<std::uint32_t, ObjectBounds> StreetBounds::objects() const {
  Owned apart, above;
  for (const auto& [place, standing] : pixels_) {
    apart.add(standing.all, false);
    above.add(standing.seen, true);
  }
  std::map<std::uint32_t, ObjectBounds> out = objects_;
  for (auto& [object, o] : out) {
    o.apart = apart.overlap(object, o.points);
    o.above = above.overlap(object, o.points);
  }
  return out;
}

}  // namespace ilot
