// SPDX-License-Identifier: Apache-2.0
// Reports on the machine: what is installed, what is missing, and how fast a small run is.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>

#include "engine/deliverables/report/report.h"
#include "engine/error.h"
#include "engine/formats/crs.h"
#include "engine/report/allowed_memory.h"
#include "engine/report/resources.h"
#include "engine/run/run.h"
#include "engine/version.h"
#include "kernels/core/parallel.h"
#include "kernels/simd/forced_isa.h"
#include "kernels/simd/variants.h"
#include "scan/scenes.h"
#include "tools/ilot/commands.h"
#include "tools/ilot/console.h"
#include "tools/ilot/opener.h"

namespace ilot {
namespace {

// Choice: points of the trial, two seconds on one core of 2020.
constexpr std::uint64_t kTrialPoints = 200000;

struct Doctor {
  std::uint64_t missing = 0;

  void row(const std::string& name, const std::string& text) {
    print(one_line(fmt::format("  {:<14} {}", name, text)));
  }
  void check(const std::string& name, bool there, const std::string& good, const std::string& bad) {
    missing += !there;
    row(name, there ? good : "MISSING: " + bad);
  }
};

// A folder of our own for the trial, which is removed at the end.
class TrialFolder {
 public:
  explicit TrialFolder(const std::filesystem::path& parent) {
    std::string name = (parent / "ilot-doctor-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw Error(parent.string() + ": no folder can be made here for the trial run");
    path_ = name;
  }
  ~TrialFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TrialFolder(const TrialFolder&) = delete;
  TrialFolder& operator=(const TrialFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

void report_program(Doctor& doctor) {
  print("program\n");
  doctor.row("version", version() + " (" + git_hash() + "), " + compiler() + ", " + build_type());
  if (build_type() == "Debug") doctor.row("note", "a debug build is many times slower; build the preset release");
  std::string libraries;
  for (const auto& [name, number] : library_versions())
    libraries += (libraries.empty() ? "" : ", ") + name + " " + number;
  doctor.row("libraries", libraries);
  bool crs = false;
  try {
    crs = !crs_from_epsg(2154).name.empty();
  } catch (const Error&) {
    crs = false;
  }
  doctor.check("CRS database", crs, "found", "PROJ's proj.db; install the Debian package proj-data");
}

void report_machine(Doctor& doctor, const std::filesystem::path& folder) {
  constexpr std::uint64_t kUsualMemory = std::uint64_t{2} << 30;
  print("machine\n");
  const int threads = hardware_threads();
  doctor.row("cores", std::to_string(threads));
  std::string isas;
  for (const std::string_view isa : simd::available_isas()) isas += (isas.empty() ? "" : ", ") + std::string(isa);
  doctor.row("instructions", std::string(simd::name_of(simd::chosen_isa())) + " of " + isas);
  const std::uint64_t memory = allowed_memory_bytes();
  doctor.row("memory", fmt::format("{} MiB; --memory is {} MiB where it is not given", memory >> 20,
                                   std::min(memory / 2, kUsualMemory) >> 20));
  doctor.row("disk", fmt::format("{} MiB free in {}", free_disk_bytes(folder) >> 20, folder.string()));
  const std::string opener = browser_opener();
  doctor.row("browser", opener.empty() ? "no xdg-open: ilot view prints the address, open it yourself" : opener);
}

// Scans a small district and finds its planes, as a user would.
void try_run(Doctor& doctor, const std::filesystem::path& parent) {
  print(one_line(fmt::format("trial: planes of {} scanned points", grouped(kTrialPoints))));
  const TrialFolder folder(parent);
  const scan::Scene& scene = scan::find_scene("district");
  const scan::ScanRequest request{scene.name, scan::SceneValues(scene.options), 1, kTrialPoints,
                                  folder.path() / "district.laz"};
  with_threads(hardware_threads(), [&] { scene.scan(request); });
  RunOptions options;
  options.inputs = {request.output};
  options.output = folder.path() / "out";
  options.report = false;
  Progress silent;
  const double cpu = cpu_seconds();
  const auto start = std::chrono::steady_clock::now();
  run(options, silent, {});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  doctor.row("run", fmt::format("{:.1f} s, {:.1f} s of processor time, {} points/s", seconds, cpu_seconds() - cpu,
                                grouped(static_cast<std::uint64_t>(kTrialPoints / seconds))));
  with_threads(hardware_threads(), [&] {
    doctor.check("report", write_report(options.output).viewer, "with its view in 3D",
                 "the view in 3D; tools/setup installs npm, then build again");
  });
}

int doctor_command(const std::string& given, bool quick) {
  const std::filesystem::path folder =
      given.empty() ? std::filesystem::temp_directory_path() : std::filesystem::path(given);
  if (!std::filesystem::is_directory(folder)) throw Error(folder.string() + ": is no folder", ExitCode::usage);
  Doctor doctor;
  report_program(doctor);
  report_machine(doctor, folder);
  if (!quick) try_run(doctor, folder);
  print(doctor.missing == 0 ? "nothing is missing\n" : "something is missing, see above\n");
  return static_cast<int>(doctor.missing == 0 ? ExitCode::ok : ExitCode::incomplete);
}

}  // namespace

void add_doctor_command(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("doctor", "Shows what is installed, what is missing, and how fast this machine is");
  auto folder = std::make_shared<std::string>();
  auto quick = std::make_shared<bool>(false);
  command->add_option("FOLDER", *folder, "whose disk is used [the folder for temporary files]")->option_text(" ");
  command->add_flag("--quick", *quick, "without the trial run [off]");
  command->footer("Exit codes: 0 nothing is missing, 3 something is, 1 the trial run failed.\nExample: ilot doctor");
  command->callback([folder, quick, &action] { action = [folder, quick] { return doctor_command(*folder, *quick); }; });
}

}  // namespace ilot
