// SPDX-License-Identifier: Apache-2.0
#include "scan/scanners/cell_scan.h"

#include <cmath>

#include "scan/optics/exact_math.h"
#include "scan/scanners/scan_record.h"
#include "scan/unit.h"

namespace ilot::scan {
namespace {

constexpr std::size_t kTrueClass = 30, kTruePlane = 31, kRecordSize = 35;

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

Vec3 middle(const Cell& cell, const Ground& ground) {
  const double x = (cell.area.x0 + cell.area.x1) / 2, y = (cell.area.y0 + cell.area.y1) / 2;
  return {x, y, ground.height(x, y)};
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

CellTracer::CellTracer(const Cell& cell, const Ground& ground, std::uint32_t first_plane)
    : cell_(cell),
      first_plane_(first_plane),
      scene_(cell.solids, cell.crowns, middle(cell, ground)),
      tracer_(scene_, ground.plane()) {}

void CellTracer::trace(const Ray& ray, Rng& rng, std::vector<Return>& returns) {
  tracer_.trace(ray, rng, echoes_);
  returns.clear();
  for (const PulseEcho& echo : echoes_) {
    if (echo.from == PulseEcho::From::ground)
      returns.push_back({echo.range, Surface::ground, kGroundPlane});
    else if (echo.from == PulseEcho::From::crown)
      returns.push_back({echo.range, Surface::vegetation, 0});
    else
      returns.push_back({echo.range, cell_.faces[echo.face].surface, first_plane_ + cell_.face_plane[echo.face]});
  }
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
      encode_fields(fields, {record, kTrueClass}, 6);
      store(record + kGpsTime, pulse.gps_time);
      store(record + kTrueClass, static_cast<std::uint8_t>(echo.surface));
      store(record + kTruePlane, echo.plane);
    }
  });
  return records;
}

}  // namespace ilot::scan
