// SPDX-License-Identifier: Apache-2.0
// Confusion matrices as the documents print them: a row per true class, a column per found class, what was not detected
// in a column of its own.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/compare/plane_matching.h"

namespace ilot {

struct ConfusionMatrix {
  std::vector<std::string> classes;
  std::vector<std::vector<std::uint64_t>> counts;  // [true][found]; one column more than classes: undetected
};

// Found as c and truly so, of all found as c; nullopt when nothing was found as c. c is a number of `classes`.
std::optional<double> precision(const ConfusionMatrix& matrix, std::size_t c);

// Found as c, of all that is truly c, undetected included; nullopt when nothing is.
std::optional<double> sensitivity(const ConfusionMatrix& matrix, std::size_t c);

// Found as what it is, of all; nullopt for an empty matrix.
std::optional<double> global_sensitivity(const ConfusionMatrix& matrix);

using ClassNames = std::map<std::uint32_t, std::string>;

// From labels: pairs of true class and found class, 0 = none. Points without a true class (mixed pixels, clutter) are
// not judged; a found 0 is undetected. Both sides speak of classes by name, and a found name that the truth does not
// have becomes a class with an empty row. Numbers without a name are their own name.
ConfusionMatrix confusion_of_labels(std::span<const LabelPair> pairs, const ClassNames& true_names,
                                    const ClassNames& found_names);

// From segments that carry no class, as Marchand 2018 and Efficient RANSAC's tables count: a segment speaks for one
// class, the true class that most of its judged points have (ties: the smaller number), and each of its points counts
// as found in that class; points of no segment are undetected. Pairs of true class and segment, 0 = none. So two
// segments on one class are no fault, and a segment across two classes costs the sensitivity of the lesser and the
// precision of the greater.
ConfusionMatrix confusion_of_segments(std::span<const LabelPair> pairs, const ClassNames& true_names);

}  // namespace ilot
