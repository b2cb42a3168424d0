// SPDX-License-Identifier: Apache-2.0
#include <libsvm/svm.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "engine/error.h"
#include "engine/streets/thing_decisions.h"
#include "engine/streets/thing_model.h"
#include "kernels/core/parallel.h"
#include "kernels/core/portable_math.h"
#include "kernels/rasters/feature_selection.h"

namespace ilot {
namespace {

constexpr int kCosts[] = {0, 3, 6, 9};  // powers of two
constexpr int kGammas[] = {-7, -5, -3, -1};

struct FreeModel {
  void operator()(svm_model* model) const { svm_free_and_destroy_model(&model); }
};
using SvmModel = std::unique_ptr<svm_model, FreeModel>;

void print_nothing(const char*) {}

// Samples as the machine sees them.
struct TrainingSet {
  std::vector<std::vector<double>> rows;  // standardised
  std::vector<std::uint32_t> classes, folds;
  std::size_t size() const { return rows.size(); }
};

std::vector<PointLabel> classes_of(std::span<const ThingSample> samples) {
  std::vector<PointLabel> classes;
  for (const ThingSample& s : samples) classes.push_back(s.label);
  std::sort(classes.begin(), classes.end());
  classes.erase(std::unique(classes.begin(), classes.end()), classes.end());
  return classes;
}

// At most so many of each class, evenly spread in their order; the others go to `rest`.
std::vector<ThingSample> thinned(std::span<const ThingSample> samples, std::uint32_t most,
                                 std::vector<ThingSample>& rest) {
  std::map<PointLabel, std::uint64_t> total, seen;
  for (const ThingSample& s : samples) ++total[s.label];
  std::vector<ThingSample> kept;
  for (const ThingSample& s : samples) {
    const std::uint64_t n = total[s.label], i = seen[s.label]++;
    (n <= most || i * most / n != (i + 1) * most / n ? kept : rest).push_back(s);
  }
  return kept;
}

// Those that a model gets wrong.
std::vector<ThingSample> wrong_ones(const ThingModel& model, std::span<const ThingSample> samples) {
  std::vector<std::uint8_t> wrong(samples.size(), 0);
  parallel_for(samples.size(),
               [&](std::size_t i) { wrong[i] = classify_thing(model, samples[i].features).label != samples[i].label; });
  std::vector<ThingSample> out;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (wrong[i] != 0) out.push_back(samples[i]);
  return out;
}

// Groups in their order, dealt out one by one; single samples where there are fewer groups than folds.
std::vector<std::uint32_t> folds_of(std::span<const ThingSample> samples, std::uint32_t folds) {
  std::map<std::uint32_t, std::uint32_t> groups;
  for (const ThingSample& s : samples) groups.emplace(s.group, 0);
  std::uint32_t next = 0;
  for (auto& entry : groups) entry.second = next++ % folds;
  std::vector<std::uint32_t> out;
  for (std::size_t i = 0; i < samples.size(); ++i)
    out.push_back(groups.size() >= folds ? groups[samples[i].group] : static_cast<std::uint32_t>(i % folds));
  return out;
}

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

TrainingSet training_set(std::span<const ThingSample> samples, const ThingModel& model, std::uint32_t folds) {
  TrainingSet set;
  for (const ThingSample& s : samples) {
    set.rows.push_back(standardised(model, s.features));
    set.classes.push_back(static_cast<std::uint32_t>(
        std::lower_bound(model.classes.begin(), model.classes.end(), s.label) - model.classes.begin()));
  }
  set.folds = folds_of(samples, folds);
  return set;
}

// All kernels of a set, as libsvm takes them: a row begins with its own number, the last node ends it.
class KernelTable {
 public:
  KernelTable(const TrainingSet& set, double gamma) : stride_(set.size() + 2), nodes_(set.size() * stride_) {
    for (std::size_t i = 0; i < set.size(); ++i) {
      nodes_[i * stride_] = {0, static_cast<double>(i + 1)};
      nodes_[i * stride_ + stride_ - 1] = {-1, 0};
      for (std::size_t j = 0; j <= i; ++j) {
        const double kernel = radial(set.rows[i], set.rows[j], gamma);
        nodes_[i * stride_ + j + 1] = {static_cast<int>(j + 1), kernel};
        nodes_[j * stride_ + i + 1] = {static_cast<int>(i + 1), kernel};
      }
    }
  }
  double at(std::size_t i, std::size_t j) const { return nodes_[i * stride_ + j + 1].value; }
  svm_node* row(std::size_t i) const { return const_cast<svm_node*>(&nodes_[i * stride_]); }  // libsvm only reads

 private:
  std::size_t stride_;
  std::vector<svm_node> nodes_;
};

// A machine trained on some samples of a set, and which they are.
struct Machine {
  SvmModel model;
  std::vector<std::size_t> samples;
};

Machine train_on(const TrainingSet& set, const KernelTable& kernels, std::vector<std::size_t> samples, double cost,
                 std::size_t class_count) {
  Machine m;
  m.samples = std::move(samples);
  const std::size_t n = m.samples.size();
  std::vector<double> count(class_count, 0), labels;
  std::vector<svm_node*> rows;
  for (const std::size_t s : m.samples) {
    ++count[set.classes[s]];
    labels.push_back(set.classes[s]);
    rows.push_back(kernels.row(s));
  }
  std::vector<int> weight_label;
  std::vector<double> weight;
  for (std::size_t c = 0; c < class_count; ++c) {
    if (count[c] == 0) continue;
    weight_label.push_back(static_cast<int>(c));
    weight.push_back(std::sqrt(static_cast<double>(n) / (static_cast<double>(class_count) * count[c])));
  }
  svm_parameter p{};
  p.svm_type = C_SVC;
  p.kernel_type = PRECOMPUTED;
  p.cache_size = 64;
  p.eps = 0.001;
  p.C = cost;
  p.shrinking = 1;
  p.nr_weight = static_cast<int>(weight.size());
  p.weight_label = weight_label.data();
  p.weight = weight.data();
  const svm_problem problem{static_cast<int>(n), labels.data(), rows.data()};
  m.model.reset(svm_train(&problem, &p));
  return m;
}

// Decisions of a machine for one sample, by pairs of the whole's classes; 0 for pairs that it does not know.
std::vector<double> decisions(const Machine& m, const KernelTable& kernels, std::size_t sample,
                              std::size_t class_count) {
  const svm_model& model = *m.model;
  const int k = model.nr_class;
  std::vector<double> out(class_count * (class_count - 1) / 2, 0);
  std::vector<int> start(static_cast<std::size_t>(k) + 1, 0);
  for (int c = 0; c < k; ++c)
    start[static_cast<std::size_t>(c) + 1] = start[static_cast<std::size_t>(c)] + model.nSV[c];
  std::vector<double> kernel(static_cast<std::size_t>(model.l));
  for (int v = 0; v < model.l; ++v)
    kernel[static_cast<std::size_t>(v)] =
        kernels.at(sample, m.samples[static_cast<std::size_t>(model.sv_indices[v] - 1)]);
  int pair = 0;
  for (int a = 0; a < k; ++a)
    for (int b = a + 1; b < k; ++b, ++pair) {
      double sum = 0;
      for (int v = start[static_cast<std::size_t>(a)]; v < start[static_cast<std::size_t>(a) + 1]; ++v)
        sum += model.sv_coef[b - 1][v] * kernel[static_cast<std::size_t>(v)];
      for (int v = start[static_cast<std::size_t>(b)]; v < start[static_cast<std::size_t>(b) + 1]; ++v)
        sum += model.sv_coef[a][v] * kernel[static_cast<std::size_t>(v)];
      sum -= model.rho[pair];
      const auto i = static_cast<std::size_t>(model.label[a]), j = static_cast<std::size_t>(model.label[b]);
      out[pair_index(std::min(i, j), std::max(i, j), class_count)] = i < j ? sum : -sum;
    }
  return out;
}

// Decisions for every sample by the machine that has not seen its fold.
std::vector<std::vector<double>> held_out(const TrainingSet& set, const KernelTable& kernels, double cost,
                                          std::uint32_t folds, std::size_t class_count) {
  std::vector<std::vector<double>> out(set.size());
  for (std::uint32_t fold = 0; fold < folds; ++fold) {
    std::vector<std::size_t> rest;
    for (std::size_t i = 0; i < set.size(); ++i)
      if (set.folds[i] != fold) rest.push_back(i);
    if (rest.empty() || rest.size() == set.size()) continue;
    const Machine machine = train_on(set, kernels, rest, cost, class_count);
    for (std::size_t i = 0; i < set.size(); ++i)
      if (set.folds[i] == fold) out[i] = decisions(machine, kernels, i, class_count);
  }
  for (auto& d : out) d.resize(class_count * (class_count - 1) / 2, 0);
  return out;
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
    for (std::size_t c = 0; c < std::size(kCosts); ++c)
      hits[g][c] = balanced_hits(set, held_out(set, kernels, std::ldexp(1.0, kCosts[c]), folds, classes), classes);
  });
  GridBest best;
  for (std::size_t c = 0; c < std::size(kCosts); ++c)
    for (std::size_t g = 0; g < std::size(kGammas); ++g)
      if (hits[g][c] > best.hits) best = {std::ldexp(1.0, kCosts[c]), std::ldexp(1.0, kGammas[g]), hits[g][c]};
  return best;
}

// 1 / (1 + exp(a f + b)) fitted to decisions f and whether the first class is true, by Newton's method with
// backtracking.
struct Sigmoid {
  double a = -1, b = 0;
};

double log1p_exp(double v) {  // log(1 + exp(v))
  return v > 0 ? v + natural_log(1 + natural_exp(-v)) : natural_log(1 + natural_exp(std::max(v, -700.0)));
}

Sigmoid fit_sigmoid(const std::vector<double>& f, const std::vector<std::uint8_t>& first) {
  const auto positives = static_cast<double>(std::count(first.begin(), first.end(), 1));
  const double negatives = static_cast<double>(first.size()) - positives;
  const double high = (positives + 1) / (positives + 2), low = 1 / (negatives + 2);
  Sigmoid s{0, natural_log((negatives + 1) / (positives + 1))};
  const auto cost_of = [&](double a, double b) {
    double sum = 0;
    for (std::size_t i = 0; i < f.size(); ++i) {
      const double v = a * f[i] + b, t = first[i] ? high : low;
      sum += v >= 0 ? t * v + log1p_exp(-v) : (t - 1) * v + log1p_exp(v);
    }
    return sum;
  };
  double value = cost_of(s.a, s.b);
  for (int round = 0; round < 100; ++round) {
    double h11 = 1e-12, h22 = 1e-12, h21 = 0, g1 = 0, g2 = 0;
    for (std::size_t i = 0; i < f.size(); ++i) {
      const double p = sigmoid(s.a * f[i] + s.b), d = p * (1 - p), t = first[i] ? high : low;
      h11 += f[i] * f[i] * d, h22 += d, h21 += f[i] * d;
      g1 += f[i] * (t - p), g2 += t - p;
    }
    if (std::abs(g1) < 1e-5 && std::abs(g2) < 1e-5) break;
    const double det = h11 * h22 - h21 * h21;
    const double da = -(h22 * g1 - h21 * g2) / det, db = -(-h21 * g1 + h11 * g2) / det, slope = g1 * da + g2 * db;
    double step = 1;
    for (; step >= 1e-10; step /= 2) {
      const double next = cost_of(s.a + step * da, s.b + step * db);
      if (next >= value + 0.0001 * step * slope) continue;
      s = {s.a + step * da, s.b + step * db};
      value = next;
      break;
    }
    if (step < 1e-10) break;
  }
  return s;
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

// The machine in the order of the model's classes: libsvm has them in the order in which they first came.
void take_over(const Machine& machine, const TrainingSet& set, ThingModel& model) {
  const svm_model& svm = *machine.model;
  const std::size_t k = model.classes.size();
  std::vector<std::size_t> place(k);  // of a class in libsvm's list
  for (std::size_t c = 0; c < k; ++c) place[static_cast<std::size_t>(svm.label[c])] = c;
  model.rho.assign(k * (k - 1) / 2, 0);
  for (std::size_t a = 0; a < k; ++a)
    for (std::size_t b = a + 1; b < k; ++b) {
      const std::size_t i = place[a], j = place[b];
      model.rho[pair_index(a, b, k)] = (i < j ? 1 : -1) * svm.rho[pair_index(std::min(i, j), std::max(i, j), k)];
    }
  for (std::size_t c = 0; c < k; ++c) {
    int first = 0;
    for (std::size_t i = 0; i < place[c]; ++i) first += svm.nSV[i];
    for (int v = first; v < first + svm.nSV[place[c]]; ++v) {
      model.vectors.push_back(set.rows[machine.samples[static_cast<std::size_t>(svm.sv_indices[v] - 1)]]);
      model.class_of_vector.push_back(static_cast<std::uint32_t>(c));
      std::vector<double> weights;
      for (std::size_t other = 0; other < k; ++other) {
        if (other == c) continue;
        const std::size_t i = place[c], j = place[other];
        const double coefficient = svm.sv_coef[i < j ? j - 1 : j][v];
        weights.push_back(((c < other) == (i < j) ? 1 : -1) * coefficient);
      }
      model.weights.push_back(weights);
    }
  }
}

void check(std::span<const ThingSample> samples) {
  std::map<PointLabel, std::size_t> counts;
  for (const ThingSample& s : samples) ++counts[s.label];
  if (counts.size() < 2) throw Error("training needs things of two classes at least", ExitCode::usage);
  for (const auto& [label, count] : counts)
    if (count < 2)
      throw Error("training needs two things of each class at least; there is one of class " +
                      (label == PointLabel::none ? "none" : point_label_names().at(static_cast<std::uint32_t>(label))),
                  ExitCode::usage);
}

std::uint32_t usable_folds(const TrainingSet& set, std::uint32_t folds) {
  return std::max(2u, std::min<std::uint32_t>(folds, static_cast<std::uint32_t>(set.size())));
}

// The kernel to the nearest support vector that is not the sample itself: what all but a hundredth of the even samples
// have at least.
double least_likeness(const TrainingSet& set, std::size_t even, const ThingModel& model) {
  std::vector<double> nearest(even, 0);
  parallel_for(even, [&](std::size_t i) {
    for (const auto& vector : model.vectors)
      if (vector != set.rows[i]) nearest[i] = std::max(nearest[i], radial(set.rows[i], vector, model.gamma));
  });
  std::sort(nearest.begin(), nearest.end());
  return nearest[even / 100];
}

// Trains the model's machine, features, cost and gamma given, and fits its probabilities.
void finish(const TrainingSet& set, std::size_t even, const ThingTrainingParams& params, ThingModel& model) {
  model.vectors.clear(), model.weights.clear(), model.class_of_vector.clear();
  model.slope.clear(), model.offset.clear();
  const std::size_t k = model.classes.size();
  const KernelTable kernels(set, model.gamma);
  fit_probabilities(set, even, held_out(set, kernels, model.cost, usable_folds(set, params.folds), k), model);
  std::vector<std::size_t> everything(set.size());
  for (std::size_t i = 0; i < everything.size(); ++i) everything[i] = i;
  take_over(train_on(set, kernels, everything, model.cost, k), set, model);
  model.unlike = least_likeness(set, even, model);
}

}  // namespace

std::vector<std::size_t> selected_features(std::span<const ThingSample> samples, const ThingTrainingParams& params) {
  const std::size_t columns = params.features == FeatureSet::document ? kComponentFeatures : kThingFeatures;
  std::vector<double> values;
  std::vector<std::uint32_t> classes;
  for (const ThingSample& s : samples) {
    for (std::size_t f = 0; f < columns; ++f) values.push_back(s.features[f]);
    classes.push_back(static_cast<std::uint32_t>(s.label));
  }
  std::vector<std::size_t> chosen;
  for (const SelectedFeature& f : select_features(values, classes, columns, params.max_p)) chosen.push_back(f.feature);
  return chosen;
}

ThingModel train_things(std::span<const ThingSample> all, const ThingTrainingParams& params) {
  svm_set_print_string_function(print_nothing);
  check(all);
  std::vector<ThingSample> rest, ignored;
  std::vector<ThingSample> samples = thinned(all, params.most_of_class, rest);
  const std::size_t even = samples.size();
  ThingModel model;
  model.classes = classes_of(samples);
  for (const PointLabel label : model.classes) {
    const auto of_class = [label](const ThingSample& s) { return s.label == label; };
    model.prior.push_back(static_cast<double>(std::count_if(all.begin(), all.end(), of_class)) /
                          static_cast<double>(std::count_if(samples.begin(), samples.end(), of_class)));
  }
  model.features = selected_features(samples, params);
  if (model.features.empty()) throw Error("training: no feature tells the classes apart", ExitCode::usage);
  standardise(samples, model);
  const TrainingSet first = training_set(samples, model, params.folds);
  const TrainingSet few = training_set(thinned(samples, params.most_in_grid, ignored), model, params.folds);
  const GridBest best = search_grid(few, usable_folds(few, params.folds), model.classes.size());
  model.cost = best.cost;
  model.gamma = best.gamma;
  finish(first, even, params, model);
  const std::vector<ThingSample> wrong = thinned(wrong_ones(model, rest), params.most_of_class / 3, ignored);
  if (wrong.empty()) return model;
  samples.insert(samples.end(), wrong.begin(), wrong.end());
  finish(training_set(samples, model, params.folds), even, params, model);
  return model;
}

std::vector<ThingClass> cross_validate(std::span<const ThingSample> samples, const ThingTrainingParams& params,
                                       std::uint32_t folds) {
  const std::vector<std::uint32_t> fold_of = folds_of(samples, folds);
  std::vector<ThingClass> out(samples.size(), {PointLabel::none, 0, 0});
  for (std::uint32_t fold = 0; fold < folds; ++fold) {
    std::vector<ThingSample> rest;
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (fold_of[i] != fold) rest.push_back(samples[i]);
    if (rest.size() == samples.size()) continue;
    const ThingModel model = train_things(rest, params);
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (fold_of[i] == fold) out[i] = classify_thing(model, samples[i].features);
  }
  return out;
}

}  // namespace ilot
