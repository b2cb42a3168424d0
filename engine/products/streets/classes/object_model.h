// SPDX-License-Identifier: Apache-2.0
// What things are: objects by a support vector machine [Hernandez and Marcotegui 2008, 5.3], and which things are whole
// by boosted trees. Plain arithmetic: the same on every machine. training/ learns them.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/model/point_label.h"
#include "engine/products/streets/classes/role_trees.h"
#include "engine/products/streets/objects/object_candidates.h"

namespace ilot {

// What a thing is in a cut through a tree of joins: whole and an object, whole and none (or vegetation), below, above.
enum class CandidateState : std::uint8_t { object, rest, part, merged };
constexpr std::size_t kCandidateStates = 4;

// How much the states count where all things of a tree are weighed together: exp(bias) p^power.
struct RoleWeights {
  std::array<double, kCandidateStates> power{1, 1, 1, 1}, bias{};
};

// A trained machine: one against one, radial kernel exp(-gamma d^2) on standardised features; and, where the samples
// had roles, trees that say what is whole and an object. The machine has learnt from objects alone then.
struct ObjectModel {
  std::string recipe;                 // how it was trained, for people: lines without a leading blank
  std::vector<std::size_t> features;  // in the order of their selection
  std::vector<double> mean, sd;       // of each, after signed_root
  double gamma = 1, cost = 1;
  std::vector<PointLabel> classes;             // rising; a single one needs no vectors
  std::vector<double> min_similarity;          // of each class: what has a smaller kernel to all its vectors is none
  std::vector<double> prior;                   // of each class: how many there were for each one that was trained on
  std::vector<std::vector<double>> vectors;    // support vectors, standardised
  std::vector<std::vector<double>> weights;    // per support vector: classes - 1, as libsvm orders them
  std::vector<std::uint32_t> class_of_vector;  // index into classes, rising
  std::vector<double> rho, slope, offset;      // per pair of classes: (0, 1), (0, 2) ... (1, 2) ...
  RoleTrees trees;
  RoleWeights roles;
};

// What a thing is if it is whole, and how probable that is then; and how much speaks for each role: how probable it is,
// weighed by the model's RoleWeights. Vegetation and what is no thing may be parted and joined at will: they count for
// every role. A model without trees knows no roles: to it all things are whole.
struct CandidateClass {
  PointLabel label = PointLabel::other;
  double probability = 0;
  double whole = 1, part = 0, merged = 0;
  double object = 0;  // how much speaks for an object over what speaks for none, as a logarithm
};

// Classes: pairwise probabilities coupled as Wu, Lin and Weng (2004) do it in their second method, times how common the
// classes are. Called an object where its weight is greater than that of being none, then by the most probable class.
// Objects that are farther from their class than anything that the machine was trained on are `other`, as probable as
// any class. `parts` of each thing, or none where no thing joins others. Many at once are several times faster than one
// by one, and get the same bits. O(things (support vectors + trees)), on the threads of the calling arena.
std::vector<CandidateClass> classify_candidates(const ObjectModel& model, std::span<const CandidateFeatures> candidates,
                                                std::span<const CandidateParts> parts = {});
CandidateClass classify_candidate(const ObjectModel& model, const CandidateFeatures& features);

// The model as text and back; parse throws Error naming `name` and the line.
std::string object_model_text(const ObjectModel& model);
ObjectModel parse_object_model(std::string_view text, const std::string& name);

// What ships with ilot: trained on the virtual scanner's streets. Its recipe stands in it.
const ObjectModel& default_object_model();

// The same for clouds from the air: trained on streets that the virtual scanner saw from flight lines.
const ObjectModel& air_object_model();

}  // namespace ilot
