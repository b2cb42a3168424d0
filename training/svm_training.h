// SPDX-License-Identifier: Apache-2.0
// Internal to the training: the support vector machine of libsvm on precomputed kernels.
#pragma once
#include <libsvm/svm.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/products/streets/classes/object_model.h"

namespace ilot {

struct FreeModel {
  void operator()(svm_model* model) const { svm_free_and_destroy_model(&model); }
};
using SvmModel = std::unique_ptr<svm_model, FreeModel>;

// Samples in the form that the support vector machine uses.
struct TrainingSet {
  std::vector<std::vector<double>> rows;  // standardised
  std::vector<std::uint32_t> classes, folds;
  std::size_t size() const { return rows.size(); }
};

// All kernels of a set in the form of libsvm: a row begins with its own number, and the last node ends it.
class KernelTable {
 public:
  KernelTable(const TrainingSet& set, double gamma);
  double at(std::size_t i, std::size_t j) const { return nodes_[i * stride_ + j + 1].value; }
  svm_node* row(std::size_t i) const { return const_cast<svm_node*>(&nodes_[i * stride_]); }  // libsvm only reads

 private:
  std::size_t stride_;
  std::vector<svm_node> nodes_;
};

// A support vector machine that was trained on some samples of a set, and the positions of these samples.
struct TrainedSvm {
  SvmModel model;
  std::vector<std::size_t> samples;
};

// Trains on some samples of a set, one class against one. Rare classes have a larger weight (the root of how rare they
// are).
TrainedSvm train_on(const TrainingSet& set, const KernelTable& kernels, std::vector<std::size_t> samples, double cost,
                    std::size_t class_count);

// Returns for each fold the machine that has not seen it, or none where the fold has all samples or none.
std::vector<TrainedSvm> fold_svms(const TrainingSet& set, const KernelTable& kernels, double cost, std::uint32_t folds,
                                  std::size_t class_count);

// Returns the decisions for every sample by the machine that has not seen its fold. They are ordered by pairs of the
// classes of the whole set, with 0 for pairs that the machine does not know.
std::vector<std::vector<double>> held_out(const TrainingSet& set, const KernelTable& kernels,
                                          const std::vector<TrainedSvm>& classifiers, std::size_t class_count);

// Copies the machine into the model in the order of the model's classes. libsvm has the classes in the order in which
// they first came. The machine must know all of them.
void take_over(const TrainedSvm& svm, const TrainingSet& set, ObjectModel& model);

}  // namespace ilot
