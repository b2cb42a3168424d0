// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ilot {

// One step of the selection.
struct SelectedFeature {
  std::size_t feature = 0;
  double lambda = 1;  // Wilks' lambda of all features selected so far, det(W) / det(T)
  double f = 0;       // partial F of this feature
  double p = 1;       // probability of that F
};

// Stepwise forward selection by Wilks' lambda [Hernandez and Marcotegui 2008, 5.2] (Mardia, Kent, Bibby 1979). Each
// step takes the feature that makes lambda least (ties: the first). It stops when the probability of the partial F of
// the feature is not below max_p. After s features the partial F is (n - g - s) / (g - 1) (lambda before / lambda after
// - 1), with g - 1 and n - g - s degrees of freedom. `samples` has row after row of `features` values. `classes` has
// the class of each row, any numbers. Features that do not vary, or that depend on the selected features within 1e-9 of
// their variance, are skipped. The result is empty with fewer than two classes or n <= g. O(n k^2 + k^4) for k
// features. Sums are in the order of the rows.
std::vector<SelectedFeature> select_features(std::span<const double> samples, std::span<const std::uint32_t> classes,
                                             std::size_t features, double max_p = 0.01);

}  // namespace ilot
