// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "engine/error.h"
#include "engine/formats/reader.h"
#include "engine/formats/row_buffer.h"
#include "engine/formats/writer.h"
#include "engine/pass/stop.h"
#include "engine/version.h"
#include "tools/ilot/commands.h"
#include "tools/ilot/console.h"
#include "tools/ilot/units.h"

namespace ilot {
namespace {

struct ConvertArguments {
  std::string input, output, dialect, memory = "1G";
  bool overwrite = false, quiet = false;
};

struct Copied {
  std::uint64_t written = 0, rejected = 0;
};

// Moves the valid rows to the front. Returns their number.
std::size_t keep_valid(std::span<std::byte> rows, std::span<const std::uint8_t> valid, std::size_t length) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < valid.size(); ++i) {
    if (valid[i] == 0) continue;
    if (kept != i) std::copy_n(&rows[i * length], length, &rows[kept * length]);
    ++kept;
  }
  return kept;
}

Copied copy_points(PointReader& reader, PointWriter& writer, Progress& progress) {
  const std::size_t length = reader.info().layout.record_length;
  const std::size_t most = rows_at_a_time(length);
  std::vector<std::byte> rows(most * length);
  std::vector<std::uint8_t> valid(most);
  Copied copied;
  for (std::uint64_t first = 0; first < reader.info().points;) {
    if (stop_requested()) throw Error("interrupted: nothing was written", ExitCode::interrupted);
    const auto asked = static_cast<std::size_t>(std::min<std::uint64_t>(most, reader.info().points - first));
    const std::size_t got = reader.read(first, std::span(rows).first(asked * length), std::span(valid).first(asked));
    const std::size_t kept = keep_valid(rows, std::span(valid).first(got), length);
    writer.write(std::span(rows).first(kept * length));
    copied.written += kept;
    copied.rejected += got - kept;
    first += got;
    progress.advance(got);
    if (got < asked) break;
  }
  return copied;
}

// Returns the attributes that the input has and the output, which is opened again, does not have.
std::vector<std::string> lost_attributes(const CloudInfo& from, const CloudInfo& to) {
  std::vector<std::string> lost;
  const auto missing = [&](bool before, bool after, const std::string& name) {
    if (before && !after) lost.push_back(name);
  };
  const auto a = from.layout.point_format, b = to.layout.point_format;
  missing(gps_time_offset(a).has_value(), gps_time_offset(b).has_value(), "GPS time");
  missing(rgb_offset(a).has_value(), rgb_offset(b).has_value(), "colour");
  missing(nir_offset(a).has_value(), nir_offset(b).has_value(), "near infrared");
  const auto waveforms = [](std::uint8_t format) { return format == 4 || format == 5 || format >= 9; };
  missing(waveforms(a), waveforms(b), "waveforms");
  for (const ExtraField& field : from.layout.extra) {
    const bool kept = std::any_of(to.layout.extra.begin(), to.layout.extra.end(),
                                  [&](const ExtraField& other) { return other.name == field.name; });
    missing(true, kept, field.name);
  }
  missing(!from.crs.wkt.empty() || from.crs.epsg != 0, !to.crs.wkt.empty() || to.crs.epsg != 0, "CRS");
  missing(!from.stations.empty(), !to.stations.empty(), "stations");
  missing(!from.vlrs.empty(), !to.vlrs.empty(), "variable-length records");
  return lost;
}

void check_paths(const ConvertArguments& given) {
  std::error_code code;
  if (given.input.empty() || given.output.empty()) {
    throw Error("convert: INPUT and OUTPUT are needed (ilot convert --help)", ExitCode::usage);
  }
  if (!std::filesystem::exists(given.input, code)) {
    throw Error(given.input + ": no such file", ExitCode::usage);
  }
  if (!std::filesystem::exists(given.output, code)) return;
  if (std::filesystem::equivalent(given.input, given.output, code)) {
    throw Error(given.output + ": is the input itself", ExitCode::usage);
  }
  if (!given.overwrite) throw Error(given.output + ": exists; --overwrite replaces it", ExitCode::usage);
}

int convert_command(const ConvertArguments& given) {
  check_paths(given);
  ConsoleProgress console(given.quiet ? Verbosity::quiet : Verbosity::normal, "");
  Progress& progress = console.get();
  const auto reader = open_cloud(given.input, open_options(given.dialect));
  const CloudInfo& info = reader->info();
  if (!info.dialect.empty()) progress.note(given.input + ": text " + info.dialect);
  for (const std::string& warning : info.warnings) progress.warn(given.input + ": " + warning);
  CloudSpec spec{info, {}, "ilot " + version()};
  spec.octree_bytes = parse_bytes("--memory", given.memory);
  const auto writer = create_cloud(given.output, spec);
  progress.begin_stage("convert", info.points);
  const Copied copied = copy_points(*reader, *writer, progress);
  writer->finish();
  progress.end_stage();
  for (const std::string& name : lost_attributes(info, open_cloud(given.output)->info())) {
    progress.note(fmt::format("{}: this format does not keep: {}", given.output, name));
  }
  const std::uint64_t missing = std::max(info.declared_points, info.points) - copied.written;
  if (missing == 0) return static_cast<int>(ExitCode::ok);
  progress.warn(fmt::format("{}: {} of {} points left out, {} of them for unusable coordinates", given.input, missing,
                            missing + copied.written, copied.rejected));
  return static_cast<int>(ExitCode::incomplete);
}

}  // namespace

void add_convert_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("convert", "Copies a point cloud into another format, by extension");
  auto given = std::make_shared<ConvertArguments>();
  command->add_option("INPUT", given->input, "a point cloud")->option_text(" ");
  command->add_option("OUTPUT", given->output, "the file to write; its extension names the format")->option_text(" ");
  add_dialect_option(*command, given->dialect);
  command
      ->add_option("--memory", given->memory,
                   "COPC alone: for its points while they are sorted, with K, M, G or T [1G]")
      ->option_text("BYTES");
  command->add_flag("--overwrite", given->overwrite, "replace OUTPUT [off]");
  command->add_flag("-q,--quiet", given->quiet, "say only what is wrong [off]");
  command->footer("Example: ilot convert district.las district.ply");
  command->callback([given, &action] { action = [given] { return convert_command(*given); }; });
}

}  // namespace ilot
