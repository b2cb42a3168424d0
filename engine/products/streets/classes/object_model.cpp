// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/classes/object_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "engine/error.h"
#include "engine/model/point_label.h"
#include "engine/products/streets/classes/class_shares.h"
#include "engine/products/streets/classes/object_model_functions.h"
#include "engine/products/streets/classes/role_trees_text.h"

namespace ilot {
namespace {

constexpr const char* kFirstLine = "ilot objects 3";
// Choice: no class is excluded by one answer; smaller bounds let one tree decide.
constexpr double kLeastShare = 1e-4;  // lower bound of a probability

// Reads a model line by line. Each line is a keyword and its values.
class ModelReader {
 public:
  ModelReader(std::string_view text, const std::string& name) : text_(std::string(text)), name_(name) {}

  ObjectModel read() {
    std::string line;
    next(line);
    if (line != kFirstLine) fail("is no model of objects: its first line is not '" + std::string(kFirstLine) + "'");
    while (next(line)) take(line);
    check();
    return model_;
  }

 private:
  bool next(std::string& line) {
    ++number_;
    return static_cast<bool>(std::getline(text_, line));
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw Error(name_ + ":" + std::to_string(number_) + ": " + what, ExitCode::usage);
  }

  void take(const std::string& line) {
    if (line.empty()) return;
    if (line[0] == '#') {
      model_.recipe += line.substr(line.size() > 1 && line[1] == ' ' ? 2 : 1) + "\n";
      return;
    }
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "feature") return take_feature(words);
    if (word == "class") return take_class(words);
    if (word == "kernel") {
      const auto v = numbers(words, 2);
      model_.cost = v[0], model_.gamma = v[1];
      return;
    }
    if (word == "pair") {
      const auto v = numbers(words, 3);
      model_.rho.push_back(v[0]), model_.slope.push_back(v[1]), model_.offset.push_back(v[2]);
      return;
    }
    if (word == "roles") {
      const auto v = numbers(words, 2 * kCandidateStates);
      std::copy_n(v.begin(), kCandidateStates, model_.roles.power.begin());
      std::copy_n(v.begin() + kCandidateStates, kCandidateStates, model_.roles.bias.begin());
      return;
    }
    if (word == "stated") {
      const auto v = numbers(words, 2);
      model_.stated = {v[0], v[1]};
      return;
    }
    if (TreesReader::knows(word)) {
      if (const std::string wrong = trees_.take(line, model_.classes.size()); !wrong.empty()) fail(wrong);
      return;
    }
    if (word != "vector" && word != "sample") fail("'" + word + "' is not known");
    take_vector(words, word == "vector" ? model_.classes.size() - 1 : 0);
  }

  void take_vector(std::istringstream& words, std::size_t weight_count) {
    const auto v = numbers(words, 1 + weight_count + model_.features.size());
    if (v[0] < 0 || v[0] >= static_cast<double>(model_.classes.size())) fail("there is no such class");
    const auto weights = v.begin() + static_cast<std::ptrdiff_t>(1 + weight_count);
    model_.class_of_vector.push_back(static_cast<std::uint32_t>(v[0]));
    if (weight_count > 0) model_.weights.emplace_back(v.begin() + 1, weights);
    model_.vectors.emplace_back(weights, v.end());
  }

  void take_feature(std::istringstream& words) {
    const auto v = numbers(words, 2);
    std::string name;
    std::getline(words >> std::ws, name);
    for (std::size_t f = 0; f < kCandidateFeatures; ++f) {
      if (name != candidate_feature_name(f)) continue;
      model_.features.push_back(f);
      model_.mean.push_back(v[0]);
      model_.sd.push_back(v[1]);
      if (!(v[1] > 0)) fail("a deviation is not above 0");
      return;
    }
    fail("there is no feature '" + name + "'");
  }

  void take_class(std::istringstream& words) {
    const auto v = numbers(words, 2);
    if (!(v[0] > 0)) fail("a class is never there");
    std::string name;
    std::getline(words >> std::ws, name);
    const PointLabel label = label_of(name);
    if (!model_.classes.empty() && model_.classes.back() >= label) fail("the classes are not in their order");
    model_.classes.push_back(label);
    model_.prior.push_back(v[0]);
    model_.min_similarity.push_back(v[1]);
  }

  // A name that is none of ours is a class of one's own; their labels are numbered in the order of their names.
  PointLabel label_of(const std::string& name) {
    if (name == "none") return PointLabel::none;
    if (const auto known = label_named(name)) return *known;
    if (name.empty()) fail("a class has no name");
    if (!model_.own.empty() && model_.own.back() >= name)
      fail("the classes of one's own are not in the order of their names");
    if (model_.own.size() == kMostOwnClasses) fail("there are too many classes");
    model_.own.push_back(name);
    return own_class(model_.own.size() - 1);
  }

  std::vector<double> numbers(std::istringstream& words, std::size_t count) const {
    std::vector<double> list;
    for (std::size_t i = 0; i < count; ++i) {
      std::string word;
      double value = 0;
      if (!(words >> word) || std::from_chars(word.data(), word.data() + word.size(), value).ec != std::errc())
        fail("fewer than " + std::to_string(count) + " numbers");
      if (!std::isfinite(value)) fail("a number is not finite");
      list.push_back(value);
    }
    return list;
  }

  void check() {
    const std::size_t k = model_.classes.size();
    if (const std::string wrong = trees_.finish(model_.trees, model_.class_trees); !wrong.empty()) fail(wrong);
    if (k == 1 && !model_.trees.empty()) return;
    if (k > 1 && !model_.class_trees.empty()) {
      if (model_.class_trees.trees.classes != k) fail("the trees of the classes are of other classes");
      if (!model_.weights.empty()) fail("there are trees of the classes and a machine");
      return;
    }
    if (k < 2 || model_.features.empty() || model_.vectors.empty()) fail("ends before its vectors");
    if (model_.weights.size() != model_.vectors.size()) fail("a line 'sample' stands in a machine");
    if (model_.rho.size() != k * (k - 1) / 2) fail("there must be a line 'pair' for each two classes");
  }

  std::istringstream text_;
  std::string name_;
  std::size_t number_ = 0;
  ObjectModel model_;
  TreesReader trees_;
};

// The shares of the kinds for a model without trees. All candidates count as whole.
KindShares nature_of(const ObjectModel& model, const std::vector<double>& share) {
  KindShares out{};
  for (std::size_t c = 0; c < share.size(); ++c) {
    const PointLabel label = model.classes[c];
    const CandidateKind kind = is_street_object(label)     ? CandidateKind::object
                               : label == PointLabel::none ? CandidateKind::nothing
                                                           : CandidateKind::vegetation;
    out[static_cast<std::size_t>(kind)] += share[c];
  }
  return out;
}

// The most probable class among the objects or among the others, its share within that group, and whether the candidate
// is similar enough to it.
struct MostProbable {
  PointLabel label = PointLabel::none;
  double share = 0;
  bool is_similar = true;
  PointLabel next = PointLabel::other;  // the most probable of another group
  double next_share = 0;
};
MostProbable most_probable(const ObjectModel& model, const ClassShares& shares, bool object) {
  MostProbable best{object ? PointLabel::other : PointLabel::none};
  double all = 0;
  for (std::size_t c = 0; c < shares.share.size(); ++c) {
    if (is_street_object(model.classes[c]) != object) continue;
    all += shares.share[c];
    if (shares.share[c] > best.share)
      best = {model.classes[c], shares.share[c], shares.nearest[c] >= model.min_similarity[c]};
  }
  for (std::size_t c = 0; object && c < shares.share.size(); ++c)
    if (is_street_object(model.classes[c]) && group_of(model.classes[c]) != group_of(best.label) &&
        shares.share[c] > best.next_share)
      best.next = model.classes[c], best.next_share = shares.share[c];
  if (all > 0) best.share /= all, best.next_share /= all;
  return best;
}

double share_of(const KindShares& kind, CandidateKind n) {
  return kind[static_cast<std::size_t>(n)];
}

// The weights of the roles, and vegetation or nothing as the class of what is no object: the most probable of the two.
CandidateClass role_of(const ObjectModel& model, const KindShares& kind) {
  const auto logs = state_logs(kind);
  std::array<double, kCandidateStates> log, weight;
  for (std::size_t s = 0; s < kCandidateStates; ++s) {
    log[s] = model.roles.power[s] * logs[s] + model.roles.bias[s];
    weight[s] = natural_exp(log[s]);
  }
  const auto [object, rest, part, merged] = weight;
  const double vegetation = share_of(kind, CandidateKind::vegetation), nothing = share_of(kind, CandidateKind::nothing),
               all = share_of(kind, CandidateKind::object) + vegetation + nothing;
  CandidateClass out{PointLabel::none, 0, std::max(object, rest), part, merged, log[0] - log[1]};
  if (vegetation > nothing) out.label = PointLabel::vegetation;
  out.probability = all > 0 ? std::max(vegetation, nothing) / all : 0;
  return out;
}

// Most models state what their trees give.
double stated_probability(const StatedOdds& stated, double p) {
  if (stated.slope == -1 && stated.offset == 0) return p;
  return sigmoid(stated.slope * log_odds(p) + stated.offset);
}

bool is_object(const CandidateClass& role, const KindShares& kind) {
  return share_of(kind, CandidateKind::object) > 0 && role.object >= 0;
}

// Sets the class of an object, or of any candidate by a model without trees of roles.
void set_class(const ObjectModel& model, const ClassShares& shares, const KindShares& kind, CandidateClass& of) {
  const bool object = is_object(of, kind);
  const auto [label, share, is_similar, next, next_share] = most_probable(model, shares, object);
  const double objects = share_of(kind, CandidateKind::object),
               rest = share_of(kind, CandidateKind::vegetation) + share_of(kind, CandidateKind::nothing);
  const auto probability = [&](double of_class) {
    return objects + rest > 0 ? of_class * (object ? objects : rest) / (objects + rest) : 0;
  };
  of.label = label, of.next = next;
  of.probability = probability(share);
  if (object) {
    of.probability = stated_probability(model.stated, of.probability);
    of.next_probability = stated_probability(model.stated, probability(next_share));
  }
  if (object && !is_similar)
    of.label = PointLabel::other, of.probability = 1 / static_cast<double>(shares.share.size());
}

}  // namespace

std::array<double, kCandidateStates> state_logs(const KindShares& shares) {
  const auto [nothing, vegetation, part, merged, object] = shares;
  const double rest = nothing + vegetation;
  std::array<double, kCandidateStates> out{object, rest, part + rest, merged + rest};
  for (double& v : out) v = natural_log(std::max(kLeastShare, v));
  return out;
}

std::vector<PointLabel> most_probable_classes(const ObjectModel& model, std::span<const CandidateFeatures> candidates) {
  std::vector<PointLabel> out;
  for (const auto& [share, nearest] : class_shares(model, candidates))
    out.push_back(
        model.classes[static_cast<std::size_t>(std::max_element(share.begin(), share.end()) - share.begin())]);
  return out;
}

std::vector<CandidateClass> classify_candidates(const ObjectModel& model, std::span<const CandidateFeatures> candidates,
                                                std::span<const CandidateParts> parts) {
  std::vector<CandidateClass> out;
  if (model.trees.empty()) {
    for (const ClassShares& shares : class_shares(model, candidates)) {
      const KindShares kind = nature_of(model, shares.share);
      out.push_back(role_of(model, kind));
      set_class(model, shares, kind, out.back());
    }
    return out;
  }
  const std::vector<CandidateParts> apart(parts.empty() ? candidates.size() : 0, CandidateParts{});
  const std::vector<KindShares> kinds = kind_shares(model.trees, candidates, parts.empty() ? apart : parts);
  std::vector<CandidateFeatures> objects;  // the classes of the others are those of their roles
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    out.push_back(role_of(model, kinds[i]));
    if (is_object(out[i], kinds[i])) objects.push_back(candidates[i]), places.push_back(i);
  }
  const std::vector<ClassShares> shares = class_shares(model, objects);
  for (std::size_t i = 0; i < places.size(); ++i) set_class(model, shares[i], kinds[places[i]], out[places[i]]);
  return out;
}

CandidateClass classify_candidate(const ObjectModel& model, const CandidateFeatures& features) {
  return classify_candidates(model, {&features, 1}).front();
}

std::string object_model_text(const ObjectModel& model) {
  std::string text = std::string(kFirstLine) + "\n";
  std::istringstream recipe(model.recipe);
  for (std::string line; std::getline(recipe, line);) text += line.empty() ? "#\n" : "# " + line + "\n";
  for (std::size_t c = 0; c < model.classes.size(); ++c)
    text += fmt::format("class {:.9g} {:.9g} {}\n", model.prior[c], model.min_similarity[c],
                        class_name_of(model.classes[c], model.own));
  for (std::size_t i = 0; i < model.features.size(); ++i)
    text += fmt::format("feature {:.9g} {:.9g} {}\n", model.mean[i], model.sd[i],
                        candidate_feature_name(model.features[i]));
  text += fmt::format("kernel {:.9g} {:.9g}\n", model.cost, model.gamma);
  for (std::size_t p = 0; p < model.rho.size(); ++p)
    text += fmt::format("pair {:.9g} {:.9g} {:.9g}\n", model.rho[p], model.slope[p], model.offset[p]);
  text += "roles";
  for (const auto& list : {model.roles.power, model.roles.bias})
    for (const double v : list) text += fmt::format(" {:.9g}", v);
  text += "\n";
  if (model.stated.slope != -1 || model.stated.offset != 0)
    text += fmt::format("stated {:.9g} {:.9g}\n", model.stated.slope, model.stated.offset);
  for (std::size_t v = 0; v < model.vectors.size(); ++v) {
    text += fmt::format("{} {}", model.weights.empty() ? "sample" : "vector", model.class_of_vector[v]);
    if (!model.weights.empty())
      for (const double w : model.weights[v]) text += fmt::format(" {:.7g}", w);
    for (const double x : model.vectors[v]) text += fmt::format(" {:.5g}", x);
    text += "\n";
  }
  return text + column_trees_text("classes", model.class_trees) + role_trees_text(model.trees);
}

ObjectModel parse_object_model(std::string_view text, const std::string& name) {
  return ModelReader(text, name).read();
}

}  // namespace ilot
