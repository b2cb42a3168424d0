// SPDX-License-Identifier: Apache-2.0
#include "study/street_models.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "engine/model/point_label.h"
#include "engine/products/streets/classes/object_model_functions.h"
#include "engine/products/streets/objects/object_selection.h"
#include "engine/whole_file.h"
#include "training/object_model_training.h"
#include "training/pair_sigmoid.h"

namespace ilot {

ObjectModel read_model(const std::filesystem::path& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return parse_object_model(text.str(), path.string());
}

std::vector<CandidateClass> classes_of(const Street& street, const ObjectModel& model) {
  std::vector<CandidateFeatures> features;
  std::vector<CandidateParts> parts;
  for (const TrainingSample& s : street.samples) features.push_back(s.features), parts.push_back(s.parts);
  return classify_candidates(model, features, parts);
}

void learn_stated(std::span<const Street> streets, std::span<const TrainingSample> samples, const HeldOut& from,
                  const std::filesystem::path& path) {
  ObjectModel model = read_model(path);
  if (from.weights) learn_weights(samples, model);
  model.stated = {};
  std::vector<double> odds;
  std::vector<std::uint8_t> right;
  for (const Street& street : streets) {
    const std::vector<CandidateClass> classes = classes_of(street, model);
    const std::vector<std::uint8_t> taken = select_objects(street.candidates, classes);
    for (std::size_t i = 0; i < taken.size(); ++i) {
      if (taken[i] == 0 || !is_street_object(classes[i].label)) continue;
      odds.push_back(log_odds(classes[i].probability));
      right.push_back(street.object[i] != 0 && street.classes.at(street.object[i]) == classes[i].label);
    }
  }
  const Sigmoid fitted = fit_sigmoid(odds, right);
  model.stated = {fitted.a, fitted.b};
  model.recipe += "study_streets";
  for (const std::string& cloud : from.clouds) model.recipe += " " + std::filesystem::path(cloud).filename().string();
  model.recipe += fmt::format("{} --stated {}\n{} objects\n", from.weights ? " --weights" : "",
                              path.filename().string(), odds.size());
  write_whole_file(path, object_model_text(model));
  fmt::print("\n{}: probabilities of {} objects: slope {:.3f}, offset {:.3f}\n", path.string(), odds.size(), fitted.a,
             fitted.b);
}

}  // namespace ilot
