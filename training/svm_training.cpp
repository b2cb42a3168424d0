// SPDX-License-Identifier: Apache-2.0
#include "training/svm_training.h"

#include <cmath>

#include "engine/products/streets/classes/object_model_functions.h"

namespace ilot {
namespace {

void print_nothing(const char*) {}

// Returns the decisions of a machine for one sample, by pairs of the classes of the whole set. They are 0 for pairs
// that the machine does not know.
std::vector<double> decisions(const TrainedSvm& m, const KernelTable& kernels, std::size_t sample,
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

}  // namespace

KernelTable::KernelTable(const TrainingSet& set, double gamma) : stride_(set.size() + 2), nodes_(set.size() * stride_) {
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
TrainedSvm train_on(const TrainingSet& set, const KernelTable& kernels, std::vector<std::size_t> samples, double cost,
                    std::size_t class_count) {
  static const bool silent = (svm_set_print_string_function(print_nothing), true);
  (void)silent;
  TrainedSvm m;
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

std::vector<TrainedSvm> fold_svms(const TrainingSet& set, const KernelTable& kernels, double cost, std::uint32_t folds,
                                  std::size_t class_count) {
  std::vector<TrainedSvm> classifiers(folds);
  for (std::uint32_t fold = 0; fold < folds; ++fold) {
    std::vector<std::size_t> rest;
    for (std::size_t i = 0; i < set.size(); ++i)
      if (set.folds[i] != fold) rest.push_back(i);
    if (rest.empty() || rest.size() == set.size()) continue;
    classifiers[fold] = train_on(set, kernels, rest, cost, class_count);
  }
  return classifiers;
}

std::vector<std::vector<double>> held_out(const TrainingSet& set, const KernelTable& kernels,
                                          const std::vector<TrainedSvm>& classifiers, std::size_t class_count) {
  std::vector<std::vector<double>> out(set.size());
  for (std::size_t i = 0; i < set.size(); ++i) {
    const TrainedSvm& svm = classifiers[set.folds[i]];
    if (svm.model != nullptr)
      out[i] = decisions(svm, kernels, i, class_count);
    else
      out[i].resize(class_count * (class_count - 1) / 2, 0);
  }
  return out;
}

void take_over(const TrainedSvm& trained, const TrainingSet& set, ObjectModel& model) {
  const svm_model& svm = *trained.model;
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
      model.vectors.push_back(set.rows[trained.samples[static_cast<std::size_t>(svm.sv_indices[v] - 1)]]);
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

}  // namespace ilot
