// SPDX-License-Identifier: Apache-2.0
// Plane geometry without rounding: lines with integer coefficients, the spots where two of them meet, and the convex
// pieces that they bound. Coefficients of directions are below 2^8 and coordinates below 2^17 (131 m in millimetres),
// so every product fits into 64 bits.
#pragma once
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace ilot::scan {

using Integer = std::int64_t;

// The half-plane a u + b v + c >= 0 and its border.
struct GridLine {
  Integer a = 0, b = 0, c = 0;
  friend auto operator<=>(const GridLine&, const GridLine&) = default;
};

// Returns the same half-plane with coefficients that have no common divisor.
GridLine reduced(const GridLine& line);
GridLine opposite(const GridLine& line);

// The position (u / w, v / w). w is positive and there is no common divisor, so equal positions have equal numbers.
struct Spot {
  Integer u = 0, v = 0, w = 1;
  friend auto operator<=>(const Spot&, const Spot&) = default;
};

// Returns the spot where two lines meet. The lines must not be parallel.
Spot meet(const GridLine& p, const GridLine& q);

// Returns 1 inside the half-plane, 0 on its border and -1 outside.
int side(const GridLine& line, const Spot& spot);

// A convex polygon, counter-clockwise, in which no three corners are on one line. An empty polygon has no area.
struct Corner {
  Spot at;
  GridLine edge;  // line of the side that leads to the next corner; the polygon is in its half-plane
};
using Piece = std::vector<Corner>;

struct GridRect {
  Integer u0 = 0, v0 = 0, u1 = 0, v1 = 0;
};
Piece rectangle(const GridRect& rect);
std::vector<GridLine> half_planes(const GridRect& rect);

// Returns the part of the piece within a half-plane.
Piece clip(const Piece& piece, const GridLine& line);

// Returns the part of the piece outside the intersection of half-planes, cut into convex pieces. If they do not
// overlap, the result is the piece itself.
std::vector<Piece> subtract(const Piece& piece, std::span<const GridLine> hole);

}  // namespace ilot::scan
