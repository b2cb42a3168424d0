// SPDX-License-Identifier: Apache-2.0
#include "tools/ilot/manual.h"

#include "engine/settings/parameters.h"
#include "engine/version.h"

namespace ilot {
namespace {

// Protects what the language of man reads as its own: backslashes, dashes, and a point or quote that begins a line.
std::string troff(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    const bool begins = safe.empty() || safe.back() == '\n';
    if (begins && (c == '.' || c == '\'')) safe += "\\&";
    if (c == '\\')
      safe += "\\e";
    else if (c == '-')
      safe += "\\-";
    else
      safe += c;
  }
  return safe;
}

std::string option_entry(const CLI::Option& option) {
  std::string names = option.get_positional() ? option.get_name(true) : option.get_name(false, true);
  for (std::size_t at = names.find(','); at != std::string::npos; at = names.find(',', at + 2))
    names.insert(at + 1, " ");
  const std::string& value = option.get_option_text();
  std::string entry = ".TP\n\\fB" + troff(names) + "\\fR";
  if (!value.empty() && value != " ") entry += " \\fI" + troff(value) + "\\fR";
  return entry + "\n" + troff(option.get_description()) + "\n";
}

std::string command_section(const CLI::App& command) {
  std::string text = ".SS \"ilot " + command.get_name() + "\"\n" + troff(command.get_description()) + ".\n";
  for (const CLI::Option* option : command.get_options({})) text += option_entry(*option);
  if (!command.get_footer().empty()) text += ".PP\n.nf\n" + troff(command.get_footer()) + "\n.fi\n";
  return text;
}

std::string settings_section() {
  std::string text =
      ".SH SETTINGS\nKeys of \\fB\\-\\-config\\fR and \\fB\\-\\-set\\fR. Lengths are metres and angles degrees.\n";
  const Settings standard;
  for (const Parameter& p : parameters()) {
    if (p.advanced) continue;
    text += ".TP\n\\fB" + troff(p.key) + "\\fR [" + troff(to_text(p.get(standard))) + "]\n" + troff(p.help) + "\n";
  }
  return text;
}

}  // namespace

std::string manual_page(const CLI::App& app) {
  std::string text =
      ".TH ILOT 1 \"\" \"ilot " + version() + "\" \"User Commands\"\n.SH NAME\nilot \\- " +
      troff("point clouds of cities into planes, roofs, facades and streets") +
      "\n.SH SYNOPSIS\n\\fBilot\\fR \\fICOMMAND\\fR [\\fIOPTION\\fR]...\n.SH DESCRIPTION\n" +
      troff(app.get_description()) +
      "\nThe first steps: \\fBilot info\\fR \\fICLOUD\\fR shows what a cloud suits, "
      "\\fBilot run\\fR \\fICLOUD\\fR \\fB\\-o\\fR \\fIOUT\\fR works on it, and \\fIOUT/report.html\\fR shows the "
      "result.\n.SH COMMANDS\n";
  for (const CLI::App* command : app.get_subcommands({})) text += command_section(*command);
  text += ".SH OPTIONS\n";
  for (const CLI::Option* option : app.get_options({})) text += option_entry(*option);
  return text + settings_section() + ".SH EXIT STATUS\n.nf\n" + troff(app.get_footer()) + "\n.fi\n";
}

}  // namespace ilot
