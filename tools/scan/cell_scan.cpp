// SPDX-License-Identifier: Apache-2.0
#include "tools/scan/cell_scan.h"

#include <algorithm>
#include <cmath>

#include "tools/scan/exact_math.h"
#include "tools/scan/ray_scene.h"

namespace ilot::scan {
namespace {

constexpr std::size_t kStandardSize = 30, kGpsTime = 22, kTrueClass = 30, kTruePlane = 31, kRecordSize = 35;
constexpr double kUnit = 0.001;  // metres per coordinate unit
constexpr std::size_t kMaxReturns = 5;
constexpr double kMinSeparation = 0.5;  // metres between echoes that the receiver tells apart

std::uint8_t las_class(Surface surface) {
  switch (surface) {
    case Surface::ground:
      return 2;
    case Surface::vegetation:
      return 5;
    default:
      return 6;
  }
}

std::uint16_t intensity_of(Surface surface, double cosine) {
  constexpr std::array<double, 5> kReflectance{0, 0.25, 0.35, 0.5, 0.4};
  return static_cast<std::uint16_t>(65535 * kReflectance[static_cast<std::size_t>(surface)] * (0.3 + 0.7 * cosine));
}

std::int32_t to_units(double metres) {
  return static_cast<std::int32_t>(std::llround(metres / kUnit));
}

}  // namespace

RecordLayout scan_layout() {
  RecordLayout layout;
  layout.point_format = 6;
  layout.record_length = kRecordSize;
  layout.scale = {kUnit, kUnit, kUnit};
  layout.offset = {kEastOrigin, kNorthOrigin, 0};
  ExtraField surface;
  surface.name = "true_class";
  surface.description = "1 ground 2 roof 3 wall 4 veg.";
  surface.type = FieldType::u8;
  surface.offset = kTrueClass;
  surface.size = 1;
  ExtraField plane;
  plane.name = "true_plane";
  plane.description = "id of the plane, 0 = none";
  plane.type = FieldType::u32;
  plane.offset = kTruePlane;
  plane.size = 4;
  layout.extra = {surface, plane};
  return layout;
}

std::uint32_t true_plane_of(const std::byte* record) {
  return load<std::uint32_t>(record + kTruePlane);
}

struct CellTracer::State {
  const Cell& cell;
  std::uint32_t first_plane;
  Plane ground;
  RayScene scene;
  CastResult found;
};

CellTracer::CellTracer(const Cell& cell, const Ground& ground, std::uint32_t first_plane) {
  const double x = (cell.area.x0 + cell.area.x1) / 2, y = (cell.area.y0 + cell.area.y1) / 2;
  const Vec3 anchor{x, y, ground.height(x, y)};
  state_.reset(new State{cell, first_plane, ground.plane(), RayScene(cell.solids, cell.crowns, anchor), {}});
}

CellTracer::~CellTracer() = default;

void CellTracer::trace(const Ray& ray, Rng& rng, std::vector<Return>& returns) {
  State& s = *state_;
  returns.clear();
  s.scene.cast(ray, s.found);
  const double to_ground = -signed_distance(s.ground, ray.origin) / dot(s.ground.n, ray.direction);
  Return last{to_ground, Surface::ground, kGroundPlane};
  if (s.found.solid && s.found.solid->t < to_ground) {
    const std::uint32_t face = s.found.solid->face;
    last = {s.found.solid->t, s.cell.faces[face].surface, s.first_plane + s.cell.face_plane[face]};
  }
  bool passes = true;
  for (const CrownHit& hit : s.found.crowns) {
    const double length = hit.chord.leave - hit.chord.enter;
    // Leaves stop a pulse somewhere along its chord, sooner rather than later; half of the light goes on.
    const double first = rng.uniform(), second = rng.uniform(), share = rng.uniform();
    if (hit.chord.enter >= last.range || share > 0.9) continue;
    returns.push_back({hit.chord.enter + length * first * first, Surface::vegetation, 0});
    if (share < 0.5) returns.push_back({hit.chord.enter + length * second, Surface::vegetation, 0});
    if (share > 0.25 && share < 0.6) passes = false;
  }
  std::erase_if(returns, [&](const Return& r) { return r.range > last.range - kMinSeparation; });
  std::sort(returns.begin(), returns.end(), [](const Return& a, const Return& b) { return a.range < b.range; });
  const auto merged = std::unique(returns.begin(), returns.end(),
                                  [](const Return& a, const Return& b) { return b.range - a.range < kMinSeparation; });
  returns.erase(merged, returns.end());
  if (returns.size() > kMaxReturns - 1) returns.resize(kMaxReturns - 1);
  if (passes || returns.empty()) returns.push_back(last);
}

std::vector<std::byte> scan_cell(const Cell& cell, const FlightPlan& flight, const Ground& ground,
                                 std::uint32_t first_plane, double noise) {
  CellTracer tracer(cell, ground, first_plane);
  std::vector<Return> returns;
  std::vector<std::byte> records;
  const double area = (cell.area.x1 - cell.area.x0) * (cell.area.y1 - cell.area.y0);
  records.reserve(static_cast<std::size_t>(1.06 * area * flight.density()) * kRecordSize);
  flight.for_each_pulse(cell.area, [&](Pulse pulse) {
    tracer.trace(pulse.ray, pulse.rng, returns);
    PointFields fields;
    fields.scan_angle_deg = pulse.scan_angle_deg;
    fields.source_id = pulse.line;
    fields.return_count = static_cast<std::uint8_t>(returns.size());
    for (const Return& echo : returns) {
      const Vec3 p = point_at(pulse.ray, echo.range + noise * gaussian(pulse.rng));
      fields.x = to_units(p.x);
      fields.y = to_units(p.y);
      fields.z = to_units(p.z);
      ++fields.return_number;
      fields.classification = las_class(echo.surface);
      fields.intensity = intensity_of(echo.surface, 1);
      const std::size_t at = records.size();
      records.resize(at + kRecordSize);
      std::byte* record = records.data() + at;
      encode_fields(fields, {record, kStandardSize}, 6);
      store(record + kGpsTime, pulse.gps_time);
      store(record + kTrueClass, static_cast<std::uint8_t>(echo.surface));
      store(record + kTruePlane, echo.plane);
    }
  });
  return records;
}

}  // namespace ilot::scan
