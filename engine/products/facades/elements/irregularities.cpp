// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/irregularities.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/products/facades/rays/cell_bands.h"

#include "kernels/delaunay/alpha_shape.h"
#include "kernels/delaunay/rings.h"
#include "kernels/delaunay/thinning.h"

namespace ilot {
namespace {

// Choice: nine points a cell, so that its mean height has a third of the noise; details below three steps are lost.
constexpr double kCellSteps = 3, kLeastCell = 0.02, kMostCell = 0.1;  // metres
// Choice: one cell of rounding and half of one for the error of the edge; wider mouldings show as bulges.
constexpr double kBeside = 1.5;  // cells around an element that belong to it
// Derived: 4 standard deviations, plus and minus two: 95 % of normal noise.
constexpr double kFlatWidths = 4;  // times the noise: the points of a sheet lie within this width
// Derived: 3 standard errors of a mean; an even wall exceeds it in 0.3 % of its cells.
constexpr double kSteepest = 3;  // times the noise of a mean height: an even wall stays below
// Choice: about a square metre around, more than one window bay; a wall that changes its density within it gives a
// wrong share.
constexpr double kAround = 1;  // metres around a region in which the density of the wall is measured
// Derived: a tenth of the finest step of usual files, 1 mm, so that rounding moves nothing that was measured.
constexpr double kLattice = 1e-4;  // metres
// Choice: the share of delta below which the mean of a cell is rounding and drift of the plane; flatter bulges of
// render are missed.
constexpr double kLeastRise = 0.14;  // share of delta: a smaller mean height counts as zero
// Choice: more than half, so that the end of a wall is no bulge; a bulge in the corner of a wall is missed.
constexpr double kEnclosed = 0.6;  // share of the cells around a region in which the wall is even
// Derived: the circumradius of neighbouring cells is 0.7 of a cell; two allow one missing cell between them.
constexpr double kReachCells = 2;  // cells; circumradius of the triangles of the shape
// Choice: one vertex in 200 may be an outlier; of fewer than 200 vertices the highest one counts.
constexpr double kHighest = 0.005;              // share of the vertices that lie above the rise
constexpr std::uint64_t kMostPoints = 1 << 17;  // an irregularity with more points is drawn coarser; 64 bytes each

struct HeightCell {
  float mean = 0;              // mean w of all points
  std::uint16_t even = 0;      // points within delta of the wall, 32,767 at most
  std::uint16_t odd : 15 = 0;  // points beyond delta and within delta + psi
  std::uint16_t taken : 1 = 0;
};

// The sums of a cell while its points are counted.
struct HeightSums {
  std::uint32_t even = 0, odd = 0;
  double w = 0;  // sum of w

  HeightCell cell() const {
    constexpr std::uint32_t kMost = 32767;
    const std::uint32_t count = even + odd;
    HeightCell cell;
    cell.mean = count == 0 ? 0.0F : static_cast<float>(w / count);
    cell.even = static_cast<std::uint16_t>(std::min(kMost, even));
    cell.odd = std::min(kMost, odd) & kMost;
    return cell;
  }
};

struct Heights {
  double cell = 0;
  std::int64_t columns = 0, rows = 0;
  std::vector<HeightCell> cells;

  HeightCell& at(std::int64_t c, std::int64_t r) { return cells[static_cast<std::size_t>(r * columns + c)]; }
  const HeightCell& at(std::int64_t c, std::int64_t r) const {
    return cells[static_cast<std::size_t>(r * columns + c)];
  }
  std::int64_t index(double u, double v) const {
    const auto c = static_cast<std::int64_t>(std::floor(u / cell)), r = static_cast<std::int64_t>(std::floor(v / cell));
    return c < 0 || r < 0 || c >= columns || r >= rows ? -1 : r * columns + c;
  }
};

void fill_rows(const RaySamples& samples, const RowBand& band, double most, Heights& h) {
  const double epsilon = samples.site().epsilon;
  const auto first = band.first * h.columns, end = band.end * h.columns;
  std::vector<HeightSums> sums(static_cast<std::size_t>(end - first));
  const Box2 rows{0, static_cast<double>(h.columns) * h.cell, static_cast<double>(band.first) * h.cell,
                  static_cast<double>(band.end) * h.cell};
  for (const Ray& ray : samples.at_places(rows.grown(h.cell))) {
    const double w = std::abs(static_cast<double>(ray.at.w));
    const std::int64_t i = h.index(ray.at.u, ray.at.v);
    if (i < first || i >= end || w > most) continue;
    HeightSums& cell = sums[static_cast<std::size_t>(i - first)];
    ++(w <= epsilon ? cell.even : cell.odd);
    cell.w += static_cast<double>(ray.at.w);
  }
  for (std::size_t i = 0; i < sums.size(); ++i) h.cells[static_cast<std::size_t>(first) + i] = sums[i].cell();
}

Heights heights_of(const RaySamples& samples, const std::vector<Box2>& taken, const IrregularityParams& params) {
  const FacadeSite& site = samples.site();
  Heights h;
  h.cell = cell_for(site.width, site.height, std::clamp(kCellSteps * site.step, kLeastCell, kMostCell));
  h.columns = static_cast<std::int64_t>(site.width / h.cell) + 1;
  h.rows = static_cast<std::int64_t>(site.height / h.cell) + 1;
  h.cells.resize(static_cast<std::size_t>(h.columns * h.rows));
  for (const RowBand& band : bands_of(h.columns, h.rows)) fill_rows(samples, band, site.epsilon + params.psi, h);
  const double rim = kBeside * h.cell;
  for (std::int64_t r = 0; r < h.rows; ++r)
    for (std::int64_t c = 0; c < h.columns; ++c) {
      const double u = (static_cast<double>(c) + 0.5) * h.cell, v = (static_cast<double>(r) + 0.5) * h.cell;
      h.at(c, r).taken = u < rim || v < rim || u > site.width - rim || v > site.height - rim;
    }
  for (const Box2& box : taken) {
    const Box2 around = box.grown(rim);
    const auto clamp = [&](double at, std::int64_t count) {
      return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(at / h.cell)), 0, count - 1);
    };
    for (std::int64_t r = clamp(around.v0, h.rows); r <= clamp(around.v1, h.rows); ++r)
      for (std::int64_t c = clamp(around.u0, h.columns); c <= clamp(around.u1, h.columns); ++c) h.at(c, r).taken = true;
  }
  return h;
}

using Region = std::vector<std::uint32_t>;  // cells, each row * columns + column

// The cells for which `belongs` is true that are connected with `start` along their sides.
template <class Belongs>
Region flood(const Heights& h, Region cells, std::vector<bool>& seen, const Belongs& belongs) {
  for (const std::uint32_t i : cells) seen[i] = true;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const std::int64_t c = cells[k] % h.columns, r = cells[k] / h.columns;
    for (const auto& [dc, dr] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
      const std::int64_t nc = c + dc, nr = r + dr;
      if (nc < 0 || nr < 0 || nc >= h.columns || nr >= h.rows) continue;
      const std::int64_t n = nr * h.columns + nc;
      if (seen[static_cast<std::size_t>(n)] || !belongs(h.cells[static_cast<std::size_t>(n)])) continue;
      seen[static_cast<std::size_t>(n)] = true;
      cells.push_back(static_cast<std::uint32_t>(n));
    }
  }
  return cells;
}

// The number of points per cell within the wide threshold, divided by that around the region, where the wall is even.
double density_of(const Heights& h, const Region& region) {
  std::vector<bool> in(h.cells.size(), false);
  std::int64_t c0 = INT64_MAX, c1 = 0, r0 = INT64_MAX, r1 = 0;
  double own = 0, wall = 0, cells = 0;
  for (const std::int64_t i : region) {
    in[static_cast<std::size_t>(i)] = true;
    own += h.cells[static_cast<std::size_t>(i)].even + h.cells[static_cast<std::size_t>(i)].odd;
    c0 = std::min(c0, i % h.columns), c1 = std::max(c1, i % h.columns);
    r0 = std::min(r0, i / h.columns), r1 = std::max(r1, i / h.columns);
  }
  const auto beside = static_cast<std::int64_t>(kAround / h.cell) + 1;
  for (std::int64_t r = std::max<std::int64_t>(0, r0 - beside); r <= std::min(h.rows - 1, r1 + beside); ++r)
    for (std::int64_t c = std::max<std::int64_t>(0, c0 - beside); c <= std::min(h.columns - 1, c1 + beside); ++c) {
      const HeightCell& cell = h.at(c, r);
      if (in[static_cast<std::size_t>(r * h.columns + c)] || cell.taken != 0 || cell.even <= cell.odd) continue;
      wall += cell.even;
      cells += 1;
    }
  return wall == 0 ? 0 : own / static_cast<double>(region.size()) / (wall / cells);
}

// The share of the cells beside a region in which the wall is even. A region on the rim of the wall is no part of it.
double enclosed(const Heights& h, const Region& region) {
  std::vector<bool> in(h.cells.size(), false);
  for (const std::int64_t i : region) in[static_cast<std::size_t>(i)] = true;
  double even = 0, all = 0;
  for (const std::int64_t i : region)
    for (const auto& [dc, dr] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
      const std::int64_t c = i % h.columns + dc, r = i / h.columns + dr;
      const bool outside = c < 0 || r < 0 || c >= h.columns || r >= h.rows;
      if (!outside && in[static_cast<std::size_t>(r * h.columns + c)]) continue;
      even += !outside && h.at(c, r).taken == 0 && h.at(c, r).even > h.at(c, r).odd;
      all += 1;
    }
  return all == 0 ? 0 : even / all;
}

// The points of a region. If there are too many, only those of one level.
struct RegionPoints {
  std::vector<Vec3> kept;
  std::uint64_t count = 0;
  int level = 0;
};

RegionPoints points_in(const RaySamples& samples, const Heights& h, const Region& region, double most) {
  std::vector<bool> in(h.cells.size(), false);
  Box2 box{INFINITY, -INFINITY, INFINITY, -INFINITY};
  for (const std::uint32_t i : region) {
    in[i] = true;
    const double u = static_cast<double>(i % h.columns) * h.cell, v = static_cast<double>(i / h.columns) * h.cell;
    box = {std::min(box.u0, u), std::max(box.u1, u + h.cell), std::min(box.v0, v), std::max(box.v1, v + h.cell)};
  }
  const auto is_inside = [&](const Ray& ray) {
    const std::int64_t i = h.index(ray.at.u, ray.at.v);
    return i >= 0 && in[static_cast<std::size_t>(i)] && std::abs(static_cast<double>(ray.at.w)) <= most;
  };
  Rays rays = samples.at_places(box.grown(h.cell));
  RegionPoints points;
  points.level = thinning_level(rays, kMostPoints, is_inside);
  for (const Ray& ray : rays) {
    if (!is_inside(ray)) continue;
    ++points.count;
    if (is_kept(ray, points.level)) points.kept.push_back({ray.at.u, ray.at.v, ray.at.w});
  }
  return points;
}

// The largest share of the points beyond delta that lies within the width of a sheet around one depth.
double flat_share(const std::vector<Vec3>& points, double delta, double width) {
  std::vector<double> w;
  for (const Vec3& p : points)
    if (std::abs(p.z) > delta) w.push_back(p.z);
  if (w.empty()) return 1;
  std::sort(w.begin(), w.end());
  std::size_t most = 0, end = 0;
  for (std::size_t i = 0; i < w.size(); ++i) {
    while (end < w.size() && w[end] - w[i] <= width) ++end;
    most = std::max(most, end - i);
  }
  return static_cast<double>(most) / static_cast<double>(w.size());
}

// One vertex per cell: the mean of its points. This divides the noise by the root of their number.
std::vector<Vec3> thinned(const std::vector<Vec3>& points, double cell) {
  std::vector<std::pair<std::pair<std::int64_t, std::int64_t>, Vec3>> by_cell;
  for (const Vec3& p : points)
    by_cell.push_back(
        {{static_cast<std::int64_t>(std::floor(p.y / cell)), static_cast<std::int64_t>(std::floor(p.x / cell))}, p});
  std::sort(by_cell.begin(), by_cell.end(), [](const auto& a, const auto& b) {
    if (a.first != b.first) return a.first < b.first;
    if (a.second.x != b.second.x) return a.second.x < b.second.x;
    return a.second.y != b.second.y ? a.second.y < b.second.y : a.second.z < b.second.z;
  });
  std::vector<Vec3> means;
  for (std::size_t i = 0, end = 0; i < by_cell.size(); i = end) {
    Vec3 sum;
    for (end = i; end < by_cell.size() && by_cell[end].first == by_cell[i].first; ++end)
      sum = sum + by_cell[end].second;
    means.push_back((1 / static_cast<double>(end - i)) * sum);
  }
  return means;
}

// Makes the triangulation, clipped to the largest ring of its alpha shape.
void make_mesh(const std::vector<Vec3>& points, double cell, Irregularity& found) {
  found.vertices = thinned(points, cell);
  std::vector<Point2> places;
  for (const Vec3& p : found.vertices) places.push_back(lattice_point({p.x / kLattice, p.y / kLattice}, 1));
  const Triangulation t = delaunay(places);
  const std::vector<float> reach(places.size(), static_cast<float>(kReachCells * cell / kLattice));
  ShapeParams shape;
  shape.reach = reach;
  std::vector<std::uint8_t> keep = shape_triangles(t, places, shape);
  keep_enclosed(t, keep);
  const std::vector<BoundaryEdge> edges = boundary_edges(t, keep);
  const Polygons outer = outer_rings(assemble_rings(edges, places), places);
  const Polygons rings = thin_rings(outer, places, cell / 2 / kLattice);
  std::int64_t most = 0;
  for (const Ring& r : rings.rings) {
    if (twice_area(rings, r, places) <= most) continue;
    most = twice_area(rings, r, places);
    found.ring.clear();
    for (std::uint32_t i = 0; i < r.count; ++i) {
      const Vec3& p = found.vertices[rings.vertices[r.first + i]];
      found.ring.push_back({p.x, p.y});
    }
  }
  for (std::size_t i = 0; i < t.triangles(); ++i)
    if (keep[i] != 0) found.triangles.push_back({t.corner[3 * i], t.corner[3 * i + 1], t.corner[3 * i + 2]});
}

void find_rise(Irregularity& found, double noise) {
  std::vector<double> w;
  for (const Vec3& p : found.vertices) w.push_back(p.z);
  std::sort(w.begin(), w.end());
  const auto tail = static_cast<std::size_t>(kHighest * static_cast<double>(w.size()));
  const double high = w[w.size() - 1 - tail], low = w[tail];
  found.rise = high >= -low ? high : low;
  found.rise_error = 2 * noise;
}

}  // namespace

std::vector<Irregularity> find_irregularities(const RaySamples& samples, const std::vector<Box2>& taken,
                                              const IrregularityParams& params) {
  const FacadeSite& site = samples.site();
  const Heights h = heights_of(samples, taken, params);
  std::vector<bool> seen(h.cells.size(), false);
  std::vector<Irregularity> found;
  for (std::size_t start = 0; start < h.cells.size(); ++start) {
    const auto seed = [](const HeightCell& c) { return c.taken == 0 && c.odd > c.even; };
    if (seen[start] || !seed(h.cells[start])) continue;
    Region region = flood(h, {static_cast<std::uint32_t>(start)}, seen, seed);
    if (static_cast<double>(region.size()) * h.cell * h.cell < params.least_area) continue;
    const double side = h.cells[start].mean;
    region = flood(h, std::move(region), seen, [&](const HeightCell& c) {
      const double bound = kSteepest * site.noise / std::sqrt(static_cast<double>(c.even + c.odd));
      return c.taken == 0 && c.even + c.odd > 0 && c.mean * side > 0 &&
             std::abs(c.mean) > bound + kLeastRise * site.epsilon;
    });
    Irregularity one;
    if (enclosed(h, region) < kEnclosed) continue;
    one.density = density_of(h, region);
    const RegionPoints points = points_in(samples, h, region, site.epsilon + params.psi);
    if (one.density < params.least_density ||
        flat_share(points.kept, site.epsilon, std::max(kFlatWidths * site.noise, site.epsilon)) > params.most_flat)
      continue;
    one.points = points.count;
    // The cell grows, so that it contains as many points as if no point had been left out.
    const double coarser = std::sqrt(std::ldexp(1.0, points.level));
    make_mesh(points.kept, coarser * std::max(h.cell / kCellSteps * 1.5, kLeastCell / 2), one);
    if (one.ring.size() < 3) continue;
    find_rise(one, site.noise);
    found.push_back(std::move(one));
  }
  return found;
}

}  // namespace ilot
