// SPDX-License-Identifier: Apache-2.0
// A polygon parted into cells by lines, on a grid of whole millimetres.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/roofs/sites/roof_site.h"
#include "kernels/geometry/flat.h"

namespace ilot {

constexpr std::uint32_t kOutside = 0;

// A straight edge between two regions; regions are numbered from 1, kOutside is beyond the polygon.
struct PartitionEdge {
  std::uint32_t from = 0, to = 0;  // vertices
  std::uint32_t left = kOutside, right = kOutside;
};

// A planar subdivision: edges meet only in vertices, no two vertices coincide. Vertices ascend by (x, y), edges by
// (from, to) with from < to.
struct Partition {
  std::vector<Point2> vertices;  // millimetres from the site's anchor
  std::vector<PartitionEdge> edges;
  std::uint32_t regions = 0;
};

// Brings a subdivision into that form after vertices were moved or added: those at one place become one, edges without
// length go, and where a region has lost its width its two sides become one edge.
void tidy(Partition& partition);

// Whether direction p - o comes before q - o counter-clockwise from the direction of +x.
bool turns_before(Point2 o, Point2 p, Point2 q);

// Cuts the polygon by the lines (metres). Ends of lines that lead nowhere are dropped. Snap rounding (line_net.h) keeps
// vertices on the grid, so lines move by up to a millimetre, and those of the outline too where a line passes within
// one. Without lines the polygon itself, region 1; of a polygon whose rings cross, what an odd number of them encloses.
Partition part(const SitePolygon& outline, std::span<const FlatEdge> lines);

// Region of each point (millimetres), kOutside when beyond all; a point on an edge belongs to either side of it.
// O(edges + points x edges of a strip), strips as many as the root of the edges.
std::vector<std::uint32_t> regions_of(const Partition& partition, std::span<const FlatPoint> points);

// Regions with one label become one region, numbered by label; edges between them go, and vertices in the middle of
// straight borders, unless fixed (one flag a vertex). Labels from 1 to `labels`, one per region.
Partition merged(const Partition& partition, std::span<const std::uint32_t> label, std::uint32_t labels,
                 std::span<const std::uint8_t> fixed);

// One flag per vertex: 1 = a corner of the outline.
std::vector<std::uint8_t> corners_in(const Partition& partition, const SitePolygon& outline);

// The ends of edges below `shortest` metres become one vertex; corners of the outline stay where they are.
void close_short_edges(Partition& partition, const SitePolygon& outline, double shortest);

// The regions as polygons, in their order, with all vertices of their borders.
std::vector<SitePolygon> region_polygons(const Partition& partition);

// Square metres of every region, [0] = 0.
std::vector<double> region_areas(const Partition& partition);

}  // namespace ilot
