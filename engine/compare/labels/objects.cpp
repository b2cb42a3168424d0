// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/labels/objects.h"

#include <algorithm>

#include "engine/model/point_label.h"

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

// Counts by the name of a true class.
using CountsByName = std::map<std::string, ObjectClassCounts>;

std::vector<ObjectClassCounts> list_of(const CountsByName& counts) {
  std::vector<ObjectClassCounts> list;
  for (const auto& [name, c] : counts) list.push_back({name, c.truth, c.detected, c.right});
  return list;
}

// The means over the true classes: the share that is right, of the detected and of all.
struct ClassShareMeans {
  std::optional<double> of_detected, of_all;
};
ClassShareMeans mean_shares(const CountsByName& counts) {
  double of_detected = 0, of_all = 0, with_detected = 0;
  for (const auto& [name, c] : counts) {
    of_all += static_cast<double>(c.right) / static_cast<double>(c.truth);
    if (c.detected == 0) continue;
    of_detected += static_cast<double>(c.right) / static_cast<double>(c.detected);
    ++with_detected;
  }
  ClassShareMeans means;
  if (with_detected > 0) means.of_detected = of_detected / with_detected;
  if (!counts.empty()) means.of_all = of_all / static_cast<double>(counts.size());
  return means;
}

void count(CountsByName& counts, const std::string& name, bool detected, bool right) {
  ObjectClassCounts& c = counts[name];
  ++c.truth, c.detected += detected, c.right += right;
}

// The group of a class, by name. Classes that no product knows are `other`.
std::string group_name(const std::string& name) {
  const auto label = label_named(name);
  return label ? label_name(group_of(*label)) : "other";
}

// Whether a truth has the four groups as its classes, as those of earlier versions. Classes that no product knows say
// nothing.
bool has_groups_alone(std::span<const TrueObject> truth, const ClassNames& known) {
  return std::none_of(truth.begin(), truth.end(), [&](const TrueObject& o) {
    const bool is_known = std::ranges::any_of(known, [&](const auto& k) { return k.second == o.class_name; });
    return o.has_group || (is_known && group_name(o.class_name) != o.class_name);
  });
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
  if (has_groups_alone(truth, label_names))
    for (auto& [label, name] : found_names)
      if (label != kUnlabelled) name = group_name(name);
  LabelPairs objects;
  ObjectResult result;
  CountsByName of_class, of_group;
  for (const auto& [found, label] : label_of) result.right_of_found[found] = false;
  for (const TrueObject& object : truth) {
    if (!seen.contains(object.id)) {
      ++result.unseen;
      continue;
    }
    ++result.truth;
    bool right = false, right_group = false;
    const auto found = partner.find(object.id);
    std::uint32_t label = 0;
    if (found != partner.end()) {
      ++result.detected;
      const auto labelled = label_of.find(found->second);
      label = labelled == label_of.end() ? kUnlabelled : labelled->second;
      const auto name = found_names.find(label);
      if (name != found_names.end()) {
        right = name->second == right_class(object.class_name, label_names);
        right_group = label != kUnlabelled && group_name(name->second) == group_name(object.class_name);
      }
      result.right_of_found[found->second] = right;
    }
    count(of_class, object.class_name, found != partner.end(), right);
    count(of_group, group_name(object.class_name), found != partner.end(), right_group);
    objects.add(numbers.at(object.class_name), label);
  }
  const ClassShareMeans means = mean_shares(of_class);
  result.right_class = means.of_detected;
  result.detected_and_right = means.of_all;
  result.right_group = mean_shares(of_group).of_detected;
  result.classes = list_of(of_class);
  result.groups = list_of(of_group);
  result.found = matching.found_planes;
  result.false_found = result.found - matching.matches.size();
  result.confusion = confusion_of_labels(objects.sorted(), true_names, found_names);
  return result;
}

}  // namespace ilot
