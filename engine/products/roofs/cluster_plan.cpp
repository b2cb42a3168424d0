// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/cluster_plan.h"

#include <algorithm>
#include <cmath>

#include "engine/columns/clusters_pass.h"
#include "engine/pass/pass.h"
#include "engine/products/roofs/site_modeller.h"
#include "engine/products/roofs/sites/cluster_outline.h"
#include "engine/products/roofs/sites/outline_repair.h"
#include "engine/products/roofs/sites/party_walls.h"
#include "engine/products/roofs/sites/site_points.h"
#include "engine/units/unit_sample.h"

namespace ilot {
namespace {

constexpr double kLeastDistance = 0.5;  // metres [Boltcheva et al. 2019, 3.1]
// Derived: neighbours on an even roof are within the square root of 2 steps; two bridge rows that are spread unevenly.
constexpr double kStepsOfDistance = 2;  // sampling steps
// Choice: the cells of the median of density; time alone beyond 1 m.
constexpr double kCountingCell = 2.1;  // metres, at most
constexpr std::uint64_t kBytesToCount = 40, kBytesToOutline = 256;
constexpr std::int64_t kMillimetresPerMetre = 1000;

// A square of the plan, and how many building points it has. Two metres wide, so that its numbers fit.
struct CountedCell {
  std::int32_t x = 0, y = 0;
  std::uint32_t points = 0;
};

bool same_cell(const CountedCell& a, const CountedCell& b) {
  return a.x == b.x && a.y == b.y;
}

// Sorts cells and adds up those that are the same.
void add_up(std::vector<CountedCell>& cells) {
  std::sort(cells.begin(), cells.end(),
            [](const CountedCell& a, const CountedCell& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
  std::size_t last = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    if (same_cell(cells[last], cells[i])) {
      cells[last].points += cells[i].points;
    } else {
      cells[++last] = cells[i];
    }
  }
  cells.resize(std::min(cells.size(), last + 1));
}

std::vector<CountedCell> cells_of(const Store& store, std::uint32_t block, int cell_bits) {
  const auto roles = store.read(block, columns::kRole);
  const auto codes = store.read(block, columns::kCodes);
  std::vector<CountedCell> cells;
  for (std::size_t i = 0; i < roles.size(); ++i) {
    if (roles[i] != PointRole::building) continue;
    const Index3 p = index_of({store.blocks()[block].node.tile, codes[i]});
    const CountedCell cell{static_cast<std::int32_t>(p.x >> cell_bits), static_cast<std::int32_t>(p.y >> cell_bits), 1};
    if (!cells.empty() && same_cell(cells.back(), cell)) {
      ++cells.back().points;
    } else {
      cells.push_back(cell);
    }
  }
  add_up(cells);
  return cells;
}

// The distance between building points in metres, from the median of their density: walls may have many more points in
// the plan than roofs, and stand in fewer cells.
double sampling_step(const Store& store, const PassContext& context) {
  const double unit = store.unit() * context.metres_per_unit;
  int cell_bits = 0;
  while (cell_bits < 40 && std::ldexp(unit, cell_bits + 1) <= kCountingCell) ++cell_bits;
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kBytesToCount, b.points});
  std::vector<std::vector<CountedCell>> parts(tasks.size());
  run_pass(tasks, context.budget_bytes,
           [&](std::size_t i) { parts[i] = cells_of(store, static_cast<std::uint32_t>(i), cell_bits); });
  std::vector<CountedCell> cells;
  for (std::vector<CountedCell>& part : parts) {
    cells.insert(cells.end(), part.begin(), part.end());
    part = {};
  }
  if (cells.empty()) return 0;
  add_up(cells);
  const auto middle = cells.begin() + static_cast<std::ptrdiff_t>(cells.size() / 2);
  std::nth_element(cells.begin(), middle, cells.end(),
                   [](const CountedCell& a, const CountedCell& b) { return a.points < b.points; });
  return std::ldexp(unit, cell_bits) / std::sqrt(static_cast<double>(middle->points));
}

// The distance is a multiple of kLeastDistance by a power of the square root of two, so that a part of a cloud and the
// whole cloud give the same value.
double distance_for(double step) {
  double distance = kLeastDistance;
  while (distance < kStepsOfDistance * step) distance *= std::sqrt(2.0);
  return distance;
}

double choose_distance(const Store& store, const RoofsSettings& settings, const PassContext& context,
                       RunRecord& record) {
  if (settings.cluster_distance) return *settings.cluster_distance;
  const double step = sampling_step(store, context);
  const double distance = distance_for(step);
  record.chosen.push_back({"roofs.cluster_distance", distance,
                           "0.5 m, times the root of 2 until it is twice the sampling step of the building points, " +
                               std::to_string(step) + " m"});
  return distance;
}

// The least number of points of a cluster: as many as cover a small building, and fewer in a sparse cloud. It is
// computed from the distance, so that a part of a cloud and the whole cloud give the same value.
std::uint64_t choose_points(double distance, const RoofsSettings& settings, RunRecord& record) {
  if (settings.cluster_points) return static_cast<std::uint64_t>(*settings.cluster_points);
  // Choice: garages have 15 m2; smaller sheds are left out.
  constexpr double kSmallBuilding = 10;  // m2
  // Derived: 20 points fix a plane and its noise; more than 100 prove nothing more.
  constexpr double kFewest = 20, kMost = 100;
  const double step = distance / kStepsOfDistance;
  const double points = std::floor(std::clamp(kSmallBuilding / (step * step), kFewest, kMost));
  record.chosen.push_back({"roofs.cluster_points", points,
                           "what covers 10 m2 where the sampling step is half of roofs.cluster_distance, 20 to 100"});
  return static_cast<std::uint64_t>(points);
}

class Outliner {
 public:
  Outliner(const Store& store, const std::vector<CloudCluster>& clusters, double metres_per_unit, double alpha_m)
      : store_(store), clusters_(clusters), millimetres_(store.unit() * metres_per_unit * kMillimetresPerMetre) {
    params_.alpha = alpha_m * kMillimetresPerMetre;
  }

  std::uint64_t points_to_read(std::uint32_t cluster) const {
    return plan_view(store_, clusters_[cluster].box, {}).size;
  }

  std::vector<PlannedSite> sites_of(std::uint32_t cluster) const {
    const CloudCluster& c = clusters_[cluster];
    const std::string id = std::to_string(c.first.x) + "_" + std::to_string(c.first.y);
    const std::int64_t x = grid(c.box.min.x), y = grid(c.box.min.y);
    std::vector<PlannedSite> sites;
    for (const SitePolygon& polygon : buildings_of(cluster, x, y)) {
      std::vector<std::vector<std::pair<std::int64_t, std::int64_t>>> rings;
      for (const auto& ring : polygon) {
        auto& placed = rings.emplace_back();
        for (const Point2 p : ring) placed.emplace_back(x + p.x, y + p.y);
      }
      const std::string part = sites.empty() ? "" : "-" + std::to_string(sites.size() + 1);
      sites.push_back({id + part, place_outline(rings), "", ""});
    }
    if (sites.empty()) sites.push_back({id, {}, "its points enclose no area", ""});
    return sites;
  }

 private:
  std::int64_t grid(std::int64_t v) const { return std::llround(static_cast<double>(v) * millimetres_); }

  // The outlines of a cluster, split where buildings adjoin. Slivers between crossing walls are
  // left out, and parts that hang together in a corner are two buildings.
  std::vector<SitePolygon> buildings_of(std::uint32_t cluster, std::int64_t x, std::int64_t y) const {
    const std::vector<Vec3> points = points_of(cluster, x, y);
    std::vector<Point2> places;
    places.reserve(points.size());
    for (const Vec3& p : points) places.push_back(lattice_point({p.x, p.y}, kMillimetresPerMetre));
    std::vector<SitePolygon> outlines = cluster_outline(places, params_);
    double area = 0;
    for (const SitePolygon& outline : outlines) area += area_of(outline);
    const double step = std::sqrt(area / static_cast<double>(points.size()));
    std::vector<SitePolygon> buildings;
    for (const SitePolygon& outline : outlines)
      for (const SitePolygon& part : split_at_party_walls(outline, points, step))
        for (SitePolygon& whole : repair_outline(part, params_.least_area).polygons)
          if (area_of(whole) >= params_.least_area) buildings.push_back(std::move(whole));
    return buildings;
  }

  // All points of the cluster, or a sample of them, in metres from the anchor on its grid of millimetres.
  std::vector<Vec3> points_of(std::uint32_t cluster, std::int64_t x, std::int64_t y) const {
    const auto of_cluster = [&](const Stretch& s) {
      return [cluster, of = s.read(store_, columns::kCluster)](const StretchPoint& p) {
        return of[p.number] == cluster + 1;
      };
    };
    const UnitSample sample = sample_unit(store_, clusters_[cluster].box, kMostSitePoints, of_cluster);
    std::vector<Vec3> points;
    points.reserve(sample.points.size());
    for (const KeptPoint& k : sample.points)
      points.push_back({static_cast<double>(grid(k.position.x) - x) / kMillimetresPerMetre,
                        static_cast<double>(grid(k.position.y) - y) / kMillimetresPerMetre,
                        static_cast<double>(grid(k.position.z)) / kMillimetresPerMetre});
    return points;
  }

  const Store& store_;
  const std::vector<CloudCluster>& clusters_;
  double millimetres_;  // millimetres of a lattice unit
  ClusterOutlineParams params_;
};

}  // namespace

double suitable_cluster_distance(const Store& store, const PassContext& context) {
  return distance_for(sampling_step(store, context));
}

std::vector<PlannedSite> plan_clusters(const Store& store, const RoofsSettings& settings, const PassContext& context,
                                       Progress& progress, RunRecord& record) {
  progress.begin_stage("clusters", store.points());
  const double distance = choose_distance(store, settings, context, record);
  const std::uint64_t fewest = choose_points(distance, settings, record);
  const double unit = store.unit() * context.metres_per_unit;
  const ClusterParams params{PointRole::building, std::max<std::int64_t>(1, std::llround(distance / unit))};
  const std::vector<CloudCluster> clusters = clusters_pass(store, params, context);
  const Outliner outliner(store, clusters, context.metres_per_unit, distance);
  ClustersRecord& summary = record.clusters.emplace();
  std::vector<std::uint32_t> large;
  std::vector<PassTask> tasks;
  for (std::uint32_t c = 0; c < clusters.size(); ++c) {
    ++summary.clusters;
    if (clusters[c].points < fewest) {
      ++summary.too_small;
      summary.points_of_too_small += clusters[c].points;
      continue;
    }
    large.push_back(c);
    const std::uint64_t points = std::min<std::uint64_t>(outliner.points_to_read(c), kMostSitePoints);
    tasks.push_back({kBytesOfSite + points * kBytesToOutline, clusters[c].points});
  }
  std::vector<std::vector<PlannedSite>> found(large.size());
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) { found[i] = outliner.sites_of(large[i]); });
  std::vector<PlannedSite> sites;
  for (auto& of_cluster : found)
    for (PlannedSite& site : of_cluster) sites.push_back(std::move(site));
  order_sites(sites);
  progress.end_stage();
  return sites;
}

}  // namespace ilot
