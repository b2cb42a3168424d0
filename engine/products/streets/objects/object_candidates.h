// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "engine/products/streets/objects/separation.h"
#include "engine/tiles/tile_layers.h"
#include "kernels/rasters/component_features.h"

namespace ilot {

// What a thing is told by: the document's eleven [Hernandez and Marcotegui 2008, 5.2], then ours.
enum class CandidateFeature : std::uint8_t {
  low_share = kComponentFeatures,  // of its points, those lower than low_height
  ground_share,                    // of the points in its pixels, those on the ground below it
  roughness,                       // metres; mean of the highest less the lowest of a pixel and its neighbours
  length,                          // metres; of the rectangle with the moments of its pixels
  width,
  inner_pass,    // of a joined thing: the lowest pass between its parts over the lower top; 1 of one that was separated
  outer_pass,    // the highest pass to another part of its component over the lower top; 0 without any
  fill,          // area over that of the rectangle with the moments of its pixels
  lesser_share,  // of a joined thing's area, that of its lesser part; 0 of one that was separated
  top_step,      // metres between the tops of its two parts
  mean_step,     // metres between their mean heights
  joined_share,  // of the area of what joins it with another, its own; 1 where nothing does
  rise,          // metres that its top is above that of the other
  joined_fill,   // of what joins them
  joined_length,
  upright_share,  // of the bins of height up to its top, those with a point in any of its pixels; 0 with no occupancy
  evenness,       // of what it fills from above, bin by bin: mean number of pixels with a point over the greatest
  free_run,       // metres over which it stands and touches nothing, bin upon bin
  touch_share,    // of the bins that it stands in, those in which it touches another
  joint_share,    // of a joined thing: of the bins of the part with fewer, those in which its two parts touch; else 1
};
constexpr std::size_t kCandidateFeatures = kComponentFeatures + 20;
using CandidateFeatures = std::array<double, kCandidateFeatures>;
const char* candidate_feature_name(std::size_t feature);

// Something that stands on the ground.
struct ObjectCandidate {
  CandidateFeatures features{};
  double x = 0, y = 0;                            // base point, pixels of the whole; centres of pixels at whole numbers
  double middle_x = 0, middle_y = 0;              // of its pixels
  Height ground = 0;                              // lowest ground below it
  double length = 0, width = 0, heading_deg = 0;  // metres; heading of the length, from x towards y, 0 to below 180
  std::uint64_t points = 0;                       // above the ground
  std::uint32_t pixels = 0;
  std::uint32_t parts[2] = {0, 0};  // numbers of the things that this one joins; 0: a thing as it was separated
};

struct ColumnParams {
  double widest = 0.4;     // metres, of a column
  double apart = 0.15;     // metres around it that are free
  double least_run = 0.6;  // metres of height over which it is free
};

struct ObjectCandidateParams {
  SeparationParams separation;
  ColumnParams columns;
  double largest = 40;           // square metres; parts are joined to no larger things
  double nearest_apart = 0.2;    // metres; parts with a narrower gap between them may be one thing
  double low_height = 2;         // metres above the ground
  double seen_within = 0.25;     // metres; what is farther from every point was filled in, and nothing stands there
  double mean_accumulation = 1;  // points of a pixel of the ground that has any: accumulations are in multiples of it
};

// Things that touch told apart [Hernandez and Marcotegui 2008, 5.1] and described [Hernandez and Marcotegui 2008, 5.2]:
// from the layers "height", "range", "accumulation", "above" (points above the ground) and "low" (those lower than
// low_height) to the layer "candidates": numbers from 1 in the order of the components' first pixels, and within a
// component as separate_artefacts numbers them; 0 = none. Pixel by pixel what separate_artefacts makes of the whole.
// Accumulation and heights are of the pixels with points, the area of all. A component is worked on whole: memory some
// 80 bytes a pixel of its box.
//
// Ours: heights that are no nearer to a point than seen_within are left out: links of the ground over shadows climb to
// what stands at their ends, and would join it. A watershed also parts what is one, as a bicycle from saddle to
// handlebar. Behind the parts as they were separated come the things that join two of them or of those: in each
// component the two whose pass is highest beside the lower top, again and again, then those that a gap of less than
// nearest_apart parts, up to `largest`. Components are joined over such gaps too. Which of them are things, classes
// tell: select_objects.
std::vector<ObjectCandidate> find_object_candidates(const TileLayers& layers, const RasterScale& scale,
                                                    const ObjectCandidateParams& params = {});

}  // namespace ilot
