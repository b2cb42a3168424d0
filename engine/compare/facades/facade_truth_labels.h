// SPDX-License-Identifier: Apache-2.0
// Converts the truth of a facade's points to the labels of facades, so that equal classes are compared.
#pragma once
#include <unordered_map>

#include "engine/compare/truth.h"
#include "engine/model/point_label.h"

namespace ilot {

// Labels of facades name what is built: facade, window, door, sill, balcony. The classes of the truth name surfaces
// (wall, reveal, moulding), and its elements name the objects to which the surfaces belong.
struct FacadeTruthLabels {
  std::unordered_map<std::uint32_t, PointLabel> of_element, of_class;

  // The label of a point: by its element where that has a label, otherwise by its class; `none` for class 0.
  PointLabel of(std::uint32_t true_class, std::uint32_t true_element) const;
};

// Windows, doors (shops are doors), sills and balconies with all their surfaces, and what was seen through openings,
// get their labels by element. Other parts of the facade (bands, surrounds, joints, stones) are facade. Everything else
// is `other`.
FacadeTruthLabels facade_truth_labels(const Truth& truth);

}  // namespace ilot
