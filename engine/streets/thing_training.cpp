// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>

#include "engine/error.h"
#include "engine/streets/pair_sigmoid.h"
#include "engine/streets/role_weights.h"
#include "engine/streets/thing_decisions.h"
#include "engine/streets/thing_machine.h"
#include "engine/streets/thing_model.h"
#include "kernels/core/parallel.h"
#include "kernels/rasters/feature_selection.h"

namespace ilot {
namespace {

constexpr int kCosts[] = {0, 3, 6, 9};  // powers of two
constexpr int kGammas[] = {-7, -5, -3, -1};
constexpr double kRounding = 1e-3;  // of a kernel, by the few digits of vectors in a model's text

std::vector<ThingKind> classes_of(std::span<const ThingSample> samples) {
  std::vector<ThingKind> classes;
  for (const ThingSample& s : samples) classes.push_back(s.kind());
  std::sort(classes.begin(), classes.end());
  classes.erase(std::unique(classes.begin(), classes.end()), classes.end());
  return classes;
}

// At most so many of each class, evenly spread in their order; the others go to `rest`.
std::vector<ThingSample> thinned(std::span<const ThingSample> samples, std::uint32_t most,
                                 std::vector<ThingSample>& rest) {
  std::map<ThingKind, std::uint64_t> total, seen;
  for (const ThingSample& s : samples) ++total[s.kind()];
  std::vector<ThingSample> kept;
  for (const ThingSample& s : samples) {
    const std::uint64_t n = total[s.kind()], i = seen[s.kind()]++;
    (n <= most || i * most / n != (i + 1) * most / n ? kept : rest).push_back(s);
  }
  return kept;
}

std::vector<ThingFeatures> features_of(std::span<const ThingSample> samples) {
  std::vector<ThingFeatures> out;
  for (const ThingSample& s : samples) out.push_back(s.features);
  return out;
}

// Those that a model gets wrong.
std::vector<ThingSample> wrong_ones(const ThingModel& model, std::span<const ThingSample> samples) {
  const std::vector<ThingKind> said = likeliest_kinds(model, features_of(samples));
  std::vector<ThingSample> out;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (said[i] != samples[i].kind()) out.push_back(samples[i]);
  return out;
}

// Groups in their order, dealt out one by one; single samples where there are fewer groups than folds.
class Folds {
 public:
  Folds(std::span<const ThingSample> samples, std::uint32_t folds) : folds_(folds) {
    for (const ThingSample& s : samples) of_group_.emplace(s.group, 0);
    std::uint32_t next = 0;
    for (auto& entry : of_group_) entry.second = next++ % folds;
  }
  bool by_group() const { return of_group_.size() >= folds_; }
  std::uint32_t of(const ThingSample& s, std::size_t place) const {
    return by_group() ? of_group_.at(s.group) : static_cast<std::uint32_t>(place % folds_);
  }
  std::uint32_t count() const { return folds_; }

 private:
  std::uint32_t folds_;
  std::map<std::uint32_t, std::uint32_t> of_group_;
};

void standardise(std::span<const ThingSample> samples, ThingModel& model) {
  const auto n = static_cast<double>(samples.size());
  for (const std::size_t f : model.features) {
    double sum = 0, squares = 0;
    for (const ThingSample& s : samples) sum += signed_root(s.features[f]);
    const double mean = sum / n;
    for (const ThingSample& s : samples) {
      const double d = signed_root(s.features[f]) - mean;
      squares += d * d;
    }
    model.mean.push_back(mean);
    model.sd.push_back(squares > 0 ? std::sqrt(squares / n) : 1);
  }
}

TrainingSet training_set(std::span<const ThingSample> samples, const ThingModel& model, const Folds& folds) {
  TrainingSet set;
  for (const ThingSample& s : samples) {
    set.rows.push_back(standardised(model, s.features));
    set.classes.push_back(static_cast<std::uint32_t>(
        std::lower_bound(model.classes.begin(), model.classes.end(), s.kind()) - model.classes.begin()));
    set.folds.push_back(folds.of(s, set.folds.size()));
  }
  return set;
}

// Mean over the classes of the share that is right: rare classes count as much as common ones.
double balanced_hits(const TrainingSet& set, const std::vector<std::vector<double>>& decided, std::size_t classes) {
  std::vector<double> right(classes, 0), all(classes, 0);
  for (std::size_t i = 0; i < set.size(); ++i) {
    ++all[set.classes[i]];
    right[set.classes[i]] += voted(decided[i], classes) == set.classes[i];
  }
  double sum = 0;
  for (std::size_t c = 0; c < classes; ++c) sum += all[c] > 0 ? right[c] / all[c] : 0;
  return sum / static_cast<double>(classes);
}

struct GridBest {
  double cost = 1, gamma = 1, hits = -1;
};

GridBest search_grid(const TrainingSet& set, std::uint32_t folds, std::size_t classes) {
  std::vector<std::vector<double>> hits(std::size(kGammas), std::vector<double>(std::size(kCosts), 0));
  parallel_for(std::size(kGammas), [&](std::size_t g) {
    const KernelTable kernels(set, std::ldexp(1.0, kGammas[g]));
    for (std::size_t c = 0; c < std::size(kCosts); ++c) {
      const auto machines = fold_machines(set, kernels, std::ldexp(1.0, kCosts[c]), folds, classes);
      hits[g][c] = balanced_hits(set, held_out(set, kernels, machines, classes), classes);
    }
  });
  GridBest best;
  for (std::size_t c = 0; c < std::size(kCosts); ++c)
    for (std::size_t g = 0; g < std::size(kGammas); ++g)
      if (hits[g][c] > best.hits) best = {std::ldexp(1.0, kCosts[c]), std::ldexp(1.0, kGammas[g]), hits[g][c]};
  return best;
}

// From the first `even` samples of the set.
void fit_probabilities(const TrainingSet& set, std::size_t even, const std::vector<std::vector<double>>& decided,
                       ThingModel& model) {
  const std::size_t k = model.classes.size();
  for (std::size_t a = 0; a < k; ++a)
    for (std::size_t b = a + 1; b < k; ++b) {
      std::vector<double> f;
      std::vector<std::uint8_t> first;
      for (std::size_t i = 0; i < even; ++i) {
        if (set.classes[i] != a && set.classes[i] != b) continue;
        f.push_back(decided[i][pair_index(a, b, k)]);
        first.push_back(set.classes[i] == a);
      }
      const Sigmoid s = fit_sigmoid(f, first);
      model.slope.push_back(s.a);
      model.offset.push_back(s.b);
    }
}

void check(std::span<const ThingSample> samples) {
  std::map<ThingKind, std::size_t> counts;
  for (const ThingSample& s : samples) ++counts[s.kind()];
  if (counts.size() < 2) throw Error("training needs things of two classes at least", ExitCode::usage);
  for (const auto& [kind, count] : counts)
    if (count < 2)
      throw Error("training needs two things of each class at least; there is one of class " + name_of(kind),
                  ExitCode::usage);
}

// The kernel to the nearest support vector that is not the sample itself: what all but a hundredth of the even samples
// of each class have at least, so that a rare and scattered class is not the strange one.
double least_likeness(const TrainingSet& set, std::size_t even, const ThingModel& model) {
  std::vector<double> nearest(even, 0);
  parallel_for(even, [&](std::size_t i) {
    for (const auto& vector : model.vectors)
      if (vector != set.rows[i]) nearest[i] = std::max(nearest[i], radial(set.rows[i], vector, model.gamma));
  });
  std::vector<std::vector<double>> of_class(model.classes.size());
  for (std::size_t i = 0; i < even; ++i) of_class[set.classes[i]].push_back(nearest[i]);
  double least = 1;
  for (std::vector<double>& list : of_class) {
    std::sort(list.begin(), list.end());
    least = std::min(least, list[list.size() / 100]);
  }
  return least * (1 - kRounding);
}

// Trains the model's machine, features, cost and gamma given, and fits its probabilities. Of each fold the model that
// has not seen it; without vectors where there is none that knows all classes.
std::vector<ThingModel> finish(const TrainingSet& set, std::size_t even, const Folds& folds, ThingModel& model) {
  model.vectors.clear(), model.weights.clear(), model.class_of_vector.clear();
  model.slope.clear(), model.offset.clear();
  const std::size_t k = model.classes.size();
  const KernelTable kernels(set, model.gamma);
  const std::vector<Machine> machines = fold_machines(set, kernels, model.cost, folds.count(), k);
  fit_probabilities(set, even, held_out(set, kernels, machines, k), model);
  std::vector<ThingModel> unseen(folds.count(), model);
  for (std::size_t f = 0; f < unseen.size(); ++f)
    if (machines[f].model != nullptr && machines[f].model->nr_class == static_cast<int>(k))
      take_over(machines[f], set, unseen[f]);
  std::vector<std::size_t> everything(set.size());
  for (std::size_t i = 0; i < everything.size(); ++i) everything[i] = i;
  take_over(train_on(set, kernels, everything, model.cost, k), set, model);
  model.unlike = least_likeness(set, even, model);
  return unseen;
}

// The states that a sample may have in a true cut. What is no thing may be parted and joined at will.
RoleSample role_sample(const ThingSample& s) {
  RoleSample out;
  const bool object = s.label >= PointLabel::car;
  switch (s.role) {
    case ThingRole::whole:
      out.may = {object, !object, 1, 1};
      break;
    case ThingRole::part:
      out.may = {0, 0, 1, 0};
      break;
    case ThingRole::several:
      out.may = {0, 0, 0, 1};
      break;
  }
  std::copy(s.parts.begin(), s.parts.end(), out.parts);
  return out;
}

// Samples of one fold: their places and features.
struct FoldSamples {
  std::vector<std::size_t> places;
  std::vector<ThingFeatures> features;
};
FoldSamples samples_of(std::span<const ThingSample> all, const Folds& folds, std::uint32_t fold) {
  FoldSamples out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (folds.of(all[i], i) != fold) continue;
    out.places.push_back(i);
    out.features.push_back(all[i].features);
  }
  return out;
}

// Learns how much the roles count, from what the models that have not seen the samples say of them.
RoleWeights roles_of(std::span<const ThingSample> all, const Folds& folds, const std::vector<ThingModel>& unseen) {
  const bool joined = std::any_of(all.begin(), all.end(), [](const ThingSample& s) { return s.parts[0] != 0; });
  const bool known = std::none_of(unseen.begin(), unseen.end(), [](const ThingModel& m) { return m.vectors.empty(); });
  if (!joined || !known || !folds.by_group()) return {};
  std::vector<RoleSample> things(all.size());
  for (std::uint32_t fold = 0; fold < folds.count(); ++fold) {
    const auto [places, features] = samples_of(all, folds, fold);
    const auto logs = role_logs(unseen[fold], features);
    for (std::size_t i = 0; i < places.size(); ++i) {
      things[places[i]] = role_sample(all[places[i]]);
      things[places[i]].log = logs[i];
    }
  }
  return learn_role_weights(things);
}

// Those of one fold or of all others, with their parts among them; what has lost a part joins none.
std::vector<ThingSample> without_fold(std::span<const ThingSample> samples, const Folds& folds, std::uint32_t fold) {
  std::vector<ThingSample> rest;
  std::vector<std::uint32_t> place(samples.size() + 1, 0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (folds.of(samples[i], i) == fold) continue;
    rest.push_back(samples[i]);
    place[i + 1] = static_cast<std::uint32_t>(rest.size());
    auto& [a, b] = rest.back().parts;
    a = place[a], b = place[b];
    if (a == 0 || b == 0) a = b = 0;
  }
  return rest;
}

}  // namespace

std::vector<std::size_t> selected_features(std::span<const ThingSample> samples, const ThingTrainingParams& params) {
  const std::size_t columns = params.features == FeatureSet::document ? kComponentFeatures : kThingFeatures;
  const std::vector<ThingKind> kinds = classes_of(samples);
  std::vector<double> values;
  std::vector<std::uint32_t> classes;
  for (const ThingSample& s : samples) {
    for (std::size_t f = 0; f < columns; ++f) values.push_back(s.features[f]);
    classes.push_back(
        static_cast<std::uint32_t>(std::lower_bound(kinds.begin(), kinds.end(), s.kind()) - kinds.begin()));
  }
  std::vector<std::size_t> chosen;
  for (const SelectedFeature& f : select_features(values, classes, columns, params.max_p)) chosen.push_back(f.feature);
  return chosen;
}

ThingModel train_things(std::span<const ThingSample> all, const ThingTrainingParams& params) {
  check(all);
  std::vector<ThingSample> rest, ignored;
  std::vector<ThingSample> samples = thinned(all, params.most_of_class, rest);
  const std::size_t even = samples.size();
  ThingModel model;
  model.classes = classes_of(samples);
  for (const ThingKind kind : model.classes) {
    const auto of_class = [kind](const ThingSample& s) { return s.kind() == kind; };
    model.prior.push_back(static_cast<double>(std::count_if(all.begin(), all.end(), of_class)) /
                          static_cast<double>(std::count_if(samples.begin(), samples.end(), of_class)));
  }
  model.features = selected_features(samples, params);
  if (model.features.empty()) throw Error("training: no feature tells the classes apart", ExitCode::usage);
  standardise(samples, model);
  const Folds folds(all, std::clamp<std::uint32_t>(static_cast<std::uint32_t>(samples.size()), 2u, params.folds));
  const TrainingSet few = training_set(thinned(samples, params.most_in_grid, ignored), model, folds);
  const GridBest best = search_grid(few, folds.count(), model.classes.size());
  model.cost = best.cost;
  model.gamma = best.gamma;
  std::vector<ThingModel> unseen = finish(training_set(samples, model, folds), even, folds, model);
  const std::vector<ThingSample> wrong = thinned(wrong_ones(model, rest), params.most_of_class / 3, ignored);
  if (!wrong.empty()) {
    samples.insert(samples.end(), wrong.begin(), wrong.end());
    unseen = finish(training_set(samples, model, folds), even, folds, model);
  }
  model.roles = roles_of(all, folds, unseen);
  return model;
}

std::vector<ThingClass> cross_validate(std::span<const ThingSample> samples, const ThingTrainingParams& params,
                                       std::uint32_t folds) {
  const Folds dealt(samples, folds);
  std::vector<ThingClass> out(samples.size(), {PointLabel::none, 0, 0});
  for (std::uint32_t fold = 0; fold < folds; ++fold) {
    const std::vector<ThingSample> rest = without_fold(samples, dealt, fold);
    if (rest.size() == samples.size()) continue;
    const ThingModel model = train_things(rest, params);
    const auto [places, features] = samples_of(samples, dealt, fold);
    const std::vector<ThingClass> classes = classify_things(model, features);
    for (std::size_t i = 0; i < places.size(); ++i) out[places[i]] = classes[i];
  }
  return out;
}

}  // namespace ilot
