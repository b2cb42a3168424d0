// SPDX-License-Identifier: Apache-2.0
#include <pybind11/functional.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <tuple>

#include "ilot/parameters.h"
#include "ilot/run.h"
#include "python/module/arrays.h"
#include "python/module/bindings.h"
#include "python/module/interrupts.h"

namespace ilot {

namespace {

// One value as --set takes it. Its faults begin with --set, which callers from Python did not write.
void apply_setting(Settings& settings, const std::string& assignment) {
  const std::string begin = "--set ";
  try {
    apply_assignment(settings, assignment);
  } catch (const Error& fault) {
    const std::string text = fault.what();
    throw Error(text.starts_with(begin) ? "settings: " + text.substr(begin.size()) : text, fault.code());
  }
}

// Values are text as TOML has it: runs.py makes it.
void apply_settings(Settings& settings, const py::dict& values) {
  for (const auto& [key, value] : values) {
    apply_setting(settings, py::str(key).cast<std::string>() + "=" + py::str(value).cast<std::string>());
  }
}

std::uint64_t bytes_of(const py::object& memory) {
  if (py::isinstance<py::int_>(memory)) return memory.cast<std::uint64_t>();
  const std::string text = py::str(memory);
  std::size_t end = 0;
  std::uint64_t number = 0;
  for (; end < text.size() && text[end] >= '0' && text[end] <= '9' && end < 12; ++end)
    number = 10 * number + static_cast<std::uint64_t>(text[end] - '0');
  const std::string unit = text.substr(end);
  if (end > 0 && unit == "M") return number << 20;
  if (end > 0 && unit == "G") return number << 30;
  throw Error("memory \"" + text + "\": a number of bytes is expected, or text as \"512M\" or \"2G\"", ExitCode::usage);
}

Existing existing_of(const std::string& word) {
  if (word == "refuse") return Existing::refuse;
  if (word == "resume") return Existing::resume;
  if (word == "overwrite") return Existing::overwrite;
  throw Error("existing=\"" + word + "\": refuse, resume or overwrite is expected", ExitCode::usage);
}

py::dict dict_of(const RunReport& report) {
  py::dict out;
  out["exit"] = static_cast<int>(report.exit);
  out["folder"] = report.folder;
  out["products"] = report.products;
  out["points_read"] = report.points_read;
  out["points_labelled"] = report.points_labelled;
  out["points_unlabelled"] = report.points_unlabelled;
  out["points_rejected"] = report.points_rejected;
  py::list skipped;
  for (const SkippedRecord& s : report.skipped) skipped.append(py::make_tuple(s.what, s.where, s.reason));
  out["skipped"] = skipped;
  out["warnings"] = report.warnings;
  out["chosen"] = report.chosen;
  out["files"] = report.files;
  out["clouds"] = report.clouds;
  out["seconds"] = report.seconds;
  out["peak_memory_bytes"] = report.peak_memory_bytes;
  out["result_hash"] = report.result_hash;
  return out;
}

// Functions of Python are called with the interpreter's lock. What they throw stops the run and is thrown again after
// it, since no exception may leave a callback.
class PythonCallbacks {
 public:
  PythonCallbacks(py::object progress, py::object message)
      : progress_(std::move(progress)), message_(std::move(message)) {}

  RunCallbacks callbacks() {
    RunCallbacks made;
    made.stop = &stop_;
    if (!progress_.is_none())
      made.progress = [this](const RunProgress& p) {
        call([&] { progress_(p.stage, p.points_done, p.points_total, p.seconds); });
      };
    if (!message_.is_none())
      made.message = [this](std::string_view line) { call([&] { message_(std::string(line)); }); };
    return made;
  }

  // With the interpreter's lock. Throws what a function threw.
  void rethrow() {
    if (fault_) throw std::move(*fault_);
  }

  // True ends the run, and no other one.
  std::atomic<bool>& stop() { return stop_; }

 private:
  template <typename Function>
  void call(const Function& function) {
    const py::gil_scoped_acquire lock;
    if (fault_) return;
    try {
      function();
    } catch (py::error_already_set& thrown) {
      fault_ = std::make_unique<py::error_already_set>(std::move(thrown));
      stop_ = true;
    }
  }

  py::object progress_, message_;
  std::unique_ptr<py::error_already_set> fault_;
  std::atomic<bool> stop_{false};
};

bool in_main_thread() {
  const py::module_ threading = py::module_::import("threading");
  return threading.attr("current_thread")().is(threading.attr("main_thread")());
}

[[noreturn]] void raise_keyboard_interrupt(const char* sentence) {
  PyErr_SetString(PyExc_KeyboardInterrupt, sentence);
  throw py::error_already_set();
}

// Ctrl-C is raised also where the run ended before it could obey.
RunReport run_released(const RunOptions& options, PythonCallbacks& python) {
  const InterruptGuard interrupts(in_main_thread(), python.stop());
  const RunCallbacks callbacks = python.callbacks();
  try {
    RunReport report;
    {
      const py::gil_scoped_release released;
      report = run(options, callbacks);
    }
    python.rethrow();
    if (interrupts.came()) raise_keyboard_interrupt("interrupted; the run had just ended, and its result is whole");
    return report;
  } catch (const Error& fault) {
    python.rethrow();
    if (fault.code() != ExitCode::interrupted || !interrupts.came()) throw;
    raise_keyboard_interrupt(fault.what());
  }
}

// The arrays stay alive with the caller's object.
ArrayCloud input_of(const py::object& given) {
  ArrayCloud cloud = cloud_of(given.attr("x"), given.attr("y"), given.attr("z"), given.attr("attributes"));
  cloud.name = given.attr("name").cast<std::string>();
  cloud.crs = given.attr("crs").cast<std::string>();
  cloud.scale = given.attr("scale").cast<double>();
  return cloud;
}

py::dict run_python(const std::vector<std::filesystem::path>& inputs, const std::filesystem::path& output,
                    const std::vector<std::string>& products, const py::dict& settings, const py::kwargs& more) {
  RunOptions options;
  options.inputs = inputs;
  for (const py::handle cloud : more["arrays"])
    options.arrays.push_back(input_of(py::reinterpret_borrow<py::object>(cloud)));
  options.output = output;
  options.products = products;
  apply_settings(options.settings, settings);
  PythonCallbacks python(more["progress"], more["message"]);
  options.memory_bytes = bytes_of(more["memory"]);
  options.threads = more["threads"].cast<int>();
  options.store = more["store"].cast<std::filesystem::path>();
  if (!more["bounds"].is_none()) {
    const auto [x0, y0, x1, y1] = more["bounds"].cast<std::tuple<double, double, double, double>>();
    options.area = Area{std::min(x0, x1), std::min(y0, y1), std::max(x0, x1), std::max(y0, y1), {}};
  }
  options.footprints = more["footprints"].cast<std::filesystem::path>();
  options.id_field = more["id_field"].cast<std::string>();
  options.stations = more["stations"].cast<std::filesystem::path>();
  options.train = more["train"].cast<std::filesystem::path>();
  options.edits = more["edits"].cast<std::vector<std::filesystem::path>>();
  options.crs = more["crs"].cast<std::string>();
  options.to_crs = more["to_crs"].cast<std::string>();
  options.existing = existing_of(more["existing"].cast<std::string>());
  options.strict = more["strict"].cast<bool>();
  options.keep_store = more["keep_store"].cast<bool>();
  options.clouds = more["clouds"].cast<bool>();
  options.report = more["report"].cast<bool>();
  return dict_of(run_released(options, python));
}

constexpr const char* kKinds[] = {"boolean", "integer", "number", "integers", "numbers", "choice"};

py::list parameters_python() {
  const Settings settings;
  py::list list;
  for (const Parameter& p : parameters()) {
    py::dict one;
    one["key"] = p.key;
    one["kind"] = kKinds[static_cast<std::size_t>(p.kind)];
    one["optional"] = p.optional;
    one["choices"] = std::vector<std::string>(p.choices.begin(), p.choices.end());
    one["default"] = to_text(p.get(settings));
    one["range"] = range_text(p);
    one["unit"] = p.unit;
    one["help"] = p.help;
    one["advanced"] = p.advanced;
    list.append(one);
  }
  return list;
}

}  // namespace

void bind_runs(py::module_& m) {
  m.def("run", &run_python, py::arg("inputs"), py::arg("output"), py::arg("products"), py::arg("settings"));
  m.def(
      "read_run", [](const std::filesystem::path& folder) { return dict_of(read_run(folder)); }, py::arg("folder"));
  m.def("parameters", &parameters_python);
}

}  // namespace ilot
