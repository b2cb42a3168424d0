// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/facade_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "engine/products/facades/elements/depth_image.h"
#include "engine/products/facades/elements/element_kinds.h"
#include "engine/products/facades/elements/facade_elements.h"
#include "engine/products/facades/elements/outside_wall.h"
#include "engine/products/facades/elements/separate_openings.h"
#include "engine/products/facades/elements/slices.h"
#include "engine/products/facades/leaves/flat_plates.h"
#include "engine/products/facades/leaves/framed_windows.h"
#include "engine/products/facades/leaves/inset_leaves.h"
#include "engine/products/facades/leaves/shutters.h"
#include "engine/products/facades/leaves/standing_leaves.h"
#include "engine/products/facades/openings/panes.h"
#include "engine/products/facades/openings/sparse_panes.h"
#include "engine/products/facades/openings/unseen_areas.h"
#include "engine/products/facades/rays/cell_bands.h"
#include "engine/products/facades/rays/limited_parallel.h"
#include "engine/products/facades/walls/side_faces.h"

namespace ilot {
namespace {

// Choice: two findings of one element differ by their edges; elements that are nested in each other so closely become
// one.
constexpr double kSameElement = 0.8;  // share of an area that two findings of one element have in common
// Choice: the error of an edge from two ends of 1 cm each; flatter splays are drawn straight.
constexpr double kStraight = 0.02;  // metres between the front end and the back end of a side that does not lean
// Derived: more than half, so that one relief gives its sides to one element only.
constexpr double kMostOf = 0.5;  // share of an element: a smaller relief is only a part of it and gives it no sides
// Derived: more than half, so that of two areas that do not overlap only one is that of an element.
constexpr double kSharedOpening = 0.5;  // share of an area, or of the smaller of two, that both have in common
// Derived: more than half, so that a patch belongs to one irregularity only.
constexpr double kSamePatch = 0.5;  // share of a patch that is within an irregularity

// The boxes of the candidates that are no part of an irregularity. Flat patches of an irregularity are no elements, and
// an irregularity contains no other element.
std::vector<Box2> boxes_of_elements(const std::vector<ElementCandidate>& candidates) {
  std::vector<Box2> boxes;
  for (const ElementCandidate& t : candidates)
    if (t.kind != ElementKind::bulge) boxes.push_back(t.shape.box());
  return boxes;
}

void drop_patches(std::vector<ElementCandidate>& candidates, const std::vector<Irregularity>& irregular) {
  std::erase_if(candidates, [&](const ElementCandidate& t) {
    const Box2 own = t.shape.box();
    return t.kind == ElementKind::bulge && std::any_of(irregular.begin(), irregular.end(), [&](const Irregularity& i) {
             return common_area(box_of(i.ring), own) >= kSamePatch * own.width() * own.height();
           });
  });
}

// Drops the areas of which an element covers most: a recess or an opening without an echo that was found otherwise.
void drop_known_areas(std::vector<UnseenArea>& unseen, const std::vector<ElementCandidate>& candidates) {
  std::erase_if(unseen, [&](const UnseenArea& area) {
    const Box2 box = box_of(area.ring);
    return std::any_of(candidates.begin(), candidates.end(), [&](const ElementCandidate& t) {
      return common_area(box, t.shape.box()) > kSharedOpening * area_of(box);
    });
  });
}

// Openings of which too little was seen are only possible ones.
void move_possible(std::vector<ElementCandidate>& candidates, std::vector<UnseenArea>& unseen) {
  for (const ElementCandidate& t : candidates)
    if (t.possible && area_of(t.shape.box()) > 0) unseen.push_back(possible_area(t));
  std::erase_if(candidates, [](const ElementCandidate& t) { return t.possible; });
}

// What of the wall was drawn up to the outline, and not seen.
void add_unseen_above(const WallCells& cells, const WallOutline& outline,
                      const std::vector<ElementCandidate>& candidates, double least_size,
                      std::vector<UnseenArea>& unseen) {
  std::vector<Box2> drawn;
  for (const ElementCandidate& t : candidates) drawn.push_back(t.shape.extent());
  for (const UnseenArea& area : unseen) drawn.push_back(box_of(area.ring));
  for (UnseenArea& area : unseen_above_wall(cells, outline.ring, drawn, least_size)) unseen.push_back(std::move(area));
}

// Elements are numbered in this order.
bool comes_before(const ElementCandidate& a, const ElementCandidate& b) {
  const Box2 p = a.shape.box(), q = b.shape.box();
  if (a.kind != b.kind) return a.kind < b.kind;
  if (a.row != b.row) return a.row < b.row;
  if (p.u0 != q.u0) return p.u0 < q.u0;
  return p.v0 != q.v0 ? p.v0 < q.v0 : a.shape.depth < b.shape.depth;
}

// Merges bulges that overlap: they are patches of one bulge.
void merge_bulges(std::vector<ElementCandidate>& candidates) {
  const auto overlap = [](const ElementCandidate& a, const ElementCandidate& b) {
    const Box2 p = a.shape.box(), q = b.shape.box();
    return a.kind == ElementKind::bulge && b.kind == ElementKind::bulge && p.u0 < q.u1 && q.u0 < p.u1 && p.v0 < q.v1 &&
           q.v0 < p.v1;
  };
  for (bool more = true; more;) {
    more = false;
    for (std::size_t a = 0; a < candidates.size(); ++a)
      for (std::size_t b = a + 1; b < candidates.size();) {
        if (!overlap(candidates[a], candidates[b])) {
          ++b;
          continue;
        }
        FoundRectangle &p = candidates[a].shape, &q = candidates[b].shape;
        const auto outer = [&](Side side, bool low) {
          if (low ? q.at(side) < p.at(side) : q.at(side) > p.at(side)) p.side(side) = q.side(side);
        };
        outer(Side::left, true), outer(Side::bottom, true), outer(Side::right, false), outer(Side::top, false);
        if (q.depth > p.depth) p.depth = q.depth, p.depth_error = q.depth_error;
        p.points += q.points;
        candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(b));
        more = true;
      }
  }
}

// Sides that come from points of side faces are more exact than sides between points of the wall and points behind it.
// An opening in which there is no surface has no depth of its own, but a niche has one.
void take_better_sides(FoundRectangle& known, const FoundRectangle& found) {
  if (known.depth == 0) known.depth = found.depth, known.depth_error = found.depth_error, known.end = found.end;
  for (const Side side : kSides)
    if (found.side(side).by_face && !known.side(side).by_face && found.error(side) < known.error(side))
      known.side(side) = found.side(side);
}

// Adds large relief that was not found before. It replaces a candidate that is only a part of it, such as the front of
// a bay.
void add_large_relief(std::vector<ElementCandidate>& candidates, const std::vector<FoundRectangle>& large,
                      double wall_height, const ElementKindParams& kinds) {
  for (const FoundRectangle& r : large) {
    const Box2 box = r.box();
    const auto same_side = [&](const ElementCandidate& t) {
      return (t.shape.depth > 0) == (r.depth > 0) && t.kind != ElementKind::stone;
    };
    const auto known = std::find_if(candidates.begin(), candidates.end(), [&](const ElementCandidate& t) {
      return same_side(t) && common_area(box, t.shape.extent()) >= kSameElement * box.width() * box.height();
    });
    if (known != candidates.end()) {
      const Box2 own = known->shape.box();
      if (common_area(box, own) >= kMostOf * own.width() * own.height()) take_better_sides(known->shape, r);
      continue;
    }
    // Openings within a recess stay: they continue from its back.
    std::erase_if(candidates, [&](const ElementCandidate& t) {
      const Box2 own = t.shape.box();
      return r.depth > 0 && same_side(t) && common_area(box, own) >= kSameElement * own.width() * own.height();
    });
    candidates.push_back({r, kind_of_large(r, wall_height, kinds), 0, 0, 0, {}});
  }
}

const char* name_of_leaf(LeafState state) {
  constexpr std::array kStates{"open", "half open", "closed", "blind"};
  return kStates[static_cast<std::size_t>(state)];
}

// Drops the relief that leaves are. What was joined over several leaves goes too, because its points are theirs.
void drop_leaves(const std::vector<ShutterLeaf>& leaves, std::vector<FoundRectangle>& relief) {
  std::erase_if(relief, [&](const FoundRectangle& r) {
    const Box2 box = r.box();
    double common = 0;
    for (const ShutterLeaf& leaf : leaves) common += common_area(box, leaf.shape.box());
    return common >= kMostOf * r.fill * box.width() * box.height();
  });
}

// The leaves of shutters. Openings that they hide wholly or in part are added or widened.
std::vector<ShutterLeaf> leaves_of(const RaySamples& samples, const FlatPlates& plates,
                                   const std::vector<StandingLeaf>& standing, const FacadeParams& params,
                                   std::vector<FoundRectangle>& openings) {
  const double alike = params.regular.alike;
  const HalfOpen half = windows_of_leaves(samples, standing, alike, openings);
  std::vector<ShutterLeaf> leaves;
  const std::vector<std::optional<ClosedPart>> parts = closed_parts(samples, openings);
  for (std::size_t i = 0; i < openings.size(); ++i)
    if (parts[i] && kind_of_opening(openings[i], openings, params.kinds) == ElementKind::window)
      leaves.push_back({parts[i]->sheet, parts[i]->from_bottom ? LeafState::closed : LeafState::blind});
  openings.insert(openings.end(), half.windows.begin(), half.windows.end());
  for (const ShutterLeaf& leaf : find_shutters(plates, alike, wall_grid(samples.site()).cell, openings))
    leaves.push_back(leaf);
  for (const FoundRectangle& leaf : half.leaves) leaves.push_back({leaf, LeafState::half});
  return leaves;
}

// The outline of the wall, with its sparse parts.
WallOutline outline_of(const RaySamples& samples, const FacadeParams& params, const SparseFindings& sparse) {
  WallOutline dense = wall_outline(samples, params.outline);
  if (sparse.step == 0) return dense;
  return outline_with_columns(dense, samples.site().width, sparse.columns, sparse.box, sparse.step);
}

std::vector<ElementCandidate> candidates_of(const RaySamples& samples, const FacadeParams& params,
                                            const SparseFindings& sparse, std::vector<UnseenArea>& unseen,
                                            OpeningSteps& cells, FacadeSteps* steps) {
  std::vector<FoundRectangle> openings, relief, stones, large;
  FlatPlates plates;
  std::vector<StandingLeaf> standing;
  const std::array<std::function<void()>, 6> searches{
      [&] { large = find_large_relief(samples, params.large); },
      [&] { relief = find_relief(samples, params.relief); },
      [&] { stones = find_stones(samples, params.stones); },
      [&] { plates = find_flat_plates(samples); },
      [&] { standing = find_standing_leaves(samples); },
      [&] { openings = find_openings(samples, params.openings, &cells, &unseen); }};
  parallel_for_limited(params.concurrency, searches.size(), [&](std::size_t i) { searches[i](); });
  for (const FoundRectangle& r : sparse.openings)
    if (!shares_area(r.box(), openings)) openings.push_back(r);
  join_panes_like_others(params.regular.alike, openings);
  unseen.insert(unseen.end(), sparse.unseen.begin(), sparse.unseen.end());
  if (steps != nullptr) {
    steps->cells = cells;
    steps->openings = openings;
    steps->relief = relief;
    steps->stones = stones;
    steps->large = large;
  }
  drop_pierced_stones(openings, stones);
  std::vector<ShutterLeaf> leaves = leaves_of(samples, plates, standing, params, openings);
  drop_leaves(leaves, relief);
  for (const ShutterLeaf& leaf :
       find_framed_windows(params.kinds.balcony_depth, params.regular.alike, cells.seen.cell, relief, openings))
    leaves.push_back(leaf);
  std::vector<ElementCandidate> candidates;
  for (const FoundRectangle& o : openings)
    candidates.push_back({o, kind_of_opening(o, openings, params.kinds), 0, 0, 0, {}});
  for (const ShutterLeaf& leaf : leaves)
    candidates.push_back({leaf.shape, ElementKind::shutter, 0, 0, 0, name_of_leaf(leaf.state)});
  for (const FoundRectangle& r : relief)
    candidates.push_back({r, kind_of_relief(r, openings, samples.site().width, params.kinds), 0, 0, 0, {}});
  for (const FoundRectangle& s : stones) candidates.push_back({s, ElementKind::stone, 0, 0, 0, {}});
  keep_nearest_sills(candidates);
  merge_bulges(candidates);
  std::erase_if(candidates, is_rail);
  add_large_relief(candidates, large, samples.site().height, params.kinds);
  return candidates;
}

// A side that does not lean ends where the outline is drawn.
Box2 straightened(const Box2& end, const Box2& measured, const Box2& drawn) {
  const auto side = [](double at, double from, double now) { return std::abs(at - from) < kStraight ? now : at; };
  return {side(end.u0, measured.u0, drawn.u0), side(end.u1, measured.u1, drawn.u1), side(end.v0, measured.v0, drawn.v0),
          side(end.v1, measured.v1, drawn.v1)};
}

// Finds the rectangle of an element at its depth [Lorraine thesis, 4.2.1], where its sides are seen to lean.
void find_ends(std::vector<ElementCandidate>& candidates, const RaySamples& samples, std::size_t concurrency) {
  // Choice: the error of an edge beside a deep reveal; an end that is hidden farther out is not drawn.
  constexpr double kMargin = 0.05;  // metres around its outline in which its end may be
  parallel_for_limited(concurrency, candidates.size(), [&](std::size_t i) {
    FoundRectangle& r = candidates[i].shape;
    const Box2 box = r.box();
    if (r.end) r.end = straightened(*r.end, box, box);
    if (r.end || !r.is_rectangle() || candidates[i].kind == ElementKind::stone || r.depth == 0) return;
    const double about = 1.5 * SliceParams{}.spacing;
    const SliceRange range{box.grown(kMargin), r.depth - about, r.depth + about};
    const std::optional<FacadeSlice> end = end_slice(slices_of(samples, range));
    if (!end) return;
    const Box2 extent = whole_extent(samples, range, *end).grown(samples.site().step / 2);
    const SideFaces faces = side_faces(samples, box, extent, r.depth);
    r.end = straightened(faces.end, faces.outline, box);
  });
}

}  // namespace

bool shares_area(const Box2& box, const std::vector<FoundRectangle>& openings) {
  const double own = box.width() * box.height();
  return std::any_of(openings.begin(), openings.end(), [&](const FoundRectangle& o) {
    const Box2 other = o.box();
    return common_area(box, other) > kSharedOpening * std::min(own, other.width() * other.height());
  });
}

std::uint64_t facade_bytes(const FacadeSite& site, std::uint64_t points, std::size_t concurrency) {
  // Derived: the bytes of the images of depths, counts and labels of a cell, added up; a bound of memory, no result
  // depends on it.
  constexpr double kCells = 30, kLeastCell = 0.02;  // bytes per cell of all images together; metres
  constexpr std::uint64_t kBands = 8 << 20;         // while the bands are counted
  constexpr std::uint64_t kSorting = 5 << 20, kPerWorker = 12 << 20,
                          kPoint = 200;  // samples of a step: 2^16 or 2^17 points
  const double width = site.width + 2 * kAroundWall, height = site.height + 2 * kAroundWall;
  const double cell = cell_for(width, height, std::max(kLeastCell, 2 * site.step));
  return static_cast<std::uint64_t>(kCells * width * height / (cell * cell)) +
         sparse_pane_bytes(site.width, site.height) + std::min(kBands + kSorting, kPoint * points) +
         concurrency * std::min(kPerWorker, kPoint * points);
}

FoundFacade find_facade(const RaySamples& samples, const FacadeParams& params, FacadeSteps* steps,
                        const SparseFindings& sparse) {
  const FacadeSite& site = samples.site();
  std::vector<UnseenArea> unseen;
  OpeningSteps cells;
  std::vector<ElementCandidate> candidates = candidates_of(samples, params, sparse, unseen, cells, steps);
  const std::vector<Irregularity> irregular =
      find_irregularities(samples, boxes_of_elements(candidates), params.irregular);
  drop_patches(candidates, irregular);
  drop_known_areas(unseen, candidates);
  group_elements(candidates, params.regular);
  if (steps != nullptr) steps->found = candidates;
  if (params.regularise) {
    regularise_elements(candidates, params.regular);
    open_overlapping_sides(candidates);
    complete_elements(candidates, params.regular);
  }
  drop_openings_within(candidates);
  end_before_others(candidates);
  move_possible(candidates, unseen);
  const WallOutline outline = outline_of(samples, params, sparse);
  drop_elements_outside(box_of(outline.ring), params.large.most_depth, candidates);
  add_unseen_above(cells.seen, outline, candidates, params.openings.least_size, unseen);
  group_elements(candidates, params.regular);
  find_ends(candidates, samples, params.concurrency);
  std::sort(candidates.begin(), candidates.end(), comes_before);

  FoundFacade found;
  Facade& f = found.facade;
  f.crs = site.crs;
  f.origin = site.axes.origin + (sparse.box.u0 / site.metres_per_unit) * site.axes.right;
  f.right = site.axes.right;
  f.up = site.axes.up;
  f.out = site.axes.out;
  if (steps != nullptr) {
    steps->drawn = candidates;
    steps->irregular = irregular;
    steps->unseen = unseen;
    steps->outline = outline;
  }
  f.elements.push_back(wall_of(samples, outline));
  f.width_m = f.elements[0].width_m;
  f.height_m = f.elements[0].height_m;
  for (const ElementCandidate& candidate : candidates) f.elements.push_back(element_of(site, candidate));
  for (const FacadeElement& e : f.elements) found.occluded_edges += unseen_sides(e);
  for (const Irregularity& i : irregular) f.elements.push_back(irregularity_of(site, i));
  for (const UnseenArea& area : unseen) f.elements.push_back(unseen_of(site, area));
  for (std::uint32_t i = 0; i < f.elements.size(); ++i) f.elements[i].id = i + 1;
  return found;
}

}  // namespace ilot
