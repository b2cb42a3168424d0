// SPDX-License-Identifier: Apache-2.0
// Document D's roof polygons [D5 to D9] as written, on the scene `roofs`: the share of buildings whose polygons close
// before vertices are projected, and the share that is still right after it; beside our own models by the same measure.
//
// The document counts a roof as done when the walk around each label's polygon comes back to its first vertex and the
// polygon is not degenerate; after projection, when no vertex was put in a wrong place. It does not say what degenerate
// and wrong are. Here: a polygon has three corners at least, an area, and does not touch itself in plan; after
// projection the same, with the sense of its turn kept, every vertex within 1 cm of the planes of all its faces and
// moved by less than --move (1 m) in plan; planes that have no common point fail. Outlines of windows that meet no
// other line get no polygon: the document leaves them out on purpose, so they are counted apart ("no face lost").
// A dormer at the eaves or the ridge meets other lines in two vertices alone, so its polygon is a line: it is open, as
// the document has it, and a second count leaves it out like a window ("lines left out").
//
// Where the document can be read in two ways the one that fails less is taken: its longest boundary chain, vertices
// where planes meet are never removed, the line between two faces ends in the middle of the boundary's edge. Its walk
// takes any unvisited neighbour that has the label ("by vertex"); "by edge" asks that the edge has it, too.
// Planes are least squares through the points of a label. Labels: the true faces, or our own plane search, of which
// each piece of a plane that the mesh holds together is a face, and pieces below --least points are left out.
//
// Usage: bench_document_roofs ROOFS.laz [--models ROOFS.city.jsonl] [--alpha M] [--radius M] [--move M] [--least N]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/deliverables/model_file.h"
#include "engine/evaluate/point_stream.h"
#include "engine/evaluate/truth.h"
#include "engine/roofs/roof_planes.h"
#include "kernels/core/eigen3.h"
#include "kernels/delaunay/delaunay.h"
#include "kernels/outlines/simple_ring.h"

namespace {

using namespace ilot;

constexpr double kPlanar = 0.01;  // metres
constexpr double kMillimetres = 1000;

struct Options {
  std::string cloud, models;
  double alpha = 0.6;   // metres; the document's longest edge
  double radius = 0.4;  // metres; one vertex within it: the narrowest that the scene's walls are
  double move = 1;      // metres in plan
  std::uint32_t least = 12;
};

// One building: its roof's points from the first of them, in metres, and their labels, 0 = none.
struct Roof {
  Vec3 anchor;
  std::vector<Vec3> points;
  std::vector<std::uint32_t> label;
  std::uint32_t labels = 0;  // they are 1 ... labels
  bool complex = false;      // more than a gable or a hip
};

Point2 place_of(Vec3 p) {
  return {static_cast<std::int32_t>(std::lround(p.x * kMillimetres)),
          static_cast<std::int32_t>(std::lround(p.y * kMillimetres))};
}

bool crosses(Vec3 a, Vec3 b, Vec3 p) {
  return (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y);
}

bool holds(const Ring3& ring, Vec3 p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (crosses(ring[i], ring[(i + 1) % ring.size()], p)) inside = !inside;
  return inside;
}

double squared_to_ring(const Ring3& ring, Vec3 p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3 a = ring[i], d = ring[(i + 1) % ring.size()] - a, v = p - a;
    const double length2 = d.x * d.x + d.y * d.y;
    const double s = length2 > 0 ? std::clamp((v.x * d.x + v.y * d.y) / length2, 0.0, 1.0) : 0;
    const Vec3 off = v - s * d;
    nearest = std::min(nearest, off.x * off.x + off.y * off.y);
  }
  return nearest;
}

// Of a plane's polygons (adjoining buildings may share one) the one that holds the point in plan, else the nearest.
std::size_t polygon_of(const TruePlane& plane, Vec3 p) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; plane.polygons.size() > 1 && i < plane.polygons.size(); ++i) {
    const double d = holds(plane.polygons[i].ring, p) ? -1 : squared_to_ring(plane.polygons[i].ring, p);
    if (d < least) {
      least = d;
      best = i;
    }
  }
  return best;
}

// What the truth says of the kinds of roofs, in the order of buildings.
void read_kinds(const std::filesystem::path& truth, std::vector<Roof>& buildings) {
  std::ifstream in(truth);
  const nlohmann::json kinds = nlohmann::json::parse(in).at("buildings");
  for (std::size_t i = 0; i < buildings.size(); ++i) buildings[i].complex = kinds.at(i).at("roof") == "complex";
}

// Buildings by their true faces, in the order of ids; each polygon of the truth is a label, seen or not.
std::vector<Roof> read_buildings(const std::string& file) {
  std::filesystem::path beside = file;
  beside.replace_extension(".truth.json");
  const Truth truth = read_truth(beside);
  std::map<std::uint32_t, const TruePlane*> planes;
  std::map<std::uint32_t, std::size_t> rank;
  for (const std::uint32_t id : truth.buildings) rank.emplace(id, rank.size());
  std::vector<Roof> buildings(rank.size());
  read_kinds(beside, buildings);
  std::map<std::pair<std::uint32_t, std::size_t>, std::uint32_t> label;
  for (const TruePlane& p : truth.planes) {
    if (p.class_name != "roof") continue;
    planes[p.id] = &p;
    for (std::size_t i = 0; i < p.polygons.size(); ++i)
      label[{p.id, i}] = ++buildings[rank.at(p.polygons[i].building)].labels;
  }
  const auto reader = open_cloud(file);
  const ExtraField field = require_field(reader->info(), "true_plane", FieldType::u32);
  for_each_record(*reader, [&](const std::byte* record) {
    const auto plane = planes.find(static_cast<std::uint32_t>(integer_of(record, field)));
    if (plane == planes.end()) return;
    const Vec3 p = position_of(record, reader->info().layout);
    const std::size_t polygon = polygon_of(*plane->second, p);
    Roof& b = buildings[rank.at(plane->second->polygons[polygon].building)];
    if (b.points.empty()) b.anchor = p;
    b.points.push_back(p - b.anchor);
    b.label.push_back(label.at({plane->first, polygon}));
  });
  return buildings;
}

struct Mesh {
  Triangulation t;
  std::vector<std::uint8_t> keep;  // per triangle
  bool kept(std::uint32_t edge) const { return edge != kNoEdge && keep[edge / 3] != 0; }
  bool on_border(std::uint32_t edge) const { return kept(edge) && !kept(t.twin[edge]); }
};

enum class Distance { kPlan, kSpace };  // versions I and II of the document's erosion

// Takes triangles away from the outside while the edge they show is longer than alpha.
Mesh eroded(const std::vector<Vec3>& points, double alpha, Distance distance) {
  std::vector<Point2> places;
  for (const Vec3& p : points) places.push_back(place_of(p));
  Mesh m{delaunay(places), {}};
  m.keep.assign(m.t.triangles(), 1);
  std::vector<std::uint32_t> open;
  for (std::uint32_t e = 0; e < m.t.corner.size(); ++e)
    if (m.t.twin[e] == kNoEdge) open.push_back(e);
  while (!open.empty()) {
    const std::uint32_t e = open.back();
    open.pop_back();
    if (!m.kept(e)) continue;
    Vec3 d = points[m.t.corner[next_edge(e)]] - points[m.t.corner[e]];
    if (distance == Distance::kPlan) d.z = 0;
    if (norm(d) <= alpha) continue;
    m.keep[e / 3] = 0;
    for (const std::uint32_t other : {next_edge(e), previous_edge(e)})
      if (m.kept(m.t.twin[other])) open.push_back(m.t.twin[other]);
  }
  return m;
}

// The border's edges one after the other, from each unused one until there is no way on; the longest such chain.
std::vector<std::uint32_t> longest_chain(const Mesh& m) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> leaving;
  std::vector<std::uint32_t> border, best;
  for (std::uint32_t e = 0; e < m.t.corner.size(); ++e)
    if (m.on_border(e)) {
      border.push_back(e);
      leaving[m.t.corner[e]].push_back(e);
    }
  std::vector<std::uint8_t> used(m.t.corner.size());
  for (const std::uint32_t first : border) {
    std::vector<std::uint32_t> chain;
    for (std::uint32_t e = first; e != kNoEdge && used[e] == 0;) {
      used[e] = 1;
      chain.push_back(e);
      const auto& ways = leaving[m.t.corner[next_edge(e)]];
      const auto way = std::find_if(ways.begin(), ways.end(), [&](std::uint32_t w) { return used[w] == 0; });
      e = way == ways.end() ? kNoEdge : *way;
    }
    if (chain.size() > best.size()) best = std::move(chain);
  }
  return best;
}

struct Corner {
  Vec3 at;
  std::vector<std::uint32_t> labels;  // of the faces it belongs to
  std::uint32_t after = 0;            // of the border behind it
  std::uint32_t border_edge = kNoEdge;
  bool junction() const { return labels.size() > 1; }
  bool has(std::uint32_t label) const { return std::find(labels.begin(), labels.end(), label) != labels.end(); }
};

// The border's points, and a junction in the middle of each edge between two labels.
std::vector<Corner> contour_of(const Mesh& m, const Roof& b, const std::vector<std::uint32_t>& chain) {
  std::vector<Corner> contour;
  for (const std::uint32_t e : chain) {
    const std::uint32_t p = m.t.corner[e], q = m.t.corner[next_edge(e)];
    contour.push_back({b.points[p], {b.label[p]}, b.label[p], kNoEdge});
    if (b.label[p] != b.label[q])
      contour.push_back({0.5 * (b.points[p] + b.points[q]), {b.label[p], b.label[q]}, b.label[q], e});
  }
  return contour;
}

Corner& around(std::vector<Corner>& ring, std::size_t i, std::size_t by) {
  return ring[(i + by) % ring.size()];
}

double plan_dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y;
}

// Cosine of the angle at b in plan; 1 where two of them coincide.
double cosine_at(Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 u = a - b, v = c - b;
  const double lengths = std::sqrt(plan_dot(u, u) * plan_dot(v, v));
  return lengths > 0 ? plan_dot(u, v) / lengths : 1;
}

// Algorithm 1 of the document.
void smooth(std::vector<Corner>& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    Corner& p = ring[i];
    const Corner &before = around(ring, i, ring.size() - 1), &next = around(ring, i, 1);
    if (p.junction() || !before.has(p.labels[0]) || !next.has(p.labels[0])) continue;
    const Vec3 along = next.at - before.at;
    if (std::abs(cosine_at(before.at, p.at, next.at)) >= 0.8 || dot(along, along) == 0) continue;
    p.at = before.at + (dot(p.at - before.at, along) / dot(along, along)) * along;
  }
}

double cost_of(const Corner& a, const Corner& b, const Corner& c) {
  constexpr double kCosine = 0.70710678118654752;  // of 45 degrees; that of 135 is its negative
  if (b.junction() || std::abs(cosine_at(a.at, b.at, c.at)) <= kCosine) return std::numeric_limits<double>::infinity();
  const Vec3 u = b.at - a.at, v = c.at - a.at;
  return std::abs(u.x * v.y - u.y * v.x) / 2;
}

// Algorithm 2: as long as some corner is flatter than 135 or sharper than 45 degrees, the one of the least triangle
// goes.
void drop_flat(std::vector<Corner>& ring) {
  while (ring.size() > 3) {
    std::size_t least = 0;
    double cost = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const double c = cost_of(around(ring, i, ring.size() - 1), ring[i], around(ring, i, 1));
      if (c < cost) {
        cost = c;
        least = i;
      }
    }
    if (std::isinf(cost)) return;
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(least));
  }
}

// Algorithm 3: one corner within the radius, never one where planes meet.
void thin(std::vector<Corner>& ring, double radius) {
  for (std::size_t i = 0; i < ring.size() && ring.size() > 3;) {
    std::size_t gone = ring.size();
    for (const std::size_t by : {ring.size() - 1, std::size_t{1}}) {
      const std::size_t other = (i + by) % ring.size();
      const Vec3 d = ring[other].at - ring[i].at;
      if (gone != ring.size() || plan_dot(d, d) >= radius * radius) continue;
      gone = !ring[i].junction() ? i : !ring[other].junction() ? other : ring.size();
    }
    if (gone == ring.size())
      ++i;
    else
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(gone));
  }
}

struct Link {
  std::uint32_t to = 0;
  std::uint32_t labels[2]{};  // of the faces on its sides; the border has one twice
  bool has(std::uint32_t label) const { return labels[0] == label || labels[1] == label; }
};

struct Graph {
  std::vector<Corner> corners;
  std::vector<std::vector<Link>> links;
  void join(std::uint32_t a, std::uint32_t b, std::uint32_t left, std::uint32_t right) {
    links[a].push_back({b, {left, right}});
    links[b].push_back({a, {left, right}});
  }
};

constexpr std::uint32_t kNowhere = 0xffffffffu;

// Lines between faces: from each junction, and each end, over the triangles of two labels to the next one.
struct InnerLines {
  const Mesh& m;
  const Roof& b;
  std::map<std::uint32_t, std::uint32_t> of_border_edge, of_triangle;  // corners of the graph

  bool mixed(std::uint32_t e) const { return b.label[m.t.corner[e]] != b.label[m.t.corner[next_edge(e)]]; }
  bool leads_on(std::uint32_t e) const { return mixed(e) && (m.kept(m.t.twin[e]) || of_border_edge.count(e) != 0); }
  int ways(std::uint32_t triangle) const {
    return leads_on(3 * triangle) + leads_on(3 * triangle + 1) + leads_on(3 * triangle + 2);
  }
  // The corner that the line which leaves a triangle over edge e comes to; its last edge in `e`.
  std::uint32_t end_of(std::uint32_t& e) const {
    for (;;) {
      if (!m.kept(m.t.twin[e])) return of_border_edge.at(e);
      const std::uint32_t in = m.t.twin[e];
      const auto corner = of_triangle.find(in / 3);
      if (corner != of_triangle.end()) {
        e = in;
        return corner->second;
      }
      e = leads_on(next_edge(in)) ? next_edge(in) : previous_edge(in);
    }
  }
};

void add_inner(const Mesh& m, const Roof& b, Graph& g) {
  InnerLines lines{m, b, {}, {}};
  for (std::uint32_t i = 0; i < g.corners.size(); ++i)
    if (g.corners[i].border_edge != kNoEdge) lines.of_border_edge[g.corners[i].border_edge] = i;
  for (std::uint32_t t = 0; t < m.keep.size(); ++t) {
    const std::uint32_t c[3]{m.t.corner[3 * t], m.t.corner[3 * t + 1], m.t.corner[3 * t + 2]};
    std::vector<std::uint32_t> labels;
    for (const std::uint32_t p : c)
      if (std::find(labels.begin(), labels.end(), b.label[p]) == labels.end()) labels.push_back(b.label[p]);
    if (m.keep[t] == 0 || labels.size() < 2 || (labels.size() == 2 && lines.ways(t) == 2)) continue;
    lines.of_triangle[t] = static_cast<std::uint32_t>(g.corners.size());
    g.corners.push_back({(1.0 / 3) * (b.points[c[0]] + b.points[c[1]] + b.points[c[2]]), labels, 0, kNoEdge});
  }
  g.links.resize(g.corners.size());
  std::vector<std::uint8_t> done(m.t.corner.size());
  const auto follow = [&](std::uint32_t from, std::uint32_t e) {
    const std::uint32_t left = b.label[m.t.corner[e]], right = b.label[m.t.corner[next_edge(e)]];
    done[e] = 1;
    const std::uint32_t to = lines.end_of(e);
    done[e] = 1;
    if (to != from) g.join(from, to, left, right);
  };
  for (const auto& [triangle, corner] : lines.of_triangle)
    for (std::uint32_t e = 3 * triangle; e < 3 * triangle + 3; ++e)
      if (lines.leads_on(e) && done[e] == 0) follow(corner, e);
  // What is left runs from border to border.
  for (const auto& [edge, corner] : lines.of_border_edge) {
    if (done[edge] != 0 || lines.of_triangle.count(edge / 3) != 0) continue;
    done[edge] = 1;
    follow(corner, lines.leads_on(next_edge(edge)) ? next_edge(edge) : previous_edge(edge));
  }
}

Graph graph_of(const Mesh& m, const Roof& b, double radius) {
  Graph g;
  g.corners = contour_of(m, b, longest_chain(m));
  if (g.corners.size() < 3) return {};
  smooth(g.corners);
  drop_flat(g.corners);
  thin(g.corners, radius);
  g.links.resize(g.corners.size());
  const auto n = static_cast<std::uint32_t>(g.corners.size());
  for (std::uint32_t i = 0; i < n; ++i) g.join(i, (i + 1) % n, g.corners[i].after, g.corners[i].after);
  add_inner(m, b, g);
  return g;
}

enum class Walk { kByVertex, kByEdge };

struct FacePolygon {
  std::uint32_t label = 0;
  std::vector<std::uint32_t> corners;
  bool closed = false;
};

// Algorithm 4: one polygon for each label that some vertex has.
std::vector<FacePolygon> polygons_of(const Graph& g, std::uint32_t labels, Walk walk) {
  std::vector<FacePolygon> result;
  std::vector<std::uint8_t> used(labels + 1);
  for (std::uint32_t s = 0; s < g.corners.size(); ++s)
    for (const std::uint32_t label : g.corners[s].labels) {
      if (used[label] != 0) continue;
      used[label] = 1;
      const auto may = [&](const Link& l) {
        return g.corners[l.to].has(label) && (walk == Walk::kByVertex || l.has(label));
      };
      FacePolygon p{label, {s}, false};
      std::vector<std::uint8_t> visited(g.corners.size());
      visited[s] = 1;
      for (std::uint32_t at = s; at != kNowhere;) {
        std::uint32_t next = kNowhere;
        for (const Link& l : g.links[at])
          if (next == kNowhere && visited[l.to] == 0 && may(l)) next = l.to;
        if (next != kNowhere) {
          visited[next] = 1;
          p.corners.push_back(next);
        }
        at = next;
      }
      for (const Link& l : g.links[p.corners.back()]) p.closed = p.closed || (l.to == s && may(l));
      p.closed = p.closed && p.corners.size() >= 3;
      result.push_back(std::move(p));
    }
  return result;
}

// Twice the area in plan in square millimetres, 0 for what is degenerate or touches itself.
double area_of(const FacePolygon& p, const std::vector<Vec3>& at) {
  std::vector<Point2> ring;
  for (const std::uint32_t c : p.corners) ring.push_back(place_of(at[c]));
  return is_simple_ring(ring) ? static_cast<double>(doubled_area(ring)) : 0;
}

Plane best_plane(const std::vector<Vec3>& points) {
  Vec3 centre;
  for (const Vec3& p : points) centre = centre + p;
  centre = (1.0 / static_cast<double>(points.size())) * centre;
  Symmetric3 s;
  for (const Vec3& p : points) {
    const Vec3 d = p - centre;
    s.xx += d.x * d.x;
    s.xy += d.x * d.y;
    s.xz += d.x * d.z;
    s.yy += d.y * d.y;
    s.yz += d.y * d.z;
    s.zz += d.z * d.z;
  }
  const Vec3 n = eigen_symmetric(s).vectors[0];
  return {n, -dot(n, centre)};
}

// Where three planes meet; false where their normals lie in one plane.
bool meet(const Plane& a, const Plane& b, const Plane& c, Vec3& at) {
  constexpr double kSingular = 1e-9;
  const double det = dot(a.n, cross(b.n, c.n));
  if (std::abs(det) < kSingular) return false;
  at = (-1 / det) * (a.d * cross(b.n, c.n) + b.d * cross(c.n, a.n) + c.d * cross(a.n, b.n));
  return true;
}

// [D9] Onto one plane, the line of two, the point of three.
bool project(const std::vector<Plane>& of_label, const Corner& c, Vec3& at) {
  const Plane& a = of_label[c.labels[0]];
  at = c.at - signed_distance(a, c.at) * a.n;
  if (c.labels.size() == 1) return true;
  const Plane& b = of_label[c.labels[1]];
  if (c.labels.size() > 2) return meet(a, b, of_label[c.labels[2]], at);
  const Vec3 along = cross(a.n, b.n);
  const double length = norm(along);
  if (length == 0) return false;
  const Vec3 n = (1 / length) * along;
  return meet(a, b, {n, -dot(n, c.at)}, at);
}

struct Row {
  std::string labels, distance, walk;
  std::size_t buildings = 0, faces = 0, polygons = 0, open = 0, degenerate = 0, lost = 0;
  std::size_t closed = 0, closed_all = 0, right = 0, right_all = 0;
  std::size_t lines = 0, other_closed = 0, other_right = 0;  // polygons of two corners; buildings without these
  std::size_t complex = 0, complex_closed = 0, complex_right = 0;
  std::size_t parallel = 0, moved = 0, not_planar = 0, crossed = 0;  // buildings, by the first fault
};

enum class Fault { kNone, kParallel, kMoved, kNotPlanar, kCrossed };

Fault projected(const Graph& g, const std::vector<FacePolygon>& polygons, const std::vector<Plane>& planes,
                double move) {
  std::vector<Vec3> before, after;
  std::vector<std::uint8_t> wanted(g.corners.size());
  for (const FacePolygon& p : polygons)
    for (const std::uint32_t c : p.corners) wanted[c] = 1;
  bool moved = false, planar = true;
  for (std::size_t i = 0; i < g.corners.size(); ++i) {
    const Corner& c = g.corners[i];
    before.push_back(c.at);
    after.push_back(c.at);
    if (wanted[i] == 0) continue;
    if (!project(planes, c, after.back())) return Fault::kParallel;
    const Vec3 d = after.back() - c.at;
    moved = moved || !(plan_dot(d, d) < move * move);
    for (const std::uint32_t label : c.labels)
      planar = planar && std::abs(signed_distance(planes[label], after.back())) <= kPlanar;
  }
  if (moved) return Fault::kMoved;
  if (!planar) return Fault::kNotPlanar;
  for (const FacePolygon& p : polygons)
    if (area_of(p, before) * area_of(p, after) <= 0) return Fault::kCrossed;
  return Fault::kNone;
}

std::vector<Plane> planes_of(const Roof& b) {
  std::vector<std::vector<Vec3>> members(b.labels + 1);
  for (std::size_t i = 0; i < b.points.size(); ++i) members[b.label[i]].push_back(b.points[i]);
  std::vector<Plane> planes(members.size());
  for (std::size_t l = 1; l < members.size(); ++l)
    if (!members[l].empty()) planes[l] = best_plane(members[l]);
  return planes;
}

// No polygon is open or degenerate.
bool all_closed(const Graph& g, const std::vector<FacePolygon>& polygons) {
  std::vector<Vec3> at;
  for (const Corner& c : g.corners) at.push_back(c.at);
  return !polygons.empty() && std::all_of(polygons.begin(), polygons.end(),
                                          [&](const FacePolygon& p) { return p.closed && area_of(p, at) != 0; });
}

void count_without_lines(const Roof& b, const Graph& g, std::vector<FacePolygon> polygons, double move, Row& row) {
  const std::size_t all = polygons.size();
  std::erase_if(polygons, [](const FacePolygon& p) { return p.corners.size() <= 2; });
  row.lines += all - polygons.size();
  if (!all_closed(g, polygons)) return;
  ++row.other_closed;
  row.other_right += projected(g, polygons, planes_of(b), move) == Fault::kNone;
}

void count(const Roof& b, const Graph& g, Walk walk, double move, Row& row) {
  const std::vector<FacePolygon> polygons = polygons_of(g, b.labels, walk);
  std::vector<Vec3> at;
  for (const Corner& c : g.corners) at.push_back(c.at);
  std::size_t open = 0, degenerate = 0;
  for (const FacePolygon& p : polygons) {
    open += !p.closed;
    degenerate += p.closed && area_of(p, at) == 0;
  }
  const std::size_t lost = b.labels - polygons.size();
  const bool closed = all_closed(g, polygons);
  count_without_lines(b, g, polygons, move, row);
  ++row.buildings;
  row.faces += b.labels;
  row.polygons += polygons.size();
  row.open += open;
  row.degenerate += degenerate;
  row.lost += lost;
  row.closed += closed;
  row.closed_all += closed && lost == 0;
  row.complex += b.complex;
  row.complex_closed += b.complex && closed;
  if (!closed) return;
  const Fault fault = projected(g, polygons, planes_of(b), move);
  row.right += fault == Fault::kNone;
  row.right_all += fault == Fault::kNone && lost == 0;
  row.complex_right += b.complex && fault == Fault::kNone;
  row.parallel += fault == Fault::kParallel;
  row.moved += fault == Fault::kMoved;
  row.not_planar += fault == Fault::kNotPlanar;
  row.crossed += fault == Fault::kCrossed;
}

// Our planes as labels: pieces of a plane that the mesh holds together, without the points that have none.
Roof relabelled(const Roof& truth, const Options& options) {
  RoofSite site;
  site.points = truth.points;
  const RoofPlanes planes = find_roof_planes(site, {});
  Roof on{truth.anchor, {}, {}, 0, truth.complex};
  for (std::size_t i = 0; i < truth.points.size(); ++i)
    if (planes.of_point[i] != 0) {
      on.points.push_back(truth.points[i]);
      on.label.push_back(planes.of_point[i]);
    }
  const Mesh m = eroded(on.points, options.alpha, Distance::kPlan);
  std::vector<std::vector<std::uint32_t>> near(on.points.size());
  for (std::uint32_t e = 0; e < m.t.corner.size(); ++e) {
    const std::uint32_t p = m.t.corner[e], q = m.t.corner[next_edge(e)];
    if (!m.kept(e) || on.label[p] != on.label[q]) continue;
    near[p].push_back(q);
    near[q].push_back(p);
  }
  Roof result{truth.anchor, {}, {}, 0, truth.complex};
  std::vector<std::uint8_t> seen(on.points.size());
  for (std::uint32_t s = 0; s < on.points.size(); ++s) {
    if (seen[s] != 0) continue;
    std::vector<std::uint32_t> piece{s};
    seen[s] = 1;
    for (std::size_t i = 0; i < piece.size(); ++i)
      for (const std::uint32_t q : near[piece[i]])
        if (seen[q] == 0) {
          seen[q] = 1;
          piece.push_back(q);
        }
    if (piece.size() < options.least) continue;
    ++result.labels;
    for (const std::uint32_t p : piece) {
      result.points.push_back(on.points[p]);
      result.label.push_back(result.labels);
    }
  }
  return result;
}

std::vector<Row> measure(const std::string& name, const std::vector<Roof>& buildings, const Options& options) {
  std::vector<Row> rows;
  for (const auto& [distance, distance_name] : {std::pair(Distance::kPlan, "I"), std::pair(Distance::kSpace, "II")}) {
    Row by_vertex{name, distance_name, "by vertex"}, by_edge{name, distance_name, "by edge"};
    for (const Roof& b : buildings) {
      const Graph g = graph_of(eroded(b.points, options.alpha, distance), b, options.radius);
      count(b, g, Walk::kByVertex, options.move, by_vertex);
      count(b, g, Walk::kByEdge, options.move, by_edge);
    }
    rows.push_back(by_vertex);
    rows.push_back(by_edge);
  }
  return rows;
}

struct Ours {
  std::size_t models = 0, closed = 0, right = 0, faces = 0;
};

// A roof face of a model: its corners within 1 cm of one plane, its outer ring simple in plan.
bool is_right(const PolygonModel& m, const PolygonFace& face) {
  const auto& ring = face.rings.at(0);
  const Vec3 first = m.vertices[ring[0]];
  std::vector<Point2> plan;
  Vec3 centre;
  for (const std::uint32_t v : ring) {
    plan.push_back(place_of(m.vertices[v] - first));
    centre = centre + (1.0 / static_cast<double>(ring.size())) * (m.vertices[v] - first);
  }
  const Vec3 normal = face_normal(m, face);
  const double length = norm(normal);
  if (length == 0 || !is_simple_ring(plan)) return false;
  for (const auto& r : face.rings)
    for (const std::uint32_t v : r)
      if (std::abs(dot(normal, m.vertices[v] - first - centre)) > kPlanar * length) return false;
  return true;
}

Ours judge_models(const std::string& file) {
  Ours ours;
  for (const PolygonModel& m : read_models(file).models) {
    const std::vector<bool> roof = roof_faces(m);
    bool right = true;
    for (std::size_t i = 0; i < m.faces.size(); ++i)
      if (roof[i]) {
        ++ours.faces;
        right = right && is_right(m, m.faces[i]);
      }
    ++ours.models;
    const bool closed = is_closed(m);
    ours.closed += closed;
    ours.right += closed && right;
  }
  return ours;
}

double percent(std::size_t n, std::size_t of) {
  return of == 0 ? 0 : 100 * static_cast<double>(n) / static_cast<double>(of);
}

// Percent of all, of gables and hips, of complex roofs.
std::string shares(const Row& r, std::size_t all, std::size_t complex) {
  return fmt::format("{:.1f} ({:.1f}, {:.1f})", percent(all, r.buildings),
                     percent(all - complex, r.buildings - r.complex), percent(complex, r.complex));
}

void print_row(const Row& r) {
  fmt::print("| {} | {} | {} | {} | {} | {} | ", r.labels, r.distance, r.walk, r.buildings,
             shares(r, r.closed, r.complex_closed), shares(r, r.right, r.complex_right));
  for (const std::size_t n : {r.closed_all, r.right_all, r.other_closed, r.other_right})
    fmt::print("{:.1f} | ", percent(n, r.buildings));
  fmt::print("{} / {} / {} / {} | {} / {} / {} / {} |\n", r.open, r.lines, r.degenerate, r.lost, r.parallel, r.moved,
             r.not_planar, r.crossed);
}

nlohmann::ordered_json json_of(const Row& r) {
  return {{"labels", r.labels},
          {"erosion", r.distance},
          {"walk", r.walk},
          {"buildings", r.buildings},
          {"faces", r.faces},
          {"polygons", r.polygons},
          {"closed", r.closed},
          {"closed_no_face_lost", r.closed_all},
          {"projected", r.right},
          {"projected_no_face_lost", r.right_all},
          {"complex", r.complex},
          {"complex_closed", r.complex_closed},
          {"complex_projected", r.complex_right},
          {"closed_lines_left_out", r.other_closed},
          {"projected_lines_left_out", r.other_right},
          {"faces_line", r.lines},
          {"faces_open", r.open},
          {"faces_degenerate", r.degenerate},
          {"faces_lost", r.lost},
          {"failed_parallel", r.parallel},
          {"failed_moved", r.moved},
          {"failed_not_planar", r.not_planar},
          {"failed_crossed", r.crossed}};
}

Options options_of(int argc, char** argv) {
  Options o;
  for (int i = 1; i < argc; ++i) {
    const std::string key = argv[i];
    if (key.rfind("--", 0) != 0) {
      o.cloud = key;
      continue;
    }
    if (i + 1 == argc) throw std::runtime_error(key + " needs a value");
    const std::string value = argv[++i];
    if (key == "--models")
      o.models = value;
    else if (key == "--alpha")
      o.alpha = std::stod(value);
    else if (key == "--radius")
      o.radius = std::stod(value);
    else if (key == "--move")
      o.move = std::stod(value);
    else if (key == "--least")
      o.least = static_cast<std::uint32_t>(std::stoul(value));
    else
      throw std::runtime_error("no option " + key);
  }
  if (o.cloud.empty())
    throw std::runtime_error(
        "usage: bench_document_roofs ROOFS.laz [--models ROOFS.city.jsonl] [--alpha M] [--radius M] [--move M] "
        "[--least POINTS]");
  return o;
}

}  // namespace

int main(int argc, char** argv) try {
  const Options options = options_of(argc, argv);
  const std::vector<Roof> truth = read_buildings(options.cloud);
  std::vector<Roof> found;
  for (const Roof& b : truth) found.push_back(relabelled(b, options));
  std::vector<Row> rows = measure("true faces", truth, options);
  for (Row& r : measure("our planes", found, options)) rows.push_back(std::move(r));
  fmt::print(
      "| labels | erosion | walk | buildings | closed, % (gables and hips, complex) | after projection | closed and no "
      "face lost, % | after projection | closed, lines left out, % | after projection | faces open / of these lines / "
      "degenerate / lost | buildings failed: parallel / moved / not planar / crossed |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  nlohmann::ordered_json line{{"bench", "document_roofs"},
                              {"alpha_m", options.alpha},
                              {"radius_m", options.radius},
                              {"move_m", options.move},
                              {"rows", nlohmann::ordered_json::array()}};
  for (const Row& r : rows) {
    print_row(r);
    line["rows"].push_back(json_of(r));
  }
  if (!options.models.empty()) {
    const Ours ours = judge_models(options.models);
    fmt::print("| our models | | | {} | {:.1f} | {:.1f} | | | | | | |\n", ours.models,
               percent(ours.closed, ours.models), percent(ours.right, ours.models));
    line["models"] = {
        {"models", ours.models}, {"roof_faces", ours.faces}, {"closed", ours.closed}, {"closed_planar", ours.right}};
  }
  fmt::print("{}\n", line.dump());
} catch (const std::exception& fault) {
  fmt::print(stderr, "bench_document_roofs: {}\n", fault.what());
  return 1;
}
