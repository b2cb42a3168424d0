// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/facades/facade_truth_labels.h"

#include <optional>

namespace ilot {
namespace {

// The label for a kind of element or for the name of a class.
std::optional<PointLabel> word_for(const std::string& name) {
  static const std::map<std::string, PointLabel> words{
      {"window", PointLabel::window},   {"opening", PointLabel::window},  {"door", PointLabel::door},
      {"shop", PointLabel::door},       {"sill", PointLabel::sill},       {"balcony", PointLabel::balcony},
      {"railing", PointLabel::balcony}, {"facade", PointLabel::facade},   {"band", PointLabel::facade},
      {"bulge", PointLabel::facade},    {"bracket", PointLabel::facade},  {"cornice", PointLabel::facade},
      {"course", PointLabel::facade},   {"joint", PointLabel::facade},    {"lintel", PointLabel::facade},
      {"moulding", PointLabel::facade}, {"pediment", PointLabel::facade}, {"quoins", PointLabel::facade},
      {"stone", PointLabel::facade},    {"stones", PointLabel::facade},   {"surround", PointLabel::facade}};
  const auto found = words.find(name);
  return found == words.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

PointLabel FacadeTruthLabels::of(std::uint32_t true_class, std::uint32_t true_element) const {
  if (true_class == 0) return PointLabel::none;
  if (const auto element = of_element.find(true_element); element != of_element.end()) return element->second;
  const auto kind = of_class.find(true_class);
  return kind == of_class.end() ? PointLabel::other : kind->second;
}

FacadeTruthLabels facade_truth_labels(const Truth& truth) {
  FacadeTruthLabels words;
  for (const TrueElement& e : truth.elements)
    if (const auto word = word_for(e.kind)) words.of_element.emplace(e.id, *word);
  for (const auto& [number, name] : truth.classes)
    if (const auto word = word_for(name)) words.of_class.emplace(number, *word);
  return words;
}

}  // namespace ilot
