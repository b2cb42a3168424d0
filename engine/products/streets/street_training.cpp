// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/street_training.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "engine/deliverables/tables/training_places.h"
#include "engine/error.h"
#include "engine/model/point_label.h"
#include "engine/products/streets/street_places.h"

namespace ilot {
namespace {

constexpr std::string_view kOldModel = "ilot things 2";  // the first words of a model of version 2
// Choice: a house front; what is nearer to each other looks alike and must not be in two folds.
constexpr double kGroupMetres = 25;  // side of a square in metres; candidates in one square are always in the same fold

// Choice: as many as the training itself has.
constexpr std::uint32_t kFolds = 5;  // of the cross-validation in the record

struct Learnt {
  std::vector<TrainingSample> samples;
  OwnClasses own;  // names of the classes of samples that are one's own
  std::size_t places = 0, outside = 0;
  Vec3 first_outside;
};

PointLabel label_of(const std::string& name, const OwnClasses& own) {
  if (name == "none") return PointLabel::none;
  if (const auto known = label_named(name)) return *known;
  return own_class(static_cast<std::size_t>(std::lower_bound(own.begin(), own.end(), name) - own.begin()));
}

// The names that are none of ours.
OwnClasses own_classes(const std::vector<TrainingPlace>& places, const std::filesystem::path& path) {
  std::set<std::string> names;
  for (const TrainingPlace& p : places) names.insert(p.name);
  names.erase("none");
  for (const auto& entry : point_label_names()) names.erase(entry.second);
  if (names.size() > kMostOwnClasses)
    throw Error(fmt::format("{}: there are {} classes of one's own, and {} at most can be learnt", path.string(),
                            names.size(), kMostOwnClasses),
                ExitCode::usage);
  return {names.begin(), names.end()};
}

Learnt samples_of(const FoundStreet& street, const std::vector<TrainingPlace>& places, OwnClasses own) {
  const std::vector<ObjectCandidate>& candidates = street.candidates;
  Learnt learnt;
  learnt.places = places.size();
  learnt.own = std::move(own);
  std::vector<std::uint32_t> held(candidates.size() + 1, 0), place_of(candidates.size() + 1, 0);
  for (std::size_t p = 0; p < places.size(); ++p) {
    const std::uint32_t part = part_at(street, places[p].at);
    if (part == 0) {
      if (learnt.outside++ == 0) learnt.first_outside = places[p].at;
      continue;
    }
    ++held[part];
    place_of[part] = static_cast<std::uint32_t>(p + 1);
  }
  std::vector<std::uint32_t> joined_by(candidates.size() + 1, 0);
  for (std::uint32_t i = 1; i <= candidates.size(); ++i) {
    for (const std::uint32_t part : candidates[i - 1].parts) {
      if (part == 0) continue;
      held[i] += held[part];
      joined_by[part] = i;
      if (place_of[part] != 0) place_of[i] = place_of[part];
    }
  }
  const TileRaster& raster = street.tiles->raster();
  std::map<std::pair<std::int64_t, std::int64_t>, std::uint32_t> groups;
  for (std::uint32_t i = 1; i <= candidates.size(); ++i) {
    if (held[i] == 0) continue;
    const bool largest = held[i] == 1 && (joined_by[i] == 0 || held[joined_by[i]] > 1);
    const double pixels = kGroupMetres / raster.scale.pixel;
    const auto cell = [&](double v) { return static_cast<std::int64_t>(std::floor(v / pixels)); };
    const std::pair key{cell(candidates[i - 1].y), cell(candidates[i - 1].x)};
    const std::uint32_t group = groups.try_emplace(key, static_cast<std::uint32_t>(groups.size())).first->second;
    if (largest)
      learnt.samples.push_back({candidates[i - 1].features, label_of(places[place_of[i] - 1].name, learnt.own), group});
  }
  return learnt;
}

// Keeps the classes of one's own that have samples, so that a model that is read again numbers them alike.
void keep_used(Learnt& learnt) {
  OwnClasses used;
  std::map<PointLabel, PointLabel> numbers;
  for (std::size_t i = 0; i < learnt.own.size(); ++i) {
    const auto is = [&](const TrainingSample& s) { return s.label == own_class(i); };
    if (std::none_of(learnt.samples.begin(), learnt.samples.end(), is)) continue;
    numbers[own_class(i)] = own_class(used.size());
    used.push_back(learnt.own[i]);
  }
  for (TrainingSample& s : learnt.samples)
    if (is_own_class(s.label)) s.label = numbers.at(s.label);
  learnt.own = std::move(used);
}

// A class with a single sample cannot be learnt. Returns the names of those that were left out.
std::vector<std::string> leave_out_single(Learnt& learnt) {
  std::map<PointLabel, std::size_t> counts;
  for (const TrainingSample& s : learnt.samples) ++counts[s.label];
  std::erase_if(learnt.samples, [&](const TrainingSample& s) { return counts[s.label] == 1; });
  std::vector<std::string> names;
  for (const auto& [label, count] : counts)
    if (count == 1) names.push_back(class_name_of(label, learnt.own));
  keep_used(learnt);
  return names;
}

// The samples of one fold, and those of the others.
struct Fold {
  std::vector<TrainingSample> others, own;
};

Fold fold_of(const std::vector<TrainingSample>& samples, std::uint32_t fold, bool by_group) {
  Fold out;
  for (std::size_t i = 0; i < samples.size(); ++i)
    ((by_group ? samples[i].group : i) % kFolds == fold ? out.own : out.others).push_back(samples[i]);
  return out;
}

// The classes of the samples, and how many samples get theirs from a model that was trained on the other folds, all
// steps of the training included. A fold without which nothing can be trained is not judged.
std::vector<TrainedClass> cross_validated(const Learnt& learnt, const TrainObjectModel& train) {
  std::map<PointLabel, TrainedClass> classes;
  std::set<std::uint32_t> groups;
  for (const TrainingSample& s : learnt.samples) {
    TrainedClass& c = classes[s.label];
    c.name = class_name_of(s.label, learnt.own), c.label = static_cast<std::uint32_t>(s.label);
    ++c.samples;
    groups.insert(s.group);
  }
  for (std::uint32_t f = 0; f < kFolds; ++f) {
    const Fold fold = fold_of(learnt.samples, f, groups.size() >= kFolds);
    if (fold.own.empty()) continue;
    std::vector<CandidateFeatures> features;
    for (const TrainingSample& s : fold.own) features.push_back(s.features);
    std::vector<CandidateClass> found;
    try {
      found = classify_candidates(train(fold.others), features);
    } catch (const Error&) {
      continue;  // the others have too few samples of a class
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
      TrainedClass& c = classes[fold.own[i].label];
      ++c.judged, c.right += found[i].label == fold.own[i].label;
    }
  }
  std::vector<TrainedClass> out;
  for (auto& [label, c] : classes) out.push_back(std::move(c));
  return out;
}

std::string recipe_of(const std::vector<TrainedClass>& classes) {
  std::uint64_t samples = 0, judged = 0, right = 0;
  std::string lines;
  for (const TrainedClass& c : classes) {
    samples += c.samples, judged += c.judged, right += c.right;
    lines += fmt::format("{}: {}, {} of {} right by the other folds\n", c.name, c.samples, c.right, c.judged);
  }
  return fmt::format("trained by ilot run --train on {} objects, {} of {} right by the other folds\n", samples, right,
                     judged) +
         lines;
}

ObjectModel learn(const FoundStreet& street, const StreetTraining& train, const Crs& crs, Progress& progress,
                  RunRecord& record) {
  const std::vector<TrainingPlace> places = read_training_places(train.places, crs);
  Learnt learnt = samples_of(street, places, own_classes(places, train.places));
  if (learnt.samples.empty())
    throw Error(fmt::format("{}: none of its {} places is on anything that stands on the ground of this cloud",
                            train.places.string(), learnt.places),
                ExitCode::usage);
  const auto add_warning = [&](const std::string& sentence) {
    progress.warn(sentence);
    record.warnings.push_back(sentence);
  };
  if (learnt.outside > 0)
    add_warning(fmt::format(
        "{}: {} of its {} places are on nothing that stands on the ground of this cloud, the first at "
        "{:.2f}, {:.2f}",
        train.places.string(), learnt.outside, learnt.places, learnt.first_outside.x, learnt.first_outside.y));
  if (const auto single = leave_out_single(learnt); !single.empty())
    add_warning(fmt::format("{}: one object alone is too little to learn from: {} is left out", train.places.string(),
                            fmt::join(single, ", ")));
  std::map<PointLabel, std::size_t> counts;
  for (const TrainingSample& s : learnt.samples) ++counts[s.label];
  std::vector<std::string> missing;
  for (const auto& entry : point_label_names())
    if (const auto label = static_cast<PointLabel>(entry.first);
        is_street_object(label) && learnt.own.empty() && counts.count(label) == 0)
      missing.push_back(class_name_of(label, {}));
  if (!missing.empty())
    add_warning(fmt::format("{}: contains no {}, so nothing will be called that", train.places.string(),
                            fmt::join(missing, ", ")));
  ObjectModel model = train.learn(learnt.samples);
  model.own = learnt.own;
  record.training = cross_validated(learnt, train.learn);
  model.recipe = recipe_of(record.training);
  return model;
}

bool is_model(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string first;
  std::getline(file, first);
  return first.starts_with("ilot objects") || first.starts_with(kOldModel);
}

// Converts a model that version 2 wrote to the words of version 3.
std::string in_new_words(std::string text) {
  text.replace(0, kOldModel.size(), "ilot objects 3");
  constexpr std::string_view kOldWord = ": several";
  for (std::size_t at = text.find(kOldWord); at != std::string::npos; at = text.find(kOldWord, at))
    text.replace(at, kOldWord.size(), ": merged");
  return text;
}

ObjectModel read_model(const std::filesystem::path& path, Progress& progress, RunRecord& record) {
  std::stringstream file;
  file << std::ifstream(path).rdbuf();
  std::string text = file.str();
  if (text.starts_with(kOldModel)) {
    text = in_new_words(std::move(text));
    record.warnings.push_back(path.string() +
                              ": a model of version 2, which the next version of ilot will not read; train it anew");
    progress.warn(record.warnings.back());
  }
  return parse_object_model(text, path.string());
}

}  // namespace

std::vector<CandidateClass> StreetClasses::of(const std::vector<ObjectCandidate>& candidates) const {
  std::vector<CandidateFeatures> features;
  std::vector<CandidateParts> parts;
  for (const ObjectCandidate& t : candidates) features.push_back(t.features), parts.push_back({t.parts[0], t.parts[1]});
  std::vector<CandidateClass> predicted = classify_candidates(*base, features, parts);
  if (!trained) return predicted;
  const std::vector<CandidateClass> learnt = classify_candidates(*trained, features);
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    if (!is_street_object(predicted[i].label)) continue;
    predicted[i].label = learnt[i].label;
    predicted[i].probability *= learnt[i].probability;
  }
  return predicted;
}

const ObjectModel& library_model(StreetView view) {
  return view == StreetView::air ? air_object_model() : default_object_model();
}

StreetClasses street_classes(const FoundStreet& street, const StreetTraining& train, const Crs& crs, Progress& progress,
                             RunRecord& record) {
  StreetClasses classes{&library_model(street.view)};
  if (train.places.empty()) return classes;
  if (is_model(train.places)) {
    classes.trained = read_model(train.places, progress, record);
  } else {
    if (!train.learn)
      throw Error(train.places.string() + ": this program reads models of objects, and learns none", ExitCode::usage);
    classes.trained = learn(street, train, crs, progress, record);
  }
  return classes;
}

}  // namespace ilot
