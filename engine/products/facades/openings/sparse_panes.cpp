// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/sparse_panes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "engine/products/facades/openings/panes.h"
#include "engine/products/facades/rays/cell_bands.h"
#include "kernels/outlines/density_step.h"

namespace ilot {
namespace {

// Choice: clean glass sends back a tenth to a third of the rays, dusty glass all of them.
constexpr double kFewer = 0.5;  // points on a pane over points on as much wall, at most
// Choice: where less comes back the few may be stray or those of a frame; then it is a hole (silent_holes.h).
constexpr double kLeastShare = 0.05;  // points on a pane over points on as much wall, at least
// Derived: of eight points one quarter has none by chance in four panes of ten, of sixteen in one of 25.
constexpr double kFewestOnPane = 8;
// Choice: leaded bars are narrower; nine of the coarsest cells are as wide as a small window.
constexpr double kFinestCell = 0.05, kCoarsestCell = 0.4;  // metres across the cells in which points are counted
// Derived: half of twelve is 1.7 standard deviations less than twelve; the sides are tested with all of their points.
constexpr double kFewestBeside = 12;  // points of nine cells of the wall about a pane
// Choice: the widest sheets of glass between two posts of a hall; farther off the density of a wall changes.
constexpr double kReach = 8;  // metres from a place on a pane to the wall beside it
// Choice: where a pane has few points, half of its cells are so by chance; its sides are tested with all points.
constexpr double kSparseFill = 0.6;  // share of its box
// Choice: as kSparseFill.
constexpr double kStraightSparse = 0.6;  // share of rows and columns that end at a straight side
constexpr double kMostOfFront = 0.6;     // Choice: as kMostOfWall in silent_holes.cpp
constexpr double kPaneFoot = 0.35;       // Choice: as kFoot in silent_holes.cpp, metres
// Choice: what is lower may be the shadow of a fence or a hedge.
constexpr double kLowestDoor = 1.8;  // metres, height of a pane at the foot of the wall
constexpr double kBand = 0.3;        // Choice: the width of a narrow pier; metres on both sides of a side
constexpr double kEnds = 0.1;        // Choice: share of a side at each of its ends that is left out: corners of frames
// Derived: twice this is chi-squared with one degree of freedom, which is exceeded by chance once in 16,000.
constexpr double kSurely = 8;  // log likelihood of the density beside a side over that of one density
// Choice: points lie in lines of the scan, and one of them may be short; the border of a shadow or of a crown is less
// sharp.
constexpr double kSharpLines = 2;   // mean distances of points of the wall: half of the range of a side, at most, or
constexpr double kSharpest = 0.03;  // Choice: the width of a joint; metres
// Choice: a fifth may be hidden by a lamp or a cable; what hides more explains the few echoes.
constexpr double kMostHidden = 0.2;  // rays that ended before a pane over points on as much wall
// Choice: frames of casements are 4 to 8 cm wide; one in the plane of the wall looks like the wall.
constexpr double kFrame = 0.06;               // metres by which an opening may be larger than its glass
constexpr double kSmallest = 0.4;             // Choice: smaller ones alone are dark paint and signs; metres
constexpr std::uint64_t kMostFlat = 1 << 17;  // points about a pane; more do not improve the result
constexpr double kFewestOfStation = 12;       // Derived: as kLeastRays in silent_holes.cpp
// Derived: the middle between as many points as on the wall and half of them.
constexpr double kPier = 0.75;   // points of a pier over those of the wall beside the pane, at least
constexpr double kOneBox = 0.5;  // Derived: a majority; intersection over union of one opening found twice
constexpr double kPiece = 0.5;   // Derived: a majority; share of a piece that lies on a pane

using enum WallCells::What;

// Whether a point lies on the wall or on something flat on it.
bool is_flat(const Ray& ray) {
  return std::abs(static_cast<double>(ray.at.w)) <= kFlatRelief;
}

// The number of flat points of each cell of a wall.
struct CountImage {
  WallCells grid;
  std::vector<std::uint32_t> counts;
};

CountImage flat_points(const RaySamples& samples) {
  const FacadeSite& site = samples.site();
  CountImage image;
  WallCells& grid = image.grid;
  grid.cell = cell_for(site.width, site.height, kFinestCell);
  grid.columns = static_cast<std::int64_t>(site.width / grid.cell) + 1;
  grid.rows = static_cast<std::int64_t>(site.height / grid.cell) + 1;
  grid.what.assign(static_cast<std::size_t>(grid.columns * grid.rows), kSolid);
  image.counts.assign(grid.what.size(), 0);
  for (const RowBand& band : bands_of(grid.columns, grid.rows)) {
    const Box2 rows{0, static_cast<double>(grid.columns) * grid.cell, static_cast<double>(band.first) * grid.cell,
                    static_cast<double>(band.end) * grid.cell};
    for (const Ray& ray : samples.near(rows.grown(grid.cell))) {
      if (!is_flat(ray)) continue;
      const Place2 p = samples.crossing(ray, 0);
      if (p.u < 0 || p.v < 0) continue;
      const auto c = static_cast<std::int64_t>(p.u / grid.cell), r = static_cast<std::int64_t>(p.v / grid.cell);
      if (c < grid.columns && r >= band.first && r < band.end)
        ++image.counts[static_cast<std::size_t>(r * grid.columns + c)];
    }
  }
  return image;
}

// The same in cells of twice the width.
CountImage halved(const CountImage& fine) {
  CountImage image;
  WallCells& grid = image.grid;
  grid.cell = 2 * fine.grid.cell;
  grid.columns = (fine.grid.columns + 1) / 2, grid.rows = (fine.grid.rows + 1) / 2;
  grid.what.assign(static_cast<std::size_t>(grid.columns * grid.rows), kSolid);
  image.counts.assign(grid.what.size(), 0);
  for (std::int64_t r = 0; r < fine.grid.rows; ++r)
    for (std::int64_t c = 0; c < fine.grid.columns; ++c)
      image.counts[static_cast<std::size_t>(r / 2 * grid.columns + c / 2)] +=
          fine.counts[static_cast<std::size_t>(r * fine.grid.columns + c)];
  return image;
}

// The number of points in a cell and in the eight around it.
std::vector<float> points_about(const CountImage& image) {
  const WallCells& grid = image.grid;
  std::vector<float> about(image.counts.size(), 0);
  for (std::int64_t r = 0; r < grid.rows; ++r)
    for (std::int64_t c = 0; c < grid.columns; ++c)
      for (std::int64_t dr = std::max<std::int64_t>(0, r - 1); dr <= std::min(grid.rows - 1, r + 1); ++dr)
        for (std::int64_t dc = std::max<std::int64_t>(0, c - 1); dc <= std::min(grid.columns - 1, c + 1); ++dc)
          about[static_cast<std::size_t>(r * grid.columns + c)] +=
              static_cast<float>(image.counts[static_cast<std::size_t>(dr * grid.columns + dc)]);
  return about;
}

// Lowers `least` to the greatest of the values within `reach` steps before each place of a line. O(count).
void lower_to_most_before(std::span<const float> values, std::int64_t first, std::int64_t stride, std::int64_t count,
                          std::int64_t reach, std::vector<float>& least) {
  const auto at = [&](std::int64_t i) { return static_cast<std::size_t>(first + i * stride); };
  std::deque<std::int64_t> falling;  // places of values, each greater than those behind it
  for (std::int64_t i = 0; i < count; ++i) {
    if (!falling.empty() && falling.front() < i - reach) falling.pop_front();
    least[at(i)] = std::min(least[at(i)], falling.empty() ? 0.0F : values[at(falling.front())]);
    while (!falling.empty() && values[at(falling.back())] <= values[at(i)]) falling.pop_back();
    falling.push_back(i);
  }
}

// For each cell the least of the greatest numbers of points to its left, to its right and above it: along a wall whose
// density falls to one side, it is hardly more than that of the cell.
std::vector<float> points_beside(const std::vector<float>& about, const WallCells& grid) {
  std::vector<float> least(about.size(), INFINITY);
  const std::int64_t columns = grid.columns, rows = grid.rows;
  const auto reach = static_cast<std::int64_t>(kReach / grid.cell) + 1;
  for (std::int64_t r = 0; r < rows; ++r) {
    lower_to_most_before(about, r * columns, 1, columns, reach, least);
    lower_to_most_before(about, (r + 1) * columns - 1, -1, columns, reach, least);
  }
  for (std::int64_t c = 0; c < columns; ++c)
    lower_to_most_before(about, (rows - 1) * columns + c, -columns, rows, reach, least);
  return least;
}

double place_of(const Box2& box, Side side) {
  return side == Side::left ? box.u0 : side == Side::right ? box.u1 : side == Side::bottom ? box.v0 : box.v1;
}

// Looks at single boxes. Around them points are looked for up to `band` metres on both sides of a side.
class PaneJudge {
 public:
  PaneJudge(const RaySamples& samples, double band) : samples_(samples), band_(band) {}

  // The pane about a box of cells; none if it is not sparse or something else explains it.
  std::optional<FoundRectangle> pane_at(const Box2& rough, double least_size) const {
    const bool at_foot = rough.v0 < kPaneFoot;
    if (at_foot && rough.height() < kLowestDoor) return std::nullopt;
    const FlatPoints flat = flat_about(rough.grown(2 * band_));
    FoundRectangle pane;
    pane.few_echoes = true;
    std::vector<double> walls;  // points a square metre beyond each side
    Box2 box = rough;
    // The second time from where the sides were found: those of a shadow that slants are not found again.
    for (int round = 0; round < 2; ++round) {
      walls.clear();
      for (const Side side : kSides) {
        if (side == Side::bottom && at_foot) {
          pane.side(side) = {0, kPaneFoot, DrawnStatus::occluded};
          continue;
        }
        const std::optional<double> density = locate(flat, box, side, pane.side(side));
        if (!density) return std::nullopt;
        walls.push_back(*density);
      }
      box = pane.box();
      if (std::min(box.width(), box.height()) < least_size || common_area(box, rough) < kOneBox * area_of(rough))
        return std::nullopt;
    }
    const double wall = std::accumulate(walls.begin(), walls.end(), 0.0) / static_cast<double>(walls.size());
    const PaneView view = view_of(box);
    if (!is_sparse(view, wall) || has_pier(view.core, wall)) return std::nullopt;
    pane.points = view.behind;
    return pane;
  }

 private:
  // What rays met in a box without its borders, and on the wall about it.
  struct PaneView {
    Box2 core;
    double ring = 0;                                    // square metres about the box
    std::map<SiteStation, std::array<double, 2>> flat;  // by station: points in the core, and about the box
    std::array<double, 4> quarters{};                   // points in each quarter of the core
    double stopped = 0;                                 // rays to the core that ended before the wall
    std::uint64_t behind = 0;                           // rays through the core
  };

  // The flat points in a box, or where these are many a sample of them; each stands for `each` points.
  struct FlatPoints {
    std::vector<Place2> places;
    double each = 1;
  };

  FlatPoints flat_about(const Box2& box) const {
    FlatPoints flat;
    Rays near = samples_.near(box);
    const auto counts = [&](const Ray& ray) { return is_flat(ray) && box.contains(samples_.crossing(ray, 0)); };
    const int level = thinning_level(near, kMostFlat, counts);
    for (int i = 0; i < level; ++i) flat.each *= 2;
    for (const Ray& ray : near)
      if (is_kept(ray, level) && counts(ray)) flat.places.push_back(samples_.crossing(ray, 0));
    return flat;
  }

  // Finds a side, and gives the density of the wall beyond it in points a square metre; nothing if there is no sharp
  // step.
  std::optional<double> locate(const FlatPoints& flat, const Box2& rough, Side side, LocatedEdge& edge) const {
    const bool u = along_u(side);
    const double low = u ? rough.v0 : rough.u0, high = u ? rough.v1 : rough.u1, cut = kEnds * (high - low);
    const double from = place_of(rough, side), along = high - low - 2 * cut;
    const double in = std::min(band_, (u ? rough.width() : rough.height()) / 2);
    std::vector<double> places;  // outwards from the side of the box
    std::vector<Place2> beside;  // along the side, as a share of it, and outwards
    for (const Place2& p : flat.places) {
      const double across = outwards(side) * ((u ? p.u : p.v) - from), at = u ? p.v : p.u;
      if (at < low + cut || at > high - cut || across < -in || across > band_) continue;
      places.push_back(across);
      beside.push_back({(at - low - cut) / along, across});
    }
    std::sort(places.begin(), places.end());
    const DensityStep step = density_step(places, -in, band_);
    if (!step.found || static_cast<double>(places.size()) < kFewestBeside || step.below > kFewer * step.above ||
        step.likelihood < kSurely)
      return std::nullopt;
    if (!is_straight(beside, step.at)) return std::nullopt;
    const double line = std::sqrt(along / (flat.each * step.above));  // the mean distance of points of the wall
    if (step.high - step.low > 2 * std::max(kSharpest, kSharpLines * line)) return std::nullopt;
    // The first point of the wall lies up to a line of the scan beyond the side.
    const double at = step.at - line / 2;
    edge.at = edge.inner = from + outwards(side) * at;
    edge.error = std::max({at - step.low, step.high - at, line / 2}) + samples_.site().noise;
    edge.form = edge.error + kFrame;
    edge.points = places.size();
    return flat.each * step.above / along;
  }

  // Whether there is wall just beyond each third of a side and none just before it: a slanting shadow goes on beyond a
  // part of a side, and ends before another part.
  static bool is_straight(const std::vector<Place2>& beside, double step) {
    std::array<double, 3> wall{}, pane{};
    for (const Place2& p : beside) {
      if (std::abs(p.v - step) > kWidestBar) continue;
      const auto third = std::min<std::size_t>(2, static_cast<std::size_t>(3 * p.u));
      ++(p.v >= step ? wall : pane)[third];
    }
    // By half, and by more than a standard deviation.
    const double mean = (wall[0] + wall[1] + wall[2]) / 3;
    return *std::min_element(wall.begin(), wall.end()) >= kFewer * mean - std::sqrt(mean) &&
           *std::max_element(pane.begin(), pane.end()) <= kFewer * mean + std::sqrt(mean);
  }

  PaneView view_of(const Box2& box) const {
    PaneView view;
    view.core = box.grown(-kEnds * std::min(box.width(), box.height()));
    const Box2 around = box.grown(band_);
    view.ring = area_of(around) - area_of(box);
    const Place2 middle{(box.u0 + box.u1) / 2, (box.v0 + box.v1) / 2};
    for (const Ray& ray : samples_.near(around)) {
      const Place2 p = samples_.crossing(ray, 0);
      const bool inside = view.core.contains(p);
      if (!is_flat(ray)) {
        view.stopped += inside && ray.at.w > 0;
        view.behind += inside && ray.at.w < 0;
      } else if (inside) {
        ++view.flat[ray.station][0];
        ++view.quarters[(p.u > middle.u ? 1U : 0U) + (p.v > middle.v ? 2U : 0U)];
      } else if (around.contains(p) && !box.contains(p)) {
        ++view.flat[ray.station][1];
      }
    }
    return view;
  }

  // Whether the points in a box are those of a pane, where the wall beside it has `wall` points a square metre.
  bool is_sparse(const PaneView& view, double wall) const {
    const double expected = wall * area_of(view.core);
    const double inside = std::accumulate(view.quarters.begin(), view.quarters.end(), 0.0);
    if (inside < std::max(kFewestOnPane, kLeastShare * expected) || inside > kFewer * expected) return false;
    if (view.stopped > kMostHidden * expected) return false;
    // All over it: a corner that is wall is that of a shadow.
    if (std::any_of(view.quarters.begin(), view.quarters.end(),
                    [&](double n) { return n == 0 || n > kFewer * expected / 4; }))
      return false;
    return std::all_of(view.flat.begin(), view.flat.end(), [&](const auto& station) {
      const double of_station = station.second[1] / view.ring * area_of(view.core);
      return of_station < kFewestOfStation || station.second[0] <= kFewer * of_station;
    });
  }

  // Whether a strip wider than a bar has hardly fewer points than the wall: it parts two panes.
  bool has_pier(const Box2& core, double wall) const {
    const auto strips_of = [](double length) { return static_cast<std::size_t>(2 * length / kWidestBar) + 1; };
    std::vector<double> columns(strips_of(core.width()), 0), rows(strips_of(core.height()), 0);
    for (const Ray& ray : samples_.near(core)) {
      const Place2 p = samples_.crossing(ray, 0);
      if (!is_flat(ray) || !core.contains(p)) continue;
      ++columns[static_cast<std::size_t>(2 * (p.u - core.u0) / kWidestBar)];
      ++rows[static_cast<std::size_t>(2 * (p.v - core.v0) / kWidestBar)];
    }
    const auto is_parted = [&](const std::vector<double>& strips, double along) {
      const double expected = wall * along * kWidestBar;
      for (std::size_t i = 0; i + 1 < strips.size(); ++i)
        if (expected >= kFewestBeside && strips[i] + strips[i + 1] > kPier * expected) return true;
      return false;
    };
    return is_parted(columns, core.height()) || is_parted(rows, core.width());
  }

  const RaySamples& samples_;
  double band_;
};

// Adds the panes that show in cells of one width.
void add_panes_of(const RaySamples& samples, CountImage& image, double least_size, std::vector<FoundRectangle>& panes) {
  WallCells& grid = image.grid;
  const std::vector<float> about = points_about(image), beside = points_beside(about, grid);
  for (std::size_t i = 0; i < about.size(); ++i)
    if (beside[i] >= kFewestBeside && about[i] < kFewer * beside[i]) grid.what[i] = kThrough;
  const PaneJudge judge(samples, std::max(kBand, 3 * grid.cell));
  for_each_region(
      grid, [&](std::size_t i) { return grid.what[i] == kThrough; },
      [&](const CellRegion& region) {
        const CellBox box = box_of(region, grid.columns);
        const auto count = static_cast<double>(region.cells.size());
        if (count < kSparseFill * static_cast<double>(box.columns() * box.rows()) ||
            count > kMostOfFront * static_cast<double>(grid.what.size()) ||
            straight_share(region, box, grid.columns) < kStraightSparse)
          return;
        const Box2 rough = box_in_metres(box, grid.cell);
        if (std::min(rough.width(), rough.height()) < least_size) return;
        if (std::optional<FoundRectangle> pane = judge.pane_at(rough, least_size)) panes.push_back(std::move(*pane));
      });
}

}  // namespace

std::vector<FoundRectangle> find_sparse_panes(const RaySamples& samples, double least_size) {
  std::vector<FoundRectangle> found;
  for (CountImage image = flat_points(samples); image.grid.cell <= kCoarsestCell; image = halved(image))
    add_panes_of(samples, image, least_size, found);
  // The larger of two that overlap is the whole window.
  std::stable_sort(found.begin(), found.end(), [](const FoundRectangle& a, const FoundRectangle& b) {
    return area_of(a.box()) > area_of(b.box());
  });
  std::vector<FoundRectangle> panes;
  for (FoundRectangle& pane : found)
    if (std::none_of(panes.begin(), panes.end(),
                     [&](const FoundRectangle& p) { return common_area(p.box(), pane.box()) > 0; }))
      panes.push_back(std::move(pane));
  join_panes(kFinestCell, panes.size(), panes);
  std::erase_if(panes, [](const FoundRectangle& p) { return std::min(p.box().width(), p.box().height()) < kSmallest; });
  std::sort(panes.begin(), panes.end(), [](const FoundRectangle& a, const FoundRectangle& b) {
    return std::pair(a.at(Side::bottom), a.at(Side::left)) < std::pair(b.at(Side::bottom), b.at(Side::left));
  });
  return panes;
}

std::uint64_t sparse_pane_bytes(double width, double height) {
  // Derived: the bytes of a count, two images of sums and two of marks, and a third of these in coarser cells.
  constexpr double kBytesACell = 18;
  const double cell = cell_for(width, height, kFinestCell);
  return static_cast<std::uint64_t>(kBytesACell * width * height / (cell * cell));
}

void add_sparse_panes(std::vector<FoundRectangle>&& panes, std::vector<FoundRectangle>& found) {
  for (FoundRectangle& pane : panes) {
    const Box2 box = pane.box();
    const auto is_known = [&](const FoundRectangle& o) {
      const double common = common_area(box, o.box());
      return common > kOneBox * area_of(box) || common > kOneBox * (area_of(box) + area_of(o.box()) - common);
    };
    if (std::any_of(found.begin(), found.end(), is_known)) continue;
    std::erase_if(found,
                  [&](const FoundRectangle& o) { return common_area(box, o.box()) > kPiece * area_of(o.box()); });
    found.push_back(std::move(pane));
  }
}

}  // namespace ilot
