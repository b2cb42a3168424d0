// SPDX-License-Identifier: Apache-2.0
// Counts the labels of a labelled cloud, true labels against found ones.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "engine/compare/facades/facade_truth_labels.h"
#include "engine/compare/planes/plane_matching.h"

namespace ilot {

struct LabelCounts {
  LabelPairs planes;          // true_plane, found plane or shape
  LabelPairs class_segments;  // true_class, found plane or shape
  LabelPairs class_labels;    // true_class, label
  LabelPairs facade_labels;   // the truth as labels of facades, label; label 0 counts as other
  LabelPairs objects;         // true_element where it is an object, else 0; object_id
  LabelPairs object_labels;   // object_id, label
  std::unordered_map<std::uint32_t, std::uint32_t> class_of;         // class of each true plane, from its first point
  std::unordered_map<std::uint32_t, std::uint64_t> points_of_plane;  // true planes
  std::uint64_t points = 0;
  bool has_true_plane = false, has_true_class = false, has_true_element = false;
  bool has_planes = false, has_labels = false, has_objects = false, has_boundary = false;
  bool any_label = false;  // a label other than 0 occurs
  double metres_per_unit = 1;
};

// Adds one cloud to the counts. Fields that the cloud does not have are skipped. `objects` are the ids of true_element
// that are objects; `words` are the labels of facades, or nullptr without facades. Throws Error when the cloud cannot
// be read.
void count_labels(const std::filesystem::path& cloud, const std::string& found_field,
                  const std::unordered_set<std::uint32_t>& objects, const FacadeTruthLabels* words,
                  LabelCounts& counts);

}  // namespace ilot
