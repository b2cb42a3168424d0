// SPDX-License-Identifier: Apache-2.0
// A polygon that lines divide into cells, on a grid of whole millimetres.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/roofs/sites/roof_site.h"
#include "kernels/geometry/flat.h"

namespace ilot {

constexpr std::uint32_t kOutside = 0;

// A straight edge between two regions. Regions are numbered from 1; kOutside is the region beyond the polygon.
struct PartitionEdge {
  std::uint32_t from = 0, to = 0;  // vertices
  std::uint32_t left = kOutside, right = kOutside;
};

// A planar subdivision: edges meet only in vertices, and no two vertices coincide. Vertices are ascending by (x, y),
// edges by (from, to) with from < to.
struct Partition {
  std::vector<Point2> vertices;  // millimetres from the site's anchor
  std::vector<PartitionEdge> edges;
  std::uint32_t regions = 0;
};

// Restores this form after vertices were moved or added. Vertices at one place become one, edges without length are
// removed, and where a region has lost its width its two sides become one edge.
void tidy(Partition& partition);

// Returns true where direction p - o comes before q - o, counter-clockwise from the direction of +x.
bool turns_before(Point2 o, Point2 p, Point2 q);

// Cuts the polygon by the lines (metres). Dead ends of lines are dropped. Snap rounding (line_net.h) keeps vertices on
// the grid, so lines move by up to a millimetre. The edges of the outline move too where a line passes within a
// millimetre. Without lines the result is the polygon itself as region 1. For a polygon whose rings cross, it is the
// area that an odd number of rings encloses.
Partition part(const SitePolygon& outline, std::span<const FlatEdge> lines);

// Returns the region of each point (millimetres), kOutside when it is outside of all regions. A point on an edge
// belongs to either side of it. O(edges + points x edges of a strip), where the number of strips is proportional to the
// square root of the number of edges.
std::vector<std::uint32_t> regions_of(const Partition& partition, std::span<const FlatPoint> points);

// Merges regions with the same label into one region, numbered by label. Edges between them are removed, and so are
// vertices in the middle of straight borders, unless they are fixed (one flag per vertex). Labels are from 1 to
// `labels`, one per region.
Partition merged(const Partition& partition, std::span<const std::uint32_t> label, std::uint32_t labels,
                 std::span<const std::uint8_t> fixed);

// Draws the borders between two regions with as few corners as stay within `tolerance` metres of them [Douglas, Peucker
// 1973]. The outline and vertices where three regions meet stay. Borders that come close to others may cross them.
void straighten_borders(Partition& partition, const SitePolygon& outline, double tolerance);

// One flag per vertex: 1 = a corner of the outline.
std::vector<std::uint8_t> corners_in(const Partition& partition, const SitePolygon& outline);

// Joins the ends of edges shorter than `shortest` metres into one vertex. Corners of the outline stay where they are.
void close_short_edges(Partition& partition, const SitePolygon& outline, double shortest);

// Returns the regions as polygons, in their order, with all vertices of their borders.
std::vector<SitePolygon> region_polygons(const Partition& partition);

// Returns the area of every region in square metres, [0] = 0.
std::vector<double> region_areas(const Partition& partition);

}  // namespace ilot
