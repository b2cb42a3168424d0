// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/roof_faces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "kernels/core/union_find.h"

namespace ilot {
namespace {

double length_of(const Partition& p, const PartitionEdge& e) {
  return std::sqrt(static_cast<double>(squared_distance(p.vertices[e.from], p.vertices[e.to]))) / 1000;
}

// Connected cells of one label, numbered from 1 in the order of their first cells.
struct Components {
  std::vector<std::uint32_t> of_cell;
  std::uint32_t count = 0;
};

Components components_of(const Partition& cells, std::span<const std::uint32_t> label) {
  std::vector<std::uint32_t> parents(cells.regions);
  UnionFind sets(parents);
  for (const PartitionEdge& e : cells.edges)
    if (e.left != kOutside && e.right != kOutside && label[e.left - 1] == label[e.right - 1])
      sets.unite(e.left - 1, e.right - 1);
  Components c;
  c.of_cell.resize(cells.regions);
  for (std::uint32_t r = 0; r < cells.regions; ++r)
    c.of_cell[r] = sets.find(r) == r ? ++c.count : c.of_cell[sets.find(r)];
  return c;
}

// The number of points of every cell on every plane.
using PointCounts = std::vector<std::map<std::uint32_t, std::uint32_t>>;

PointCounts count_points(const RoofPlanes& planes, std::span<const std::uint32_t> cell_of_point, std::uint32_t cells) {
  PointCounts counts(cells);
  for (std::size_t i = 0; i < cell_of_point.size(); ++i)
    if (cell_of_point[i] != kOutside && planes.of_point[i] != 0) ++counts[cell_of_point[i] - 1][planes.of_point[i]];
  return counts;
}

// The faces of the labels so far: what decides which of them can stay, and their borders.
struct Draft {
  Components components;
  std::vector<double> area;
  std::vector<std::uint32_t> points;
  std::vector<std::map<std::uint32_t, double>> shared;  // per face: length of its borders by the neighbour's label
};

Draft draft_of(const Partition& cells, const std::vector<double>& areas, const PointCounts& counts,
               const std::vector<std::uint32_t>& label) {
  Draft d{components_of(cells, label), {}, {}, {}};
  const Components& c = d.components;
  d.area.resize(c.count + 1);
  d.points.resize(c.count + 1);
  d.shared.resize(c.count + 1);
  for (std::uint32_t r = 0; r < cells.regions; ++r) {
    d.area[c.of_cell[r]] += areas[r + 1];
    const auto at = counts[r].find(label[r]);
    if (at != counts[r].end()) d.points[c.of_cell[r]] += at->second;
  }
  for (const PartitionEdge& e : cells.edges) {
    if (e.left == kOutside || e.right == kOutside) continue;
    const std::uint32_t a = c.of_cell[e.left - 1], b = c.of_cell[e.right - 1];
    if (a == b) continue;
    d.shared[a][label[e.right - 1]] += length_of(cells, e);
    d.shared[b][label[e.left - 1]] += length_of(cells, e);
  }
  return d;
}

// Returns true when the plane would fall too low at a corner of the face.
bool falls(const RoofPlane& plane, const Partition& cells, const Components& c, std::uint32_t face,
           const FaceLimits& limits) {
  const auto low = [&](std::uint32_t v) {
    return too_low(plane, {cells.vertices[v].x / 1000.0, cells.vertices[v].y / 1000.0}, limits) > 0;
  };
  return std::any_of(cells.edges.begin(), cells.edges.end(), [&](const PartitionEdge& e) {
    const bool around = (e.left != kOutside && c.of_cell[e.left - 1] == face) ||
                        (e.right != kOutside && c.of_cell[e.right - 1] == face);
    return around && (low(e.from) || low(e.to));
  });
}

// Gives the smallest face that cannot stay to its neighbour. Returns false when all faces stay.
bool give_one_away(const RoofPlanes& planes, const Partition& cells, const std::vector<double>& areas,
                   const PointCounts& counts, const RoofFaceParams& params, std::vector<std::uint32_t>& label) {
  const Draft d = draft_of(cells, areas, counts, label);
  std::vector<std::uint32_t> leaving;
  for (std::uint32_t k = 1; k <= d.components.count; ++k)
    if (d.area[k] < params.least_area || d.points[k] == 0) leaving.push_back(k);
  std::stable_sort(leaving.begin(), leaving.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return d.area[a] < d.area[b]; });
  for (const std::uint32_t face : leaving) {
    std::uint32_t to = 0;
    double longest = -1;
    for (const auto& [plane, length] : d.shared[face])
      if (length > longest && !falls(planes.planes[plane - 1], cells, d.components, face, params.limits))
        std::tie(to, longest) = std::pair(plane, length);
    if (to == 0) continue;
    for (std::uint32_t r = 0; r < cells.regions; ++r)
      if (d.components.of_cell[r] == face) label[r] = to;
    return true;
  }
  return false;
}

}  // namespace

RoofFaces roof_faces(const RoofSite& site, const RoofPlanes& planes, const Partition& cells,
                     std::span<const std::uint32_t> cell_of_point, std::vector<std::uint32_t> label,
                     const RoofFaceParams& params) {
  const PointCounts counts = count_points(planes, cell_of_point, cells.regions);
  const std::vector<double> areas = region_areas(cells);
  while (give_one_away(planes, cells, areas, counts, params, label)) {
  }
  const Components c = components_of(cells, label);
  RoofFaces r;
  r.planes.resize(c.count);
  for (std::uint32_t cell = 0; cell < cells.regions; ++cell)
    r.planes[c.of_cell[cell] - 1] = planes.planes[label[cell] - 1];
  for (std::size_t i = 0; i < cell_of_point.size(); ++i) {
    const std::uint32_t cell = cell_of_point[i];
    const bool lies_on = cell != kOutside && planes.of_point[i] != 0 && label[cell - 1] == planes.of_point[i];
    r.of_point.push_back(lies_on ? c.of_cell[cell - 1] : 0);
  }
  r.faces = merged(cells, c.of_cell, c.count, corners_in(cells, site.outline));
  return r;
}

}  // namespace ilot
