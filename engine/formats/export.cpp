// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/export.h"

#include "engine/formats/field_roles.h"

namespace ilot {
namespace {

using namespace field_roles;

struct Standard {
  FieldRole source;
  const char* name;
  FieldType type;
};

constexpr Standard kStandard[] = {{kX, "x", FieldType::f64},
                                  {kY, "y", FieldType::f64},
                                  {kZ, "z", FieldType::f64},
                                  {kIntensity, "intensity", FieldType::u16},
                                  {kReturnNumber, "return_number", FieldType::u8},
                                  {kReturnCount, "number_of_returns", FieldType::u8},
                                  {kClassification, "classification", FieldType::u8},
                                  {kSynthetic, "synthetic", FieldType::u8},
                                  {kKeyPoint, "key_point", FieldType::u8},
                                  {kWithheld, "withheld", FieldType::u8},
                                  {kOverlap, "overlap", FieldType::u8},
                                  {kChannel, "scanner_channel", FieldType::u8},
                                  {kDirection, "scan_direction", FieldType::u8},
                                  {kEdge, "edge_of_flight_line", FieldType::u8},
                                  {kUserData, "user_data", FieldType::u8},
                                  {kAngle, "scan_angle", FieldType::f32},
                                  {kSourceId, "point_source_id", FieldType::u16},
                                  {kGpsTime, "gps_time", FieldType::f64},
                                  {kRed, "red", FieldType::u16},
                                  {kGreen, "green", FieldType::u16},
                                  {kBlue, "blue", FieldType::u16},
                                  {kNir, "nir", FieldType::u16}};

bool has(const RecordLayout& layout, FieldRole source) {
  if (source == kOverlap || source == kChannel) return layout.point_format >= 6;
  if (source == kGpsTime) return gps_time_offset(layout.point_format).has_value();
  if (source >= kRed && source <= kBlue) return rgb_offset(layout.point_format).has_value();
  return source != kNir || nir_offset(layout.point_format).has_value();
}

double standard_value(const std::byte* record, const PointFields& f, const RecordLayout& layout, int source) {
  switch (source) {
    case kX:
      return f.x * layout.scale[0] + layout.offset[0];
    case kY:
      return f.y * layout.scale[1] + layout.offset[1];
    case kZ:
      return f.z * layout.scale[2] + layout.offset[2];
    case kIntensity:
      return f.intensity;
    case kReturnNumber:
      return f.return_number;
    case kReturnCount:
      return f.return_count;
    case kClassification:
      return f.classification;
    case kSynthetic:
      return f.synthetic;
    case kKeyPoint:
      return f.key_point;
    case kWithheld:
      return f.withheld;
    case kOverlap:
      return f.overlap;
    case kChannel:
      return f.scanner_channel;
    case kDirection:
      return f.scan_direction;
    case kEdge:
      return f.edge_of_flight_line;
    case kUserData:
      return f.user_data;
    case kAngle:
      return f.scan_angle_deg;
    case kSourceId:
      return f.source_id;
    case kGpsTime:
      return load<double>(record + *gps_time_offset(layout.point_format));
    case kNir:
      return load<std::uint16_t>(record + *nir_offset(layout.point_format));
    default:
      break;
  }
  return load<std::uint16_t>(record + *rgb_offset(layout.point_format) + std::ptrdiff_t{2} * (source - kRed));
}

double extra_value(const std::byte* p, FieldType type) {
  switch (type) {
    case FieldType::u8:
      return load<std::uint8_t>(p);
    case FieldType::i8:
      return load<std::int8_t>(p);
    case FieldType::u16:
      return load<std::uint16_t>(p);
    case FieldType::i16:
      return load<std::int16_t>(p);
    case FieldType::u32:
      return load<std::uint32_t>(p);
    case FieldType::i32:
      return load<std::int32_t>(p);
    case FieldType::u64:
      return static_cast<double>(load<std::uint64_t>(p));
    case FieldType::i64:
      return static_cast<double>(load<std::int64_t>(p));
    case FieldType::f32:
      return static_cast<double>(load<float>(p));
    case FieldType::f64:
      return load<double>(p);
    case FieldType::opaque:
      break;
  }
  return 0;
}

}  // namespace

std::vector<ExportColumn> export_columns(const RecordLayout& layout) {
  std::vector<ExportColumn> columns;
  for (const Standard& standard : kStandard) {
    if (!has(layout, standard.source)) continue;
    ExportColumn column;
    column.name = standard.name;
    column.type = standard.type;
    column.source = standard.source;
    columns.push_back(column);
  }
  for (const ExtraField& field : layout.extra) {
    if (field.type == FieldType::opaque) continue;
    ExportColumn column;
    column.name = field.name;
    column.type = field.scale == 1 && field.shift == 0 ? field.type : FieldType::f64;
    column.source = kExtra;
    column.place = field.offset;
    column.raw = field.type;
    column.scale = field.scale;
    column.shift = field.shift;
    columns.push_back(column);
  }
  return columns;
}

void export_row(std::span<const std::byte> record, const RecordLayout& layout, std::span<const ExportColumn> columns,
                std::span<double> values) {
  const PointFields fields = decode_fields(record, layout.point_format);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const ExportColumn& column = columns[i];
    values[i] = column.source == kExtra
                    ? extra_value(record.data() + column.place, column.raw) * column.scale + column.shift
                    : standard_value(record.data(), fields, layout, column.source);
  }
}

}  // namespace ilot
