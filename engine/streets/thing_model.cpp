// SPDX-License-Identifier: Apache-2.0
#include "engine/streets/thing_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "engine/error.h"
#include "engine/streets/thing_decisions.h"
#include "engine/streets/thing_shares.h"

namespace ilot {
namespace {

constexpr const char* kFirstLine = "ilot things 1";
constexpr double kLeastShare = 1e-4;  // nothing is less probable

constexpr std::pair<ThingRole, const char*> kRoles[] = {{ThingRole::part, "part"}, {ThingRole::several, "several"}};

}  // namespace

std::string name_of(ThingKind kind) {
  for (const auto& [role, name] : kRoles)
    if (kind.role == role) return name;
  return kind.label == PointLabel::none ? "none" : point_label_names().at(static_cast<std::uint32_t>(kind.label));
}

namespace {

// Reads a model line by line: a word, then what belongs to it.
class ModelReader {
 public:
  ModelReader(std::string_view text, const std::string& name) : text_(std::string(text)), name_(name) {}

  ThingModel read() {
    std::string line;
    next(line);
    if (line != kFirstLine) fail("is no model of things: its first line is not '" + std::string(kFirstLine) + "'");
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
      const auto v = numbers(words, 3);
      model_.cost = v[0], model_.gamma = v[1], model_.unlike = v[2];
      return;
    }
    if (word == "pair") {
      const auto v = numbers(words, 3);
      model_.rho.push_back(v[0]), model_.slope.push_back(v[1]), model_.offset.push_back(v[2]);
      return;
    }
    if (word == "roles") {
      const auto v = numbers(words, 2 * kThingStates);
      std::copy_n(v.begin(), kThingStates, model_.roles.power.begin());
      std::copy_n(v.begin() + kThingStates, kThingStates, model_.roles.bias.begin());
      return;
    }
    if (word != "vector") fail("'" + word + "' is not known");
    const auto v = numbers(words, model_.classes.size() + model_.features.size());
    if (v[0] < 0 || v[0] >= static_cast<double>(model_.classes.size())) fail("there is no such class");
    const auto weights = v.begin() + static_cast<std::ptrdiff_t>(model_.classes.size());
    model_.class_of_vector.push_back(static_cast<std::uint32_t>(v[0]));
    model_.weights.emplace_back(v.begin() + 1, weights);
    model_.vectors.emplace_back(weights, v.end());
  }

  void take_feature(std::istringstream& words) {
    const auto v = numbers(words, 2);
    std::string name;
    std::getline(words >> std::ws, name);
    for (std::size_t f = 0; f < kThingFeatures; ++f) {
      if (name != thing_feature_name(f)) continue;
      model_.features.push_back(f);
      model_.mean.push_back(v[0]);
      model_.sd.push_back(v[1]);
      if (!(v[1] > 0)) fail("a deviation is not above 0");
      return;
    }
    fail("there is no feature '" + name + "'");
  }

  void take_class(std::istringstream& words) {
    const double prior = numbers(words, 1)[0];
    if (!(prior > 0)) fail("a class is never there");
    std::string name;
    words >> name;
    std::vector<ThingKind> kinds;
    for (const auto& entry : kRoles) kinds.push_back({PointLabel::none, entry.first});
    for (std::uint32_t value = 0; value <= static_cast<std::uint32_t>(PointLabel::other); ++value)
      kinds.push_back({static_cast<PointLabel>(value)});
    for (const ThingKind kind : kinds) {
      if (name_of(kind) != name) continue;
      model_.classes.push_back(kind);
      model_.prior.push_back(prior);
      return;
    }
    fail("there is no class '" + name + "'");
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

  void check() const {
    const std::size_t k = model_.classes.size();
    if (k < 2 || model_.features.empty() || model_.vectors.empty()) fail("ends before its vectors");
    if (model_.rho.size() != k * (k - 1) / 2) fail("there must be a line 'pair' for each two classes");
  }

  std::istringstream text_;
  std::string name_;
  std::size_t number_ = 0;
  ThingModel model_;
};

// The shares of what a thing is, if it is whole, and of its roles.
struct StateShares {
  std::array<double, kThingStates> of_state{};
  PointLabel object = PointLabel::other, rest = PointLabel::none;
  double object_share = 0, rest_share = 0;
};

StateShares states_of(const ThingModel& model, const std::vector<double>& share) {
  StateShares out;
  auto& [object, rest, part, several] = out.of_state;
  for (std::size_t c = 0; c < share.size(); ++c) {
    const auto [label, role] = model.classes[c];
    if (role == ThingRole::part) part += share[c];
    if (role == ThingRole::several) several += share[c];
    if (role != ThingRole::whole) continue;
    const bool is_object = label >= PointLabel::car;
    (is_object ? object : rest) += share[c];
    double& best = is_object ? out.object_share : out.rest_share;
    if (share[c] > best) best = share[c], (is_object ? out.object : out.rest) = label;
  }
  part += rest, several += rest;
  return out;
}

ThingClass class_of(const ThingModel& model, const ClassShares& shares) {
  const StateShares states = states_of(model, shares.share);
  std::array<double, kThingStates> weight;
  for (std::size_t s = 0; s < kThingStates; ++s)
    weight[s] = natural_exp(model.roles.power[s] * natural_log(std::max(kLeastShare, states.of_state[s])) +
                            model.roles.bias[s]);
  const auto [object, rest, part, several] = weight;
  const bool is_object = states.object_share > 0 && object >= rest;
  const double all = states.of_state[0] + states.of_state[1];
  ThingClass out{is_object ? states.object : states.rest, 0, std::max(object, rest), part, several};
  out.probability = all > 0 ? (is_object ? states.object_share : states.rest_share) / all : 0;
  if (shares.nearest >= model.unlike) return out;
  out.whole = out.part = out.several = 1;
  if (is_object) out.label = PointLabel::other, out.probability = 1 / static_cast<double>(shares.share.size());
  return out;
}

}  // namespace

std::vector<std::array<double, kThingStates>> role_logs(const ThingModel& model,
                                                        std::span<const ThingFeatures> things) {
  std::vector<std::array<double, kThingStates>> out;
  for (const ClassShares& shares : class_shares(model, things)) {
    out.push_back(states_of(model, shares.share).of_state);
    for (double& v : out.back()) v = natural_log(std::max(kLeastShare, v));
  }
  return out;
}

std::vector<ThingKind> likeliest_kinds(const ThingModel& model, std::span<const ThingFeatures> things) {
  std::vector<ThingKind> out;
  for (const auto& [share, nearest] : class_shares(model, things))
    out.push_back(
        model.classes[static_cast<std::size_t>(std::max_element(share.begin(), share.end()) - share.begin())]);
  return out;
}

std::vector<ThingClass> classify_things(const ThingModel& model, std::span<const ThingFeatures> things) {
  std::vector<ThingClass> out;
  for (const ClassShares& shares : class_shares(model, things)) out.push_back(class_of(model, shares));
  return out;
}

ThingClass classify_thing(const ThingModel& model, const ThingFeatures& features) {
  return classify_things(model, {&features, 1}).front();
}

std::string thing_model_text(const ThingModel& model) {
  std::string text = std::string(kFirstLine) + "\n";
  std::istringstream recipe(model.recipe);
  for (std::string line; std::getline(recipe, line);) text += line.empty() ? "#\n" : "# " + line + "\n";
  for (std::size_t c = 0; c < model.classes.size(); ++c)
    text += fmt::format("class {:.9g} {}\n", model.prior[c], name_of(model.classes[c]));
  for (std::size_t i = 0; i < model.features.size(); ++i)
    text +=
        fmt::format("feature {:.9g} {:.9g} {}\n", model.mean[i], model.sd[i], thing_feature_name(model.features[i]));
  text += fmt::format("kernel {:.9g} {:.9g} {:.9g}\n", model.cost, model.gamma, model.unlike);
  for (std::size_t p = 0; p < model.rho.size(); ++p)
    text += fmt::format("pair {:.9g} {:.9g} {:.9g}\n", model.rho[p], model.slope[p], model.offset[p]);
  text += "roles";
  for (const auto& list : {model.roles.power, model.roles.bias})
    for (const double v : list) text += fmt::format(" {:.9g}", v);
  text += "\n";
  for (std::size_t v = 0; v < model.vectors.size(); ++v) {
    text += fmt::format("vector {}", model.class_of_vector[v]);
    for (const double w : model.weights[v]) text += fmt::format(" {:.7g}", w);
    for (const double x : model.vectors[v]) text += fmt::format(" {:.5g}", x);
    text += "\n";
  }
  return text;
}

ThingModel parse_thing_model(std::string_view text, const std::string& name) {
  return ModelReader(text, name).read();
}

}  // namespace ilot
