// SPDX-License-Identifier: Apache-2.0
// Where objects of streets are lost: how many of the true ones each step of the search could still give, over wild
// streets. The steps are, from left to right:
//   true: objects with points;
//   measure: three of their points or more stand above the ground, and half of all;
//   apart: each pixel belongs to the object that has most points in it, walls and crowns taken out as the truth has
//   them;
//   above: the same, with walls, crowns and ground taken out as the run has them;
//   union: a union of separated parts has half of the points in common;
//   candidate: a candidate of the tree has;
//   taken: the models of the library choose it.
// Then, for objects that are lost: where most of their points went, or what became of their candidate.
// Usage: study_street_stages STREET.laz...
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "engine/model/point_label.h"
#include "engine/products/streets/objects/object_selection.h"
#include "kernels/core/parallel.h"
#include "study/street_samples.h"

namespace {

using namespace ilot;

constexpr double kHalf = 0.5;
constexpr std::uint64_t kLeastStanding = 3;  // points of an object of a run
constexpr std::array<std::uint64_t, 4> kGroups{1, 3, 10, 50};

enum Stage : std::uint8_t { kTrue, kMeasure, kApart, kAbove, kUnion, kCandidate, kTaken, kStages };
using Counts = std::array<std::uint64_t, kStages>;

struct Table {
  std::array<Counts, kGroups.size()> of_group{};  // by number of points
  std::map<std::string, std::uint64_t> of_cause;  // of objects with three points or more

  void add(const Table& o) {
    for (std::size_t g = 0; g < of_group.size(); ++g)
      for (std::size_t s = 0; s < kStages; ++s) of_group[g][s] += o.of_group[g][s];
    for (const auto& [cause, n] : o.of_cause) of_cause[cause] += n;
  }
};

std::string place_of_most(const ObjectBounds& o) {
  static constexpr std::array<const char*, kPointPlaces> kNames{
      "taken for ground", "in a building", "in a crown or an overhang", "in no part", "in wrong parts"};
  const auto most = std::max_element(o.places.begin(), o.places.end()) - o.places.begin();
  return std::string("no candidate: ") + kNames[static_cast<std::size_t>(most)];
}

std::string name_of_class(PointLabel label) {
  if (is_street_object(label)) return "object";
  return label == PointLabel::vegetation ? "vegetation" : "nothing";
}

// What became of the best candidate of a lost object: itself or one that contains it was taken as something.
std::string fate_of(std::size_t i, const std::vector<CandidateClass>& classes, const std::vector<std::uint8_t>& taken,
                    const std::vector<std::size_t>& parent) {
  if (taken[i] != 0) return "candidate taken for " + name_of_class(classes[i].label);
  while (parent[i] != i && taken[i] == 0) i = parent[i];
  return taken[i] == 0 ? "its parts taken" : "inside of what is taken for " + name_of_class(classes[i].label);
}

Table table_of(const Street& street) {
  std::vector<CandidateFeatures> features;
  std::vector<CandidateParts> parts;
  for (const TrainingSample& s : street.samples) features.push_back(s.features), parts.push_back(s.parts);
  const ObjectModel& model = street.view == StreetView::air ? air_object_model() : default_object_model();
  const std::vector<CandidateClass> classes = classify_candidates(model, features, parts);
  const std::vector<std::uint8_t> taken = select_objects(street.candidates, classes);
  std::vector<std::size_t> parent(street.candidates.size());
  for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = i;
  for (std::size_t i = 0; i < parent.size(); ++i)
    for (const std::uint32_t part : street.candidates[i].parts)
      if (part != 0) parent[part - 1] = i;
  std::map<std::uint32_t, std::uint8_t> found;
  for (std::size_t i = 0; i < taken.size(); ++i)
    if (street.object[i] != 0 && taken[i] != 0 && is_street_object(classes[i].label)) found[street.object[i]] = 1;
  const std::map<std::uint32_t, std::size_t> best = best_samples(street);
  Table table;
  for (const auto& [object, o] : street.bounds.objects()) {
    const bool measure = o.standing() >= kLeastStanding && 2 * o.standing() >= o.points;
    const bool candidate = best.count(object) != 0, is_found = found.count(object) != 0;
    const auto joined = street.unions.find(object);
    const bool in_parts = joined != street.unions.end() && joined->second >= kHalf;
    const std::array<bool, kStages> kept{
        true, measure, measure && o.apart >= kHalf, measure && o.above >= kHalf, in_parts, candidate, is_found};
    std::size_t group = kGroups.size() - 1;
    while (o.points < kGroups[group]) --group;
    for (std::size_t s = 0; s < kStages; ++s) table.of_group[group][s] += kept[s];
    if (!is_found && o.points >= kLeastStanding)
      ++table.of_cause[candidate  ? fate_of(best.at(object), classes, taken, parent)
                       : in_parts ? "no candidate: its parts are not joined"
                                  : place_of_most(o)];
  }
  return table;
}

void print(const char* title, const Table& table) {
  fmt::print("\n{}\n{:22} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n", title, "points of the object", "true",
             "measure", "apart", "above", "union", "candidate", "taken");
  Counts all{};
  for (std::size_t g = 0; g < kGroups.size(); ++g) {
    const Counts& n = table.of_group[g];
    fmt::print("{:22} {:9} {:9} {:9} {:9} {:9} {:9} {:9}\n",
               g + 1 < kGroups.size() ? fmt::format("{} to {}", kGroups[g], kGroups[g + 1] - 1)
                                      : fmt::format("{} and more", kGroups[g]),
               n[kTrue], n[kMeasure], n[kApart], n[kAbove], n[kUnion], n[kCandidate], n[kTaken]);
    for (std::size_t s = 0; s < kStages; ++s) all[s] += n[s];
  }
  fmt::print("{:22} {:9} {:9} {:9} {:9} {:9} {:9} {:9}\n", "all", all[kTrue], all[kMeasure], all[kApart], all[kAbove],
             all[kUnion], all[kCandidate], all[kTaken]);
  for (const auto& [cause, n] : table.of_cause) fmt::print("  {:44} {:6}\n", cause, n);
}

void run(const std::vector<std::string>& clouds) {
  if (clouds.empty()) throw std::runtime_error("usage: study_street_stages STREET.laz...");
  std::map<StreetView, Table> tables;
  for (const std::string& cloud : clouds) {
    const Street street = study(cloud);
    tables[street.view].add(table_of(street));
  }
  for (const auto& [view, table] : tables) print(view == StreetView::air ? "from the air" : "from the ground", table);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::vector<std::string> clouds(argv + 1, argv + argc);
    with_threads(hardware_threads(), [&] { run(clouds); });
    return 0;
  } catch (const std::exception& e) {
    fmt::print(stderr, "study_street_stages: {}\n", e.what());
    return 1;
  }
}
