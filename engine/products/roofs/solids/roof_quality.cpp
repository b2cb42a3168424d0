// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/roof_quality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/model/polygon_model.h"
#include "engine/products/roofs/sites/outline_repair.h"

namespace ilot {
namespace {

// Choice: the distance within which published comparisons of roofs count a point as near.
constexpr double kNear = 0.2;  // metres

Vec3 from_anchor(Vec3 p, const RoofSite& site, double metres_per_unit) {
  return metres_per_unit * (p - site.anchor);
}

// The plane of a face by Newell's normal, whose length is twice the area, through the mean of the ring; metres from the
// anchor.
MeasuredFace face_of(const Building& building, const BuildingSurface& surface, const RoofSite& site,
                     double metres_per_unit) {
  Vec3 normal{0, 0, 0}, mean{0, 0, 0};
  const auto at = [&](std::uint32_t v) { return from_anchor(building.vertices[v], site, metres_per_unit); };
  for (const auto& ring : surface.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec3 a = at(ring[i]), b = at(ring[(i + 1) % ring.size()]);
      normal = normal + cross(a, b);
      if (&ring == &surface.rings.front()) mean = mean + a;
    }
  }
  const double length = norm(normal);
  if (surface.rings.empty() || !(length > 0)) return {};
  const Vec3 n = (1 / length) * normal;
  return {{n, -dot(n, (1.0 / static_cast<double>(surface.rings.front().size())) * mean)}, length / 2};
}

std::map<std::uint32_t, MeasuredFace> roof_faces_of(const RoofModel& model, const RoofSite& site,
                                                    double metres_per_unit) {
  std::map<std::uint32_t, MeasuredFace> faces;
  for (const BuildingSurface& s : model.lod22.surfaces) {
    if (s.kind != SurfaceKind::roof) continue;
    const MeasuredFace face = face_of(model.lod22, s, site, metres_per_unit);
    MeasuredFace& known = faces[s.plane_id];
    if (face.area > known.area) known = face;
  }
  return faces;
}

const Building& finest(const RoofModel& model) {
  return model.lod22.surfaces.empty() ? model.lod12 : model.lod22;
}

std::vector<Triangle3> triangles_of(const Building& building, const RoofSite& site, double metres_per_unit) {
  PolygonModel model;
  for (const Vec3& v : building.vertices) model.vertices.push_back(from_anchor(v, site, metres_per_unit));
  std::vector<Triangle3> triangles;
  for (const BuildingSurface& s : building.surfaces) {
    PolygonFace face;
    face.rings = s.rings;
    append_triangles(model, face, triangles);
  }
  return triangles;
}

double top_of(const Building& building, const RoofSite& site, double metres_per_unit) {
  double top = -HUGE_VAL;
  for (const Vec3& v : building.vertices) top = std::max(top, from_anchor(v, site, metres_per_unit).z);
  return top;
}

// The limits from which a roof is to be checked, and those from which it is called bad.
struct Limits {
  double off_m2, explained, bare, overshoot;
};
// Choice: 3 m2 is the least part of a roof whose loss counts, and half of a cell around it is on the model. A sixth of
// the points may be on small objects that no roof shows. A roof may rise above its points by roofs.overshoot and noise.
constexpr Limits kCheck{2, 0.85, 0.1, 0.6}, kBad{12, 0.6, 0.5, 2};

// Choice: the share of points whose residual is stated as p95_m.
constexpr double kMostPoints = 0.95;

// What is wrong by these limits; empty when nothing is.
std::string fault(const Limits& limits, const PointMeasures& m, double off, double bare, double overshoot) {
  if (off > limits.off_m2) return fmt::format("{:.1f} m2 of points in one place lie off the model", off);
  if (m.explained() < limits.explained)
    return fmt::format("{:.0f} % of the points lie farther than {:.2f} m from the model", 100 * (1 - m.explained()),
                       m.reach());
  if (bare > limits.bare) return fmt::format("{:.0f} % of the roof is without a point within 1 m", 100 * bare);
  if (overshoot > limits.overshoot) return fmt::format("the roof rises {:.1f} m above the points", overshoot);
  return {};
}

}  // namespace

PointMeasures::PointMeasures(const RoofSite& site, const RoofModel& model, double metres_per_unit)
    : faces_(roof_faces_of(model, site, metres_per_unit)),
      surface_(triangles_of(finest(model), site, metres_per_unit)),
      reach_(std::max(kNear, model.map.epsilon)),
      top_(top_of(finest(model), site, metres_per_unit)),
      area_(area_of(site.outline)),
      solid_(!finest(model).surfaces.empty()),
      raster_(solid_ ? site : RoofSite{}, model, top_) {}

void PointMeasures::add(Vec3 p, std::uint32_t face) {
  ++points_;
  if (face == 0) ++off_;
  (face != 0 ? on_faces_ : off_faces_).add(p.z);
  highest_ = std::max(highest_, p.z);
  if (!solid_) return;
  const auto at = face == 0 ? faces_.end() : faces_.find(face);
  const double d = at != faces_.end() ? std::abs(signed_distance(at->second.plane, p))
                                      : std::sqrt(surface_.nearest(p).squared_distance);
  squares_ += d * d;
  distances_.add(d);
  explained_ += d <= reach_;
  raster_.add(p, d > reach_);
}

double PointMeasures::rmse() const {
  return measured() ? std::sqrt(squares_ / static_cast<double>(distances_.count())) : NAN;
}

double PointMeasures::quantile(double share) {
  if (!measured()) return NAN;
  return distances_.nth(static_cast<std::uint64_t>(share * static_cast<double>(distances_.count() - 1)));
}

double PointMeasures::explained() const {
  return measured() ? static_cast<double>(explained_) / static_cast<double>(distances_.count()) : NAN;
}

double PointMeasures::overshoot() const {
  return measured() ? std::max(raster_.overshoot(), top_ - highest_) : NAN;
}

double PointMeasures::step() const {
  return points_ > 0 ? std::sqrt(area_ / static_cast<double>(points_)) : INFINITY;
}

RoofVerdict PointMeasures::verdict(RoofStatus status) {
  if (status == RoofStatus::footprint_only || !measured()) return {"bad", "there is no solid"};
  const double off = largest_off(), bare = bare_share(), above = overshoot();
  Limits bad = kBad;
  bad.off_m2 = std::min(bad.off_m2, std::max(kCheck.off_m2, area_ / 3));  // a third of a small building
  if (std::string reason = fault(bad, *this, off, bare, above); !reason.empty()) return {"bad", reason};
  if (std::string reason = fault(kCheck, *this, off, bare, above); !reason.empty()) return {"check", reason};
  if (const double p95 = quantile(kMostPoints); p95 > reach_ + step())
    return {"check", fmt::format("5 % of the points lie farther than {:.2f} m from the model", p95)};
  if (status != RoofStatus::lod22) return {"check", "a level block without faces"};
  return {"good", {}};
}

}  // namespace ilot
