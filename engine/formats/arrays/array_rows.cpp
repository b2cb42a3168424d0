// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/arrays/array_rows.h"

#include <cmath>
#include <string>
#include <vector>

#include "engine/error.h"

namespace ilot {
namespace {

constexpr std::uint8_t kPlainFormat = 6, kColourFormat = 7;  // ASPRS LAS 1.4
// Where these fields are in the formats 6 and 7 [LAS 1.4 R15, tables 13 and 14].
constexpr std::size_t kX = 0, kY = 4, kZ = 8, kIntensity = 12, kClassification = 16;

struct Axis {
  std::span<const double> values;
  const char* name;
  double scale, offset;

  std::int32_t raw(std::size_t i, const std::string& cloud) const {
    const double raw = (values[i] - offset) / scale;
    // Rounds to the nearest, halves away from 0, without a call of the maths library.
    if (std::abs(raw) <= 2147483647.0) return static_cast<std::int32_t>(raw + std::copysign(0.5, raw));
    const char* what = std::isfinite(values[i]) ? "beyond 2^31 scales of the offset: leave it out" : "not finite";
    throw Error(cloud + ": " + name + "[" + std::to_string(i) + "] = " + std::to_string(values[i]) + " is " + what,
                ExitCode::usage);
  }
};

template <class T>
T value_of(std::span<const T> values, std::size_t i) {
  return values.empty() ? T{0} : values[i];
}

// A row without a place: one return of one.
std::vector<std::byte> empty_row(const RecordLayout& layout) {
  std::vector<std::byte> row(layout.record_length);
  PointFields fields;
  fields.return_number = fields.return_count = 1;
  encode_fields(fields, row, layout.point_format);
  return row;
}

}  // namespace

RecordLayout array_layout(bool colour, double scale, Vec3 offset) {
  if (!(scale > 0)) throw Error("scale: must be above 0", ExitCode::usage);
  RecordLayout layout;
  layout.point_format = colour ? kColourFormat : kPlainFormat;
  layout.record_length = static_cast<std::uint16_t>(standard_size(layout.point_format));
  layout.scale = {scale, scale, scale};
  layout.offset = {offset.x, offset.y, offset.z};
  return layout;
}

void check_array_lengths(const ArrayCloud& cloud) {
  const std::size_t size = cloud.x.size();
  if (cloud.y.size() != size || cloud.z.size() != size)
    throw Error(cloud.name + ": x, y and z have different lengths", ExitCode::usage);
  for (const std::size_t other :
       {cloud.intensity.size(), cloud.classification.size(), cloud.red.size(), cloud.green.size(), cloud.blue.size()})
    if (other != 0 && other != size)
      throw Error(cloud.name + ": an attribute has " + std::to_string(other) + " values for " + std::to_string(size) +
                      " points",
                  ExitCode::usage);
}

void fill_rows(const ArrayCloud& cloud, const RecordLayout& layout, std::size_t first, std::span<std::byte> rows) {
  const std::vector<std::byte> empty = empty_row(layout);
  const Axis x{cloud.x, "x", layout.scale[0], layout.offset[0]}, y{cloud.y, "y", layout.scale[1], layout.offset[1]},
      z{cloud.z, "z", layout.scale[2], layout.offset[2]};
  const auto rgb = rgb_offset(layout.point_format);
  std::byte* row = rows.data();
  for (std::size_t i = first; row != rows.data() + rows.size(); ++i, row += empty.size()) {
    __builtin_memcpy(row, empty.data(), empty.size());
    store(row + kX, x.raw(i, cloud.name));
    store(row + kY, y.raw(i, cloud.name));
    store(row + kZ, z.raw(i, cloud.name));
    store(row + kIntensity, value_of(cloud.intensity, i));
    store(row + kClassification, value_of(cloud.classification, i));
    if (!rgb) continue;
    store(row + *rgb, value_of(cloud.red, i));
    store(row + *rgb + 2, value_of(cloud.green, i));
    store(row + *rgb + 4, value_of(cloud.blue, i));
  }
}

}  // namespace ilot
