// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/classes/object_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/error.h"
#include "engine/products/streets/classes/role_trees_text.h"
#include "kernels/core/parallel.h"
#include "kernels/core/rng.h"
#include "training/object_model_training.h"

namespace ilot {
namespace {

constexpr PointLabel kLabels[] = {PointLabel::car, PointLabel::lamppost, PointLabel::pedestrian};

// Three classes: by height and area, and by the two together; all other features are noise.
std::vector<TrainingSample> samples_of(std::size_t each, std::uint64_t seed) {
  Rng rng(seed, 1);
  std::vector<TrainingSample> samples;
  for (std::size_t i = 0; i < each; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      TrainingSample s;
      for (double& f : s.features) f = rng.uniform();
      s.features[static_cast<std::size_t>(ComponentFeature::mean_height)] = (c == 1 ? 4 : 1) + 0.5 * rng.uniform();
      s.features[static_cast<std::size_t>(ComponentFeature::area)] = (c == 0 ? 8 : 0.3) + 0.2 * rng.uniform();
      s.label = kLabels[c];
      s.group = static_cast<std::uint32_t>(i % 12);
      samples.push_back(s);
    }
  }
  return samples;
}

TEST(ObjectModel, ClassesThatItHasNotSeen) {
  const ObjectModel model = train_object_model(samples_of(30, 1));
  std::size_t right = 0;
  double probability = 0;
  const auto others = samples_of(40, 2);
  for (const TrainingSample& s : others) {
    const CandidateClass c = classify_candidate(model, s.features);
    right += c.label == s.label;
    probability += c.probability;
    EXPECT_GE(c.probability, 1.0 / 3);
    EXPECT_LE(c.probability, 1.0);
  }
  EXPECT_GE(right, others.size() * 95 / 100);  // all features but two are noise
  EXPECT_GT(probability / static_cast<double>(others.size()), 0.9);
}

TEST(ObjectModel, SelectsFeaturesThatSeparate) {
  const auto chosen = selected_features(samples_of(40, 3), {});
  ASSERT_GE(chosen.size(), 2u);
  const std::vector<std::size_t> best{chosen[0], chosen[1]};
  EXPECT_TRUE(std::count(best.begin(), best.end(), static_cast<std::size_t>(ComponentFeature::mean_height)) == 1);
  EXPECT_TRUE(std::count(best.begin(), best.end(), static_cast<std::size_t>(ComponentFeature::area)) == 1);
}

TEST(ObjectModel, TextAndBack) {
  ObjectModel model = train_object_model(samples_of(20, 4));
  model.recipe = "three heaps\n\nof a test\n";
  const std::string text = object_model_text(model);
  const ObjectModel back = parse_object_model(text, "test");
  EXPECT_EQ(back.recipe, model.recipe);
  EXPECT_EQ(object_model_text(back), text);
  for (const TrainingSample& s : samples_of(20, 5)) {
    EXPECT_EQ(classify_candidate(back, s.features).label, classify_candidate(model, s.features).label);
    EXPECT_NEAR(classify_candidate(back, s.features).probability, classify_candidate(model, s.features).probability,
                1e-3);
  }
}

ObjectModel model_of_trees(std::uint64_t seed) {
  ObjectTrainingParams params;
  params.classes = ClassMethod::trees;
  ObjectModel model;
  train_classes(samples_of(60, seed), params, model);
  return model;
}

TEST(ObjectModel, ClassesOfTreesAreThoseOfTheirTextToo) {
  const ObjectModel model = model_of_trees(12);
  EXPECT_TRUE(model.weights.empty());  // no machine
  const std::string text = object_model_text(model);
  const ObjectModel back = parse_object_model(text, "test");
  EXPECT_EQ(object_model_text(back), text);
  std::size_t right = 0;
  const auto others = samples_of(60, 13);
  for (const TrainingSample& s : others) {
    const CandidateClass c = classify_candidate(back, s.features);
    EXPECT_EQ(c.label, classify_candidate(model, s.features).label);
    EXPECT_NEAR(c.probability, classify_candidate(model, s.features).probability, 1e-9);
    right += c.label == s.label;
  }
  EXPECT_GE(right, others.size() * 95 / 100);
  EXPECT_THROW(parse_object_model(text.substr(0, text.rfind("tree")), "test"), Error);
  std::string fewer = text;  // a class less than its trees have
  const std::size_t line = fewer.find("\nclass ");
  fewer.erase(line, fewer.find('\n', line + 1) - line);
  EXPECT_THROW(parse_object_model(fewer, "test"), Error);
}

// Half of the labels of two classes are drawn at random, so no probability of these may be near 1.
TEST(ObjectModel, ProbabilitiesOfTreesAreThoseOfUnseenSamples) {
  const auto drawn = [](std::uint64_t seed) {
    auto samples = samples_of(400, seed);
    Rng rng(seed, 5);
    for (TrainingSample& s : samples)
      if (s.label != PointLabel::car) s.label = kLabels[1 + rng.below(2)];
    return samples;
  };
  ObjectTrainingParams params;
  params.classes = ClassMethod::trees;
  ObjectModel model;
  train_classes(drawn(14), params, model);
  double stated = 0, right = 0, count = 0;
  for (const TrainingSample& s : drawn(15)) {
    const CandidateClass c = classify_candidate(model, s.features);
    if (s.label == PointLabel::car || c.label == PointLabel::car) continue;
    stated += c.probability, right += c.label == s.label, ++count;
  }
  EXPECT_NEAR(stated / count, right / count, 0.15);
}

// A model may state other odds than its trees give: the class stays, and so do models that state what the trees give.
TEST(ObjectModel, StatedOddsChangeProbabilitiesAlone) {
  const auto samples = samples_of(60, 12);
  ObjectTrainingParams params;
  params.classes = ClassMethod::trees;
  ObjectModel model;
  train_classes(samples, params, model);
  EXPECT_EQ(object_model_text(model).find("stated"), std::string::npos);
  ObjectModel surer = model;
  surer.stated = {-2, 0.5};
  surer = parse_object_model(object_model_text(surer), "test");
  for (const TrainingSample& s : samples) {
    const CandidateClass as_trees = classify_candidate(model, s.features), c = classify_candidate(surer, s.features);
    ASSERT_EQ(c.label, as_trees.label);
    const double odds = as_trees.probability / (1 - as_trees.probability), stated = odds * odds * std::exp(-0.5);
    if (as_trees.probability < 0.999) {
      EXPECT_NEAR(c.probability, stated / (1 + stated), 1e-6);
    }
  }
}

// Other classes may be learnt for the roles that a model has.
TEST(ObjectModel, TrainingClassesKeepsTheRoles) {
  auto samples = samples_of(40, 16);
  for (TrainingSample& s : samples)
    if (s.label == PointLabel::pedestrian) s.role = CandidateRole::part;
  ObjectModel model = train_roles(samples);
  const std::string roles = role_trees_text(model.trees);
  ObjectTrainingParams params;
  params.classes = ClassMethod::trees;
  train_classes(samples, params, model);
  EXPECT_EQ(role_trees_text(model.trees), roles);
  EXPECT_EQ(model.classes, (std::vector{PointLabel::car, PointLabel::lamppost}));
}

// One class of objects is left, so there is no machine.
TEST(ObjectModel, RolesAreSeparated) {
  auto samples = samples_of(60, 10);
  for (TrainingSample& s : samples) {  // the second class: parts; the third: several
    if (s.label == PointLabel::lamppost) s.role = CandidateRole::part;
    if (s.label == PointLabel::pedestrian) s.role = CandidateRole::merged;
  }
  const ObjectModel model = parse_object_model(object_model_text(train_object_model(samples)), "test");
  EXPECT_TRUE(model.vectors.empty());
  for (const TrainingSample& s : samples) {
    const CandidateClass c = classify_candidate(model, s.features);
    EXPECT_EQ(c.label, PointLabel::car);  // nothing else is whole
    EXPECT_GT(c.probability, 0.9);
    EXPECT_EQ(c.whole > 0.5, s.role == CandidateRole::whole);
    EXPECT_EQ(c.part > 0.5, s.role == CandidateRole::part);
    EXPECT_EQ(c.merged > 0.5, s.role == CandidateRole::merged);
  }
}

TEST(ObjectModel, WhatGrowsAndWhatIsNothingAreNoObjects) {
  auto samples = samples_of(60, 11);
  for (TrainingSample& s : samples) {
    if (s.label == PointLabel::lamppost) s.label = PointLabel::vegetation;
    if (s.label == PointLabel::pedestrian) s.label = PointLabel::none;
  }
  samples[0].role = CandidateRole::part;
  const ObjectModel model = train_object_model(samples);
  EXPECT_EQ(model.classes, std::vector{PointLabel::car});
  for (std::size_t i = 3; i < samples.size(); ++i)
    EXPECT_EQ(classify_candidate(model, samples[i].features).label, samples[i].label);
}

// A rare class is as scattered as lampposts are; what is common is alike.
TEST(ObjectModel, RareAndScatteredSamplesAreNoOutliers) {
  const auto drawn = [](std::uint64_t seed) {
    Rng rng(seed, 2);
    std::vector<TrainingSample> samples;
    for (std::uint32_t i = 0; i < 1200; ++i) {
      const bool rare = i % 40 == 0;
      TrainingSample s;
      s.features[static_cast<std::size_t>(ComponentFeature::mean_height)] =
          rare ? 4 + 8 * rng.uniform() : 1 + 0.2 * rng.uniform();
      s.features[static_cast<std::size_t>(ComponentFeature::area)] = rare ? 4 * rng.uniform() : 1 + 0.2 * rng.uniform();
      s.label = rare ? PointLabel::lamppost : PointLabel::pedestrian;
      s.group = i / 40;
      samples.push_back(s);
    }
    return samples;
  };
  const ObjectModel model = train_object_model(drawn(1));
  std::size_t strange = 0;
  for (const TrainingSample& s : drawn(2)) {
    if (s.label != PointLabel::lamppost) continue;
    strange += classify_candidate(model, s.features).label == PointLabel::other;
  }
  EXPECT_EQ(strange, 0u);
}

TEST(ObjectModel, ThreadsDoNotShow) {
  const auto samples = samples_of(15, 6);
  std::string first;
  for (const int threads : {1, 3})
    with_threads(threads, [&] {
      const std::string text = object_model_text(train_object_model(samples));
      if (first.empty()) first = text;
      EXPECT_EQ(text, first);
    });
}

TEST(ObjectModel, WhatIsLikeNothingIsOther) {
  const ObjectModel model = train_object_model(samples_of(20, 7));
  CandidateFeatures strange{};
  strange.fill(1e6);
  const CandidateClass c = classify_candidate(model, strange);
  EXPECT_EQ(c.label, PointLabel::other);
  EXPECT_DOUBLE_EQ(c.probability, 1.0 / 3);
}

TEST(ObjectModel, TooLittleToLearnFrom) {
  auto samples = samples_of(4, 8);
  for (TrainingSample& s : samples) s.label = PointLabel::car;
  EXPECT_THROW(train_object_model(samples), Error);
  samples[0].label = PointLabel::other;
  EXPECT_THROW(train_object_model(samples), Error);
  EXPECT_THROW(train_object_model({}), Error);
}

TEST(ObjectModel, BrokenTextsAreRefusedWithTheirLine) {
  const std::string text = object_model_text(train_object_model(samples_of(10, 9)));
  EXPECT_THROW(parse_object_model("", "m"), Error);
  EXPECT_THROW(parse_object_model("something else\n", "m"), Error);
  for (std::size_t cut = 0; cut < text.size(); cut += 97) {
    try {
      parse_object_model(text.substr(0, cut), "m");
    } catch (const Error& e) {
      EXPECT_TRUE(std::string(e.what()).starts_with("m:")) << e.what();
    }
  }
  std::string wrong = text;
  wrong.replace(wrong.find(" car\n"), 4, " cat");
  EXPECT_THROW(parse_object_model(wrong, "m"), Error);
}

TEST(ObjectModel, TheLibrarysHaveTheirRecipes) {
  for (const ObjectModel* model : {&default_object_model(), &air_object_model()}) {
    EXPECT_FALSE(model->recipe.empty());
    for (const PointLabel label : {PointLabel::car, PointLabel::lamppost, PointLabel::pedestrian, PointLabel::other})
      EXPECT_EQ(std::count(model->classes.begin(), model->classes.end(), label), 1);
    EXPECT_EQ(model->classes.size(), 13u);
    EXPECT_FALSE(model->trees.empty());
  }
}

}  // namespace
}  // namespace ilot
