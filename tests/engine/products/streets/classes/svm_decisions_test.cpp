// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/classes/svm_decisions.h"

#include <gtest/gtest.h>

#include "engine/products/streets/classes/class_shares.h"
#include "engine/products/streets/classes/object_model_functions.h"
#include "kernels/core/parallel.h"
#include "kernels/core/rng.h"
#include "training/svm_training.h"

namespace ilot {
namespace {

constexpr std::size_t kClasses = 4, kDimensions = 6;

// Four heaps that overlap, in a model whose features are as they come.
struct Blobs {
  std::vector<CandidateFeatures> candidates;
  TrainingSet set;
  ObjectModel model;
};

Blobs make_blobs(std::size_t each) {
  Blobs out;
  for (std::size_t f = 0; f < kDimensions; ++f) {
    out.model.features.push_back(2 * f);
    out.model.mean.push_back(0.1 * static_cast<double>(f));
    out.model.sd.push_back(0.5);
  }
  out.model.gamma = 0.25;
  Rng rng(each, 4);
  for (std::size_t i = 0; i < each * kClasses; ++i) {
    const std::size_t c = (i * 7 + i / 5) % kClasses;
    CandidateFeatures f{};
    for (double& v : f) v = rng.uniform();
    f[2 * c] += 0.6;
    out.candidates.push_back(f);
    out.set.rows.push_back(standardised(out.model, f));
    out.set.classes.push_back(static_cast<std::uint32_t>(c));
    out.set.folds.push_back(0);
  }
  out.model.classes = {PointLabel::car, PointLabel::lamppost, PointLabel::pedestrian, PointLabel::other};
  return out;
}

TEST(PairDecisions, AreThoseOfLibsvm) {
  Blobs blobs = make_blobs(80);
  const KernelTable kernels(blobs.set, blobs.model.gamma);
  std::vector<std::size_t> all(blobs.set.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  const TrainedSvm svm = train_on(blobs.set, kernels, all, 8, kClasses);
  take_over(svm, blobs.set, blobs.model);
  const PairDecisions ours = pair_decisions(blobs.model, blobs.candidates);
  ASSERT_EQ(ours.pairs, kClasses * (kClasses - 1) / 2);
  ASSERT_LT(blobs.model.vectors.size(), blobs.set.size());
  std::size_t far = 0;
  for (std::size_t i = 0; i < blobs.set.size(); ++i) {
    std::vector<double> theirs(ours.pairs);
    svm_predict_values(svm.model.get(), kernels.row(i), theirs.data());
    const int* label = svm.model->label;
    for (std::size_t a = 0, p = 0; a < kClasses; ++a)
      for (std::size_t b = a + 1; b < kClasses; ++b, ++p) {
        const auto x = static_cast<std::size_t>(label[a]), y = static_cast<std::size_t>(label[b]);
        const double mine = ours.of[i * ours.pairs + pair_index(std::min(x, y), std::max(x, y), kClasses)];
        EXPECT_NEAR(x < y ? mine : -mine, theirs[p], 1e-12);
        far += std::abs(theirs[p]) > 0.5;
      }
  }
  EXPECT_GT(far, blobs.set.size());  // not all of it near 0
}

TEST(PairDecisions, NearestIsTheKernelOfTheVectorItself) {
  Blobs blobs = make_blobs(30);
  for (const std::size_t i : {3u, 40u}) {
    blobs.model.vectors.push_back(blobs.set.rows[i]);
    blobs.model.class_of_vector.push_back(static_cast<std::uint32_t>(blobs.model.vectors.size()) - 1);
    blobs.model.weights.push_back({1, 2, 3});
  }
  blobs.model.rho.assign(6, 0.25);
  const PairDecisions d = pair_decisions(blobs.model, std::vector{blobs.candidates[40], blobs.candidates[5]});
  EXPECT_EQ(d.nearest[1], 1);  // the second vector is of the second class
  EXPECT_EQ(d.nearest[2], 0);  // the third has none
  for (const std::size_t v : {0u, 1u})
    EXPECT_NEAR(d.nearest[kClasses + v], radial(blobs.set.rows[5], blobs.set.rows[v == 0 ? 3 : 40], 0.25), 1e-14);
  const double beside = radial(blobs.set.rows[40], blobs.set.rows[3], 0.25);
  EXPECT_NEAR(d.of[pair_index(0, 1, kClasses)], beside + 1 - 0.25, 1e-13);  // first weighs the first vector, and so on
  EXPECT_NEAR(d.of[pair_index(0, 3, kClasses)], 3 * beside - 0.25, 1e-13);  // the second has no such pair
  EXPECT_NEAR(d.of[pair_index(1, 2, kClasses)], 2 - 0.25, 1e-13);
  EXPECT_NEAR(d.of[pair_index(2, 3, kClasses)], -0.25, 1e-13);
}

TEST(ClassShares, SumToOneAndKnowNoCompanyAndNoThreads) {
  Blobs blobs = make_blobs(150);
  const KernelTable kernels(blobs.set, blobs.model.gamma);
  std::vector<std::size_t> all(blobs.set.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  take_over(train_on(blobs.set, kernels, all, 1, kClasses), blobs.set, blobs.model);
  blobs.model.slope.assign(6, -2), blobs.model.offset.assign(6, 0.1);
  blobs.model.prior.assign(kClasses, 1);
  std::vector<ClassShares> one, three;
  with_threads(1, [&] { one = class_shares(blobs.model, blobs.candidates); });
  with_threads(3, [&] { three = class_shares(blobs.model, blobs.candidates); });
  for (std::size_t i = 0; i < one.size(); ++i) {
    double sum = 0;
    for (const double s : one[i].share) sum += s;
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_EQ(one[i].share, three[i].share);
    if (i % 50 == 0) {
      EXPECT_EQ(class_shares(blobs.model, {&blobs.candidates[i], 1})[0].share, one[i].share);
    }
  }
}

}  // namespace
}  // namespace ilot
