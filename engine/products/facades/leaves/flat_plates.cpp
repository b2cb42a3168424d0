// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/leaves/flat_plates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "engine/products/facades/leaves/relief_cells.h"
#include "engine/products/facades/openings/trend_surface.h"
#include "engine/products/facades/openings/wall_means.h"
#include "engine/products/facades/rays/cell_bands.h"
#include "kernels/core/quantile.h"

namespace ilot {
namespace {

// Derived: at the middle between both, a point in fifteen is on the wrong side.
constexpr double kRiseOfNoise = 3;  // times the scatter of the wall
// Choice: as kSamePlane in relief.cpp: louvres and panels of a leaf are less deep.
constexpr double kOnePlate = 0.01;  // metres between neighbouring cells of one plate
// Derived: a majority; what stands before a leaf may hide the ends of the others.
constexpr double kStraightPlate = 0.5;  // share of rows and columns that end at a straight side
// Choice: leaves are rectangles, but a corner may be hidden.
constexpr double kPlateFill = 0.75;  // share of its box
// Choice: as kStrayWall in shallow_openings.cpp.
constexpr double kStrayHole = 0.15;  // share of the cells of a square in which there may be something else
// Derived: 2 % of the points of a wall with normal noise are farther out.
constexpr double kSurroundOfNoise = 2;  // times the scatter of the wall
// Choice: half of the 30 cm beside a plate that a surround of 9 cm takes; the side of a leaf takes less.
constexpr double kLeastSurround = 0.15;  // share of the points beside a plate
// Choice: sharp and averaged edges differ by a cell, a tenth of a narrow leaf.
constexpr double kMostOfPlate = 0.8;           // share of a plate that another one of the same leaf covers
constexpr std::uint64_t kMostAbout = 1 << 16;  // points of that; more do not improve the result
constexpr double kFaceOfPlate = 0.01;          // Derived: kLeastFace in relief.cpp

using enum WallCells::What;

void mark_relief(const RaySamples& samples, const TrendSurface& form, double rise, std::int64_t r0, std::int64_t r1,
                 ReliefCells& relief) {
  WallCells& cells = relief.cells;
  const auto size = static_cast<std::size_t>((r1 - r0) * cells.columns);
  std::vector<std::int32_t> before(size, 0), wall(size, 0), behind(size, 0);
  std::vector<double> sum(size, 0);
  const Box2 rows{0, static_cast<double>(cells.columns) * cells.cell, static_cast<double>(r0) * cells.cell,
                  static_cast<double>(r1) * cells.cell};
  for (const Ray& ray : samples.near(rows.grown(cells.cell + 2 * kFlatRelief))) {
    const double off = static_cast<double>(ray.at.w) - form.at(ray.at.u, ray.at.v);
    if (off > kFlatRelief) continue;
    const Place2 p = off > -rise / 2 ? Place2{ray.at.u, ray.at.v} : samples.crossing(ray, 0);
    if (p.u < 0 || p.v < 0) continue;
    const auto c = static_cast<std::int64_t>(p.u / cells.cell), r = static_cast<std::int64_t>(p.v / cells.cell);
    if (c >= cells.columns || r < r0 || r >= r1) continue;
    const auto i = static_cast<std::size_t>((r - r0) * cells.columns + c);
    if (off > rise / 2)
      ++before[i], sum[i] += off;
    else
      ++(off < -rise / 2 ? behind : wall)[i];
  }
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t at = static_cast<std::size_t>(r0 * cells.columns) + i;
    const bool plate = before[i] > wall[i] + behind[i];
    cells.what[at] = plate ? kRelief : behind[i] > wall[i] ? kThrough : wall[i] > 0 ? kSolid : kUnknown;
    relief.out[at] = plate ? static_cast<float>(sum[i] / before[i]) : 0;
  }
}

// On a rough wall single points of a cell do not show a plate that lies near; their mean does. What was marked farther
// before the wall than this stays, and so does what rays went through.
void mark_by_means(const WallMeans& means, double step, double rise, ReliefCells& relief) {
  for (std::size_t i = 0; i < relief.out.size(); ++i) {
    std::uint8_t& what = relief.cells.what[i];
    if (!means.has(i) || what == kThrough || relief.out[i] > static_cast<float>(rise)) continue;
    const double mean = static_cast<double>(means.mean[i]);
    what = mean > step / 2 ? kRelief : mean < -step / 2 ? kThrough : kSolid;
    relief.out[i] = what == kRelief ? static_cast<float>(mean) : 0;
  }
}

// A cell without points is on a plate where five of its neighbours are.
ReliefCells without_gaps_in(const ReliefCells& relief) {
  ReliefCells out = relief;
  const WallCells& cells = relief.cells;
  for (std::int64_t r = 1; r + 1 < cells.rows; ++r)
    for (std::int64_t c = 1; c + 1 < cells.columns; ++c) {
      if (cells.at(c, r) != kUnknown) continue;
      int count = 0;
      float sum = 0;
      for (std::int64_t k = 0; k < 9; ++k) {
        const auto i = static_cast<std::size_t>((r - 1 + k / 3) * cells.columns + c - 1 + k % 3);
        if (cells.what[i] == kRelief) ++count, sum += relief.out[i];
      }
      if (count < 5) continue;
      out.cells.at(c, r) = kRelief;
      out.out[static_cast<std::size_t>(r * cells.columns + c)] = sum / static_cast<float>(count);
    }
  return out;
}

// The connected sets of cells whose depths continue from cell to cell.
std::vector<CellRegion> plates_of(const ReliefCells& relief, const std::vector<bool>& wanted, double apart) {
  const std::int64_t columns = relief.cells.columns, rows = relief.cells.rows;
  std::vector<bool> taken(wanted.size(), false);
  std::vector<CellRegion> regions;
  for (std::size_t start = 0; start < wanted.size(); ++start) {
    if (taken[start] || !wanted[start]) continue;
    CellRegion& region = regions.emplace_back();
    region.cells = {static_cast<std::uint32_t>(start)};
    taken[start] = true;
    for (std::size_t k = 0; k < region.cells.size(); ++k) {
      const std::uint32_t i = region.cells[k];
      const std::int64_t c = i % columns, r = i / columns;
      for (const auto& [nc, nr] :
           {std::pair{c - 1, r}, std::pair{c + 1, r}, std::pair{c, r - 1}, std::pair{c, r + 1}}) {
        if (nc < 0 || nr < 0 || nc >= columns || nr >= rows) continue;
        const auto n = static_cast<std::size_t>(nr * columns + nc);
        if (taken[n] || !wanted[n] || std::abs(relief.out[n] - relief.out[i]) > static_cast<float>(apart)) continue;
        taken[n] = true;
        region.cells.push_back(static_cast<std::uint32_t>(n));
      }
    }
  }
  return regions;
}

// The share of the columns of a region whose highest cell is within one cell of the top of its box.
double straight_at_top(const CellRegion& region, const CellBox& box, std::int64_t columns) {
  std::vector<std::int64_t> high(static_cast<std::size_t>(columns), -1);
  for (const std::int64_t i : region.cells) {
    std::int64_t& top = high[static_cast<std::size_t>(i % columns)];
    top = std::max(top, i / columns);
  }
  double found = 0, all = 0;
  for (const std::int64_t top : high) all += top >= 0, found += std::abs(top - box.r1) <= 1;
  return found / all;
}

// The share of the cells of its box that a region has; more than one where a few cells lie outside of it.
double fill_of(const CellRegion& region, const CellBox& b) {
  return static_cast<double>(region.cells.size()) / static_cast<double>(b.columns() * b.rows());
}

// How far before the wall a surround beside a plate stands, if there is one: points to the left or right of the plate
// that are neither as far out as it nor the wall.
std::optional<double> surround_beside(Rays& near, int thinned, const Box2& box, double level, double out,
                                      double scatter) {
  const double low = std::max(out / 4, kSurroundOfNoise * scatter), high = out - std::max(kOnePlate, scatter);
  const Box2 around = box.grown(kAboutPlate);
  std::vector<double> outs;
  std::size_t all = 0;
  for (const Ray& ray : near) {
    const double u = ray.at.u, v = ray.at.v, w = static_cast<double>(ray.at.w) - level;
    if (!is_kept(ray, thinned) || !around.contains({u, v})) continue;
    if (v < box.v0 || v > box.v1 || (u >= box.u0 && u <= box.u1)) continue;
    ++all;
    if (w > low && w < high) outs.push_back(w);
  }
  if (static_cast<double>(outs.size()) < kLeastSurround * static_cast<double>(all) || outs.empty()) return {};
  return upper_median(outs);
}

// The points about a plate as a wall with one plane before it, levelled. A sill or a lintel ends the plate as the wall
// does, and so does a surround. `scatter` is that of the wall.
FacadeSite site_about_plate(const RaySamples& samples, const Box2& box, double level, double out, double scatter) {
  constexpr std::uint32_t kWallId = 1, kPlateId = 2;
  const FacadeSite& whole = samples.site();
  FacadeSite site;
  site.axes = whole.axes;
  site.width = whole.width, site.height = whole.height;
  site.epsilon = std::min(out / 2, std::max(whole.epsilon, kOnePlate)), site.noise = whole.noise,
  site.step = whole.step;
  site.wall = {kWallId};
  site.parallel = {{kPlateId, 1}};
  for (FacadeStation s : whole.stations) {
    s.position.z -= level;
    site.stations.push_back(s);
  }
  const Box2 around = box.grown(kAboutPlate);
  Rays near = samples.near(around);
  const auto counts = [&](const Ray& ray) { return around.contains(samples.crossing(ray, 0)); };
  const int thinned = thinning_level(near, kMostAbout, counts);
  const std::optional<double> surround = surround_beside(near, thinned, box, level, out, scatter);
  if (surround) site.epsilon = std::min(site.epsilon, (out - *surround) / 2);
  for (const Ray& ray : near) {
    if (!counts(ray) || !is_kept(ray, thinned)) continue;
    FacadePoint p = ray.at;
    p.w -= static_cast<float>(level);
    if (p.w > static_cast<float>(out + kBeforePlate) && p.w <= static_cast<float>(2 * kFlatRelief)) p.w = 0;
    if (surround && p.w < static_cast<float>(out - site.epsilon)) p.w = std::min(p.w, 0.0F);
    const double w = p.w;
    p.plane = std::abs(w - out) <= site.epsilon ? kPlateId : std::abs(w) <= out / 2 ? kWallId : 0;
    site.points.push_back(p);
    if (samples.oblique()) site.from.push_back(static_cast<SiteStation>(ray.station + 1));
  }
  return site;
}

// A plate with its sides.
FoundRectangle located_plate(const RaySamples& samples, const TrendSurface& form, const Box2& box, double out,
                             double cell) {
  const double level = form.at((box.u0 + box.u1) / 2, (box.v0 + box.v1) / 2);
  const FacadeSite site = site_about_plate(samples, box, level, out, form.noise);
  const RaySamples about(site);
  const std::array<std::uint32_t, 1> ids{2};
  const double reach = std::max(2 * cell, std::min(0.12, std::min(box.width(), box.height()) / 2));
  const SideSearch search{
      box,   out, site.epsilon, false, std::min(kFaceOfPlate, out / 3), out - std::min(kFaceOfPlate, out / 3),
      reach, ids};
  FoundRectangle plate;
  for (const Side side : kSides) plate.side(side) = locate_edge(about, search, side);
  std::vector<double> depths;
  for (const FacadePoint& p : site.points)
    if (p.plane == ids[0] && box.contains({p.u, p.v})) depths.push_back(p.w);
  if (!depths.empty()) out = upper_median(depths);
  plate.points = depths.size();
  plate.depth = out + level;
  plate.depth_error = samples.site().noise;
  return plate;
}

// The box of a region that has the form of a plate.
std::optional<CellBox> plate_box(const CellRegion& region, std::int64_t columns) {
  const CellBox b = box_of(region, columns);
  const double fill = fill_of(region, b);
  if (fill < kPlateFill || straight_share(region, b, columns) < kStraightPlate ||
      straight_at_top(region, b, columns) < kStraightPlate)
    return {};
  return b;
}

// The plates that are marked. Whether the wall begins beside them is looked up in `about`.
std::vector<FlatPlate> marked_plates(const RaySamples& samples, const TrendSurface& form, const ReliefCells& relief,
                                     const ReliefCells& about) {
  const WallCells& cells = relief.cells;
  const double apart = std::max(kOnePlate, form.noise);
  const std::vector<bool> is_pier = pier_cells(about, apart);
  std::vector<bool> obstacles = pier_cells(relief, apart);
  for (std::size_t i = 0; i < obstacles.size(); ++i) obstacles[i] = obstacles[i] || cells.what[i] != kRelief;
  const auto side = std::max<std::int64_t>(3, std::llround(kNarrowestPlate / cells.cell));
  std::vector<FlatPlate> found;
  for (const CellRegion& region : plates_of(relief, covered_by_squares(cells, obstacles, side, kStrayHole), apart)) {
    if (static_cast<std::int64_t>(region.cells.size()) < side * side) continue;
    const std::optional<CellBox> b = plate_box(region, cells.columns);
    if (!b) continue;
    std::vector<float> outs;
    for (const std::uint32_t i : region.cells) outs.push_back(relief.out[i]);
    const double out = upper_median(outs);
    const Box2 box = box_in_metres(*b, cells.cell);
    FlatPlate plate{located_plate(samples, form, box, out, cells.cell), {}};
    plate.shape.fill = std::min(1.0, fill_of(region, *b));
    if (std::min(plate.shape.box().width(), plate.shape.box().height()) < kNarrowestPlate) continue;
    for (const Side s : kSides) plate.wall[static_cast<std::size_t>(s)] = wall_beyond(about, is_pier, *b, out, s);
    found.push_back(plate);
  }
  return found;
}

double area_in_both(const Box2& a, const Box2& b) {
  return std::max(0.0, std::min(a.u1, b.u1) - std::max(a.u0, b.u0)) *
         std::max(0.0, std::min(a.v1, b.v1) - std::max(a.v0, b.v0));
}

// Adds plates that means show to those that single points show. What single points show is sharper, but on a rough wall
// it may be a piece only: then the whole takes its place.
void add_averaged(std::vector<FlatPlate>&& averaged, std::vector<FlatPlate>& found) {
  const std::vector<FlatPlate> sharp = found;
  for (FlatPlate& plate : averaged) {
    const Box2 own = plate.shape.box();
    const double area = own.width() * own.height();
    const auto is_whole = [&](const FlatPlate& p) { return area_in_both(p.shape.box(), own) > kMostOfPlate * area; };
    if (std::any_of(sharp.begin(), sharp.end(), is_whole)) continue;
    std::erase_if(found, [&](const FlatPlate& p) { return area_in_both(p.shape.box(), own) > 0; });
    found.push_back(std::move(plate));
  }
}

}  // namespace

FlatPlates find_flat_plates(const RaySamples& samples) {
  const WallCells cells = wall_grid(samples.site());
  const TrendSurface form = trend_surface(samples);
  const double rise = std::max(kLeastStep, kRiseOfNoise * form.noise);
  if (!form.found || rise > kFlatRelief / 2) return {};
  ReliefCells relief{cells, std::vector<float>(cells.what.size(), 0)};
  for (const RowBand& band : bands_of(cells.columns, cells.rows))
    mark_relief(samples, form, rise, band.first, band.end, relief);
  const double scatter = kStepOfNoise * form.noise, deepest = -std::numeric_limits<double>::infinity();
  const WallMeans means = means_about_cells(samples, form, cells, {deepest, rise + scatter, -scatter, rise + scatter});
  const double step = std::max(means.step, kStepOfNoise * means.scatter);
  if (step >= rise) {
    relief = without_gaps_in(relief);
    return {marked_plates(samples, form, relief, relief), relief};
  }
  ReliefCells averaged = relief;
  mark_by_means(means, step, rise, averaged);
  relief = without_gaps_in(relief), averaged = without_gaps_in(averaged);
  std::vector<FlatPlate> found = marked_plates(samples, form, relief, averaged);
  add_averaged(marked_plates(samples, form, averaged, averaged), found);
  return {std::move(found), std::move(averaged)};
}

}  // namespace ilot
