// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/labels/objects.h"

#include <algorithm>

namespace ilot {
namespace {

constexpr std::uint32_t kUnlabelled = 256;  // above every label

std::map<std::uint32_t, std::uint32_t> main_labels(std::span<const LabelPair> labels) {
  std::map<std::uint32_t, std::pair<std::uint64_t, std::uint32_t>> best;  // object -> points, label
  for (const LabelPair& pair : labels) {                                  // ascending by object, then label
    if (pair.truth == 0 || pair.found == 0) continue;
    auto& [points, label] = best[pair.truth];
    if (pair.points <= points) continue;
    points = pair.points;
    label = pair.found;
  }
  std::map<std::uint32_t, std::uint32_t> main;
  for (const auto& [object, entry] : best) main[object] = entry.second;
  return main;
}

// Numbers the classes of the true objects from 1 in alphabetical order.
std::map<std::string, std::uint32_t> class_numbers(std::span<const TrueObject> truth) {
  std::map<std::string, std::uint32_t> numbers;
  for (const TrueObject& object : truth) numbers.emplace(object.class_name, 0);
  std::uint32_t next = 0;
  for (auto& [name, number] : numbers) number = ++next;
  return numbers;
}

struct ClassCounts {
  std::uint64_t truth = 0, detected = 0, right = 0;
};

// The means over the true classes.
void set_class_shares(const std::map<std::string, ClassCounts>& counts, ObjectResult& result) {
  double of_detected = 0, of_all = 0, with_detected = 0;
  for (const auto& [name, c] : counts) {
    of_all += static_cast<double>(c.right) / static_cast<double>(c.truth);
    if (c.detected == 0) continue;
    of_detected += static_cast<double>(c.right) / static_cast<double>(c.detected);
    ++with_detected;
  }
  if (with_detected > 0) result.right_class = of_detected / with_detected;
  if (!counts.empty()) result.detected_and_right = of_all / static_cast<double>(counts.size());
}

// Returns the class that is right for a true class: `other` for those that the product does not know.
const std::string& right_class(const std::string& true_class, const ClassNames& known) {
  static const std::string kOther = "other";
  const bool is_known = std::any_of(known.begin(), known.end(), [&](const auto& k) { return k.second == true_class; });
  return is_known ? true_class : kOther;
}

}  // namespace

ObjectResult evaluate_objects(std::span<const TrueObject> truth, std::span<const LabelPair> pairs,
                              std::span<const LabelPair> labels, const ClassNames& label_names) {
  const PlaneMatching matching = match_planes(pairs, {}, MatchRule::overlap);
  std::map<std::uint32_t, std::uint32_t> partner;
  for (const PlaneMatch& match : matching.matches) partner[match.truth] = match.found;
  std::map<std::uint32_t, bool> seen;
  for (const LabelPair& pair : pairs) seen[pair.truth] = true;
  const std::map<std::uint32_t, std::uint32_t> label_of = main_labels(labels);
  const std::map<std::string, std::uint32_t> numbers = class_numbers(truth);
  ClassNames true_names, found_names = label_names;
  for (const auto& [name, number] : numbers) true_names[number] = name;
  found_names[kUnlabelled] = "unlabelled";
  LabelPairs objects;
  ObjectResult result;
  std::map<std::string, ClassCounts> of_class;
  for (const auto& [found, label] : label_of) result.right_of_found[found] = false;
  for (const TrueObject& object : truth) {
    if (!seen.contains(object.id)) {
      ++result.unseen;
      continue;
    }
    ++result.truth;
    ClassCounts& count = of_class[object.class_name];
    ++count.truth;
    const auto found = partner.find(object.id);
    std::uint32_t label = 0;
    if (found != partner.end()) {
      ++result.detected;
      ++count.detected;
      const auto labelled = label_of.find(found->second);
      label = labelled == label_of.end() ? kUnlabelled : labelled->second;
      const bool right =
          found_names.contains(label) && found_names.at(label) == right_class(object.class_name, label_names);
      count.right += right;
      result.right_of_found[found->second] = right;
    }
    objects.add(numbers.at(object.class_name), label);
  }
  set_class_shares(of_class, result);
  result.found = matching.found_planes;
  result.false_found = result.found - matching.matches.size();
  result.confusion = confusion_of_labels(objects.sorted(), true_names, found_names);
  return result;
}

}  // namespace ilot
