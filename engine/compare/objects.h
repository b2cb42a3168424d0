// SPDX-License-Identifier: Apache-2.0
// Things on the street: were they detected, and as what? [Hernandez and Marcotegui 2008]
#pragma once
#include <cstdint>
#include <span>

#include "engine/compare/confusion.h"
#include "engine/compare/truth.h"

namespace ilot {

struct ObjectResult {
  std::uint64_t truth = 0;        // true objects that points lie on
  std::uint64_t unseen = 0;       // true objects without points: not judged
  std::uint64_t found = 0;        // found objects
  std::uint64_t detected = 0;     // true objects with a partner
  std::uint64_t false_found = 0;  // found objects without one
  ConfusionMatrix confusion;  // objects: true class, class of the partner; a partner without a class is `unlabelled`
};

// `pairs`: points by true object (0 = none) and found object (0 = none). A true and a found object are partners when
// their common points are at least half of the points of both together; at most one to one, the greater intersection
// first. `labels`: points by found object and label (0 = none); an object has the label that most of its points have,
// `none` aside (ties: the smaller).
ObjectResult evaluate_objects(std::span<const TrueObject> truth, std::span<const LabelPair> pairs,
                              std::span<const LabelPair> labels, const ClassNames& label_names);

}  // namespace ilot
