// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/same_openings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace ilot {
namespace {

// Choice: the value that joins facades side by side (10 degrees).
constexpr double kParallel = 0.985;  // cosine of the angle between two facades of one wall, at least
// Choice: the reveals of usual walls with what stands before them; a loggia is deeper.
constexpr double kWall = 0.3;  // metres between the planes of two facades of one wall, at most
// Derived: more than half, so that an opening has one partner only.
constexpr double kMostOf = 0.5;  // share of the smaller opening that two have in common

// An opening of a facade and how well it is known.
struct DrawnOpening {
  std::size_t facade = 0, element = 0;
  std::uint64_t unseen = 0;  // edges
  double error = 0;          // metres, of all edges together

  bool better_than(const DrawnOpening& o) const {
    if (unseen != o.unseen) return unseen < o.unseen;
    if (error != o.error) return error < o.error;
    return facade != o.facade ? facade < o.facade : element < o.element;
  }
};

// A ring in the axes of a facade, in metres: its box and its mean distance before the plane.
struct OnFacade {
  Box2 box;
  double w = 0;
};

OnFacade on_facade(const Facade& f, const std::vector<Vec3>& ring, double metres_per_unit) {
  std::vector<Place2> places;
  OnFacade out;
  for (const Vec3& p : ring) {
    const Vec3 off = metres_per_unit * (p - f.origin);
    places.push_back({dot(off, f.right), dot(off, f.up)});
    out.w += dot(off, f.out) / static_cast<double>(ring.size());
  }
  out.box = box_of(places);
  return out;
}

double area_of(const Box2& b) {
  return std::max(0.0, b.width()) * std::max(0.0, b.height());
}

bool are_same(const Facade& f, const FacadeElement& a, const Facade& g, const FacadeElement& b, double unit) {
  if (dot(f.out, g.out) < kParallel) return false;
  const OnFacade p = on_facade(f, a.ring, unit), q = on_facade(f, b.ring, unit);
  if (std::abs(p.w - q.w) > kWall) return false;
  const Box2 common{std::max(p.box.u0, q.box.u0), std::min(p.box.u1, q.box.u1), std::max(p.box.v0, q.box.v0),
                    std::min(p.box.v1, q.box.v1)};
  return area_of(common) > kMostOf * std::min(area_of(p.box), area_of(q.box));
}

std::uint64_t unseen_edges(const FacadeElement& e) {
  return static_cast<std::uint64_t>(std::count_if(
      e.edges.begin(), e.edges.end(), [](const FacadeEdge& edge) { return edge.status != DrawnStatus::seen; }));
}

std::vector<DrawnOpening> drawn_openings(std::span<const FoundFacade> found) {
  std::vector<DrawnOpening> openings;
  for (std::size_t f = 0; f < found.size(); ++f)
    for (std::size_t i = 0; i < found[f].facade.elements.size(); ++i) {
      const FacadeElement& e = found[f].facade.elements[i];
      if (!e.opening || e.ring.empty() || e.region != FacadeRegion::element) continue;
      DrawnOpening& o = openings.emplace_back(DrawnOpening{f, i, unseen_edges(e), 0});
      for (const FacadeEdge& edge : e.edges) o.error += edge.error_m / static_cast<double>(e.edges.size());
    }
  return openings;
}

}  // namespace

void drop_same_openings(std::span<FoundFacade> found, double metres_per_unit) {
  std::vector<DrawnOpening> openings = drawn_openings(found);
  std::sort(openings.begin(), openings.end(),
            [](const DrawnOpening& a, const DrawnOpening& b) { return a.better_than(b); });
  std::vector<DrawnOpening> kept;
  std::vector<std::vector<bool>> dropped(found.size());
  for (std::size_t f = 0; f < found.size(); ++f) dropped[f].assign(found[f].facade.elements.size(), false);
  for (const DrawnOpening& o : openings) {
    const Facade& own = found[o.facade].facade;
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const DrawnOpening& k) {
      const Facade& other = found[k.facade].facade;
      return k.facade != o.facade &&
             are_same(own, own.elements[o.element], other, other.elements[k.element], metres_per_unit);
    });
    if (!known) kept.push_back(o);
    dropped[o.facade][o.element] = known;
    if (known) found[o.facade].occluded_edges -= std::min(o.unseen, found[o.facade].occluded_edges);
  }
  for (std::size_t f = 0; f < found.size(); ++f) {
    std::vector<FacadeElement>& elements = found[f].facade.elements;
    std::size_t i = 0;
    std::vector<FacadeElement> left;
    for (FacadeElement& e : elements)
      if (!dropped[f][i++]) left.push_back(std::move(e));
    elements = std::move(left);
    for (std::uint32_t k = 0; k < elements.size(); ++k) elements[k].id = k + 1;
  }
}

}  // namespace ilot
