// SPDX-License-Identifier: Apache-2.0
// Plane geometry without rounding: lines with whole coefficients, the spots where two of them meet, and the convex
// pieces they bound. Coefficients of directions stay below 2^8 and coordinates below 2^17 (131 m in millimetres), so
// that every product fits 64 bits.
#pragma once
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace ilot::scan {

using Integer = std::int64_t;

// The half-plane a u + b v + c >= 0, and its border.
struct GridLine {
  Integer a = 0, b = 0, c = 0;
  friend auto operator<=>(const GridLine&, const GridLine&) = default;
};

// The same half-plane with coefficients that have no common divisor.
GridLine reduced(const GridLine& line);
GridLine opposite(const GridLine& line);

// The place (u / w, v / w); w > 0 and no common divisor, so that equal places have equal numbers.
struct Spot {
  Integer u = 0, v = 0, w = 1;
  friend auto operator<=>(const Spot&, const Spot&) = default;
};

// Where two lines that are not parallel meet.
Spot meet(const GridLine& p, const GridLine& q);

// 1 inside the half-plane, 0 on its border, -1 outside.
int side(const GridLine& line, const Spot& spot);

// A convex polygon, counter-clockwise, with no three corners in line. Empty: no area.
struct Corner {
  Spot at;
  GridLine edge;  // of the side that leads on to the next corner; the polygon lies in its half-plane
};
using Piece = std::vector<Corner>;

struct GridRect {
  Integer u0 = 0, v0 = 0, u1 = 0, v1 = 0;
};
Piece rectangle(const GridRect& rect);
std::vector<GridLine> half_planes(const GridRect& rect);

// The part within a half-plane.
Piece clip(const Piece& piece, const GridLine& line);

// The part outside the intersection of half-planes, cut into convex pieces. The piece itself where they do not overlap.
std::vector<Piece> subtract(const Piece& piece, std::span<const GridLine> hole);

}  // namespace ilot::scan
