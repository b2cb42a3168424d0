// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/boundaries/density_pass.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <vector>

#include "engine/pass/pass.h"
#include "engine/products/planes/boundaries/boundary_stretches.h"

namespace ilot {
namespace {

constexpr std::size_t kTogether = 8;        // maps that are made at a time
constexpr std::uint32_t kMostPixels = 512;  // along one side of a map
// Derived: a count of 100 has a standard error of 10 %.
constexpr double kPointsPerPixel = 100;
constexpr int kPlaces = 4;                           // along a side of a pixel; at these places the inside is measured
constexpr std::uint64_t kDensityBytesPerPoint = 24;  // code, plane, pixel
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

// The smallest of 1, 2, 5, 10, 20 ... (times a power of ten) that is not below the value.
double round_width(double least) {
  double decade = 1;
  while (decade > least) decade /= 10;
  while (decade * 10 <= least) decade *= 10;
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * decade >= least) return factor * decade;
  return 10 * decade;
}

// A map that is being made: it has the places of the pixels on the plane, in lattice units from the anchor of the
// plane.
struct Draft {
  DensityMap map;
  const JoinedPlane* plane = nullptr;
  PlaneFrame frame;
  double left = 0, top = 0, pixel = 1;
  std::vector<std::uint32_t> count;  // number of points per pixel
  std::vector<std::uint8_t> inside;  // marks of the places per pixel
  std::size_t pixels() const { return std::size_t{map.width} * map.height; }
};

struct Flat {
  double u = 0, v = 0;
};

Flat flat(const Draft& d, Vec3 from_anchor) {
  const Vec3 p = from_anchor - d.frame.origin;
  return {dot(d.frame.u, p), dot(d.frame.v, p)};
}

Vec3 anchor_of(const Draft& d) {
  return {static_cast<double>(d.plane->anchor.x), static_cast<double>(d.plane->anchor.y),
          static_cast<double>(d.plane->anchor.z)};
}

std::vector<std::vector<Flat>> flat_rings(const Draft& d, const Outline& outline, double unit) {
  std::vector<std::vector<Flat>> rings;
  for (const Outline::Part& part : outline.parts)
    for (const Outline::Ring& ring : part) {
      auto& out = rings.emplace_back();
      for (const Vec3 p : ring) out.push_back(flat(d, (1 / unit) * p - anchor_of(d)));
    }
  return rings;
}

// Sets the place and the size of the raster.
void frame_raster(Draft& d, const std::vector<std::vector<Flat>>& rings, const DensityRequest& request, double unit,
                  double metres_per_unit) {
  double u0 = std::numeric_limits<double>::infinity(), u1 = -u0, v0 = u0, v1 = -u0;
  for (const auto& ring : rings)
    for (const Flat p : ring) {
      u0 = std::min(u0, p.u);
      u1 = std::max(u1, p.u);
      v0 = std::min(v0, p.v);
      v1 = std::max(v1, p.v);
    }
  const double metre = 1 / (unit * metres_per_unit);
  const double wanted =
      std::sqrt(kPointsPerPixel * request.area / static_cast<double>(request.points)) * metres_per_unit;
  const double least = std::max(u1 - u0, v1 - v0) / (kMostPixels - 1) / metre;
  d.pixel = round_width(std::max(wanted, least)) * metre;
  d.left = d.pixel * std::floor(u0 / d.pixel);
  d.top = d.pixel * std::ceil(v1 / d.pixel);
  d.map.width = static_cast<std::uint32_t>(std::floor((u1 - d.left) / d.pixel)) + 1;
  d.map.height = static_cast<std::uint32_t>(std::floor((d.top - v0) / d.pixel)) + 1;
}

// Marks the places of pixels that are inside of the rings: they have an odd number of edges to their left.
void measure_inside(Draft& d, const std::vector<std::vector<Flat>>& rings) {
  const double place = d.pixel / kPlaces;
  const std::size_t rows = std::size_t{d.map.height} * kPlaces, columns = std::size_t{d.map.width} * kPlaces;
  std::vector<std::vector<double>> crossings(rows);
  for (const auto& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Flat a = ring[i], b = ring[(i + 1) % ring.size()];
      // The rows, counted from the top, whose middle is between the two ends.
      const double ra = (d.top - a.v) / place - 0.5, rb = (d.top - b.v) / place - 0.5;
      const double first = std::max(0.0, std::ceil(std::min(ra, rb))), last = std::max(ra, rb);
      for (double r = first; r < last && r < static_cast<double>(rows); ++r)
        crossings[static_cast<std::size_t>(r)].push_back(a.u + (r - ra) / (rb - ra) * (b.u - a.u));
    }
  d.inside.assign(d.pixels(), 0);
  for (std::size_t r = 0; r < rows; ++r) {
    std::sort(crossings[r].begin(), crossings[r].end());
    for (std::size_t i = 0; i + 1 < crossings[r].size(); i += 2) {
      const auto column = [&](double u) {
        return static_cast<std::size_t>(
            std::clamp(std::ceil((u - d.left) / place - 0.5), 0.0, static_cast<double>(columns)));
      };
      for (std::size_t c = column(crossings[r][i]); c < column(crossings[r][i + 1]); ++c)
        ++d.inside[r / kPlaces * d.map.width + c / kPlaces];
    }
  }
}

Draft draft_of(const Store& store, const DensityParams& params, const DensityRequest& request, double metres_per_unit) {
  Draft d;
  d.map.plane_id = request.outline.plane_id;
  d.plane = &params.planes[d.map.plane_id - 1];
  d.frame = frame_of_joined(*d.plane);
  const auto rings = flat_rings(d, request.outline, store.unit());
  frame_raster(d, rings, request, store.unit(), metres_per_unit);
  measure_inside(d, rings);
  d.count.assign(d.pixels(), 0);
  return d;
}

// A pixel of a point of a block, as the number of the map and the number of the pixel. There is one for each point.
struct Hit {
  std::uint32_t map = 0, pixel = 0;
};

std::vector<Hit> hits_of(const Store& store, std::uint32_t block, const std::vector<std::uint32_t>& map_of,
                         const std::vector<Draft>& drafts) {
  const auto plane = store.read(block, columns::kPlane);
  std::vector<Hit> hits;
  if (std::none_of(plane.begin(), plane.end(), [&](std::uint32_t p) { return map_of[p] != 0; })) return hits;
  const auto codes = store.read(block, columns::kCodes);
  const Tile tile = store.blocks()[block].node.tile;
  for (std::size_t i = 0; i < plane.size(); ++i) {
    if (map_of[plane[i]] == 0) continue;
    const Draft& d = drafts[map_of[plane[i]] - 1];
    const Index3 p = index_of({tile, codes[i]}), a = d.plane->anchor;
    const Flat at =
        flat(d, {static_cast<double>(p.x - a.x), static_cast<double>(p.y - a.y), static_cast<double>(p.z - a.z)});
    const double column = std::floor((at.u - d.left) / d.pixel), row = std::floor((d.top - at.v) / d.pixel);
    if (column < 0 || row < 0 || column >= d.map.width || row >= d.map.height) continue;
    hits.push_back(
        {map_of[plane[i]] - 1, static_cast<std::uint32_t>(row) * d.map.width + static_cast<std::uint32_t>(column)});
  }
  return hits;
}

void count_points(const Store& store, const DensityParams& params, const PassContext& context,
                  std::vector<Draft>& drafts) {
  std::vector<std::uint32_t> map_of(params.final_id.size(), 0);  // by joined plane + 1: 1 + index into drafts
  for (std::size_t j = 0; j < map_of.size(); ++j)
    for (std::uint32_t m = 0; m < drafts.size(); ++m)
      if (params.final_id[j] == drafts[m].map.plane_id) map_of[j] = m + 1;
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kDensityBytesPerPoint, b.points});
  std::mutex adding;
  run_pass(tasks, context.budget_bytes, [&](std::size_t b) {
    const std::vector<Hit> hits = hits_of(store, static_cast<std::uint32_t>(b), map_of, drafts);
    const std::lock_guard lock(adding);
    for (const Hit& h : hits) ++drafts[h.map].count[h.pixel];
  });
}

DensityMap finished(Draft& d, const Store& store, const DensityParams& params, double metres_per_unit) {
  DensityMap& map = d.map;
  const Vec3 anchor = anchor_of(d);
  map.origin = store.unit() * (anchor + d.frame.origin);
  map.right = d.frame.u;
  map.up = d.frame.v;
  map.left = d.left * store.unit();
  map.top = d.top * store.unit();
  map.pixel = d.pixel * store.unit();
  std::vector<Scanner> stations(params.stations.begin(), params.stations.end());
  for (Scanner& s : stations) s.position = s.position - anchor;
  const double metre = store.unit() * metres_per_unit;  // a lattice unit in metres
  const double place_m2 = d.pixel * d.pixel * metre * metre / (kPlaces * kPlaces);
  map.measured.assign(d.pixels(), kNone);
  map.predicted.assign(d.pixels(), kNone);
  for (std::size_t i = 0; i < d.pixels(); ++i) {
    if (2 * d.inside[i] < kPlaces * kPlaces) continue;
    map.measured[i] = static_cast<float>(d.count[i] / (d.inside[i] * place_m2));
    const double u = d.left + (static_cast<double>(i % map.width) + 0.5) * d.pixel;
    const double v = d.top - (static_cast<double>(i / map.width) + 0.5) * d.pixel;
    const Vec3 middle = d.frame.origin + u * d.frame.u + v * d.frame.v;
    const double density = predicted_density(stations, d.plane->plane, middle) / (metre * metre);
    if (density > 0) map.predicted[i] = static_cast<float>(density);
  }
  return std::move(map);
}

}  // namespace

void density_pass(const Store& store, const DensityParams& params, std::span<const DensityRequest> requests,
                  const PassContext& context, const std::function<void(const DensityMap&)>& take) {
  for (std::size_t done = 0; done < requests.size(); done += kTogether) {
    std::vector<Draft> drafts;
    for (std::size_t i = done; i < std::min(requests.size(), done + kTogether); ++i)
      drafts.push_back(draft_of(store, params, requests[i], context.metres_per_unit));
    count_points(store, params, context, drafts);
    for (Draft& d : drafts) take(finished(d, store, params, context.metres_per_unit));
  }
}

}  // namespace ilot
