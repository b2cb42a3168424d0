// SPDX-License-Identifier: Apache-2.0
#include "engine/cloud/record.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ilot {
namespace {

constexpr std::uint8_t kFormats = 11;
constexpr double kAngleStep = 0.006;  // degrees per unit of the scan angle in formats 6-10

std::uint8_t byte_at(std::span<const std::byte> record, std::size_t i) {
  return std::to_integer<std::uint8_t>(record[i]);
}

std::uint8_t bit(bool value, int position) {
  return static_cast<std::uint8_t>((value ? 1 : 0) << position);
}

template <class T>
T rounded(double value) {
  if (!(value == value)) return 0;
  return static_cast<T>(std::clamp(std::round(value), static_cast<double>(std::numeric_limits<T>::min()),
                                   static_cast<double>(std::numeric_limits<T>::max())));
}

void decode_old(std::span<const std::byte> record, PointFields& f) {
  const std::uint8_t returns = byte_at(record, 14), kind = byte_at(record, 15);
  f.return_number = returns & 7;
  f.return_count = (returns >> 3) & 7;
  f.scan_direction = returns & 0x40;
  f.edge_of_flight_line = returns & 0x80;
  f.classification = kind & 31;
  f.synthetic = kind & 0x20;
  f.key_point = kind & 0x40;
  f.withheld = kind & 0x80;
  f.scan_angle_deg = load<std::int8_t>(&record[16]);
  f.user_data = byte_at(record, 17);
  f.source_id = load<std::uint16_t>(&record[18]);
}

void decode_new(std::span<const std::byte> record, PointFields& f) {
  const std::uint8_t returns = byte_at(record, 14), flags = byte_at(record, 15);
  f.return_number = returns & 15;
  f.return_count = returns >> 4;
  f.synthetic = flags & 1;
  f.key_point = flags & 2;
  f.withheld = flags & 4;
  f.overlap = flags & 8;
  f.scanner_channel = (flags >> 4) & 3;
  f.scan_direction = flags & 0x40;
  f.edge_of_flight_line = flags & 0x80;
  f.classification = byte_at(record, 16);
  f.user_data = byte_at(record, 17);
  f.scan_angle_deg = load<std::int16_t>(&record[18]) * kAngleStep;
  f.source_id = load<std::uint16_t>(&record[20]);
}

void encode_old(const PointFields& f, std::byte* record) {
  const int number = std::min<int>(f.return_number, 7), count = std::min<int>(f.return_count, 7);
  const std::uint8_t kind = f.classification > 31 ? 1 : f.classification;
  store<std::uint8_t>(record + 14, static_cast<std::uint8_t>(number | count << 3 | bit(f.scan_direction, 6) |
                                                             bit(f.edge_of_flight_line, 7)));
  store<std::uint8_t>(record + 15,
                      static_cast<std::uint8_t>(kind | bit(f.synthetic, 5) | bit(f.key_point, 6) | bit(f.withheld, 7)));
  store<std::int8_t>(record + 16, rounded<std::int8_t>(f.scan_angle_deg));
  store<std::uint8_t>(record + 17, f.user_data);
  store<std::uint16_t>(record + 18, f.source_id);
}

void encode_new(const PointFields& f, std::byte* record) {
  const int number = std::min<int>(f.return_number, 15), count = std::min<int>(f.return_count, 15);
  const int flags = bit(f.synthetic, 0) | bit(f.key_point, 1) | bit(f.withheld, 2) | bit(f.overlap, 3) |
                    (f.scanner_channel & 3) << 4 | bit(f.scan_direction, 6) | bit(f.edge_of_flight_line, 7);
  store<std::uint8_t>(record + 14, static_cast<std::uint8_t>(number | count << 4));
  store<std::uint8_t>(record + 15, static_cast<std::uint8_t>(flags));
  store<std::uint8_t>(record + 16, f.classification);
  store<std::uint8_t>(record + 17, f.user_data);
  store<std::int16_t>(record + 18, rounded<std::int16_t>(f.scan_angle_deg / kAngleStep));
  store<std::uint16_t>(record + 20, f.source_id);
}

std::optional<std::size_t> offset_or_none(const std::array<std::uint8_t, kFormats>& offsets, std::uint8_t format) {
  if (format >= kFormats || offsets[format] == 0) return std::nullopt;
  return offsets[format];
}

}  // namespace

std::size_t standard_size(std::uint8_t point_format) {
  constexpr std::array<std::size_t, kFormats> kSizes{20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
  return point_format < kSizes.size() ? kSizes[point_format] : 0;
}

std::optional<std::size_t> gps_time_offset(std::uint8_t point_format) {
  return offset_or_none({0, 20, 0, 20, 20, 20, 22, 22, 22, 22, 22}, point_format);
}

std::optional<std::size_t> rgb_offset(std::uint8_t point_format) {
  return offset_or_none({0, 0, 20, 28, 0, 28, 0, 30, 30, 0, 30}, point_format);
}

std::optional<std::size_t> nir_offset(std::uint8_t point_format) {
  return offset_or_none({0, 0, 0, 0, 0, 0, 0, 0, 36, 0, 36}, point_format);
}

PointFields decode_fields(std::span<const std::byte> record, std::uint8_t point_format) {
  PointFields f;
  f.x = load<std::int32_t>(&record[0]);
  f.y = load<std::int32_t>(&record[4]);
  f.z = load<std::int32_t>(&record[8]);
  f.intensity = load<std::uint16_t>(&record[12]);
  if (point_format < 6)
    decode_old(record, f);
  else
    decode_new(record, f);
  return f;
}

void encode_fields(const PointFields& fields, std::span<std::byte> record, std::uint8_t point_format) {
  store(&record[0], fields.x);
  store(&record[4], fields.y);
  store(&record[8], fields.z);
  store(&record[12], fields.intensity);
  if (point_format < 6)
    encode_old(fields, record.data());
  else
    encode_new(fields, record.data());
}

}  // namespace ilot
