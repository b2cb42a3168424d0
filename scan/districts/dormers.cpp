// SPDX-License-Identifier: Apache-2.0
#include "scan/districts/dormers.h"

#include <algorithm>

#include "scan/roofs/roof_wings.h"

namespace ilot::scan {
namespace {

constexpr Integer kGap = 1000;  // between dormers, and to the ends of the slope
constexpr Integer kGableSlope = 12, kShedSlope = 3;

enum class DormerStyle { gable, shed, flat };

// Returns the depth from the eaves of the slope to the position where the roof of the dormer meets the slope.
Integer depth_of(const Slope& slope, DormerStyle style, Integer width, Integer setback, Integer height) {
  const Integer above = height - slope.eave;  // height of the dormer's eaves above the slope's
  switch (style) {
    case DormerStyle::gable:
      return (above + kGableSlope * width / (2 * kSlopeUnit)) * kSlopeUnit / slope.slope;
    case DormerStyle::shed:
      return (kSlopeUnit * above - kShedSlope * setback) / (slope.slope - kShedSlope);
    default:
      return above * kSlopeUnit / slope.slope;
  }
}

Wing dormer(DormerStyle style, const GridRect& rect, Integer height) {
  switch (style) {
    case DormerStyle::gable:
      return gable_wing(rect, Axis::v, height, kGableSlope);
    case DormerStyle::shed:
      return shed_wing(rect, height, kShedSlope, Uphill::north);
    default:
      return flat_wing(rect, height);
  }
}

}  // namespace

void add_dormers(Rng& rng, const Slope& slope, std::vector<Wing>& wings) {
  const auto style = static_cast<DormerStyle>(rng.below(3));
  const Integer width = 1500 + 500 * static_cast<Integer>(rng.below(style == DormerStyle::gable ? 3 : 5));
  const Integer setback = 250 * static_cast<Integer>(rng.below(4));
  const Integer height = slope.eave + slope.slope * setback / kSlopeUnit + 1250;
  if (slope.slope < kShedSlope + 5) return;
  const Integer end = (depth_of(slope, style, width, setback, height) / 250 + 1) * 250;
  const Integer room = slope.to - slope.from - kGap;
  const Integer count = std::min<Integer>(room / (width + kGap), 1 + static_cast<Integer>(rng.below(4)));
  if (end > slope.depth || count < 1) return;
  const Integer pitch = (slope.to - slope.from) / count / 250 * 250;
  for (Integer i = 0; i < count; ++i) {
    const Integer u = slope.from + i * pitch + (pitch - width) / 2;
    wings.push_back(dormer(style, {u, setback, u + width, end}, height));
  }
}

}  // namespace ilot::scan
