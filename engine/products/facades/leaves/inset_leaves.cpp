// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/leaves/inset_leaves.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernels/core/quantile.h"

namespace ilot {
namespace {

// Choice: reveals and frames of a leaf take the rim.
constexpr double kRim = 0.05;  // metres within the sides that are not looked at
// Choice: louvres and panels of a leaf; frames stand at least twice as far before panes.
constexpr double kEven = 0.01;  // metres from the depth of a sheet
// Derived: normal noise stays within three standard deviations.
constexpr double kEvenOfNoise = 3;
// Choice: a frame with one bar takes a sixth of a window; a handle and a few lost rays take a tenth.
constexpr double kSheetCover = 0.9;  // share of the cells of a row with points of the sheet
// Choice: gaps between leaves; a pane with a curtain lets more pass.
constexpr double kSheetPassed = 0.05;  // share of the points of a row that may lie behind it
// Choice: leaves end at most as far below the head of a window as half of it.
constexpr double kLeastOfHeight = 0.5;  // share of the height of an opening that leaves close
// Choice: what is lower may be the case of a blind or a transom.
constexpr double kLeastBlind = 0.15;  // share of the height of an opening that a blind closes
// Choice: frames and sills take the ends.
constexpr double kAtEnd = 0.15;  // metres between a sheet and the end of its opening
// Derived: even steps put one ray into each square of one step; of 2.5 steps a square is seldom empty.
constexpr double kSheetCell = 2.5;  // steps
// Choice: reveals of thick walls; seen at 45 degrees a point is as far beside the place where its ray came in.
constexpr double kReveal = 0.5;  // metres
// Choice: a leaf is 2 cm thick at least and does not touch the frame behind it.
constexpr double kBeforePane = 0.02;  // metres
// Choice: deep frames; the depth of a window is that of its pane or of the frame before it.
constexpr double kFrame = 0.06;            // metres between two depths of one kind of window
constexpr std::size_t kFewestOfRest = 10;  // points
constexpr std::int64_t kFewestAcross = 4;
constexpr std::size_t kFewestSheetRows = 3;
constexpr std::uint64_t kMostInOpening = 1 << 16;  // points; more do not improve the result

// A row of cells across an opening: the depths of the points and the cells they are in.
struct SheetRow {
  std::vector<std::pair<double, std::int64_t>> points;
  bool even = false;
  double depth = 0;
};

void judge_row(SheetRow& row, std::int64_t columns, double within) {
  if (row.points.empty()) return;
  std::vector<double> depths;
  for (const auto& [w, c] : row.points) depths.push_back(w);
  row.depth = upper_median(depths);
  std::vector<bool> on(static_cast<std::size_t>(columns), false);
  double behind = 0;
  for (const auto& [w, c] : row.points) {
    behind += w < row.depth - within;
    if (std::abs(w - row.depth) <= within) on[static_cast<std::size_t>(c)] = true;
  }
  row.even =
      static_cast<double>(std::count(on.begin(), on.end(), true)) >= kSheetCover * static_cast<double>(columns) &&
      behind <= kSheetPassed * static_cast<double>(row.points.size());
}

// The last of the even rows that follow each other from `first` on, at one depth.
std::size_t end_of_sheet(const std::vector<SheetRow>& rows, std::size_t first, double within) {
  std::size_t end = first;
  while (end < rows.size() && rows[end].even && std::abs(rows[end].depth - rows[first].depth) <= within) ++end;
  return end;
}

}  // namespace

std::optional<ClosedPart> closed_part(const RaySamples& samples, const FoundRectangle& opening) {
  if (!(opening.depth < 0) || opening.no_echo) return std::nullopt;
  const Box2 inner = opening.box().grown(-kRim);
  if (inner.width() <= 0 || inner.height() <= 0) return std::nullopt;
  const Place2 steps = samples.step_at({(inner.u0 + inner.u1) / 2, (inner.v0 + inner.v1) / 2});
  const auto columns = static_cast<std::int64_t>(inner.width() / (kSheetCell * steps.u));
  const auto count = static_cast<std::size_t>(inner.height() / (kSheetCell * steps.v));
  if (columns < kFewestAcross || count < kFewestSheetRows) return std::nullopt;
  const double within = std::max(kEven, kEvenOfNoise * samples.site().noise);
  std::vector<SheetRow> rows(count);
  // A point within the reveal is where it is; of one in the room, the place where its ray went through.
  const auto place_of = [&](const Ray& ray) {
    return static_cast<double>(ray.at.w) > -kReveal ? Place2{ray.at.u, ray.at.v} : samples.crossing(ray, 0);
  };
  Rays near = samples.near(inner.grown(kReveal));
  const auto counts = [&](const Ray& ray) { return inner.contains(place_of(ray)); };
  const int level = thinning_level(near, kMostInOpening, counts);
  for (const Ray& ray : near) {
    if (!counts(ray) || !is_kept(ray, level)) continue;
    const Place2 p = place_of(ray);
    const double c = (p.u - inner.u0) / inner.width(), r = (p.v - inner.v0) / inner.height();
    rows[std::min(count - 1, static_cast<std::size_t>(r * static_cast<double>(count)))].points.emplace_back(
        ray.at.w, std::min(columns - 1, static_cast<std::int64_t>(c * static_cast<double>(columns))));
  }
  for (SheetRow& row : rows) judge_row(row, columns, within);
  const double high = inner.height() / static_cast<double>(count);
  const auto at_end = static_cast<std::size_t>(kAtEnd / high) + 1;
  std::size_t best = 0, best_end = 0;
  for (std::size_t first = 0, end = 0; first < count; first = std::max(end, first + 1)) {
    end = end_of_sheet(rows, first, within);
    if (end - first > best_end - best && (first <= at_end || end + at_end >= count)) best = first, best_end = end;
  }
  const double share = static_cast<double>(best_end - best) / static_cast<double>(count);
  const bool from_bottom = best <= at_end;
  if (best_end - best < kFewestSheetRows || share < (from_bottom ? kLeastOfHeight : kLeastBlind)) return std::nullopt;
  FoundRectangle sheet = opening;
  sheet.arc.reset(), sheet.pointed.reset();
  sheet.lean = {};
  std::vector<double> depths;
  sheet.points = 0;
  for (std::size_t r = best; r < best_end; ++r) depths.push_back(rows[r].depth), sheet.points += rows[r].points.size();
  sheet.depth = upper_median(depths), sheet.depth_error = within;
  if (sheet.depth < opening.depth - within) return std::nullopt;  // a pane: bars stand before it
  const auto end_at = [&](Side side, std::size_t row) {
    sheet.side(side) = {inner.v0 + static_cast<double>(row) * high, high};
    sheet.side(side).inner = sheet.at(side);
  };
  if (best > at_end) end_at(Side::bottom, best);
  if (best_end + at_end < count || opening.arc || opening.pointed) end_at(Side::top, best_end);
  ClosedPart part{sheet, from_bottom, std::nullopt};
  std::vector<double> rest;
  for (std::size_t r = 0; r < count; ++r)
    for (const auto& [w, c] : rows[r].points)
      if (r + 1 < best || r > best_end) rest.push_back(w);
  if (rest.size() >= kFewestOfRest) part.behind = upper_median(rest);
  return part;
}

std::vector<std::optional<ClosedPart>> closed_parts(const RaySamples& samples,
                                                    const std::vector<FoundRectangle>& openings) {
  std::vector<std::optional<ClosedPart>> parts;
  std::vector<double> panes;
  for (const FoundRectangle& o : openings) {
    parts.push_back(closed_part(samples, o));
    if (!parts.back() && o.depth < 0) panes.push_back(o.depth);
  }
  // Whether panes of two openings lie at one depth behind the sheet.
  const auto is_before_panes = [&](double depth) {
    for (const double a : panes)
      if (a <= depth - kBeforePane &&
          std::count_if(panes.begin(), panes.end(), [&](double b) { return std::abs(a - b) <= kFrame; }) >= 2)
        return true;
    return false;
  };
  for (std::optional<ClosedPart>& part : parts) {
    if (!part) continue;
    const double depth = part->sheet.depth;
    const bool here = part->behind && *part->behind <= depth - kBeforePane;
    if (!here && !(part->from_bottom && is_before_panes(depth))) part.reset();
  }
  return parts;
}

}  // namespace ilot
