// SPDX-License-Identifier: Apache-2.0
// Every point is a LAS point record, whatever format it came from: the standard fields of its point format, then extra
// bytes that descriptors name. Because all rows have this one form, every reader can feed the same index, every field
// of the input is kept byte for byte, and labels are appended without a change to the other fields. (ASPRS LAS 1.4 R15)
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ilot {

// LAS extra-byte types 1-10; 0 = opaque bytes. The deprecated arrays (11-30) are kept as opaque bytes.
enum class FieldType : std::uint8_t { opaque, u8, i8, u16, i16, u32, i32, u64, i64, f32, f64 };

struct ExtraField {
  std::string name;         // at most 32 bytes
  std::string description;  // at most 32 bytes, with the unit
  FieldType type = FieldType::opaque;
  std::uint16_t offset = 0;     // from the start of the record
  std::uint16_t size = 0;       // bytes
  double scale = 1, shift = 0;  // value = raw * scale + shift
};

struct RecordLayout {
  std::uint8_t point_format = 0;                     // 0-10
  std::uint16_t record_length = 20;                  // bytes, extra bytes included
  std::array<double, 3> scale{0.001, 0.001, 0.001};  // world = raw * scale + offset, in the units of the CRS
  std::array<double, 3> offset{0, 0, 0};
  std::vector<ExtraField> extra;
};

// Returns the size in bytes of the standard part of a record; 0 for an unknown format.
std::size_t standard_size(std::uint8_t point_format);

// Return the offsets of fields that only some formats have; nullopt when the field is absent.
std::optional<std::size_t> gps_time_offset(std::uint8_t point_format);
std::optional<std::size_t> rgb_offset(std::uint8_t point_format);
std::optional<std::size_t> nir_offset(std::uint8_t point_format);

// The standard fields of one record, decoded. The bit layouts of formats 0-5 and 6-10 differ. This struct hides the
// difference.
struct PointFields {
  std::int32_t x = 0, y = 0, z = 0;
  std::uint16_t intensity = 0;
  std::uint8_t return_number = 0, return_count = 0;
  std::uint8_t classification = 0;
  bool withheld = false, synthetic = false, key_point = false, overlap = false;
  bool scan_direction = false, edge_of_flight_line = false;
  std::uint8_t scanner_channel = 0, user_data = 0;
  double scan_angle_deg = 0;
  std::uint16_t source_id = 0;
};

// The record must have at least standard_size(point_format) bytes. O(1), never throws. Formats 0-5 have no overlap flag
// (producers use class 12) and no scanner channel. Both are decoded as unset.
PointFields decode_fields(std::span<const std::byte> record, std::uint8_t point_format);

// Writes these fields and leaves GPS time, colours, waveform and extra bytes as they are. Values that a format cannot
// store are changed: return numbers saturate (7 or 15), classes above 31 become 1 (unclassified) in formats 0-5, angles
// are rounded and saturate, and overlap and channel are dropped in formats 0-5.
void encode_fields(const PointFields& fields, std::span<std::byte> record, std::uint8_t point_format);

// Little-endian loads and stores at any alignment.
template <class T>
T load(const std::byte* p) {
  T v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
template <class T>
void store(std::byte* p, T v) {
  __builtin_memcpy(p, &v, sizeof v);
}

}  // namespace ilot
