// SPDX-License-Identifier: Apache-2.0
#include "scan/roofs/roof_partition.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace ilot::scan {
namespace {

enum class Order { below, equal, above, varies };

// Returns the half-plane in which q is at least as high as p.
GridLine not_below(const RoofPlane& q, const RoofPlane& p) {
  return {q.a - p.a, q.b - p.b, q.c - p.c};
}

Order compare(const RoofPlane& q, const RoofPlane& p) {
  const GridLine line = not_below(q, p);
  if (line.a != 0 || line.b != 0) return Order::varies;
  return line.c > 0 ? Order::above : line.c < 0 ? Order::below : Order::equal;
}

// Returns the piece where the plane is the lowest of its wing. Of equal planes the first one counts.
Piece seen_in_wing(const Wing& wing, std::size_t plane) {
  Piece piece = rectangle(wing.rect);
  for (std::size_t other = 0; other < wing.planes.size() && !piece.empty(); ++other) {
    if (other == plane) continue;
    const Order order = compare(wing.planes[other], wing.planes[plane]);
    if (order == Order::below || (order == Order::equal && other < plane)) return {};
    if (order == Order::varies) piece = clip(piece, not_below(wing.planes[other], wing.planes[plane]));
  }
  return piece;
}

// Returns where the wing hides the plane. Returns nothing when it does so nowhere.
std::optional<std::vector<GridLine>> hidden_by(const Wing& wing, const RoofPlane& plane, bool comes_first) {
  std::vector<GridLine> region = half_planes(wing.rect);
  for (const RoofPlane& other : wing.planes) {
    const Order order = compare(other, plane);
    if (order == Order::below || (order == Order::equal && !comes_first)) return std::nullopt;
    if (order == Order::varies) region.push_back(not_below(other, plane));
  }
  return region;
}

}  // namespace

std::vector<RoofPiece> partition_roof(std::span<const Wing> wings) {
  std::vector<RoofPiece> seen;
  for (std::size_t i = 0; i < wings.size(); ++i) {
    for (std::size_t p = 0; p < wings[i].planes.size(); ++p) {
      const RoofPlane& plane = wings[i].planes[p];
      std::vector<Piece> pieces{seen_in_wing(wings[i], p)};
      for (std::size_t j = 0; j < wings.size(); ++j) {
        if (j == i) continue;
        const auto hidden = hidden_by(wings[j], plane, j < i);
        if (!hidden) continue;
        std::vector<Piece> left;
        for (const Piece& piece : pieces)
          for (Piece& part : subtract(piece, *hidden)) left.push_back(std::move(part));
        pieces = std::move(left);
      }
      for (Piece& piece : pieces)
        if (!piece.empty()) seen.push_back({std::move(piece), plane});
    }
  }
  return seen;
}

double height_mm(const RoofPlane& plane, double u, double v) {
  return (static_cast<double>(plane.a) * u + static_cast<double>(plane.b) * v + static_cast<double>(plane.c)) /
         kSlopeUnit;
}

double height_mm(const Wing& wing, double u, double v) {
  double height = std::numeric_limits<double>::infinity();
  for (const RoofPlane& plane : wing.planes) height = std::min(height, height_mm(plane, u, v));
  return height;
}

}  // namespace ilot::scan
