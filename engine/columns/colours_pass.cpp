// SPDX-License-Identifier: Apache-2.0
#include "engine/columns/colours_pass.h"

#include <algorithm>

#include "engine/cloud/record.h"
#include "engine/columns/row_values.h"
#include "engine/formats/fields.h"
#include "kernels/core/rng.h"
#include "kernels/plane_methods/colour_classes.h"

namespace ilot {
namespace {

constexpr std::uint32_t kRows = 1 << 16;  // rows read at a time
constexpr std::uint64_t kSample = std::uint64_t{1} << 17;

struct RawColour {
  std::uint16_t r = 0, g = 0, b = 0;
};

RawColour colour_of(std::span<const std::byte> record, const RecordLayout& layout) {
  const std::byte* rgb = record.data() + *rgb_offset(layout.point_format);
  return {load<std::uint16_t>(rgb), load<std::uint16_t>(rgb + 2), load<std::uint16_t>(rgb + 4)};
}

// Replaces the sum of colours: it keeps the largest channel.
void keep_largest(RawColour& most, const RawColour& c) {
  most.r = std::max({most.r, c.r, c.g, c.b});
}

Lab lab_of(StoredColour c) {
  return ilot::lab_of(static_cast<std::uint8_t>(c >> 16), static_cast<std::uint8_t>(c >> 8),
                      static_cast<std::uint8_t>(c));
}

bool are_written(const Store& store) {
  for (std::uint32_t block = 0; block < store.blocks().size(); ++block)
    if (!store.has(block, columns::kColour)) return false;
  return !store.blocks().empty();
}

}  // namespace

bool has_colours(const PointReader& input) {
  return input.info().points > 0 && rgb_offset(input.info().layout.point_format).has_value();
}

bool colours_pass(const Store& store, const std::vector<std::unique_ptr<PointReader>>& inputs,
                  const PassContext& context) {
  if (are_written(store)) return true;
  const RowValues<RawColour> rows(store, "colours", inputs,
                                  [&](std::size_t file) { return has_colours(*inputs[file]); });
  if (rows.empty()) return false;
  rows.read(kFieldRgb, context, colour_of, keep_largest);
  std::vector<int> shifts(inputs.size(), 0);
  for (const RowStretch& s : rows.stretches())
    if (rows.sum(s).r > 255) shifts[s.file] = 8;
  rows.gather(columns::kColour, kNoColour, context, [&](const RawColour& c, std::size_t file) {
    const auto byte = [&](std::uint16_t v) { return static_cast<StoredColour>(v >> shifts[file]); };
    return byte(c.r) << 16 | byte(c.g) << 8 | byte(c.b);
  });
  return true;
}

std::uint32_t ColourPalette::class_of(StoredColour colour) const {
  if (colour == kNoColour) return 0;
  const Lab lab = lab_of(colour);
  std::uint32_t best = 0;
  double least = 0;
  for (std::uint32_t c = 0; c < centre.size(); ++c) {
    double d2 = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double d = lab[axis] - centre[c][axis];
      d2 += d * d;
    }
    if (best != 0 && d2 >= least) continue;
    best = c + 1;
    least = d2;
  }
  return best;
}

ColourPalette colour_palette(const Store& store, std::uint32_t k, std::uint64_t seed) {
  const std::uint64_t stride = std::max<std::uint64_t>(1, store.points() / kSample);
  std::vector<std::uint8_t> r, g, b;
  for (std::uint32_t block = 0; block < store.blocks().size(); ++block) {
    const std::uint32_t points = store.blocks()[block].points;
    for (std::uint32_t first = 0; first < points; first += kRows) {
      const auto n = std::min(kRows, points - first);
      const auto codes = store.read(block, columns::kCodes, first, n);
      const auto colours = store.read(block, columns::kColour, first, n);
      for (std::size_t i = 0; i < n; ++i) {
        if (colours[i] == kNoColour || mix64(codes[i]) % stride != 0) continue;
        r.push_back(static_cast<std::uint8_t>(colours[i] >> 16));
        g.push_back(static_cast<std::uint8_t>(colours[i] >> 8));
        b.push_back(static_cast<std::uint8_t>(colours[i]));
      }
    }
  }
  ColourClassParams params;
  params.k = k;
  params.key = seed;
  return {colour_classes({r, g, b, {}}, params).centre};
}

}  // namespace ilot
