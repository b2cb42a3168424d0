// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/products/facades/openings/silent_holes.h"

namespace ilot {
namespace {

// Derived: a majority; rays that ended on reveals alone are near the sides of a hole.
constexpr double kSpreadBehind = 0.5;  // share of the height and of the width over which rays ended behind the wall
// Choice: frames reach the head of their door but for a few cells; what stands in a room ends anywhere.
constexpr double kStraightBehind = 0.8;  // share of the lines of cells in which these rays end at one height
// Choice: rooms are dark below a lintel; a sign or an awning that was removed from the cloud is higher.
constexpr double kMostUnshown = 0.5;  // metres between these rays and a side of the hole

// The lines of cells across one axis of a hole, as its rows or columns are numbered.
struct HoleLines {
  std::int64_t first = INT64_MAX, last = -1;  // lines in which rays ended behind the wall
  double to_first = 0, to_last = 0;           // share of the lines across that reach these ends
};

HoleLines lines_of(const CellBox& hole, const std::vector<bool>& behind, bool rows) {
  const std::int64_t columns = hole.columns(), across = rows ? columns : hole.rows();
  std::vector<HoleLines> of_line(static_cast<std::size_t>(across));
  HoleLines all;
  for (std::size_t i = 0; i < behind.size(); ++i) {
    if (!behind[i]) continue;
    const std::int64_t c = static_cast<std::int64_t>(i) % columns, r = static_cast<std::int64_t>(i) / columns;
    const std::int64_t at = rows ? r : c;
    HoleLines& own = of_line[static_cast<std::size_t>(rows ? c : r)];
    own.first = std::min(own.first, at), own.last = std::max(own.last, at);
    all.first = std::min(all.first, at), all.last = std::max(all.last, at);
  }
  double seen = 0;
  for (const HoleLines& own : of_line) {
    if (own.last < 0) continue;
    ++seen;
    all.to_first += own.first <= all.first + 1, all.to_last += own.last >= all.last - 1;
  }
  if (seen > 0) all.to_first /= seen, all.to_last /= seen;
  return all;
}

}  // namespace

std::optional<CellBox> shown_part(const CellBox& hole, const std::vector<bool>& behind, double cell) {
  CellBox part = hole;
  const HoleLines rows = lines_of(hole, behind, true), columns = lines_of(hole, behind, false);
  const auto is_spread = [](const HoleLines& l, std::int64_t all) {
    return static_cast<double>(l.last - l.first + 1) >= kSpreadBehind * static_cast<double>(all);
  };
  if (!is_spread(rows, part.rows()) || !is_spread(columns, part.columns())) return std::nullopt;
  const auto most = static_cast<std::int64_t>(kMostUnshown / cell);
  const auto cut = [&](const HoleLines& l, std::int64_t& first, std::int64_t& last) {
    const std::int64_t begin = first, end = last;
    if (l.first > most && l.to_first >= kStraightBehind) first = begin + l.first;
    if (end - begin - l.last > most && l.to_last >= kStraightBehind) last = begin + l.last;
  };
  cut(columns, part.c0, part.c1), cut(rows, part.r0, part.r1);
  return part;
}

}  // namespace ilot
