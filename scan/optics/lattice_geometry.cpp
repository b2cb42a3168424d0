// SPDX-License-Identifier: Apache-2.0
#include "scan/optics/lattice_geometry.h"

#include <array>
#include <numeric>

namespace ilot::scan {

GridLine reduced(const GridLine& line) {
  const Integer divisor = std::gcd(std::gcd(line.a, line.b), line.c);
  return divisor > 1 ? GridLine{line.a / divisor, line.b / divisor, line.c / divisor} : line;
}

GridLine opposite(const GridLine& line) {
  return {-line.a, -line.b, -line.c};
}

Spot meet(const GridLine& p, const GridLine& q) {
  Spot spot{p.b * q.c - q.b * p.c, p.c * q.a - q.c * p.a, p.a * q.b - q.a * p.b};
  Integer divisor = std::gcd(std::gcd(spot.u, spot.v), spot.w);
  if (spot.w < 0) divisor = -divisor;
  return {spot.u / divisor, spot.v / divisor, spot.w / divisor};
}

int side(const GridLine& line, const Spot& spot) {
  const Integer value = line.a * spot.u + line.b * spot.v + line.c * spot.w;
  return (value > 0) - (value < 0);
}

std::vector<GridLine> half_planes(const GridRect& rect) {
  return {{0, 1, -rect.v0}, {-1, 0, rect.u1}, {0, -1, rect.v1}, {1, 0, -rect.u0}};
}

Piece rectangle(const GridRect& rect) {
  const std::vector<GridLine> edges = half_planes(rect);
  const std::array<Spot, 4> corners{
      {{rect.u0, rect.v0, 1}, {rect.u1, rect.v0, 1}, {rect.u1, rect.v1, 1}, {rect.u0, rect.v1, 1}}};
  Piece piece;
  for (std::size_t i = 0; i < 4; ++i) piece.push_back({corners[i], edges[i]});
  return piece;
}

Piece clip(const Piece& piece, const GridLine& line) {
  std::vector<int> sides;
  bool any_inside = false;
  for (const Corner& corner : piece) {
    sides.push_back(side(line, corner.at));
    any_inside = any_inside || sides.back() > 0;
  }
  Piece kept;
  if (!any_inside) return kept;
  const GridLine border = reduced(line);
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const int here = sides[i], next = sides[(i + 1) % piece.size()];
    const Corner& corner = piece[i];
    if (here >= 0) kept.push_back({corner.at, here == 0 && next < 0 ? border : corner.edge});
    if (here > 0 && next < 0) kept.push_back({meet(corner.edge, border), border});
    if (here < 0 && next > 0) kept.push_back({meet(corner.edge, border), corner.edge});
  }
  return kept;
}

std::vector<Piece> subtract(const Piece& piece, std::span<const GridLine> hole) {
  Piece inner = piece;
  for (const GridLine& line : hole) inner = clip(inner, line);
  if (inner.empty()) return {piece};
  std::vector<Piece> outside;
  inner = piece;
  for (const GridLine& line : hole) {
    Piece cut = clip(inner, opposite(line));
    if (!cut.empty()) outside.push_back(std::move(cut));
    inner = clip(inner, line);
  }
  return outside;
}

}  // namespace ilot::scan
