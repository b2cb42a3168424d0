// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/same_openings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/products/facades/elements/facade_elements.h"
#include "engine/products/facades/same_wall.h"

namespace ilot {
namespace {

// Derived: more than half, so that an opening has one partner only.
constexpr double kMostOf = 0.5;  // share of the smaller opening that two have in common

// An opening of a facade, and how well it is known.
struct DrawnOpening {
  std::size_t facade = 0, element = 0;
  std::array<Vec3, 4> corners;  // of its box
  std::uint64_t unseen = 0;     // sides
  double error = 0;             // metres, the mean of all edges

  bool better_than(const DrawnOpening& o) const {
    if (unseen != o.unseen) return unseen < o.unseen;
    if (error != o.error) return error < o.error;
    return facade != o.facade ? facade < o.facade : element < o.element;
  }
};

// The corners of the box around a ring along the axes of its facade.
std::array<Vec3, 4> corners_of(const Facade& f, const std::vector<Vec3>& ring) {
  std::vector<Place2> places;
  double w = 0;
  for (const Vec3& p : ring) {
    const Vec3 off = p - f.origin;
    places.push_back({dot(off, f.right), dot(off, f.up)});
    w += dot(off, f.out) / static_cast<double>(ring.size());
  }
  const Box2 box = box_of(places);
  const auto corner = [&](double u, double v) { return f.origin + u * f.right + v * f.up + w * f.out; };
  return {corner(box.u0, box.v0), corner(box.u1, box.v0), corner(box.u1, box.v1), corner(box.u0, box.v1)};
}

// Corners in the axes of a facade, in metres: their box and their mean distance before the plane.
struct OnFacade {
  Box2 box;
  double w = 0;
};

OnFacade on_facade(const Facade& f, const std::array<Vec3, 4>& corners, double metres_per_unit) {
  std::array<Place2, 4> places;
  OnFacade out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 off = metres_per_unit * (corners[i] - f.origin);
    places[i] = {dot(off, f.right), dot(off, f.up)};
    out.w += dot(off, f.out) / static_cast<double>(corners.size());
  }
  out.box = box_of(places);
  return out;
}

bool face_alike(const Facade& a, const Facade& b) {
  return dot(a.out, b.out) >= kOneWallCosine;
}

// Whether most of an area of a facade is that of an opening of another sheet of its wall, or of most of this opening
// where it may be the smaller one.
bool is_same(const Facade& own, const DrawnOpening& area, const DrawnOpening& other, double unit, bool or_of_other) {
  const OnFacade p = on_facade(own, area.corners, unit), q = on_facade(own, other.corners, unit);
  if (std::abs(p.w - q.w) > kOneWallDepth) return false;
  const double least = or_of_other ? std::min(area_of(p.box), area_of(q.box)) : area_of(p.box);
  return common_area(p.box, q.box) > kMostOf * least;
}

bool is_possible(const FacadeElement& e) {
  return e.kind == "possible opening";
}

// The openings of all facades, or the possible ones.
std::vector<DrawnOpening> drawn_openings(std::span<const FoundFacade> found, bool possible) {
  std::vector<DrawnOpening> openings;
  for (std::size_t f = 0; f < found.size(); ++f)
    for (std::size_t i = 0; i < found[f].facade.elements.size(); ++i) {
      const FacadeElement& e = found[f].facade.elements[i];
      const bool opening = e.opening && e.region == FacadeRegion::element;
      if (e.ring.empty() || !(possible ? is_possible(e) : opening)) continue;
      DrawnOpening& o =
          openings.emplace_back(DrawnOpening{f, i, corners_of(found[f].facade, e.ring), unseen_sides(e), 0});
      for (const FacadeEdge& edge : e.edges) o.error += edge.error_m / static_cast<double>(e.edges.size());
    }
  return openings;
}

}  // namespace

void drop_same_openings(std::span<FoundFacade> found, double metres_per_unit) {
  std::vector<DrawnOpening> openings = drawn_openings(found, false), kept;
  std::sort(openings.begin(), openings.end(),
            [](const DrawnOpening& a, const DrawnOpening& b) { return a.better_than(b); });
  std::vector<std::vector<bool>> dropped(found.size());
  for (std::size_t f = 0; f < found.size(); ++f) dropped[f].assign(found[f].facade.elements.size(), false);
  const auto known = [&](const DrawnOpening& o, bool or_of_other) {
    const Facade& own = found[o.facade].facade;
    return std::any_of(kept.begin(), kept.end(), [&](const DrawnOpening& k) {
      return k.facade != o.facade && face_alike(own, found[k.facade].facade) &&
             is_same(own, o, k, metres_per_unit, or_of_other);
    });
  };
  for (const DrawnOpening& o : openings) {
    if (!known(o, true)) {
      kept.push_back(o);
      continue;
    }
    dropped[o.facade][o.element] = true;
    found[o.facade].occluded_edges -= o.unseen;
  }
  for (const DrawnOpening& o : drawn_openings(found, true)) dropped[o.facade][o.element] = known(o, false);
  for (std::size_t f = 0; f < found.size(); ++f) remove_elements(dropped[f], found[f].facade.elements);
}

}  // namespace ilot
