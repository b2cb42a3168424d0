// SPDX-License-Identifier: Apache-2.0
#include "tools/render/colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "engine/error.h"
#include "kernels/core/rng.h"

namespace ilot::render {
namespace {

constexpr Rgb kNone{70, 70, 70};

// Returns a colour from dark blue over green and yellow to red.
Rgb ramp(double share) {
  constexpr std::array<std::array<double, 3>, 5> kStops{
      {{40, 60, 130}, {40, 140, 150}, {90, 180, 80}, {240, 200, 60}, {200, 50, 40}}};
  const double at = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const double part = at - static_cast<double>(low);
  Rgb colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = static_cast<std::uint8_t>(kStops[low][c] * (1 - part) + kStops[low + 1][c] * part);
  return colour;
}

// Returns bright colours from the whole hue circle, in a few lightnesses.
Rgb colour_of_id(std::uint64_t id) {
  if (id == 0) return kNone;
  const std::uint64_t bits = mix64(id);
  const double hue = static_cast<double>(bits & 0xffff) / 65536 * 6;
  const double light = 0.65 + 0.35 * static_cast<double>((bits >> 16) & 0xff) / 255;
  const double white = 0.45 * static_cast<double>((bits >> 24) & 0xff) / 255;
  Rgb colour{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double turn = std::fmod(hue + 2 * static_cast<double>(c), 6.0);
    const double pure = std::clamp(std::abs(turn - 3) - 1, 0.0, 1.0);
    colour[c] = static_cast<std::uint8_t>(255 * light * (white + (1 - white) * pure));
  }
  return colour;
}

Rgb colour_of_class(std::uint8_t value) {
  constexpr std::array<Rgb, 10> kClasses{{{160, 160, 160},
                                          {185, 185, 185},
                                          {168, 140, 100},
                                          {150, 200, 100},
                                          {90, 170, 70},
                                          {40, 120, 50},
                                          {200, 80, 60},
                                          {255, 0, 255},
                                          {230, 200, 60},
                                          {70, 120, 200}}};
  return value < kClasses.size() ? kClasses[value] : colour_of_id(value);
}

// Returns colours for small numbers, such as classes. Consecutive numbers are never neighbours on the hue circle (steps
// of the golden ratio).
Rgb colour_of_small(std::uint8_t value) {
  if (value == 0) return kNone;
  const double turns = 0.07 + 0.618034 * (value - 1);
  const double hue = 6 * (turns - std::floor(turns)), white = value % 3 == 0 ? 0.15 : 0.4;
  Rgb colour{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double turn = std::fmod(hue + 6 - 2 * static_cast<double>(c), 6.0);
    const double pure = std::clamp(std::abs(turn - 3) - 1, 0.0, 1.0);
    colour[c] = static_cast<std::uint8_t>(235 * (white + (1 - white) * pure));
  }
  return colour;
}

std::uint64_t load_id(const std::byte* p, std::uint16_t size) {
  switch (size) {
    case 1:
      return load<std::uint8_t>(p);
    case 2:
      return load<std::uint16_t>(p);
    case 4:
      return load<std::uint32_t>(p);
    default:
      return load<std::uint64_t>(p);
  }
}

// Scanners use from 8 to 16 bits. Mirrors and signs are much brighter than all other surfaces.
double white_intensity(const std::vector<std::uint64_t>& counts) {
  constexpr double kShare = 0.98;
  const auto all = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
  std::uint64_t below = 0;
  for (std::size_t value = 0; value < counts.size(); ++value) {
    below += counts[value];
    if (static_cast<double>(below) >= kShare * all) return std::max(1.0, static_cast<double>(value));
  }
  return 1;
}

Colouring by_field(const std::string& name, const RecordLayout& layout) {
  std::string known = "class, height, intensity";
  if (rgb_offset(layout.point_format)) known += ", rgb";
  for (const ExtraField& field : layout.extra) {
    const bool integer = field.type >= FieldType::u8 && field.type <= FieldType::i64;
    if (!integer) continue;
    if (field.name == name && field.type == FieldType::u8)
      return [offset = field.offset](std::span<const std::byte> record) {
        return colour_of_small(load<std::uint8_t>(&record[offset]));
      };
    if (field.name == name)
      return [offset = field.offset, size = field.size](std::span<const std::byte> record) {
        return colour_of_id(load_id(&record[offset], size));
      };
    known += ", " + field.name;
  }
  throw Error("the cloud has no field \"" + name + "\" to colour by; it has " + known, ExitCode::usage);
}

}  // namespace

void note_colour(std::span<const std::byte> record, const RecordLayout& layout, ColourRange& range) {
  const auto rgb = rgb_offset(layout.point_format);
  for (std::size_t c = 0; rgb && c < 3; ++c)
    range.brightest = std::max(range.brightest, load<std::uint16_t>(&record[*rgb + 2 * c]));
  ++range.intensities[decode_fields(record, layout.point_format).intensity];
}

Colouring colouring(const std::string& by, const RecordLayout& layout, const ColourRange& range) {
  const std::uint8_t format = layout.point_format;
  if (by == "class" || by == "classification")
    return [format](auto record) { return colour_of_class(decode_fields(record, format).classification); };
  if (by == "intensity")
    return [format, white = white_intensity(range.intensities)](auto record) {
      const double share = std::min(1.0, decode_fields(record, format).intensity / white);
      const auto grey = static_cast<std::uint8_t>(225 * share + 0.5);  // the background is white
      return Rgb{grey, grey, grey};
    };
  if (by == "height")
    return
        [format, scale = layout.scale[2], offset = layout.offset[2], low = range.low, high = range.high](auto record) {
          return ramp((decode_fields(record, format).z * scale + offset - low) / std::max(high - low, 1e-9));
        };
  if (const auto offset = rgb_offset(format); by == "rgb" && offset)
    return [at = *offset, shift = range.brightest > 255 ? 8 : 0](auto record) {
      Rgb colour{};
      for (std::size_t c = 0; c < 3; ++c)
        colour[c] = static_cast<std::uint8_t>(load<std::uint16_t>(&record[at + 2 * c]) >> shift);
      return colour;
    };
  return by_field(by, layout);
}

}  // namespace ilot::render
