// SPDX-License-Identifier: Apache-2.0
#include "scan/roofs/roof_wings.h"

#include <utility>

namespace ilot::scan {
namespace {

// Returns the plane that begins at `eave` on the lowest side of the rectangle and rises by `slope`.
RoofPlane rising(const GridRect& rect, Uphill uphill, Integer eave, Integer slope) {
  const Integer z = kSlopeUnit * eave;
  switch (uphill) {
    case Uphill::east:
      return {slope, 0, z - slope * rect.u0};
    case Uphill::west:
      return {-slope, 0, z + slope * rect.u1};
    case Uphill::north:
      return {0, slope, z - slope * rect.v0};
    default:
      return {0, -slope, z + slope * rect.v1};
  }
}

using Pair = std::pair<Uphill, Uphill>;

Pair slopes(Axis ridge) {
  return ridge == Axis::u ? Pair{Uphill::north, Uphill::south} : Pair{Uphill::east, Uphill::west};
}

Pair ends(Axis ridge) {
  return slopes(ridge == Axis::u ? Axis::v : Axis::u);
}

void add_pair(Wing& wing, Pair directions, Integer eave, Integer slope) {
  wing.planes.push_back(rising(wing.rect, directions.first, eave, slope));
  wing.planes.push_back(rising(wing.rect, directions.second, eave, slope));
}

// Adds a pair of slopes: `steep` up to `knee` above the eaves and `shallow` above it.
void add_broken_pair(Wing& wing, Pair directions, Integer eave, Integer steep, Integer shallow, Integer knee) {
  add_pair(wing, directions, eave, steep);
  add_pair(wing, directions, eave + knee - knee * shallow / steep, shallow);
}

}  // namespace

Wing flat_wing(const GridRect& rect, Integer height) {
  return {rect, {{0, 0, kSlopeUnit * height}}};
}

Wing shed_wing(const GridRect& rect, Integer eave, Integer slope, Uphill uphill) {
  return {rect, {rising(rect, uphill, eave, slope)}};
}

Wing gable_wing(const GridRect& rect, Axis ridge, Integer eave, Integer slope) {
  Wing wing{rect, {}};
  add_pair(wing, slopes(ridge), eave, slope);
  return wing;
}

Wing hip_wing(const GridRect& rect, Integer eave, Integer slope, Integer end_slope) {
  const Axis ridge = rect.u1 - rect.u0 >= rect.v1 - rect.v0 ? Axis::u : Axis::v;
  Wing wing = gable_wing(rect, ridge, eave, slope);
  add_pair(wing, ends(ridge), eave, end_slope);
  return wing;
}

Wing half_hip_wing(const GridRect& rect, Axis ridge, Integer eave, Integer slope, Integer lift) {
  Wing wing = gable_wing(rect, ridge, eave, slope);
  add_pair(wing, ends(ridge), eave + lift, slope);
  return wing;
}

Wing mansard_wing(const GridRect& rect, Integer eave, Integer steep, Integer shallow, Integer knee) {
  Wing wing{rect, {}};
  for (Axis axis : {Axis::u, Axis::v}) add_broken_pair(wing, slopes(axis), eave, steep, shallow, knee);
  return wing;
}

Wing gambrel_wing(const GridRect& rect, Axis ridge, Integer eave, Integer steep, Integer shallow, Integer knee) {
  Wing wing{rect, {}};
  add_broken_pair(wing, slopes(ridge), eave, steep, shallow, knee);
  return wing;
}

Integer gable_rise(const GridRect& rect, Axis ridge, Integer slope) {
  const Integer span = ridge == Axis::u ? rect.v1 - rect.v0 : rect.u1 - rect.u0;
  return slope * span / (2 * kSlopeUnit);
}

Wing moved(Wing wing, Integer du, Integer dv, Integer dz) {
  wing.rect = {wing.rect.u0 + du, wing.rect.v0 + dv, wing.rect.u1 + du, wing.rect.v1 + dv};
  for (RoofPlane& plane : wing.planes) plane.c += kSlopeUnit * dz - plane.a * du - plane.b * dv;
  return wing;
}

Wing mirrored_u(Wing wing, Integer length) {
  wing.rect = {length - wing.rect.u1, wing.rect.v0, length - wing.rect.u0, wing.rect.v1};
  for (RoofPlane& plane : wing.planes) {
    plane.c += plane.a * length;
    plane.a = -plane.a;
  }
  return wing;
}

Wing mirrored_v(Wing wing, Integer depth) {
  wing.rect = {wing.rect.u0, depth - wing.rect.v1, wing.rect.u1, depth - wing.rect.v0};
  for (RoofPlane& plane : wing.planes) {
    plane.c += plane.b * depth;
    plane.b = -plane.b;
  }
  return wing;
}

}  // namespace ilot::scan
