// SPDX-License-Identifier: Apache-2.0
// The classes of object candidates. A support vector machine classifies objects [Hernandez and Marcotegui 2008, 5.3],
// and boosted trees decide which candidates are whole. All of it is plain arithmetic that gives the same result on
// every machine. The code in training/ trains the models.
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

// The state of a candidate in a cut through a tree of joins: whole and an object; whole and no object (or vegetation);
// a part of an object; merged from more than one object.
enum class CandidateState : std::uint8_t { object, rest, part, merged };
constexpr std::size_t kCandidateStates = 4;

// The weights of the states where all candidates of a tree are weighed together: exp(bias) p^power.
struct RoleWeights {
  std::array<double, kCandidateStates> power{1, 1, 1, 1}, bias{};
};

// The probability that is stated for the class of an object: 1 / (1 + exp(slope f + offset)), where f is the logarithm
// of the odds that the trees give. Learnt on streets that the trees were not trained with.
struct StatedOdds {
  double slope = -1, offset = 0;
};

// A trained classifier. The classes come from a support vector machine (one against one, radial kernel exp(-gamma d^2)
// on standardised features) or from boosted trees. Where the samples had roles, the model also has trees that decide
// what is whole and an object; the classes are then learnt from objects only.
struct ObjectModel {
  std::string recipe;                 // how it was trained, for people: lines without a leading blank
  std::vector<std::size_t> features;  // in the order of their selection
  std::vector<double> mean, sd;       // mean and standard deviation of each feature, after signed_root
  double gamma = 1, cost = 1;
  std::vector<PointLabel> classes;     // ascending; a single class needs neither vectors nor trees
  OwnClasses own;                      // names of those classes that are one's own
  std::vector<double> min_similarity;  // of each class: least kernel to the nearest of its vectors for a member
  std::vector<double> prior;           // of each class: how many samples there were for each one that was trained on
  std::vector<std::vector<double>> vectors;    // support vectors, or samples of the classes of trees; standardised
  std::vector<std::vector<double>> weights;    // per support vector: one less than there are classes, in libsvm's order
  std::vector<std::uint32_t> class_of_vector;  // index into classes, ascending
  std::vector<double> rho, slope, offset;      // per pair of classes: (0, 1), (0, 2) ... (1, 2) ...
  ColumnTrees class_trees;                     // empty: the machine decides the classes
  RoleTrees trees;
  RoleWeights roles;
  StatedOdds stated;
};

// The class of a candidate if it is whole, and the probability of that class; and the weight of each role: its
// probability, weighed by the model's RoleWeights. Vegetation and candidates that are no objects may be split and
// joined freely: they count for every role. A model without trees knows no roles and regards all candidates as whole.
struct CandidateClass {
  PointLabel label = PointLabel::other;
  double probability = 0;
  double whole = 1, part = 0, merged = 0;
  double object = 0;  // logarithm of the weight of being an object over the weight of being none
  // Of an object: the most probable class of another group (group_of), and the probability that is stated for it.
  PointLabel next = PointLabel::other;
  double next_probability = 0;
};

// Classifies candidates. The probabilities of the classes are pairwise probabilities coupled by the second method of
// Wu, Lin and Weng (2004), times the frequencies of the classes. A candidate is called an object where the weight of
// being an object is not less than that of being none; its class is then the most probable one. An object that is
// farther from its class than anything in the training set gets the class `other`, with the probability 1 / (number of
// classes). `parts` has one entry per candidate, or is empty where no candidate joins others. Many candidates in one
// call are several times faster than single calls, with the same bits. O(candidates (support vectors + trees)), on the
// threads of the calling arena.
std::vector<CandidateClass> classify_candidates(const ObjectModel& model, std::span<const CandidateFeatures> candidates,
                                                std::span<const CandidateParts> parts = {});
CandidateClass classify_candidate(const ObjectModel& model, const CandidateFeatures& features);

// Converts the model to text and back. parse_object_model throws Error, which names `name` and the line.
std::string object_model_text(const ObjectModel& model);
ObjectModel parse_object_model(std::string_view text, const std::string& name);

// The model that is part of ilot. It was trained on streets of the virtual scanner; its recipe is recorded in it.
const ObjectModel& default_object_model();

// The same for clouds from the air. It was trained on streets that the virtual scanner saw from flight lines.
const ObjectModel& air_object_model();

}  // namespace ilot
