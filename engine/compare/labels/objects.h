// SPDX-License-Identifier: Apache-2.0
// Judges objects on the street: whether they were detected, and with which class. [Hernandez and Marcotegui 2008]
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/compare/labels/confusion.h"
#include "engine/compare/truth.h"

namespace ilot {

struct ObjectClassCounts {
  std::string name;
  std::uint64_t truth = 0, detected = 0, right = 0;
};

struct ObjectResult {
  std::uint64_t truth = 0;        // true objects with points
  std::uint64_t unseen = 0;       // true objects without points: not judged
  std::uint64_t found = 0;        // found objects
  std::uint64_t detected = 0;     // true objects with a partner
  std::uint64_t false_found = 0;  // found objects without one
  // Share of the objects with a partner whose partner has the right class: mean over the true classes that have one.
  std::optional<double> right_class;
  // Share of all true objects that are detected and have the right class: mean over the true classes.
  std::optional<double> detected_and_right;
  std::vector<ObjectClassCounts> classes;  // of true objects, by name
  // The same for the four classes of Hernandez and Marcotegui (group_of in engine/model/point_label.h).
  std::optional<double> right_group;
  std::vector<ObjectClassCounts> groups;
  std::map<std::uint32_t, bool> right_of_found;  // of each found object: has a partner, and its class
  ConfusionMatrix confusion;  // of objects: true class, class of the partner; a partner without a class is `unlabelled`
};

// `pairs` are numbers of points by true object (0 = none) and found object (0 = none). A true and a found object are
// partners when their common points are at least half of the points of both together. They are matched at most one to
// one, the greater intersection first. `labels` are numbers of points by found object and label (0 = none). The label
// of an object is the one of most of its points, without `none` (ties: the smaller label). The right class of a true
// object whose class is not one of `label_names` is "other". A truth of an earlier version knows the four classes
// alone: where no object has a group and all classes are of the four, a found class counts as its group.
ObjectResult evaluate_objects(std::span<const TrueObject> truth, std::span<const LabelPair> pairs,
                              std::span<const LabelPair> labels, const ClassNames& label_names);

}  // namespace ilot
