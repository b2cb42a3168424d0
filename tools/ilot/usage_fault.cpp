// SPDX-License-Identifier: Apache-2.0
#include "tools/ilot/usage_fault.h"

#include <algorithm>

#include "engine/settings/nearest_name.h"
#include "engine/settings/parameters.h"

namespace ilot {
namespace {

// Returns the settings that an option without its dashes names: `--epsilon` is planes.epsilon, given by --set.
std::string setting_named(const std::string& option) {
  std::string name = option.substr(std::min(option.find_first_not_of('-'), option.size()));
  std::replace(name.begin(), name.end(), '-', '_');
  for (const Parameter& p : parameters())
    if (p.key == name || p.key.substr(p.key.rfind('.') + 1) == name) return p.key;
  return {};
}

std::string unknown_option(const CLI::App& command, const std::string& given, const std::string& help) {
  const std::string option = given.substr(0, given.find('='));
  const std::string where = command.get_parent() == nullptr ? "ilot" : "ilot " + command.get_name();
  std::string text = option + ": " + where + " has no such option";
  if (const std::string key = setting_named(option); !key.empty() && command.get_name() == "run")
    return text + "; settings are given as --set " + key + "=VALUE" + help;
  return text + did_you_mean(option, option_names(command)) + help;
}

std::string unknown_words(const CLI::App& app, const CLI::ParseError& fault) {
  const auto called = app.get_subcommands();
  const CLI::App& command = called.empty() ? app : *called.front();
  const std::string help = called.empty() ? " (ilot --help)" : " (ilot " + command.get_name() + " --help)";
  const std::vector<std::string> words = app.remaining(true);
  if (words.empty()) return fault.what() + help;
  const auto option = std::find_if(words.begin(), words.end(), [](const auto& w) { return w.starts_with("-"); });
  if (called.empty() && !words.front().starts_with("-"))
    return words.front() + ": there is no such command" + did_you_mean(words.front(), command_names(app)) + help;
  if (option != words.end()) return unknown_option(command, *option, help);
  return words.front() + ": ilot " + command.get_name() + " takes no such argument" + help;
}

}  // namespace

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({}))
    if (!command->get_group().empty()) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options({}))
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::string usage_fault(const CLI::App& app, const CLI::ParseError& fault) {
  if (dynamic_cast<const CLI::ExtrasError*>(&fault) != nullptr) return unknown_words(app, fault);
  const auto called = app.get_subcommands();
  const std::string help = called.empty() ? " (ilot --help)" : " (ilot " + called.front()->get_name() + " --help)";
  std::string what = fault.what();
  if (const std::size_t at = what.find(": 1 required "); at != std::string::npos)
    what = what.substr(0, at) + ": a value must follow";
  const std::size_t value = what.find(": Value "), range = what.find(" not in range ");  // the library's words
  if (value != std::string::npos && range != std::string::npos)
    what = what.substr(0, value) + " " + what.substr(value + 8, range - value - 8) + ": a number from " +
           what.substr(range + 14) + " is expected";
  return what + help;
}

}  // namespace ilot
