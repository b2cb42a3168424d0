// SPDX-License-Identifier: Apache-2.0
// The truth of points of a facade in the words of a facade's labels, so that like is judged with like.
#pragma once
#include <unordered_map>

#include "engine/compare/truth.h"
#include "engine/model/point_label.h"

namespace ilot {

// Labels of facades name what is built: facade, window, door, sill, balcony; the truth's classes name surfaces (wall,
// reveal, moulding) and its elements what they are of.
struct FacadeTruthLabels {
  std::unordered_map<std::uint32_t, PointLabel> of_element, of_class;

  // A point's, by its element where it has one that there is a word for, else by its class; `none` for class 0.
  PointLabel of(std::uint32_t true_class, std::uint32_t true_element) const;
};

// Windows, doors (shops are doors), sills and balconies with all their surfaces, and what was seen through openings, by
// element; other parts of the facade (bands, surrounds, joints, stones) are facade; all else is `other`.
FacadeTruthLabels facade_truth_labels(const Truth& truth);

}  // namespace ilot
