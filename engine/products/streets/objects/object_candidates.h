// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "engine/products/streets/objects/separation.h"
#include "engine/tiles/tile_layers.h"
#include "kernels/rasters/component_features.h"

namespace ilot {

constexpr std::size_t kHeightBands = 7;  // candidate_bands.h

// The features by which object candidates are classified: first the eleven of the paper [Hernandez and Marcotegui 2008,
// 5.2], then ours.
enum class CandidateFeature : std::uint8_t {
  low_share = kComponentFeatures,  // share of its points that are lower than low_height
  ground_share,                    // share of the points in its pixels that are on the ground below it
  roughness,                       // metres; mean of the highest less the lowest of a pixel and its neighbours
  length,                          // metres; length of the rectangle with the moments of its pixels
  width,
  inner_pass,    // of a join: lowest pass between its parts divided by the lower top; 1 for a separated part
  outer_pass,    // highest pass to another part of its component divided by the lower top; 0 without any
  fill,          // area divided by that of the rectangle with the moments of its pixels
  lesser_share,  // of a join: share of its area that its smaller part has; 0 for a separated part
  top_step,      // metres between the tops of its two parts
  mean_step,     // metres between their mean heights
  joined_share,  // its share of the area of the join that contains it; 1 where there is none
  rise,          // metres; its top less the top of its partner in the join
  joined_fill,   // `fill` of the join that contains it
  joined_length,
  upright_share,  // share of the height bins up to its top that contain a point of its pixels
  evenness,       // over the bins up to its top: mean number of pixels with a point divided by the greatest
  free_run,       // metres; longest run of bins in which it has points and touches nothing
  touch_share,    // share of its bins in which it touches another candidate
  joint_share,    // of a join: share of the bins of the part with fewer bins in which its two parts touch; else 1
  // Of form, along and across the axis of the moments (candidate_shape.h).
  box_length,  // metres; from the first to the last pixel
  box_width,
  box_fill,     // area divided by that of this box
  high_length,  // metres; of the rectangle with the moments of its pixels above three quarters of its height
  high_width,
  high_share,    // share of its pixels that are above three quarters of its height
  half_share,    // share above half of its height
  ends_height,   // mean height of the outer quarters of its length divided by that of the middle half
  sides_height,  // the same across
  unevenness,    // metres; standard deviation of its heights from the best plane
  foot_length,   // metres; of the rectangle with the moments of its pixels with a point in the lowest third of its
                 // height
  foot_width,
  foot_share,   // share of its pixels with a point in the lowest third
  waist_share,  // in the middle third
  head_share,   // in the highest third
  solid_share,  // share of the bins of its pixels up to its top that contain a point
  // Of what is around it (structures_beside.h).
  wall_distance,   // metres; from the nearest of its pixels to a cell of a building, as far as it is known
  wall_mean,       // metres; mean of the same over its pixels
  crown_share,     // share of its pixels below a crown
  overhang_share,  // share of its pixels below an overhang
  edge_ground,     // of the sides of its pixels on its edge: share beside ground that has a point
  edge_standing,   // share beside something else that stands in its component
  edge_building,   // share beside a building
  seen_points,     // number of its points above the ground
  pixel_size,      // metres
  root_share,      // its share of the area of all that is joined with it in the end
  root_length,     // metres; length of all of that
  // Of how its occupied bins lie (candidate_bins.h). The spread is the covariance of their
  // middles.
  neighbour_bins,  // mean number of its occupied bins that touch one of them, of 26
  linear,          // largest less middle eigenvalue of the spread, divided by the largest
  planar,          // middle less smallest, divided by the largest
  upright_axis,    // |z| of the direction of the largest
  level_normal,    // |z| of the direction of the smallest
  lowest_bin,      // metres above the ground; lower side of the lowest
  thickness,       // metres; standard deviation along the direction of the smallest
  // Of bands of height (candidate_bands.h), kHeightBands of each.
  band_share,                               // share of its pixels with a point in the band
  band_length = band_share + kHeightBands,  // metres; of the rectangle with the moments of these pixels
  band_width = band_length + kHeightBands,
  band_offset = band_width + kHeightBands,   // metres; from the middle of its pixels to that of these
  level_share = band_offset + kHeightBands,  // of its pixels side by side: share with less than half a pixel between
                                             // their tops
  step_share,                                // share with more than two pixels
};
constexpr std::size_t kCandidateFeatures = static_cast<std::size_t>(CandidateFeature::step_share) + 1;
using CandidateFeatures = std::array<double, kCandidateFeatures>;
const char* candidate_feature_name(std::size_t feature);

// An object candidate: a separated part, or a join of two candidates.
struct ObjectCandidate {
  CandidateFeatures features{};
  double x = 0, y = 0;  // base point, in pixels of the whole image; centres of pixels are at whole numbers
  double middle_x = 0, middle_y = 0;              // of its pixels
  Height ground = 0;                              // lowest ground below it
  double own_top = 0;                             // metres above the ground; candidate_bands.h
  double length = 0, width = 0, heading_deg = 0;  // metres; heading of the length, from x towards y, 0 to below 180
  std::uint64_t points = 0;                       // above the ground
  std::uint32_t pixels = 0;
  std::uint32_t parts[2] = {0, 0};  // numbers of the candidates that this one joins; 0: a separated part
};

struct ColumnParams {
  double widest = 0.4;     // metres; greatest width of a column
  double apart = 0.15;     // metres; width of the empty ring around it
  double least_run = 0.6;  // metres; least height over which the ring is empty
};

struct ObjectCandidateParams {
  SeparationParams separation;
  ColumnParams columns;
  bool columns_apart = true;       // whether columns are cut out; from the air the sides of things are hardly seen
  std::uint64_t least_points = 3;  // above the ground, of a component that is smaller than a top
  double largest = 40;             // square metres; no join is larger
  double nearest_apart = 0.2;      // metres; parts with a narrower gap between them may be one object
  std::uint32_t pixels_apart = 0;  // so many pixels in place of nearest_apart where that is more
  double low_height = 2;           // metres above the ground
  double seen_within = 0.25;       // metres; pixels farther from every point were filled in and are left out
  double mean_accumulation = 1;    // mean points of a ground pixel that has any; accumulations are multiples of it
};

// Separates objects that touch [Hernandez and Marcotegui 2008, 5.1] and describes them [Hernandez and Marcotegui 2008,
// 5.2]. Reads the layers "height", "range", "accumulation", "above" (points above the ground) and "low" (those lower
// than low_height). Writes the layer "candidates": numbers from 1 in the order of the first pixels of the components,
// and within a component as separate_artefacts numbers them; 0 = none. Each pixel is the same as if separate_artefacts
// worked on the whole image. Accumulation and heights are computed over the pixels with points, the area over all
// pixels. A component is processed as a whole: memory is some 80 bytes per pixel of its box.
//
// Our additions: heights farther than seen_within from every point are left out, because links of the ground over
// shadows climb to the objects at their ends and would join them. A watershed also splits single objects, such as a
// bicycle between saddle and handlebar. So after the separated parts come joins of two candidates: in each component
// the two candidates whose pass is highest relative to the lower top are joined, again and again. Then candidates with
// a gap of less than nearest_apart or pixels_apart between them are joined. No join is larger than `largest`.
// Components are joined over such gaps too. select_objects then decides from the classes which candidates are objects.
std::vector<ObjectCandidate> find_object_candidates(const TileLayers& layers, const RasterScale& scale,
                                                    const ObjectCandidateParams& params = {});

}  // namespace ilot
