// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/plane_section.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ilot {
namespace {

FlatPoint flat(Vec3 p, const SectionPlane& plane) {
  return {dot(p - plane.origin, plane.u), dot(p - plane.origin, plane.v)};
}

// Returns where the rings pass through the plane.
std::vector<FlatPoint> crossings_of(const SectionFace& face, const SectionPlane& plane, Vec3 normal) {
  std::vector<FlatPoint> crossings;
  for (const std::vector<Vec3>& ring : face.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec3 a = ring[i], b = ring[(i + 1) % ring.size()];
      const double da = dot(a - plane.origin, normal), db = dot(b - plane.origin, normal);
      if ((da >= 0) != (db >= 0)) crossings.push_back(flat(a + (da / (da - db)) * (b - a), plane));
    }
  }
  return crossings;
}

// Keeps the part of a segment between two places along x. Returns false when there is none.
bool keep_between(double from, double to, FlatEdge& e) {
  if (std::max(e.a.x, e.b.x) < from || std::min(e.a.x, e.b.x) > to) return false;
  const FlatPoint a = e.a, b = e.b;
  const auto at = [&](double x) { return FlatPoint{x, a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y)}; };
  for (FlatPoint* end : {&e.a, &e.b}) {
    if (end->x < from) *end = at(from);
    if (end->x > to) *end = at(to);
  }
  return true;
}

// An end of a segment: its place and its number.
struct SegmentEnd {
  FlatPoint place;
  std::size_t stretch = 0;
  bool second = false;
};

// Returns for each end (2 x segment + second) the end to which it is joined, or itself.
std::vector<std::size_t> partners(const std::vector<FlatEdge>& edges, double touch) {
  std::vector<SegmentEnd> ends;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    ends.push_back({edges[i].a, i, false});
    ends.push_back({edges[i].b, i, true});
  }
  const auto number = [](const SegmentEnd& end) { return 2 * end.stretch + end.second; };
  std::sort(ends.begin(), ends.end(), [&](const SegmentEnd& a, const SegmentEnd& b) {
    return a.place.x < b.place.x || (a.place.x == b.place.x && number(a) < number(b));
  });
  struct Link {
    double distance;
    std::size_t a, b;
  };
  std::vector<Link> links;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t k = i + 1; k < ends.size() && ends[k].place.x - ends[i].place.x <= touch; ++k) {
      const double away = norm(ends[k].place - ends[i].place);
      if (away <= touch && ends[i].stretch != ends[k].stretch)
        links.push_back({away, std::min(number(ends[i]), number(ends[k])), std::max(number(ends[i]), number(ends[k]))});
    }
  std::sort(links.begin(), links.end(), [](const Link& a, const Link& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.a != b.a ? a.a < b.a : a.b < b.b;
  });
  std::vector<std::size_t> partner(2 * edges.size());
  for (std::size_t i = 0; i < partner.size(); ++i) partner[i] = i;
  for (const Link& link : links)
    if (partner[link.a] == link.a && partner[link.b] == link.b) {
      partner[link.a] = link.b;
      partner[link.b] = link.a;
    }
  return partner;
}

}  // namespace

std::vector<FlatEdge> cut_faces(std::span<const SectionFace> faces, const SectionPlane& plane) {
  const Vec3 normal = cross(plane.u, plane.v);
  std::vector<FlatEdge> edges;
  for (const SectionFace& face : faces) {
    std::vector<FlatPoint> crossings = crossings_of(face, plane, normal);
    if (crossings.size() < 2) continue;
    // All crossings are on one line, so they are sorted along its longer axis.
    const auto [low_x, high_x] =
        std::minmax_element(crossings.begin(), crossings.end(), [](FlatPoint a, FlatPoint b) { return a.x < b.x; });
    const auto [low_y, high_y] =
        std::minmax_element(crossings.begin(), crossings.end(), [](FlatPoint a, FlatPoint b) { return a.y < b.y; });
    const bool by_x = high_x->x - low_x->x >= high_y->y - low_y->y;
    std::sort(crossings.begin(), crossings.end(), [&](FlatPoint a, FlatPoint b) {
      return by_x ? a.x < b.x || (a.x == b.x && a.y < b.y) : a.y < b.y || (a.y == b.y && a.x < b.x);
    });
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
      if (FlatEdge e{crossings[i], crossings[i + 1]}; keep_between(plane.from, plane.to, e)) edges.push_back(e);
  }
  return edges;
}

std::vector<std::vector<FlatPoint>> join_stretches(std::span<const FlatEdge> given, double touch) {
  std::vector<FlatEdge> edges;
  for (const FlatEdge& e : given)
    if (norm(e.b - e.a) > touch) edges.push_back(e);
  const std::vector<std::size_t> partner = partners(edges, touch);
  const auto place = [&](std::size_t end) { return end % 2 == 0 ? edges[end / 2].a : edges[end / 2].b; };
  std::vector<char> used(edges.size(), 0);
  std::vector<std::vector<FlatPoint>> chains;
  const auto follow = [&](std::size_t end) {  // from the end of a segment through it and on
    std::vector<FlatPoint> chain{place(end)};
    const std::size_t first = end;
    for (;;) {
      used[end / 2] = 1;
      const std::size_t far = end ^ 1u;
      chain.push_back(place(far));
      if (partner[far] == far || partner[far] == first) break;
      end = partner[far];
    }
    if (partner[first] != first) chain.back() = chain.front();
    chains.push_back(std::move(chain));
  };
  for (std::size_t end = 0; end < partner.size(); ++end)  // open lists begin at ends that are not joined
    if (partner[end] == end && !used[end / 2]) follow(end);
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (!used[i]) follow(2 * i);
  return chains;
}

}  // namespace ilot
