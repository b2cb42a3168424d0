// SPDX-License-Identifier: Apache-2.0
#include "scan/facades/facade_builder.h"

#include <algorithm>
#include <cmath>

#include "scan/optics/arch.h"
#include "scan/optics/exact_math.h"

namespace ilot::scan {
namespace {

Plane plane_through(const std::vector<Vec3>& ring) {
  Vec3 area{0, 0, 0};
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) area = area + cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  const Vec3 normal = (1 / norm(area)) * area;
  return {normal, -dot(normal, ring[0])};
}

// Returns the corners of a head of several arcs between its springings, from right to left.
std::vector<FlatPoint> head_points(const Opening& opening, double chord_deg) {
  std::vector<FlatPoint> points;
  for (const ArchArc& arc : arcs_of(opening)) {
    const int chords = std::max(2, static_cast<int>(std::ceil((arc.to_deg - arc.from_deg) / chord_deg)));
    for (int i = 1; i <= chords; ++i) {
      const SinCos turn = sin_cos_deg(arc.from_deg + (arc.to_deg - arc.from_deg) * i / chords);
      points.push_back({arc.centre.x + arc.radius * turn.cos, arc.centre.y + arc.radius * turn.sin});
    }
  }
  points.pop_back();  // the left springing
  return points;
}

}  // namespace

double top_of(const Opening& opening) {
  return opening.springing + opening.rise;
}

// The tangent of this angle is half / (radius - rise). By the half-angle formula, the tangent of half of this angle is
// rise / half.
double arch_half_angle_deg(const Opening& opening) {
  return 2 * atan_deg(opening.rise / ((opening.right - opening.left) / 2));
}

std::uint32_t FacadeBuilder::add_element(TrueElement element) {
  element.id = static_cast<std::uint32_t>(scene_.elements.size() + 1);
  element.facade = facade_;
  scene_.elements.push_back(std::move(element));
  return scene_.elements.back().id;
}

void FacadeBuilder::add_opening(std::uint32_t element, std::vector<Vec3> ring) {
  const auto id = static_cast<std::uint32_t>(scene_.openings.size() + 1);
  scene_.openings.push_back({id, element, facade_, std::move(ring)});
}

void FacadeBuilder::control_point(const char* group, std::uint32_t element, double x, double out, double z) {
  scene_.control_points.push_back({group, element, frame_.place(x, out, z)});
}

SurfaceId FacadeBuilder::surface(const Finish& finish, std::uint32_t plane) {
  return scene_.model.add_surface({finish.surface_class, plane, finish.element, finish.material, finish.tone});
}

std::uint32_t FacadeBuilder::own_plane(const Plane& plane, const Finish& finish, std::vector<Vec3> ring) {
  const std::uint32_t id = next_id();
  TruePlane added{id, scene_.classes.at(finish.surface_class), plane, 0, finish.element, {}};
  added.polygons.push_back({0, std::move(ring), {}});
  scene_.planes.push_back(std::move(added));
  return id;
}

std::uint32_t FacadeBuilder::plane_parallel(double out, const Finish& finish, TruePolygon polygon) {
  constexpr double kTouch = 1e-5;  // metres
  if (!frame_.form.flat()) return bowed_plane(finish, std::move(polygon));
  FlatPoint low{1e9, 1e9}, high{-1e9, -1e9};
  for (Vec3 p : polygon.ring) {
    const double x = dot(frame_.along, p - frame_.origin), z = p.z - frame_.origin.z;
    low = {std::min(low.x, x), std::min(low.y, z)};
    high = {std::max(high.x, x), std::max(high.y, z)};
  }
  std::vector<Piece>& pieces = parallel_[{std::llround(out * 1e4), finish.surface_class}];
  const auto touching = std::find_if(pieces.begin(), pieces.end(), [&](const Piece& piece) {
    return piece.low.x < high.x + kTouch && piece.low.y < high.y + kTouch && low.x < piece.high.x + kTouch &&
           low.y < piece.high.y + kTouch;
  });
  if (touching != pieces.end()) {
    const std::size_t known = touching->plane;
    pieces.push_back({low, high, known});
    TruePlane& plane = scene_.planes[known];
    plane.polygons.push_back(std::move(polygon));
    if (plane.element != finish.element) plane.element = 0;  // several elements share the plane
    return plane.id;
  }
  const Plane plane{frame_.out, -dot(frame_.out, frame_.origin + out * frame_.out)};
  const std::uint32_t id = own_plane(plane, finish, {});
  scene_.planes.back().polygons = {std::move(polygon)};
  pieces.push_back({low, high, scene_.planes.size() - 1});
  return id;
}

std::vector<Vec3> FacadeBuilder::outline(const Opening& opening, double out, double chord_deg) const {
  std::vector<Vec3> ring{frame_.place(opening.left, out, opening.bottom),
                         frame_.place(opening.right, out, opening.bottom),
                         frame_.place(opening.right, out, opening.springing)};
  if (opening.head != ArchHead::circular) {
    for (FlatPoint p : head_points(opening, chord_deg)) ring.push_back(frame_.place(p.x, out, p.y));
  } else if (opening.rise > 0) {
    const double radius = arch_radius(opening), half = arch_half_angle_deg(opening);
    const double x = (opening.left + opening.right) / 2, z = top_of(opening) - radius;
    const int chords = std::max(2, static_cast<int>(std::ceil(2 * half / chord_deg)));
    for (int i = 1; i < chords; ++i) {
      const SinCos angle = sin_cos_deg(half - 2 * half * i / chords);
      ring.push_back(frame_.place(x + radius * angle.sin, out, z + radius * angle.cos));
    }
  }
  ring.push_back(frame_.place(opening.left, out, opening.springing));
  return ring;
}

// A wall that leans or bows has the plane in least squares through its corners and the middles of its sides.
std::uint32_t FacadeBuilder::bowed_plane(const Finish& finish, TruePolygon polygon) {
  FlatPoint low{1e9, 1e9}, high{-1e9, -1e9};
  double outs = 0, forms = 0;
  for (Vec3 p : polygon.ring) {
    const double x = dot(frame_.along, p - frame_.origin), z = p.z - frame_.origin.z;
    low = {std::min(low.x, x), std::min(low.y, z)};
    high = {std::max(high.x, x), std::max(high.y, z)};
    outs += dot(frame_.out, p - frame_.origin);
    forms += frame_.form.at(x, z);
  }
  const FormPlane f = plane_of_form(frame_.form, low.x, high.x, low.y, high.y);
  const double out = (outs - forms) / static_cast<double>(polygon.ring.size()) + f.base;
  const Vec3 normal = frame_.out - f.along * frame_.along - f.up * kUp;
  const Vec3 unit = (1 / norm(normal)) * normal;
  const std::uint32_t id = own_plane({unit, -dot(unit, frame_.origin + out * frame_.out)}, finish, {});
  scene_.planes.back().polygons = {std::move(polygon)};
  return id;
}

void FacadeBuilder::wall(double x0, double x1, double z0, double z1, double out, const std::vector<Opening>& openings,
                         const Finish& finish) {
  wall(x0, x1, z0, z1, out, openings, finish, {}, finish);
}

Panel FacadeBuilder::panel_of(double x0, double x1, double z0, double z1, double out,
                              const std::vector<Opening>& openings, TruePolygon& polygon) const {
  polygon.ring = {frame_.place(x0, out, z0), frame_.place(x1, out, z0), frame_.place(x1, out, z1),
                  frame_.place(x0, out, z1)};
  Panel panel{frame_.origin + x0 * frame_.along + out * frame_.out, frame_.along, kUp, {}, {}, 0};
  const double w = x1 - x0, e = kOverlap;
  panel.ring = {{-e, z0 - e}, {w + e, z0 - e}, {w + e, z1 + e}, {-e, z1 + e}};
  for (Opening o : openings) {
    if (o.right <= x0 || o.left >= x1 || top_of(o) <= z0 || o.bottom >= z1) continue;
    polygon.holes.push_back(outline(o, out));
    std::reverse(polygon.holes.back().begin(), polygon.holes.back().end());
    o.left -= x0;
    o.right -= x0;
    panel.openings.push_back(o);
  }
  return panel;
}

void FacadeBuilder::wall(double x0, double x1, double z0, double z1, double out, const std::vector<Opening>& openings,
                         const Finish& finish, const WallRelief& relief, const Finish& joint) {
  TruePolygon polygon;
  Panel panel = panel_of(x0, x1, z0, z1, out, openings, polygon);
  const std::uint32_t plane = plane_parallel(out, finish, std::move(polygon));
  panel.surface = surface(finish, plane);
  if (frame_.form.flat() && relief.most() == 0) return add(std::move(panel));
  const SurfaceId joint_surface = relief.joint > 0 ? surface(joint) : panel.surface;
  add(Sheet{std::move(panel), x0, 0, frame_.form, relief, joint_surface});
}

void FacadeBuilder::plate(const std::vector<Vec3>& ring, const Finish& finish, Faces faces) {
  std::vector<Vec3> places;
  for (Vec3 p : ring) places.push_back(frame_.place(p.x, p.y, p.z));
  const Plane plane = plane_through(places);
  const Vec3 first = places[1] - places[0];
  Panel panel{places[0], (1 / norm(first)) * first, {}, {}, {}, 0};
  panel.v = cross(plane.n, panel.u);
  FlatPoint middle;
  for (Vec3 p : places) {
    panel.ring.push_back({dot(panel.u, p - panel.origin), dot(panel.v, p - panel.origin)});
    middle.x += panel.ring.back().x / static_cast<double>(places.size());
    middle.y += panel.ring.back().y / static_cast<double>(places.size());
  }
  for (FlatPoint& p : panel.ring) {  // a little larger, so that no ray passes its edge
    const double dx = p.x - middle.x, dy = p.y - middle.y, grow = 1 + 2 * kOverlap / std::sqrt(dx * dx + dy * dy);
    p = {middle.x + grow * dx, middle.y + grow * dy};
  }
  panel.surface = surface(finish, faces == Faces::true_planes ? own_plane(plane, finish, places) : 0);
  add(std::move(panel));
}

void FacadeBuilder::sweep(const std::vector<Vec3>& ring, Vec3 way, const Finish& finish, Faces faces) {
  Solid solid = prism(ring, way, surface(finish));
  if (faces == Faces::true_planes) {
    const std::size_t n = ring.size();
    for (std::size_t face = 0; face < n + 2; ++face) {
      const Plane& plane = solid.planes[face];
      if (dot(plane.n, frame_.out) < -0.999) continue;  // the back of the block
      std::vector<Vec3> outline;
      if (face < n)
        outline = {ring[face], ring[(face + 1) % n], ring[(face + 1) % n] + way, ring[face] + way};
      else
        for (Vec3 p : ring) outline.push_back(face == n ? p : p + way);
      if (dot(plane_through(outline).n, plane.n) < 0) std::reverse(outline.begin(), outline.end());
      const bool parallel = dot(plane.n, frame_.out) > 1 - 1e-12;
      const double out = dot(frame_.out, outline[0] - frame_.origin);
      const std::uint32_t id = parallel ? plane_parallel(out, finish, {0, std::move(outline), {}})
                                        : own_plane(plane, finish, std::move(outline));
      solid.surfaces[face] = surface(finish, id);
    }
  }
  add(solid);
}

void FacadeBuilder::block(const Block& b, const Finish& finish, Faces faces) {
  relief({{b.x0, b.z0}, {b.x1, b.z0}, {b.x1, b.z1}, {b.x0, b.z1}}, b.out0, b.out1, finish, faces);
}

void FacadeBuilder::moulding(const std::vector<FlatPoint>& profile, double x0, double x1, const Finish& finish,
                             Faces faces) {
  std::vector<Vec3> ring;
  for (FlatPoint p : profile) ring.push_back(frame_.place(x0, p.x, p.y));
  sweep(ring, (x1 - x0) * frame_.along, finish, faces);
}

void FacadeBuilder::relief(const std::vector<FlatPoint>& shape, double out0, double out1, const Finish& finish,
                           Faces faces) {
  std::vector<Vec3> ring;
  for (FlatPoint p : shape) ring.push_back(frame_.place(p.x, out0, p.y));
  sweep(ring, (out1 - out0) * frame_.out, finish, faces);
}

void FacadeBuilder::post(double x, double out, double z0, double z1, double radius, const Finish& finish) {
  add(cylinder(frame_.place(x, out, z0), kUp, z1 - z0, radius, surface(finish)));
}

void FacadeBuilder::reveal(const Opening& o, double out0, double out1, const Finish& finish, Ledge ledge) {
  const double front = out0 + kOverlap, back = out1 - kOverlap;
  const double b = o.bottom, s = o.springing;
  plate({{o.left, back, b}, {o.left, back, s}, {o.left, front, s}, {o.left, front, b}}, finish);
  plate({{o.right, front, b}, {o.right, front, s}, {o.right, back, s}, {o.right, back, b}}, finish);
  if (ledge == Ledge::with)
    plate({{o.left, back, b}, {o.left, front, b}, {o.right, front, b}, {o.right, back, b}}, finish);
  if (!(o.rise > 0)) {
    plate({{o.left, back, s}, {o.right, back, s}, {o.right, front, s}, {o.left, front, s}}, finish);
    return;
  }
  if (o.head == ArchHead::circular && frame_.form.flat()) return soffit(o, out0, out1, finish);
  // Chords of 3 degrees lie within a millimetre of the arcs.
  std::vector<FlatPoint> head = head_points(o, 3);
  head.insert(head.begin(), {o.right, s});
  head.push_back({o.left, s});
  for (std::size_t i = 0; i + 1 < head.size(); ++i) {
    const FlatPoint right = head[i], left = head[i + 1];
    plate({{left.x, back, left.y}, {right.x, back, right.y}, {right.x, front, right.y}, {left.x, front, left.y}},
          finish, Faces::unnamed);
  }
}

// Adds the soffit of a circular arch.
void FacadeBuilder::soffit(const Opening& o, double out0, double out1, const Finish& finish) {
  const double front = out0 + kOverlap, back = out1 - kOverlap;
  const double radius = arch_radius(o), x = (o.left + o.right) / 2, z = top_of(o) - radius;
  TrueShape soffit{next_id(), "cylinder", frame_.place(x, out1, z), frame_.out, radius, 0, out0 - out1, 0};
  Shell shell;
  shell.quadric = {Quadric::Kind::cylinder, soffit.point, frame_.out, radius, 0};
  const Vec3 low = frame_.place(x, back, o.springing - kOverlap), high = frame_.place(x, front, 0);
  shell.clips = {Plane{-1.0 * kUp, dot(kUp, low)}, Plane{frame_.out, -dot(frame_.out, high)},
                 Plane{-1.0 * frame_.out, dot(frame_.out, low)}};
  const std::array corners{frame_.place(o.left, front, o.springing - kOverlap), frame_.place(o.right, back, top_of(o)),
                           frame_.place(o.left, back, top_of(o)), frame_.place(o.right, front, o.springing)};
  shell.bounds = {corners[0], corners[0]};
  for (Vec3 p : corners) {
    shell.bounds.min = {std::min(shell.bounds.min.x, p.x), std::min(shell.bounds.min.y, p.y),
                        std::min(shell.bounds.min.z, p.z)};
    shell.bounds.max = {std::max(shell.bounds.max.x, p.x), std::max(shell.bounds.max.y, p.y),
                        std::max(shell.bounds.max.z, p.z)};
  }
  shell.surface = surface(finish, soffit.id);
  scene_.shapes.push_back(std::move(soffit));
  add(std::move(shell));
}

}  // namespace ilot::scan
