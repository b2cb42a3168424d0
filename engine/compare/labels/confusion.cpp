// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/labels/confusion.h"

#include <algorithm>
#include <numeric>

namespace ilot {
namespace {

std::string name_of(std::uint32_t number, const ClassNames& names) {
  const auto found = names.find(number);
  return found == names.end() ? std::to_string(number) : found->second;
}

std::uint64_t row_total(const ConfusionMatrix& m, std::size_t c) {
  return std::accumulate(m.counts[c].begin(), m.counts[c].end(), std::uint64_t{0});
}

std::optional<double> ratio(std::uint64_t part, std::uint64_t whole) {
  if (whole == 0) return std::nullopt;
  return static_cast<double>(part) / static_cast<double>(whole);
}

// The class for which each segment counts.
std::map<std::uint32_t, std::uint32_t> majority_classes(std::span<const LabelPair> pairs) {
  std::map<std::uint32_t, std::pair<std::uint64_t, std::uint32_t>> best;  // segment -> points, class
  for (const LabelPair& pair : pairs) {                                   // ascending by class
    if (pair.truth == 0 || pair.found == 0) continue;
    auto& [points, truth] = best[pair.found];
    if (pair.points <= points) continue;
    points = pair.points;
    truth = pair.truth;
  }
  std::map<std::uint32_t, std::uint32_t> classes;
  for (const auto& [segment, entry] : best) classes[segment] = entry.second;
  return classes;
}

}  // namespace

std::optional<double> precision(const ConfusionMatrix& m, std::size_t c) {
  std::uint64_t found = 0;
  for (const auto& row : m.counts) found += row[c];
  return ratio(m.counts[c][c], found);
}

std::optional<double> sensitivity(const ConfusionMatrix& m, std::size_t c) {
  return ratio(m.counts[c][c], row_total(m, c));
}

std::optional<double> global_sensitivity(const ConfusionMatrix& m) {
  std::uint64_t right = 0, all = 0;
  for (std::size_t c = 0; c < m.classes.size(); ++c) {
    right += m.counts[c][c];
    all += row_total(m, c);
  }
  return ratio(right, all);
}

ConfusionMatrix confusion_of_labels(std::span<const LabelPair> pairs, const ClassNames& true_names,
                                    const ClassNames& found_names) {
  ConfusionMatrix m;
  std::map<std::string, std::size_t> place;
  const auto add_class = [&](const std::string& name) {
    if (place.try_emplace(name, m.classes.size()).second) m.classes.push_back(name);
  };
  std::map<std::uint32_t, bool> found_numbers;
  for (const LabelPair& pair : pairs) {  // ascending by true class
    if (pair.truth == 0) continue;
    add_class(name_of(pair.truth, true_names));
    if (pair.found != 0) found_numbers[pair.found] = true;
  }
  for (const auto& [number, seen] : found_numbers) add_class(name_of(number, found_names));
  m.counts.assign(m.classes.size(), std::vector<std::uint64_t>(m.classes.size() + 1));
  for (const LabelPair& pair : pairs) {
    if (pair.truth == 0) continue;
    const std::size_t column = pair.found == 0 ? m.classes.size() : place.at(name_of(pair.found, found_names));
    m.counts[place.at(name_of(pair.truth, true_names))][column] += pair.points;
  }
  return m;
}

ConfusionMatrix confusion_of_segments(std::span<const LabelPair> pairs, const ClassNames& true_names) {
  const std::map<std::uint32_t, std::uint32_t> classes = majority_classes(pairs);
  std::vector<LabelPair> labels(pairs.begin(), pairs.end());
  for (LabelPair& pair : labels) {
    const auto speaks = classes.find(pair.found);
    pair.found = speaks == classes.end() ? 0 : speaks->second;
  }
  return confusion_of_labels(labels, true_names, true_names);
}

}  // namespace ilot
