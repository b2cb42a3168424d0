// SPDX-License-Identifier: Apache-2.0
// What things are: objects by a support vector machine [B7], and which things are whole by boosted trees. Training and
// use are plain arithmetic: the same on every machine.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/model/point_label.h"
#include "engine/streets/role_trees.h"
#include "engine/streets/things.h"

namespace ilot {

// What a thing is of what stands there: parts are joined to wholes, and these to several in one.
enum class ThingRole : std::uint8_t { whole, part, several };

// What a thing is in a cut through a tree of joins: whole and an object, whole and none (or vegetation), below, above.
enum class ThingState : std::uint8_t { object, rest, part, several };
constexpr std::size_t kThingStates = 4;

// How much the states count where all things of a tree are weighed together: exp(bias) p^power.
struct RoleWeights {
  std::array<double, kThingStates> power{1, 1, 1, 1}, bias{};
};

// A thing whose class is known. `none`: a remnant that is no thing at all.
struct ThingSample {
  ThingFeatures features{};
  PointLabel label = PointLabel::none;
  std::uint32_t group = 0;  // things of one group are never parted by a fold: the number of a block
  ThingRole role = ThingRole::whole;
  ThingParts parts{};  // places in the list of samples, from 1, of those it joins; 0: none
};

// Which features may be selected.
enum class FeatureSet : std::uint8_t { document, all };

struct ThingTrainingParams {
  FeatureSet features = FeatureSet::all;
  double max_p = 0.01;      // of the stepwise selection
  std::uint32_t folds = 5;  // of the cross-validation that the grid is searched by
  std::uint32_t most_in_grid =
      300;  // samples of a class that the grid is searched with; of more, as many evenly spread
  std::uint32_t most_of_class = 900;  // samples of a class that the machine is trained on, likewise
};

// A trained machine: one against one, radial kernel exp(-gamma d^2) on standardised features; and, where the samples
// had roles, trees that say what is whole and an object. The machine has learnt from objects alone then.
struct ThingModel {
  std::string recipe;                 // how it was trained, for people: lines without a leading blank
  std::vector<std::size_t> features;  // in the order of their selection
  std::vector<double> mean, sd;       // of each, after signed_root
  double gamma = 1, cost = 1;
  std::vector<PointLabel> classes;             // rising; a single one needs no vectors
  std::vector<double> unlike;                  // of each class: what has a smaller kernel to all its vectors is none
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
struct ThingClass {
  PointLabel label = PointLabel::other;
  double probability = 0;
  double whole = 1, part = 0, several = 0;
  double object = 0;  // how much speaks for an object over what speaks for none, as a logarithm
};

// The features that the stepwise selection takes, in its order.
std::vector<std::size_t> selected_features(std::span<const ThingSample> samples, const ThingTrainingParams& params);

// Where samples have roles, learns the trees and the weights of roles from all of them (role_training.h), and the
// machine from those that are whole and objects; otherwise the machine from all. For the machine selects features,
// searches cost and gamma on a grid by cross-validation over groups, trains on all with what was best (ties: the lower
// cost, then the lower gamma) and fits the probabilities to the decisions of the cross-validation (Platt 1999 as Lin,
// Lin and Weng 2007 do it). Where samples were left out because a class has many, those that the machine gets wrong (at
// most a third as many) join the others, and it is trained once more; probabilities stay those of the even choice,
// times how many samples each class really had. At least two classes (or roles, and one class) with two samples each,
// else Error(usage).
ThingModel train_things(std::span<const ThingSample> samples, const ThingTrainingParams& params = {});

// Classes: pairwise probabilities coupled as Wu, Lin and Weng (2004) do it in their second method, times how common the
// classes are. Called an object where its weight is greater than that of being none, then by the most probable class.
// Objects that are farther from their class than anything that the machine was trained on are `other`, as probable as
// any class. `parts` of each thing, or none where no thing joins others. Many at once are several times faster than one
// by one, and get the same bits. O(things (support vectors + trees)), on the threads of the calling arena.
std::vector<ThingClass> classify_things(const ThingModel& model, std::span<const ThingFeatures> things,
                                        std::span<const ThingParts> parts = {});
ThingClass classify_thing(const ThingModel& model, const ThingFeatures& features);

// Cross-validation by groups: what a machine says of each sample when trained on the other folds' samples, all steps of
// the training included.
std::vector<ThingClass> cross_validate(std::span<const ThingSample> samples, const ThingTrainingParams& params,
                                       std::uint32_t folds = 10);

// The model as text and back; parse throws Error naming `name` and the line.
std::string thing_model_text(const ThingModel& model);
ThingModel parse_thing_model(std::string_view text, const std::string& name);

// What ships with ilot: trained on the virtual scanner's streets. Its recipe stands in it.
const ThingModel& default_thing_model();

// The same for clouds from the air: trained on streets that the virtual scanner saw from flight lines.
const ThingModel& air_thing_model();

}  // namespace ilot
