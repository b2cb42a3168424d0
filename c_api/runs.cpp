// SPDX-License-Identifier: Apache-2.0
// Whole runs, over run.h and parameters.h.
#include "ilot/run.h"

#include <atomic>
#include <charconv>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "c_api/guard.h"
#include "ilot/parameters.h"

struct ilot_run {
  ilot::RunOptions options;
  ilot_progress progress = nullptr;
  ilot_message message = nullptr;
  void* user = nullptr;
};

namespace ilot::c {

namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& value, const std::string& expected) {
  throw Error(name + " = \"" + value + "\": " + expected + " is expected", ExitCode::usage);
}

template <typename Number>
Number number_of(const std::string& name, const std::string& value) {
  Number number = 0;
  const auto [end, fault] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (value.empty() || fault != std::errc() || end != value.data() + value.size())
    refuse(name, value, "a whole number");
  return number;
}

bool flag_of(const std::string& name, const std::string& value) {
  if (value != "true" && value != "false") refuse(name, value, "true or false");
  return value == "true";
}

std::vector<std::string> words_of(const std::string& value) {
  std::vector<std::string> words;
  std::istringstream in(value);
  for (std::string word; std::getline(in, word, ',');) words.push_back(word);
  return words;
}

Existing existing_of(const std::string& value) {
  if (value == "refuse") return Existing::refuse;
  if (value == "resume") return Existing::resume;
  if (value != "overwrite") refuse("existing", value, "refuse, resume or overwrite");
  return Existing::overwrite;
}

using Setter = void (*)(RunOptions& options, const std::string& name, const std::string& value);
using Name = const std::string&;

// Every option that ilot_run_set_option() takes, and what it sets.
const std::map<std::string, Setter>& setters() {
  static const std::map<std::string, Setter> all{
      {"output", [](RunOptions& o, Name, Name v) { o.output = v; }},
      {"products", [](RunOptions& o, Name, Name v) { o.products = words_of(v); }},
      {"memory_bytes", [](RunOptions& o, Name n, Name v) { o.memory_bytes = number_of<std::uint64_t>(n, v); }},
      {"threads", [](RunOptions& o, Name n, Name v) { o.threads = number_of<int>(n, v); }},
      {"store", [](RunOptions& o, Name, Name v) { o.store = v; }},
      {"bounds", [](RunOptions& o, Name, Name v) { o.area = parse_bounds(v); }},
      {"within", [](RunOptions& o, Name, Name v) { o.area = read_area(v); }},
      {"footprints", [](RunOptions& o, Name, Name v) { o.footprints = v; }},
      {"id_field", [](RunOptions& o, Name, Name v) { o.id_field = v; }},
      {"stations", [](RunOptions& o, Name, Name v) { o.stations = v; }},
      {"edits", [](RunOptions& o, Name, Name v) { o.edits.emplace_back(v); }},
      {"train", [](RunOptions& o, Name, Name v) { o.train = v; }},
      {"crs", [](RunOptions& o, Name, Name v) { o.crs = v; }},
      {"to_crs", [](RunOptions& o, Name, Name v) { o.to_crs = v; }},
      {"existing", [](RunOptions& o, Name, Name v) { o.existing = existing_of(v); }},
      {"strict", [](RunOptions& o, Name n, Name v) { o.strict = flag_of(n, v); }},
      {"dry_run", [](RunOptions& o, Name n, Name v) { o.dry_run = flag_of(n, v); }},
      {"keep_store", [](RunOptions& o, Name n, Name v) { o.keep_store = flag_of(n, v); }},
      {"clouds", [](RunOptions& o, Name n, Name v) { o.clouds = flag_of(n, v); }},
      {"report", [](RunOptions& o, Name n, Name v) { o.report = flag_of(n, v); }},
  };
  return all;
}

std::string option_names() {
  std::string names;
  for (const auto& [name, setter] : setters()) names += (names.empty() ? "" : ", ") + name;
  return names;
}

// What apply_assignment says begins with the option of the program, which nobody gave here.
void apply_setting(Settings& settings, const std::string& assignment) {
  const std::string begin = "--set ";
  try {
    apply_assignment(settings, assignment);
  } catch (const Error& thrown) {
    const std::string text = thrown.what();
    throw Error(text.starts_with(begin) ? text.substr(begin.size()) : text, thrown.code());
  }
}

constexpr const char* kKinds[] = {"boolean", "integer", "number", "integers", "numbers", "choice"};

nlohmann::json parameter_json(const Parameter& p, const Settings& settings) {
  nlohmann::json json{{"key", p.key},          {"kind", kKinds[static_cast<std::size_t>(p.kind)]},
                      {"unit", p.unit},        {"default", to_text(p.get(settings))},
                      {"help", p.help},        {"optional", p.optional},
                      {"advanced", p.advanced}};
  if (p.kind == ParameterKind::choice)
    for (const std::string_view word : p.choices) json["choices"].push_back(std::string(word));
  else if (p.kind != ParameterKind::boolean)
    json.update({{"minimum", p.range.min}, {"maximum", p.range.max}});
  return json;
}

// The caller's functions. One that asks for a stop ends this run, and neither one that waits nor a later one.
ilot_status start(ilot_run& run) {
  std::atomic<bool> stopped{false};
  RunCallbacks callbacks;
  callbacks.stop = &stopped;
  if (run.progress != nullptr)
    callbacks.progress = [&](const RunProgress& p) {
      if (stopped || run.progress(run.user, p.stage.c_str(), p.points_done, p.points_total, p.seconds) == 0) return;
      stopped = true;
    };
  if (run.message != nullptr)
    callbacks.message = [&](std::string_view line) { run.message(run.user, std::string(line).c_str()); };
  const ilot_status status = guarded([&] { return static_cast<ilot_status>(ilot::run(run.options, callbacks).exit); });
  if (status == ILOT_FAILED && *ilot_last_error() == 0) fault(status, "the run failed, see run.json");
  return status;
}

}  // namespace

}  // namespace ilot::c

using namespace ilot;
using namespace ilot::c;

extern "C" {

ilot_run* ilot_run_new(void) {
  ilot_run* made = nullptr;
  guarded([&] {
    made = new ilot_run();
    return ILOT_OK;
  });
  return made;
}

void ilot_run_free(ilot_run* run) {
  delete run;
}

ilot_status ilot_run_add_input(ilot_run* run, const char* path) {
  return guarded([&] {
    need(run, "run");
    need(path, "path");
    run->options.inputs.emplace_back(path);
    return ILOT_OK;
  });
}

ilot_status ilot_run_set_option(ilot_run* run, const char* name, const char* value) {
  return guarded([&] {
    need(run, "run");
    need(name, "name");
    need(value, "value");
    const auto setter = setters().find(name);
    if (setter == setters().end())
      throw Error("there is no option " + std::string(name) + "; there are: " + option_names(), ExitCode::usage);
    setter->second(run->options, name, value);
    return ILOT_OK;
  });
}

ilot_status ilot_run_set(ilot_run* run, const char* assignment) {
  return guarded([&] {
    need(run, "run");
    need(assignment, "assignment");
    apply_setting(run->options.settings, assignment);
    return ILOT_OK;
  });
}

ilot_status ilot_run_load_config(ilot_run* run, const char* path) {
  return guarded([&] {
    need(run, "run");
    need(path, "path");
    load_config(run->options.settings, path);
    return ILOT_OK;
  });
}

void ilot_run_set_callbacks(ilot_run* run, ilot_progress progress, ilot_message message, void* user) {
  if (run == nullptr) return;
  run->progress = progress;
  run->message = message;
  run->user = user;
}

ilot_status ilot_run_start(ilot_run* run) {
  if (run == nullptr) return fault(ILOT_USAGE, "run: NULL is given, which is not allowed");
  fault(ILOT_OK, "");
  return guarded([&] { return start(*run); });
}

void ilot_request_stop(void) {
  request_stop();
}

void ilot_accept_runs(void) {
  accept_runs();
}

ilot_status ilot_parameters(char** json) {
  return guarded([&] {
    clear(json);
    need(json, "json");
    const Settings settings;
    nlohmann::json list = nlohmann::json::array();
    for (const Parameter& p : parameters()) list.push_back(parameter_json(p, settings));
    *json = text_of(list);
    return ILOT_OK;
  });
}

}  // extern "C"
