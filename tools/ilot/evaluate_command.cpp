// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/compare/evaluation_report.h"
#include "engine/compare/facades/drawing_control.h"
#include "engine/compare/roofs/wireframe_report.h"
#include "engine/compare/seams.h"
#include "engine/deliverables/solids/model_file.h"
#include "engine/error.h"
#include "engine/proof/model_report.h"
#include "engine/whole_file.h"
#include "tools/ilot/commands.h"
#include "tools/ilot/console.h"

namespace ilot {
namespace {

struct EvaluateArguments {
  std::string input, truth, html, models, cloud, drawing, corrected, layers = "ilot", against;
  std::vector<std::string> wireframes;
  EvaluateParams params;
  ModelPointsParams points;
  ModelResidualParams residuals;
  bool truth_fields = false, seams = false, json = false;
};

int evaluate_models(const EvaluateArguments& given) {
  if (given.models.empty()) throw Error("evaluate: --cloud needs --models FILE", ExitCode::usage);
  if (given.cloud.empty()) throw Error("evaluate: --models needs --cloud FILE", ExitCode::usage);
  if (!given.input.empty() || given.truth_fields || !given.truth.empty() || !given.html.empty())
    throw Error("evaluate: --models judges against --cloud alone: no OUT, --truth, --truth-fields or --html",
                ExitCode::usage);
  const ModelFile file = read_models(given.models);
  if (file.models.empty()) throw Error(given.models + ": contains no model of a building with faces");
  for (const std::string& warning : file.warnings) say("ilot: " + warning + "\n");
  ModelPointsParams wanted = given.points;
  wanted.classification = given.params.only_class;
  ModelEvaluation evaluation{given.models, given.cloud, read_model_points(given.cloud, file.models, wanted), {}, {}};
  evaluation.params = given.residuals;
  evaluation.params.metres_per_unit = evaluation.points.metres_per_unit;
  evaluation.residuals = evaluate_building_models(file.models, evaluation.points.buildings, evaluation.params);
  if (evaluation.residuals.buildings.empty())
    throw Error(given.cloud + ": no point of it belongs to a model of " + given.models +
                "; are both in the same coordinate system?");
  print(given.json ? model_json(evaluation) : model_text(evaluation));
  return static_cast<int>(ExitCode::ok);
}

int evaluate_drawing(const EvaluateArguments& given) {
  if (given.drawing.empty() || given.corrected.empty())
    throw Error("evaluate: --drawing FILE and --corrected FILE belong together", ExitCode::usage);
  if (!given.input.empty() || given.truth_fields || !given.truth.empty() || !given.html.empty())
    throw Error("evaluate: --drawing is judged by --corrected alone: no OUT, --truth, --truth-fields or --html",
                ExitCode::usage);
  const auto layers = compare_drawings(read_dxf(given.drawing), read_dxf(given.corrected),
                                       {given.params.control_point_limit_m, read_layers(given.layers)});
  print(given.json ? drawing_control_json(layers) : drawing_control_text(layers));
  return static_cast<int>(ExitCode::ok);
}

int evaluate_seams_of_run(const EvaluateArguments& given) {
  if (given.input.empty()) throw Error("evaluate: --seams needs OUT, the output folder of a run", ExitCode::usage);
  if (given.truth_fields || !given.truth.empty() || !given.html.empty())
    throw Error("evaluate: --seams measures a result alone: no --truth, --truth-fields or --html", ExitCode::usage);
  std::optional<std::filesystem::path> other;
  if (!given.against.empty()) other = given.against;
  const Seams seams = evaluate_seams(given.input, other);
  print(given.json ? seams_json(seams) : seams_text(seams));
  return static_cast<int>(ExitCode::ok);
}

int evaluate_roof_edges(const EvaluateArguments& given) {
  if (given.input.empty())
    throw Error("evaluate: --wireframe needs OUT, the output folder of a run or a file of models", ExitCode::usage);
  if (given.truth_fields || given.seams || !given.truth.empty() || !given.html.empty())
    throw Error("evaluate: --wireframe is the truth: no --truth, --truth-fields, --seams or --html", ExitCode::usage);
  const WireframeEvaluation evaluation = evaluate_wireframes(given.input, given.wireframes);
  print(given.json ? wireframes_json(evaluation) : wireframes_text(evaluation));
  return static_cast<int>(ExitCode::ok);
}

Truth truth_for(const EvaluateArguments& given) {
  if (given.truth_fields) return {};
  return is_model_file(given.truth) ? truth_of_models(read_models(given.truth).models) : read_truth(given.truth);
}

int evaluate_command(const EvaluateArguments& given) {
  if (!given.drawing.empty() || !given.corrected.empty()) return evaluate_drawing(given);
  if (!given.models.empty() || !given.cloud.empty()) return evaluate_models(given);
  if (!given.wireframes.empty()) return evaluate_roof_edges(given);
  if (given.seams) return evaluate_seams_of_run(given);
  if (!given.against.empty()) throw Error("evaluate: --against belongs to --seams", ExitCode::usage);
  if (given.input.empty()) throw Error("evaluate: OUT is needed (ilot evaluate --help)", ExitCode::usage);
  if (given.truth.empty() == !given.truth_fields)
    throw Error("evaluate: where is the truth? --truth FILE names it, --truth-fields takes the cloud's own extra bytes",
                ExitCode::usage);
  Evaluation evaluation = evaluate(given.input, truth_for(given), given.params);
  evaluation.truth = given.truth_fields ? "extra bytes" : given.truth;
  if (!given.html.empty()) write_whole_file(given.html, evaluation_html(evaluation));
  print(given.json ? evaluation_json(evaluation) : evaluation_text(evaluation));
  return static_cast<int>(ExitCode::ok);
}

template <class Value>
CLI::CheckedTransformer one_of(const std::map<std::string, Value>& values) {
  return CLI::CheckedTransformer(values);
}

void add_model_options(CLI::App& command, EvaluateArguments& given) {
  command.add_option("--models", given.models, "judge these models against a cloud: .obj, .json, .jsonl [none]")
      ->option_text("FILE");
  command.add_option("--cloud", given.cloud, "the cloud to judge models against [none]")->option_text("FILE");
  const std::map<std::string, PointOwner> owners{{"auto", PointOwner::automatic},
                                                 {"field", PointOwner::field},
                                                 {"plan", PointOwner::plan},
                                                 {"everything", PointOwner::everything}};
  command.add_option("--points-of", given.points.owner, "points of a model: auto, field, plan or everything [auto]")
      ->option_text("HOW")
      ->transform(one_of(owners));
  command.add_option("--building-field", given.points.field, "extra bytes with the number of the model [building]")
      ->option_text("NAME");
  command.add_option("--margin", given.points.margin_m, "metres that points may lie outside a model's plan [0.5]")
      ->option_text("M")
      ->check(CLI::Range(0.0, 1000.0));
  const std::map<std::string, EvaluatedFaces> faces{{"all", EvaluatedFaces::all}, {"roofs", EvaluatedFaces::roofs}};
  command.add_option("--faces", given.residuals.faces, "of models: all or roofs [all]")
      ->option_text("WHICH")
      ->transform(one_of(faces));
}

void add_drawing_options(CLI::App& command, EvaluateArguments& given) {
  command.add_option("--drawing", given.drawing, "judge this DXF drawing by a corrected one [none]")
      ->option_text("FILE");
  command.add_option("--corrected", given.corrected, "the DXF drawing as a surveyor corrected it [none]")
      ->option_text("FILE");
  command.add_option("--layers", given.layers, "of both drawings: ilot, aia, iso13567 or a mapping file [ilot]")
      ->option_text("NAME");
}

}  // namespace

void add_evaluate_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("evaluate", "Judges a result against the truth, or models against a cloud");
  auto given = std::make_shared<EvaluateArguments>();
  command->add_option("OUT", given->input, "output folder of a run, a labelled cloud or models of roofs")
      ->option_text(" ");
  command->add_option("--truth", given->truth, "NAME.truth.json of the scene, or true models [none]")
      ->option_text("FILE");
  command->add_flag("--truth-fields", given->truth_fields,
                    "the truth is in extra bytes true_plane and true_class alone [off]");
  command->add_option("--found-field", given->params.found_field, "extra bytes with the found planes [plane_id]")
      ->option_text("NAME");
  command
      ->add_option("--class", given->params.only_class,
                   "judge only planes of this true_class, 2 = roofs; with --models only points of this class [all]")
      ->option_text("N")
      ->check(CLI::Range(0, 255));
  command->add_option("--min-points", given->params.min_points, "judge only true planes with so many points [1]")
      ->option_text("N");
  const std::map<std::string, MatchRule> rules{{"main", MatchRule::main}, {"iou", MatchRule::overlap}};
  command
      ->add_option("--match", given->params.rule,
                   "planes are partners when half of the found one's points agree (main), or half of both (iou) "
                   "[main]")
      ->option_text("RULE")
      ->transform(one_of(rules));
  command
      ->add_option("--control-limit", given->params.control_point_limit_m,
                   "metres within which a drawn vertex counts for a control point [0.3]")
      ->option_text("M")
      ->check(CLI::Range(0.0, 100.0));
  command->add_flag("--as-documents", given->params.as_documents,
                    "vertices on occluded edges count as drawn, as in the tables of the documents [off]");
  command->add_flag("--seams", given->seams,
                    "measure how often planes end at the borders of the cells in which they were searched [off]");
  command
      ->add_option("--against", given->against,
                   "with --seams: output folder of a run over the same rows, to compare pairs of neighbours [none]")
      ->option_text("OUT");
  command
      ->add_option("--wireframe", given->wireframes,
                   "judge the edges of roofs by true wireframes: OBJ files of v and l lines, one building each [none]")
      ->option_text("FILE...");
  add_model_options(*command, *given);
  add_drawing_options(*command, *given);
  command->add_option("--html", given->html, "also write a fragment for a page [none]")->option_text("FILE");
  command->add_flag("--json", given->json, "for programs [off]");
  command->footer(
      "Example: ilot evaluate out --truth town.truth.json\n"
      "Example: ilot evaluate out --wireframe house-1.obj house-2.obj\n"
      "Example: ilot evaluate --models roofs.city.jsonl --cloud town.laz --class 6 --faces roofs\n"
      "Example: ilot evaluate --drawing facade-001.dxf --corrected corrected.dxf");
  command->callback([given, &action] { action = [given] { return evaluate_command(*given); }; });
}

}  // namespace ilot
