// SPDX-License-Identifier: Apache-2.0
// Plinth, bands, cornice, pilasters and balconies of a wild front.
#include <algorithm>
#include <cmath>

#include "scan/wild/facade/wild_front.h"

namespace ilot::scan {
namespace {

constexpr double kPiece = 1.5;  // metres: long mouldings follow a bowed wall in pieces

void long_block(FacadeBuilder& facade, const Block& b, const Finish& finish) {
  const int pieces = std::max(1, static_cast<int>(std::ceil((b.x1 - b.x0) / kPiece)));
  for (int i = 0; i < pieces; ++i) {
    const double x0 = b.x0 + (b.x1 - b.x0) * i / pieces, x1 = b.x0 + (b.x1 - b.x0) * (i + 1) / pieces;
    facade.block({x0, x1, b.out0, b.out1, b.z0, b.z1}, finish, Faces::unnamed);
  }
}

Finish stone(const WildFront& front, std::uint32_t element) {
  return wild_finish(WildClass::moulding, Material::limestone, element, front.tone);
}

void add_band(FacadeBuilder& facade, const WildFront& front, const char* kind, const Block& b) {
  long_block(facade, b, stone(front, add_thing(facade, kind, b)));
}

// A plinth ends at doors, shops and passages.
void add_plinth(FacadeBuilder& facade, Draws& draws, const WildFront& front) {
  const double out = draws.number("plinth", front.plot.house);
  if (!(out > 0.01)) return;
  double lowest = 1.2;
  for (const WildOpening& o : front.openings)
    if (o.place.row == 1 && o.use == WildUse::window) lowest = std::min(lowest, o.hole.bottom - 0.05);
  const double top = 0.15 + (lowest - 0.15) * draws.random("plinth", front.plot.house).uniform();
  double from = 0;
  const auto piece = [&](double to) {
    if (to - from > 0.1) add_band(facade, front, "plinth", {from, to, -kOverlap, out, front.foot(), top});
  };
  for (const WildOpening& o : front.openings) {
    if (o.place.row != 1 || o.use == WildUse::window) continue;
    piece(o.hole.left);
    from = o.hole.right;
  }
  piece(front.plot.width);
}

void add_bands(FacadeBuilder& facade, Draws& draws, const WildFront& front) {
  for (std::uint32_t row = 2; row < front.floors.size(); ++row) {
    const std::uint64_t storey = element_index(front.plot.house, row);
    if (!draws.happens("bands", storey, front.plot.house)) continue;
    Rng rng = draws.random("band", storey);
    const double out = 0.02 + 0.12 * rng.uniform(), high = 0.06 + 0.14 * rng.uniform(), z = front.floors[row - 1];
    double below = z - 0.3;  // windows of the storey below may reach far up
    for (const WildOpening& o : front.openings)
      if (o.place.row + 1 == row) below = std::max(below, top_of(o.hole));
    add_band(facade, front, "band",
             {0, front.plot.width, -kOverlap, out, std::max(below + 0.01, z - high), std::max(below + 0.03, z)});
  }
}

// A cornice of three steps.
void add_cornice(FacadeBuilder& facade, Draws& draws, const WildFront& front) {
  const double out = draws.number("cornice", front.plot.house), top = front.eave();
  if (!(out > 0.03)) return;
  const double high = std::min(0.1, 0.3 * out);
  const std::uint32_t id = add_thing(facade, "cornice", {0, front.plot.width, 0, out, top - 3 * high, top});
  for (int step = 1; step <= 3; ++step)
    long_block(facade,
               {0, front.plot.width, -kOverlap, out * step / 3, top - (4 - step) * high, top - (3 - step) * high},
               stone(front, id));
}

void add_pilasters(FacadeBuilder& facade, Draws& draws, const WildFront& front) {
  const double bay = bay_of(front), out = draws.number("pilaster_out", front.plot.house);
  for (std::uint32_t i = 0; i <= front.bays; ++i) {
    if (!draws.happens("pilasters", element_index(front.plot.house, i), front.plot.house)) continue;
    const double middle = (front.plot.width - front.bays * bay) / 2 + i * bay;
    double half = 0.22;
    for (const WildOpening& o : front.openings) {
      half = std::min({half, std::abs(o.hole.left - middle) - 0.03, std::abs(o.hole.right - middle) - 0.03});
      if (o.hole.left < middle && o.hole.right > middle) half = 0;
    }
    if (half < 0.08) continue;
    const double left = std::max(0.0, middle - half), right = std::min(front.plot.width, middle + half);
    add_band(facade, front, "pilaster", {left, right, -kOverlap, out, front.foot(), front.eave() - 0.05});
  }
}

void add_balcony(FacadeBuilder& facade, Draws& draws, const WildFront& front, const WildOpening& o) {
  Rng rng = draws.random("balcony", o.element);
  const double out = draws.number("balcony_out", front.plot.house), beside = 0.1 + 0.3 * rng.uniform();
  const double x0 = std::max(0.05, o.hole.left - beside), x1 = std::min(front.plot.width - 0.05, o.hole.right + beside);
  const double z = std::min(o.hole.bottom, front.floors[o.place.row - 1] + 0.15), thick = 0.08 + 0.12 * rng.uniform();
  const double high = 0.9 + 0.25 * rng.uniform();
  const std::uint32_t id = add_thing(facade, "balcony", {x0, x1, 0, out, z - thick, z + high});
  facade.block({x0, x1, -kOverlap, out, z - thick, z},
               wild_finish(WildClass::balcony, Material::limestone, id, front.tone), Faces::unnamed);
  const Finish iron = wild_finish(WildClass::balcony, Material::iron, id);
  if (rng.uniform() < 0.3) {  // a parapet of stone or boards
    const Finish board = wild_finish(WildClass::balcony, Material::render, id, front.tone);
    facade.block({x0, x1, out - 0.08, out, z, z + high}, board, Faces::unnamed);
    for (double x : {x0, x1 - 0.08}) facade.block({x, x + 0.08, 0, out, z, z + high}, board, Faces::unnamed);
    return;
  }
  add_railing(facade, x0, x1, out - 0.04, z, high, iron);
  for (double x : {x0 + 0.02, x1 - 0.02}) {
    facade.block({x - 0.02, x + 0.02, 0, out, z + high - 0.02, z + high + 0.02}, iron, Faces::unnamed);
    for (double at = 0.1; at < out - 0.05; at += 0.12) facade.post(x, at, z, z + high, 0.008, iron);
  }
}

}  // namespace

void add_mouldings(FacadeBuilder& facade, Draws& draws, const WildFront& front) {
  add_plinth(facade, draws, front);
  add_bands(facade, draws, front);
  add_cornice(facade, draws, front);
  add_pilasters(facade, draws, front);
  for (const WildOpening& o : front.openings)
    if (o.place.row > 1 && draws.happens("balconies", o.element, front.plot.house))
      add_balcony(facade, draws, front, o);
}

}  // namespace ilot::scan
