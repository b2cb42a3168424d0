// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

// The features of a component [Hernandez and Marcotegui 2008, 5.2], in the order of the document.
enum class ComponentFeature : std::uint8_t {
  mean_height,
  sd_height,
  max_height,
  min_height,
  mode_height,
  mean_accumulation,
  sd_accumulation,
  max_accumulation,
  min_accumulation,
  mode_accumulation,
  area
};
constexpr std::size_t kComponentFeatures = 11;
using ComponentFeatures = std::array<double, kComponentFeatures>;
const char* feature_name(ComponentFeature feature);  // "mean height", ...

struct ComponentFeaturesParams {
  double unit = 0.001;   // metres of one unit of height
  double pixel = 0.05;   // metres, side of a pixel
  Height mode_bin = 50;  // units, at least 1; heights within one bin count as equal
};

// Computes the features of each label, [0] for label 1: mean, standard deviation, maximum, minimum and mode of the
// heights of its pixels (metres) and of their accumulations (points), and its area (square metres). The standard
// deviation divides by the number of pixels. The mode of heights is the middle of the fullest bin [k mode_bin, (k + 1)
// mode_bin) of whole units (ties: the lowest). Every labelled pixel must have a height. A label without pixels has
// zeros. O(n log of the largest).
std::vector<ComponentFeatures> component_features(const PixelLabels& labels, const Image& heights,
                                                  std::span<const std::uint32_t> accumulation,
                                                  const ComponentFeaturesParams& params = {});

}  // namespace ilot
