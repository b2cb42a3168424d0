// SPDX-License-Identifier: Apache-2.0
#include "scan/scanners/scan_record.h"

#include <array>
#include <cmath>

namespace ilot::scan {
namespace {

constexpr std::uint8_t kFormat = 7;
constexpr std::size_t kStandardSize = 36, kRgb = 30;
constexpr std::size_t kTruth = 9;  // bytes of the true class, plane and element

// Bytes before the truth: the standard fields of point formats 6 and 7.
std::size_t standard_size(std::uint8_t format) {
  return format == kFormat ? kStandardSize : kRgb;
}

// EPSG:2154 as WKT 1, the form that LAS 1.4 requires. It is a constant because the text of PROJ changes with its
// version.
constexpr const char* kLambert93 =
    R"(PROJCS["RGF93 v1 / Lambert-93",GEOGCS["RGF93 v1",DATUM["Reseau_Geodesique_Francais_1993_v1",)"
    R"(SPHEROID["GRS 1980",6378137,298.257222101,AUTHORITY["EPSG","7019"]],AUTHORITY["EPSG","6171"]],)"
    R"(PRIMEM["Greenwich",0,AUTHORITY["EPSG","8901"]],UNIT["degree",0.0174532925199433,AUTHORITY["EPSG","9122"]],)"
    R"(AUTHORITY["EPSG","4171"]],PROJECTION["Lambert_Conformal_Conic_2SP"],PARAMETER["latitude_of_origin",46.5],)"
    R"(PARAMETER["central_meridian",3],PARAMETER["standard_parallel_1",49],PARAMETER["standard_parallel_2",44],)"
    R"(PARAMETER["false_easting",700000],PARAMETER["false_northing",6600000],)"
    R"(UNIT["metre",1,AUTHORITY["EPSG","9001"]],AXIS["Easting",EAST],AXIS["Northing",NORTH],)"
    R"(AUTHORITY["EPSG","2154"]])";

ExtraField extra_field(const char* name, const char* description, FieldType type, std::size_t offset,
                       std::size_t size) {
  ExtraField field;
  field.name = name;
  field.description = description;
  field.type = type;
  field.offset = static_cast<std::uint16_t>(offset);
  field.size = static_cast<std::uint16_t>(size);
  return field;
}

RecordLayout layout_of(std::uint8_t format, double grid, Vec3 origin) {
  RecordLayout layout;
  const std::size_t at = standard_size(format);
  layout.point_format = format;
  layout.record_length = static_cast<std::uint16_t>(at + kTruth);
  layout.scale = {grid, grid, grid};
  layout.offset = {origin.x, origin.y, origin.z};
  layout.extra = {extra_field("true_class", "named in the truth", FieldType::u8, at, 1),
                  extra_field("true_plane", "id of plane or shape, 0 = none", FieldType::u32, at + 1, 4),
                  extra_field("true_element", "id of the element, 0 = none", FieldType::u32, at + 5, 4)};
  return layout;
}

}  // namespace

Crs lambert_93() {
  Crs crs;
  crs.wkt = kLambert93;
  crs.epsg = 2154;
  crs.unit_assumed = false;
  return crs;
}

RecordLayout coloured_layout(double grid, Vec3 origin) {
  return layout_of(kFormat, grid, origin);
}

RecordLayout uncoloured_layout(double grid) {
  return layout_of(kFormat - 1, grid, kSceneOrigin);
}

CloudSpec cloud_spec(const RecordLayout& layout, const Crs& crs) {
  CloudSpec spec;
  spec.like.format = "las";
  spec.like.layout = layout;
  spec.like.crs = crs;
  spec.software = "ilot scan";
  return spec;
}

void append_record(std::vector<std::byte>& records, const ColouredPoint& point, const RecordLayout& layout) {
  const std::size_t at = records.size(), standard = standard_size(layout.point_format);
  records.resize(at + standard + kTruth);
  std::byte* record = records.data() + at;
  const auto units = [&](double metres, std::size_t axis) {
    return static_cast<std::int32_t>(std::llround(metres / layout.scale[axis]));
  };
  PointFields fields;
  fields.x = units(point.place.x, 0);
  fields.y = units(point.place.y, 1);
  fields.z = units(point.place.z, 2);
  fields.intensity = point.intensity;
  fields.return_number = point.return_number;
  fields.return_count = point.return_count;
  fields.classification = point.classification;
  fields.user_data = point.material;
  fields.source_id = point.source;
  fields.scan_angle_deg = point.scan_angle_deg;
  encode_fields(fields, {record, standard}, layout.point_format);
  store(record + kGpsTime, point.gps_time);
  if (layout.point_format == kFormat)
    for (std::size_t c = 0; c < 3; ++c) store(record + kRgb + 2 * c, point.rgb[c]);
  store(record + standard, point.true_class);
  store(record + standard + 1, point.true_plane);
  store(record + standard + 5, point.true_element);
}

RecordTruth truth_of(const std::byte* record, const RecordLayout& layout) {
  const std::byte* truth = record + standard_size(layout.point_format);
  return {load<std::uint8_t>(truth), load<std::uint32_t>(truth + 1), load<std::uint32_t>(truth + 5)};
}

Vec3 place_of(const std::byte* record, const RecordLayout& layout) {
  const PointFields f = decode_fields({record, standard_size(layout.point_format)}, layout.point_format);
  return {f.x * layout.scale[0], f.y * layout.scale[1], f.z * layout.scale[2]};
}

}  // namespace ilot::scan
