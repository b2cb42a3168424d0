// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/classes/thing_shares.h"

#include <gtest/gtest.h>

#include "engine/products/streets/classes/thing_decisions.h"
#include "kernels/core/parallel.h"
#include "kernels/core/rng.h"
#include "training/thing_machine.h"

namespace ilot {
namespace {

constexpr std::size_t kClasses = 4, kDimensions = 6;

// Four heaps that overlap, in a model whose features are as they come.
struct Heaps {
  std::vector<ThingFeatures> things;
  TrainingSet set;
  ThingModel model;
};

Heaps make_heaps(std::size_t each) {
  Heaps out;
  for (std::size_t f = 0; f < kDimensions; ++f) {
    out.model.features.push_back(2 * f);
    out.model.mean.push_back(0.1 * static_cast<double>(f));
    out.model.sd.push_back(0.5);
  }
  out.model.gamma = 0.25;
  Rng rng(each, 4);
  for (std::size_t i = 0; i < each * kClasses; ++i) {
    const std::size_t c = (i * 7 + i / 5) % kClasses;
    ThingFeatures f{};
    for (double& v : f) v = rng.uniform();
    f[2 * c] += 0.6;
    out.things.push_back(f);
    out.set.rows.push_back(standardised(out.model, f));
    out.set.classes.push_back(static_cast<std::uint32_t>(c));
    out.set.folds.push_back(0);
  }
  out.model.classes = {PointLabel::car, PointLabel::lamppost, PointLabel::pedestrian, PointLabel::other};
  return out;
}

TEST(PairDecisions, AreThoseOfLibsvm) {
  Heaps heaps = make_heaps(80);
  const KernelTable kernels(heaps.set, heaps.model.gamma);
  std::vector<std::size_t> all(heaps.set.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  const Machine machine = train_on(heaps.set, kernels, all, 8, kClasses);
  take_over(machine, heaps.set, heaps.model);
  const PairDecisions ours = pair_decisions(heaps.model, heaps.things);
  ASSERT_EQ(ours.pairs, kClasses * (kClasses - 1) / 2);
  ASSERT_LT(heaps.model.vectors.size(), heaps.set.size());
  std::size_t far = 0;
  for (std::size_t i = 0; i < heaps.set.size(); ++i) {
    std::vector<double> theirs(ours.pairs);
    svm_predict_values(machine.model.get(), kernels.row(i), theirs.data());
    const int* label = machine.model->label;
    for (std::size_t a = 0, p = 0; a < kClasses; ++a)
      for (std::size_t b = a + 1; b < kClasses; ++b, ++p) {
        const auto x = static_cast<std::size_t>(label[a]), y = static_cast<std::size_t>(label[b]);
        const double mine = ours.of[i * ours.pairs + pair_index(std::min(x, y), std::max(x, y), kClasses)];
        EXPECT_NEAR(x < y ? mine : -mine, theirs[p], 1e-12);
        far += std::abs(theirs[p]) > 0.5;
      }
  }
  EXPECT_GT(far, heaps.set.size());  // not all of it near 0
}

TEST(PairDecisions, NearestIsTheKernelOfTheVectorItself) {
  Heaps heaps = make_heaps(30);
  for (const std::size_t i : {3u, 40u}) {
    heaps.model.vectors.push_back(heaps.set.rows[i]);
    heaps.model.class_of_vector.push_back(static_cast<std::uint32_t>(heaps.model.vectors.size()) - 1);
    heaps.model.weights.push_back({1, 2, 3});
  }
  heaps.model.rho.assign(6, 0.25);
  const PairDecisions d = pair_decisions(heaps.model, std::vector{heaps.things[40], heaps.things[5]});
  EXPECT_EQ(d.nearest[1], 1);  // the second vector is of the second class
  EXPECT_EQ(d.nearest[2], 0);  // the third has none
  for (const std::size_t v : {0u, 1u})
    EXPECT_NEAR(d.nearest[kClasses + v], radial(heaps.set.rows[5], heaps.set.rows[v == 0 ? 3 : 40], 0.25), 1e-14);
  const double beside = radial(heaps.set.rows[40], heaps.set.rows[3], 0.25);
  EXPECT_NEAR(d.of[pair_index(0, 1, kClasses)], beside + 1 - 0.25, 1e-13);  // first weighs the first vector, and so on
  EXPECT_NEAR(d.of[pair_index(0, 3, kClasses)], 3 * beside - 0.25, 1e-13);  // the second has no such pair
  EXPECT_NEAR(d.of[pair_index(1, 2, kClasses)], 2 - 0.25, 1e-13);
  EXPECT_NEAR(d.of[pair_index(2, 3, kClasses)], -0.25, 1e-13);
}

TEST(ClassShares, SumToOneAndKnowNoCompanyAndNoThreads) {
  Heaps heaps = make_heaps(150);
  const KernelTable kernels(heaps.set, heaps.model.gamma);
  std::vector<std::size_t> all(heaps.set.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  take_over(train_on(heaps.set, kernels, all, 1, kClasses), heaps.set, heaps.model);
  heaps.model.slope.assign(6, -2), heaps.model.offset.assign(6, 0.1);
  heaps.model.prior.assign(kClasses, 1);
  std::vector<ClassShares> one, three;
  with_threads(1, [&] { one = class_shares(heaps.model, heaps.things); });
  with_threads(3, [&] { three = class_shares(heaps.model, heaps.things); });
  for (std::size_t i = 0; i < one.size(); ++i) {
    double sum = 0;
    for (const double s : one[i].share) sum += s;
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_EQ(one[i].share, three[i].share);
    if (i % 50 == 0) {
      EXPECT_EQ(class_shares(heaps.model, {&heaps.things[i], 1})[0].share, one[i].share);
    }
  }
}

}  // namespace
}  // namespace ilot
