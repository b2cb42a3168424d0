// SPDX-License-Identifier: Apache-2.0
// Confusion matrices as the papers print them: a row per true class, a column per found class, and a column of its own
// for what was not detected.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/compare/planes/plane_matching.h"

namespace ilot {

struct ConfusionMatrix {
  std::vector<std::string> classes;
  std::vector<std::vector<std::uint64_t>> counts;  // [true][found]; one column more than classes: undetected
};

// The share of what is truly c in all that was found as c; nullopt when nothing was found as c. c is an index into
// `classes`.
std::optional<double> precision(const ConfusionMatrix& matrix, std::size_t c);

// The share of what was found as c in all that is truly c, undetected included; nullopt when nothing is truly c.
std::optional<double> sensitivity(const ConfusionMatrix& matrix, std::size_t c);

// The share of what was found with its true class in all; nullopt for an empty matrix.
std::optional<double> global_sensitivity(const ConfusionMatrix& matrix);

using ClassNames = std::map<std::uint32_t, std::string>;

// Builds the matrix from labels: pairs of true class and found class, 0 = none. Points without a true class (mixed
// pixels, clutter) are not judged; a found 0 is undetected. Classes of both sides are compared by name. A found name
// that the truth does not have becomes a class with an empty row. The name of a number without a name is the number
// itself.
ConfusionMatrix confusion_of_labels(std::span<const LabelPair> pairs, const ClassNames& true_names,
                                    const ClassNames& found_names);

// Builds the matrix from segments that carry no class, as the tables of Marchand 2018 and of Efficient RANSAC count. A
// segment counts for one class: the true class of most of its judged points (ties: the smaller number). Each of its
// points counts as found in that class; points of no segment are undetected. `pairs` are true class and segment, 0 =
// none. So two segments on one class are no fault, and a segment across two classes lowers the sensitivity of the
// smaller class and the precision of the larger one.
ConfusionMatrix confusion_of_segments(std::span<const LabelPair> pairs, const ClassNames& true_names);

}  // namespace ilot
