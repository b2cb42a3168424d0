// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "engine/error.h"
#include "engine/evaluate/plane_matching.h"
#include "engine/formats/reader.h"
#include "tools/ilot/commands.h"
#include "tools/ilot/console.h"

namespace ilot {
namespace {

constexpr std::size_t kChunk = 1 << 16;  // points read at a time
constexpr double kForeignLimit = 0.01;   // share of foreign points above which a found plane is counted

struct EvaluateArguments {
  std::string input;
  std::string found_field = "plane_id";
  bool truth_fields = false, json = false;
  std::optional<int> only_class;  // true_class
  std::uint64_t min_points = 1;   // smaller true planes are not judged
};

// Labels of a cloud as far as they are judged.
struct Labels {
  LabelPairs pairs;
  std::unordered_map<std::uint32_t, std::uint8_t> class_of;  // of true planes
  std::unordered_map<std::uint32_t, std::uint64_t> points_of;
};

const ExtraField& require_field(const CloudInfo& info, const std::string& name, FieldType type) {
  for (const ExtraField& field : info.layout.extra)
    if (field.name == name && field.type == type) return field;
  throw Error(fmt::format("{}: no extra bytes '{}' of the type {}; give a cloud that carries them", info.path.string(),
                          name, type == FieldType::u8 ? "u8" : "u32"));
}

Labels read_labels(const EvaluateArguments& options) {
  const std::unique_ptr<PointReader> reader = open_cloud(options.input);
  const CloudInfo& info = reader->info();
  const std::size_t length = info.layout.record_length;
  const std::size_t truth_at = require_field(info, "true_plane", FieldType::u32).offset;
  const std::size_t class_at = require_field(info, "true_class", FieldType::u8).offset;
  const std::size_t found_at = require_field(info, options.found_field, FieldType::u32).offset;
  std::vector<std::byte> records(kChunk * length);
  std::vector<std::uint8_t> valid(kChunk);
  Labels labels;
  for (std::uint64_t first = 0; first < info.points;) {
    const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(kChunk, info.points - first));
    const std::size_t got =
        reader->read(first, std::span(records).first(wanted * length), std::span(valid).first(wanted));
    for (std::size_t i = 0; i < got; ++i) {
      if (!valid[i]) continue;
      const std::byte* record = &records[i * length];
      const auto truth = load<std::uint32_t>(record + truth_at);
      labels.pairs.add(truth, load<std::uint32_t>(record + found_at));
      if (truth == 0) continue;
      labels.class_of.emplace(truth, load<std::uint8_t>(record + class_at));
      ++labels.points_of[truth];
    }
    if (got < wanted) break;
    first += got;
  }
  return labels;
}

std::string report_text(const PlaneMatching& m, const FoundPlane* worst, std::uint64_t impure) {
  std::string text = fmt::format("planes   true {}  found {}  matched {}  over {}  under {}  missed {}\n",
                                 m.true_planes, m.found_planes, m.matches.size(), m.over, m.under, m.missed);
  text += fmt::format("points   {:.3f} % of {} points of true planes carry their plane\n", 100 * m.share(), m.points);
  if (worst)
    text += fmt::format("foreign  at most {:.3f} % (plane {} with {} points); {} found planes above {:.0f} %\n",
                        100 * worst->foreign_share(), worst->id, worst->points, impure, 100 * kForeignLimit);
  return text;
}

nlohmann::ordered_json report_json(const PlaneMatching& m, const FoundPlane* worst, std::uint64_t impure) {
  nlohmann::ordered_json json;
  json["planes"] = {{"true", m.true_planes}, {"found", m.found_planes}, {"matched", m.matches.size()},
                    {"over", m.over},        {"under", m.under},        {"missed", m.missed}};
  json["points"] = {{"true", m.points},
                    {"carrying", m.carrying},
                    {"share", m.share()},
                    {"foreign_share_max", worst ? worst->foreign_share() : 0},
                    {"found_above_1_percent", impure}};
  return json;
}

int evaluate_command(const EvaluateArguments& options) {
  if (options.input.empty()) throw Error("evaluate: INPUT is needed (ilot evaluate --help)", ExitCode::usage);
  if (!options.truth_fields)
    throw Error("evaluate: where is the truth? --truth-fields takes it from the cloud's own extra bytes",
                ExitCode::usage);
  const Labels labels = read_labels(options);
  std::function<bool(std::uint32_t)> judged;
  if (options.only_class || options.min_points > 1)
    judged = [&](std::uint32_t plane) {
      return (!options.only_class || labels.class_of.at(plane) == *options.only_class) &&
             labels.points_of.at(plane) >= options.min_points;
    };
  const PlaneMatching matching = match_planes(labels.pairs.sorted(), judged);
  const auto worst = std::max_element(matching.found.begin(), matching.found.end(), [](const auto& a, const auto& b) {
    return a.foreign_share() < b.foreign_share();
  });
  const FoundPlane* worst_plane = worst == matching.found.end() ? nullptr : &*worst;
  const auto impure = static_cast<std::uint64_t>(
      std::count_if(matching.found.begin(), matching.found.end(),
                    [](const FoundPlane& plane) { return plane.foreign_share() > kForeignLimit; }));
  print(options.json ? report_json(matching, worst_plane, impure).dump(2) + "\n"
                     : report_text(matching, worst_plane, impure));
  return static_cast<int>(ExitCode::ok);
}

}  // namespace

void add_evaluate_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("evaluate", "Judges a result against the truth");
  auto given = std::make_shared<EvaluateArguments>();
  command->add_option("INPUT", given->input, "a labelled point cloud")->option_text(" ");
  command->add_flag("--truth-fields", given->truth_fields,
                    "the truth is in extra bytes true_plane and true_class [off]");
  command->add_option("--found-field", given->found_field, "extra bytes with the found planes [plane_id]")
      ->option_text("NAME");
  command->add_option("--class", given->only_class, "judge only planes of this true_class, 2 = roofs [all]")
      ->option_text("N")
      ->check(CLI::Range(0, 255));
  command->add_option("--min-points", given->min_points, "judge only true planes with so many points [1]")
      ->option_text("N");
  command->add_flag("--json", given->json, "for programs [off]");
  command->footer("Example: ilot evaluate out/points/town.las --truth-fields --class 2");
  command->callback([given, &action] { action = [given] { return evaluate_command(*given); }; });
}

}  // namespace ilot
