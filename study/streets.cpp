// SPDX-License-Identifier: Apache-2.0
// Finds and classifies the objects on streets [Hernandez and Marcotegui 2008, 5.1 to 5.3] on scenes `street`, and
// compares them with their truth. Prints how many objects are found, which features separate them and in which order,
// and the confusion matrix of a cross-validation by block, with the features of the document and with ours. With
// --model, the classifier that is trained on all data is written. With --shipped, the default model is evaluated on
// streets that it has not seen, with --air that for clouds from the air, with --judge MODEL another one. With --cut H,
// each street is used twice: as it is, and without the points higher than H metres above the road. The classifier
// learns from both, and each kind is evaluated separately. With --roles MODEL, the roles are those of that model, and
// only the classes are learnt; with --classes MODEL the classes are those of a model, and only the roles are learnt,
// without their weights. With --thin N, the classes are also learnt from one point in N of each street, with --bare H
// from each street without its ground and what is higher than H, with --floor N from each street with points of the
// ground below its objects; the roles are not, unless --all-roles is given. With --in-turn, each street is used as it
// is and in one of these ways in turn. Where there are many streets, the folds of the training keep each of them
// together. With --stated MODEL, that model learns what probabilities it states from the streets, which it must not
// have been trained with, and is written again; with --weights it learns the weights of the roles from them too. With
// --later-weights the training leaves these weights to that call; they are nearly half of the work of the trees.
//
// Usage: study_streets STREET.laz... [--cut H] [--bare H] [--thin N]... [--floor N] [--all-roles] [--in-turn] [--air]
//        [--cache FOLDER] [--model FILE] [--roles MODEL] [--classes MODEL] [--judge MODEL] [--stated MODEL] [--weights]
//        [--later-weights] [--only-model | --everything | --shipped]
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "engine/model/point_label.h"
#include "engine/pass/resident.h"
#include "engine/products/streets/objects/object_selection.h"
#include "engine/whole_file.h"
#include "kernels/core/parallel.h"
#include "kernels/core/portable_math.h"
#include "study/confusion.h"
#include "study/pooled_samples.h"
#include "study/stated.h"
#include "study/street_models.h"
#include "study/street_samples.h"
#include "training/object_model_training.h"

namespace {

using namespace ilot;
namespace fs = std::filesystem;

// Choice: each fold takes as long as a training of its own; more than two were not compared with two.
constexpr std::uint32_t kFoldsOfMany = 2;

struct Arguments {
  std::vector<std::string> clouds;
  fs::path cache, model, roles, classes, judged, stated;
  double cut = 0;
  std::vector<Leaving> others;  // the classes are also learnt from them
  bool evaluate = true, four_classes = true, shipped = false, air = false, all_roles = false, in_turn = false,
       weights = false, later_weights = false;
};

// Returns for each object that was found the object candidate that overlaps it best, with one of the four classes of
// the document.
std::vector<TrainingSample> objects_of(const Street& street) {
  std::vector<TrainingSample> out;
  for (const auto& [object, i] : best_samples(street)) {
    out.push_back(street.samples[i]);
    out.back().label = group_of(out.back().label);
    out.back().parts = {};
  }
  return out;
}

void print_ranking(const std::vector<TrainingSample>& samples, const ObjectTrainingParams& params) {
  fmt::print("  features:");
  for (const std::size_t f : selected_features(samples, params)) fmt::print(" {},", candidate_feature_name(f));
  fmt::print("\n");
}

// Evaluates the result that a run would give: the candidates that are whole, by class. All objects with points on them
// count.
void evaluate_selection(const Street& street, const std::vector<CandidateClass>& classes, Confusion& all,
                        RunShares& shares, StatedOf& stated) {
  const std::vector<std::uint8_t> taken = select_objects(street.candidates, classes);
  Confusion m, judged;
  std::map<std::string, std::uint64_t> detected;
  std::uint64_t wrong = 0, right = 0, objects = 0;
  for (std::size_t i = 0; i < taken.size(); ++i) {
    if (taken[i] == 0 || !is_street_object(classes[i].label)) continue;
    const bool named = street.object[i] != 0 && street.classes.at(street.object[i]) == classes[i].label;
    for (const std::string& of : {std::string("all"), name_of(classes[i].label)})
      stated[of].add(classes[i].probability, named);
    if (street.object[i] == 0) {
      ++wrong;
      ++m[is_street_object(street.samples[i].label) ? PointLabel::none : street.samples[i].label][classes[i].label];
      continue;
    }
    const PointLabel truth = street.classes.at(street.object[i]);
    ++m[truth][classes[i].label];
    ++judged[truth][classes[i].label];
    ++detected[name_of(truth)];
    ++right;
  }
  note_shares(judged, shares);
  for (const auto& [name, n] : street.objects) {
    m[label_of(name)][PointLabel::none] += n - detected[name];
    objects += n;
  }
  add(m, all);
  const auto percent = [](std::uint64_t part, std::uint64_t of) {
    return 100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::uint64_t>(1, of));
  };
  shares["recall"].push_back(percent(right, objects));
  shares["false"].push_back(percent(wrong, wrong + right));
}

// The same with objects weighted more or less: counts of the objects found, and of the false ones among them.
struct Found {
  std::uint64_t right = 0, wrong = 0;
};
Found found_at(const Street& street, std::vector<CandidateClass> classes, double more) {
  for (CandidateClass& c : classes) {
    const double most = std::max(c.object, 0.0), most_now = std::max(c.object + more, 0.0);
    c.whole *= natural_exp(most_now - most);
    c.object += more;
  }
  const std::vector<std::uint8_t> taken = select_objects(street.candidates, classes);
  Found out;
  for (std::size_t i = 0; i < taken.size(); ++i)
    if (taken[i] != 0 && classes[i].object >= 0) ++(street.object[i] != 0 ? out.right : out.wrong);
  return out;
}

void print_trade(const std::vector<Street>& streets, const std::vector<std::vector<CandidateClass>>& classes) {
  std::uint64_t objects = 0;
  for (const Street& street : streets)
    for (const auto& [name, n] : street.objects) objects += n;
  fmt::print("  objects weighed exp(w) times: w, found of {}, false\n", objects);
  for (const double more : {-2.0, -1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5, 2.0}) {
    Found all;
    for (std::size_t s = 0; s < streets.size(); ++s) {
      const Found own = found_at(streets[s], classes[s], more);
      all.right += own.right, all.wrong += own.wrong;
    }
    fmt::print(
        "  {:5.1f} {:6.2f} % {:6.2f} %\n", more,
        100 * static_cast<double>(all.right) / static_cast<double>(std::max<std::uint64_t>(1, objects)),
        100 * static_cast<double>(all.wrong) / static_cast<double>(std::max<std::uint64_t>(1, all.right + all.wrong)));
  }
}

Confusion confusion_of(const std::vector<TrainingSample>& samples, const std::vector<CandidateClass>& given) {
  Confusion m;
  for (std::size_t i = 0; i < samples.size(); ++i) ++m[samples[i].label][given[i].label];
  return m;
}

// Prints the figures of streets of one kind and resets them.
void print_kind(Confusion& all, RunShares& shares, StatedOf& stated, const std::string& kind) {
  fmt::print("  streets {}:\n", kind);
  print_confusion(all);
  print_intervals(shares);
  for (const auto& [of, bins] : stated) print_stated(of, bins);
  all.clear();
  shares.clear();
  stated.clear();
}

// One cross-validation over the blocks of all streets. It evaluates either what the document does, with 4 classes of
// the found objects, or what a run would give.
enum class Judged : std::uint8_t { objects, everything };

void evaluate(const std::vector<Street>& streets, std::size_t different, const char* title,
              const ObjectTrainingParams& params, Judged judged) {
  fmt::print("\n{}\n", title);
  std::vector<std::vector<TrainingSample>> samples;
  for (const Street& street : streets)
    samples.push_back(judged == Judged::objects ? objects_of(street) : street.samples);
  const std::vector<TrainingSample> all_samples = pooled(samples, different);
  print_ranking(all_samples, params);
  const std::vector<CandidateClass> given = cross_validate(all_samples, params);
  RunShares shares;
  Confusion all;
  StatedOf stated;
  std::vector<std::vector<CandidateClass>> by_street;
  auto first = given.begin();
  for (std::size_t s = 0; s < streets.size(); ++s) {
    if (s == different) print_kind(all, shares, stated, "as they are");
    const std::vector<CandidateClass> own(first, first + static_cast<std::ptrdiff_t>(samples[s].size()));
    first += static_cast<std::ptrdiff_t>(samples[s].size());
    by_street.push_back(own);
    if (judged == Judged::everything) {
      evaluate_selection(streets[s], own, all, shares, stated);
      continue;
    }
    const Confusion m = confusion_of(samples[s], own);
    note_shares(m, shares);
    add(m, all);
  }
  print_kind(all, shares, stated, streets.size() > different ? "cut" : "as they are");
  if (judged == Judged::everything) print_trade(streets, by_street);
}

// Evaluates the result of a run with a model. Of the streets each `different` are of one kind, which `kinds` names.
void evaluate_model(const std::vector<Street>& streets, std::size_t different, const std::vector<std::string>& kinds,
                    const ObjectModel& model) {
  fmt::print("\neverything found, by a model\n");
  RunShares shares;
  Confusion all;
  StatedOf stated;
  std::vector<std::vector<CandidateClass>> by_street;
  for (const Street& street : streets) {
    by_street.push_back(classes_of(street, model));
    evaluate_selection(street, by_street.back(), all, shares, stated);
    if (by_street.size() % different == 0) print_kind(all, shares, stated, kinds[by_street.size() / different - 1]);
  }
  print_trade(streets, by_street);
}

// How the model was trained, so that it can be trained again.
std::string recipe_of(const Arguments& a, std::size_t samples) {
  std::string text = "study_streets";
  for (const std::string& c : a.clouds) text += " " + fs::path(c).filename().string();
  if (a.cut > 0) text += fmt::format(" --cut {}", a.cut);
  for (const Leaving& leaving : a.others) text += leaving.option();
  if (a.in_turn) text += " --in-turn";
  if (a.all_roles) text += " --all-roles";
  if (a.later_weights) text += " --later-weights";
  if (!a.roles.empty()) text += " --roles " + a.roles.filename().string();
  if (!a.classes.empty()) text += " --classes " + a.classes.filename().string();
  text += " --only-model --model " + a.model.filename().string() + "\n";
  return text + (a.clouds.size() >= kManyStreets
                     ? fmt::format("{} objects; {} folds by street\n", samples, kFoldsOfMany)
                     : fmt::format("{} objects; {} folds by block\n", samples, ObjectTrainingParams{}.folds));
}

// The roles of `a.roles`, or those that are learnt from the streets, with --all-roles also from the others; the classes
// are learnt from all.
void write_model(std::vector<Street> streets, std::vector<Street> others, const Arguments& a) {
  const std::vector<TrainingSample> all = samples_of(streets, others, a.clouds.size());
  const std::vector<TrainingSample> only_whole =
      a.all_roles ? std::vector<TrainingSample>{} : samples_of(streets, {}, a.clouds.size());
  streets = {}, others = {};  // thousands of streets take as much memory as the samples
  trim_memory();
  const auto came_from = [](const char* what, const fs::path& path, const ObjectModel& model) {
    return fmt::format("{} of {}, which came from:\n{}", what, path.filename().string(), model.recipe);
  };
  ObjectModel model;
  std::string others_recipe;
  if (a.roles.empty()) {
    ObjectTrainingParams params;
    params.role_weights = a.classes.empty() && !a.later_weights;
    if (a.clouds.size() >= kManyStreets) params.folds = kFoldsOfMany;
    model = train_roles(a.all_roles ? all : only_whole, params);
  } else {
    model = read_model(a.roles);
    others_recipe = came_from("roles", a.roles, model);
  }
  if (a.classes.empty()) {
    ObjectTrainingParams params;
    params.classes = ClassMethod::trees;
    train_classes(all, params, model);
  } else {
    ObjectModel classes = read_model(a.classes);
    others_recipe += came_from("classes", a.classes, classes);
    classes.trees = std::move(model.trees), classes.roles = model.roles, classes.stated = {};
    model = std::move(classes);
  }
  model.recipe = recipe_of(a, all.size()) + others_recipe;
  write_whole_file(a.model, object_model_text(model));
  fmt::print("\n{}: {} trees of roles, {} of classes\n", a.model.string(),
             model.trees.stages[0].trees.trees() + model.trees.stages[1].trees.trees(),
             model.class_trees.trees.trees());
}

Street street_of(const std::string& cloud, const Leaving& leaving, const fs::path& cache) {
  const std::string kind = leaving.name();
  fmt::print("{}{}\n", cloud, kind);
  const fs::path kept = cache.empty() ? fs::path() : cache / (fs::path(cloud).stem().string() + kind + ".candidates");
  Street street = !kept.empty() && fs::exists(kept) ? load(kept) : study(cloud, leaving);
  if (!kept.empty() && !fs::exists(kept)) {
    save(street, kept);
    street = load(kept);  // without what takes the most memory
  }
  set_roles(street);
  std::map<std::string, std::uint64_t> counts;
  for (const TrainingSample& s : street.samples)
    ++counts[s.role == CandidateRole::whole ? name_of(s.label) : s.role == CandidateRole::part ? "part" : "merged"];
  fmt::print(
      "  ground {:.2f} %; candidates of {} objects;",
      100.0 * static_cast<double>(street.ground_found) / static_cast<double>(std::max<std::uint64_t>(1, street.ground)),
      street.classes.size());
  for (const auto& [name, n] : counts) fmt::print(" {} {},", name, n);
  fmt::print("\n");
  return street;
}

Arguments read_arguments(const std::vector<std::string>& words) {
  Arguments a;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--cache" && i + 1 < words.size())
      a.cache = words[++i];
    else if (words[i] == "--model" && i + 1 < words.size())
      a.model = words[++i];
    else if (words[i] == "--cut" && i + 1 < words.size())
      a.cut = std::stod(words[++i]);
    else if (is_leaving(words[i]) && i + 1 < words.size())
      a.others.push_back(leaving_of(words[i], words[i + 1])), ++i;
    else if (words[i] == "--roles" && i + 1 < words.size())
      a.roles = words[++i];
    else if (words[i] == "--classes" && i + 1 < words.size())
      a.classes = words[++i];
    else if (words[i] == "--weights")
      a.weights = true;
    else if (words[i] == "--later-weights")
      a.later_weights = true;
    else if (words[i] == "--judge" && i + 1 < words.size())
      a.judged = words[++i], a.evaluate = false;
    else if (words[i] == "--stated" && i + 1 < words.size())
      a.stated = words[++i], a.evaluate = false;
    else if (words[i] == "--in-turn")
      a.in_turn = true;
    else if (words[i] == "--all-roles")
      a.all_roles = true;
    else if (words[i] == "--only-model")
      a.evaluate = false;
    else if (words[i] == "--shipped")
      a.shipped = true, a.evaluate = false;
    else if (words[i] == "--air")
      a.air = true;
    else if (words[i] == "--everything")
      a.four_classes = false;
    else
      a.clouds.push_back(words[i]);
  }
  if (a.clouds.empty())
    throw std::runtime_error("usage: study_streets STREET.laz... [--cut H] [--cache FOLDER] [--model FILE]");
  if (a.in_turn && a.cut > 0) a.others.insert(a.others.begin(), {a.cut, 1, false}), a.cut = 0;
  if (a.in_turn && a.others.empty()) throw std::runtime_error("--in-turn needs --cut, --bare, --thin or --floor");
  return a;
}

// The streets with points left out, as many as there are clouds for each way, or for all ways in turn.
std::vector<Street> other_streets(const Arguments& a) {
  std::vector<Street> others;
  for (std::size_t w = 0; w < (a.in_turn ? 1 : a.others.size()); ++w)
    for (std::size_t c = 0; c < a.clouds.size(); ++c)
      others.push_back(street_of(a.clouds[c], a.others[a.in_turn ? c % a.others.size() : w], a.cache));
  return others;
}

void run(const Arguments& a) {
  if (!a.cache.empty()) fs::create_directories(a.cache);
  std::vector<Street> streets;
  for (const std::string& cloud : a.clouds) streets.push_back(street_of(cloud, {}, a.cache));
  const std::vector<Street> whole = a.evaluate ? streets : std::vector<Street>{};
  if (a.cut > 0)
    for (const std::string& cloud : a.clouds) streets.push_back(street_of(cloud, {a.cut, 1, false}, a.cache));
  const std::size_t different = a.clouds.size();
  std::vector<Street> others = other_streets(a);
  if (a.shipped || !a.judged.empty()) {
    std::vector<Street> judged = streets;
    judged.insert(judged.end(), others.begin(), others.end());
    std::vector<std::string> kinds{"as they are"};
    if (a.cut > 0) kinds.emplace_back("cut");
    for (const Leaving& leaving : a.others) kinds.push_back(leaving.option());
    if (a.in_turn) kinds = {"as they are", "with points left out in turn"};
    if (a.shipped) evaluate_model(judged, different, kinds, a.air ? air_object_model() : default_object_model());
    if (!a.judged.empty()) evaluate_model(judged, different, kinds, read_model(a.judged));
  }
  if (a.evaluate) {
    ObjectTrainingParams document;
    document.features = FeatureSet::document;
    fmt::print(
        "\ndocument: mean height, area, max accumulation, s.d. height, mode accumulation, s.d. accumulation;\n"
        "car 91.04, lamppost 100, pedestrian 96.97, other 62.50 %, total error 14.93 %\n");
    if (a.four_classes) {
      evaluate(whole, different, "four classes of what was found, the document's features", document, Judged::objects);
      evaluate(whole, different, "four classes of what was found, all features", {}, Judged::objects);
    }
    evaluate(streets, different, "everything found, all features", {}, Judged::everything);
  }
  if (!a.stated.empty())
    learn_stated(streets, samples_of(streets, {}, a.clouds.size()), {a.clouds, a.weights}, a.stated);
  if (!a.model.empty()) write_model(std::move(streets), std::move(others), a);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Arguments arguments = read_arguments({argv + 1, argv + argc});
    with_threads(hardware_threads(), [&] { run(arguments); });
    return 0;
  } catch (const std::exception& e) {
    fmt::print(stderr, "study_streets: {}\n", e.what());
    return 1;
  }
}
