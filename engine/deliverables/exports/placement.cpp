// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/placement.h"

#include <cmath>
#include <numbers>

#include "engine/error.h"
#include "engine/formats/crs.h"

namespace ilot {
namespace {

constexpr int kGeocentric = 4978, kGeodetic = 4979;  // EPSG: WGS 84 as x, y, z, and as longitude, latitude, height

bool is_known(const Crs& crs) {
  return !crs.wkt.empty() || crs.epsg != 0;
}

bool is_finite(Vec3 p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace

Placement::Placement(const ExportFrame& frame, double geoid_m) : frame_(frame), geoid_m_(geoid_m) {
  if (!is_known(frame.crs)) return;
  const Crs earth = crs_from_epsg(kGeocentric);
  transform_ = std::make_shared<CrsTransform>(frame.crs, earth);
  // PROJ reads heights in metres where the CRS has none of its own; those of a result have the unit of the plan.
  const bool own_heights = horizontal_crs(frame.crs).wkt != frame.crs.wkt;
  height_unit_ = own_heights ? frame.crs.metres_per_unit_z : 1;
  centre_ = frame.origin;
  to_4978(std::span(&centre_, 1));
  Vec3 geodetic = centre_;
  CrsTransform(earth, crs_from_epsg(kGeodetic)).apply(std::span(&geodetic, 1));
  if (!is_finite(centre_) || !is_finite(geodetic))
    throw Error(frame.crs_name + ": the models are not where this coordinate system holds; give another --crs",
                ExitCode::usage);
  const double longitude = geodetic.x * std::numbers::pi / 180, latitude = geodetic.y * std::numbers::pi / 180;
  const double s = std::sin(longitude), c = std::cos(longitude);
  east_ = {-s, c, 0};
  up_ = {std::cos(latitude) * c, std::cos(latitude) * s, std::sin(latitude)};
  north_ = cross(up_, east_);
}

void Placement::to_4978(std::span<Vec3> places) const {
  for (Vec3& p : places) p.z = (p.z * frame_.metres_per_unit + geoid_m_) / height_unit_;
  transform_->apply(places);
}

void Placement::apply(std::span<Vec3> places) const {
  if (!on_earth()) {
    for (Vec3& p : places) p = frame_.at(p);
    return;
  }
  to_4978(places);
  for (Vec3& p : places) {
    if (!is_finite(p))
      throw Error(frame_.crs_name + ": a model is not where this coordinate system holds", ExitCode::usage);
    const Vec3 d = p - centre_;
    p = {dot(d, east_), dot(d, north_), dot(d, up_)};
  }
}

std::array<double, 16> Placement::to_earth() const {
  return {east_.x, east_.y, east_.z, 0, north_.x,  north_.y,  north_.z,  0,
          up_.x,   up_.y,   up_.z,   0, centre_.x, centre_.y, centre_.z, 1};
}

}  // namespace ilot
