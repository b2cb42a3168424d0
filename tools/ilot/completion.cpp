// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "engine/run/products.h"
#include "engine/settings/parameters.h"
#include "tools/ilot/manual.h"
#include "tools/ilot/usage_fault.h"

namespace ilot {
namespace {

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::string products_joined() {
  std::vector<std::string> names;
  for (const Product* product : all_products()) names.push_back(product->name);
  return join(names);
}

std::string keys_joined() {
  std::vector<std::string> keys;
  for (const Parameter& p : parameters()) keys.push_back(p.key + "=");
  return join(keys);
}

// Returns the text between single quotes of a shell. `escape` is what the shell writes for a quote inside.
std::string quoted(std::string text, const std::string& escape) {
  for (std::size_t at = text.find('\''); at != std::string::npos; at = text.find('\'', at + escape.size()))
    text.replace(at, 1, escape);
  return "'" + text + "'";
}

bool has_option(const CLI::App& command, const std::string& name) {
  const auto names = option_names(command);
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Returns one argument of zsh's _arguments for each option.
std::string zsh_options(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options({})) {
    std::string help = option->get_description();
    std::erase_if(help, [](char c) { return c == '[' || c == ']'; });
    std::replace(help.begin(), help.end(), ':', ' ');
    const bool takes = option->get_items_expected_max() > 0;
    for (const std::string& name : option->get_lnames()) {
      std::string values = ":value:_files";
      if (name == "products") values = ":products:_values -s , product " + products_joined();
      if (name == "set" && command.get_name() == "run") values = ":setting:(" + keys_joined() + ")";
      text += " \\\n        " + quoted("*--" + name + "[" + help + "]" + (takes ? values : ""), "'\\''");
    }
  }
  return text;
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  std::string text =
      "# bash completion of ilot, made by `ilot completion bash`\n"
      "_ilot() {\n"
      "  local word=\"${COMP_WORDS[COMP_CWORD]}\" before=\"${COMP_WORDS[COMP_CWORD-1]}\" command=\"${COMP_WORDS[1]}\"\n"
      "  COMPREPLY=()\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
      "    COMPREPLY=($(compgen -W '" +
      join(command_names(app)) +
      " --help --version' -- \"$word\"))\n"
      "    return\n  fi\n"
      "  case \"$command$before\" in\n"
      "    run--products) COMPREPLY=($(compgen -W '" +
      products_joined() +
      "' -- \"$word\")); return ;;\n"
      "    run--set) compopt -o nospace; COMPREPLY=($(compgen -W '" +
      keys_joined() +
      "' -- \"$word\")); return ;;\n"
      "  esac\n"
      "  if [[ \"$word\" != -* ]]; then\n"
      "    compopt -o default\n    return\n  fi\n"
      "  case \"$command\" in\n";
  for (const CLI::App* command : app.get_subcommands({}))
    text += "    " + command->get_name() + ") COMPREPLY=($(compgen -W '" + join(option_names(*command)) +
            "' -- \"$word\")) ;;\n";
  return text + "  esac\n}\ncomplete -F _ilot ilot\n";
}

std::string zsh_completion(const CLI::App& app) {
  std::string text =
      "#compdef ilot\n# zsh completion of ilot, made by `ilot completion zsh`\n"
      "_ilot() {\n  local -a commands\n  commands=(\n";
  for (const CLI::App* command : app.get_subcommands({})) {
    std::string help = command->get_description();
    std::replace(help.begin(), help.end(), ':', ' ');
    text += "    " + quoted(command->get_name() + ":" + help, "'\\''") + "\n";
  }
  text +=
      "  )\n  if (( CURRENT == 2 )); then\n    _describe 'command' commands\n    return\n  fi\n  case $words[2] in\n";
  for (const CLI::App* command : app.get_subcommands({}))
    text += "    " + command->get_name() + ")\n      _arguments" + zsh_options(*command) +
            " \\\n        '*:file:_files' ;;\n";
  return text + "  esac\n}\n_ilot \"$@\"\n";
}

std::string fish_completion(const CLI::App& app) {
  std::string text = "# fish completion of ilot, made by `ilot completion fish`\n";
  const std::string begin = "complete -c ilot -n ";
  for (const CLI::App* command : app.get_subcommands({})) {
    text += begin + "__fish_use_subcommand -a " + command->get_name() + " -d " +
            quoted(command->get_description(), "\\'") + "\n";
    const std::string here = begin + "'__fish_seen_subcommand_from " + command->get_name() + "' ";
    for (const CLI::Option* option : command->get_options({}))
      for (const std::string& name : option->get_lnames())
        text += here + "-l " + name + (option->get_items_expected_max() > 0 ? " -r" : "") + " -d " +
                quoted(option->get_description(), "\\'") + "\n";
    if (has_option(*command, "--products"))
      text += here + "-l products -x -a " + quoted(products_joined(), "\\'") + "\n" + here + "-l set -x -a " +
              quoted(keys_joined(), "\\'") + "\n";
  }
  return text;
}

}  // namespace ilot
