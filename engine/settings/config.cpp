// SPDX-License-Identifier: Apache-2.0
#include "engine/settings/config.h"

#include <toml++/toml.h>

#include <cerrno>
#include <fstream>
#include <sstream>

#include "engine/error.h"
#include "engine/settings/parameters.h"
#include "engine/system_reason.h"

namespace ilot {
namespace {

constexpr std::uintmax_t kMaxConfigBytes = 1u << 20;

struct Fault {
  toml::source_position where;
  std::string sentence;
};

std::string place(const std::string& name, toml::source_position where) {
  return name + ":" + std::to_string(where.line) + ":" + std::to_string(where.column) + ": ";
}

std::string describe(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list of other values";
    case toml::node_type::string:
      return "a string";
    default:
      return "a date or time";
  }
}

// Returns the node as a Value; nullopt when no setting could have it.
std::optional<Value> read_value(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get() == "auto" ? Value(Auto{}) : Value(text->get());
  if (const auto* flag = node.as_boolean()) return flag->get();
  if (const auto* whole = node.as_integer()) return whole->get();
  if (const auto* number = node.as_floating_point()) return number->get();
  const toml::array* array = node.as_array();
  if (array == nullptr) return std::nullopt;
  std::vector<std::int64_t> whole;
  std::vector<double> numbers;
  for (const toml::node& entry : *array) {
    if (const auto* v = entry.as_integer()) {
      whole.push_back(v->get());
      numbers.push_back(static_cast<double>(v->get()));
    } else if (const auto* d = entry.as_floating_point()) {
      numbers.push_back(d->get());
    } else {
      return std::nullopt;
    }
  }
  return whole.size() == numbers.size() ? Value(whole) : Value(numbers);
}

// Returns the line with a character beyond ASCII outside a comment, from 1; nullopt when there is none. No setting
// needs one, and the result of the parser is undefined for some of them where a key could be.
std::optional<std::uint32_t> line_beyond_ascii(std::string_view text) {
  std::uint32_t line = 1;
  bool comment = false, quoted = false;
  for (const char c : text) {
    if (c == '\n') {
      ++line;
      comment = quoted = false;
    } else if (c == '#' && !quoted) {
      comment = true;
    } else if (!comment) {
      quoted |= c == '"' || c == '\'';
      if (static_cast<unsigned char>(c) > 127) return line;
    }
  }
  return std::nullopt;
}

// True for a bare word, as people type it on a command line: auto, ransac. False for true, false, inf and nan.
bool is_word(const std::string& text) {
  const bool letters = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == std::string::npos;
  return letters && !text.empty() && text != "true" && text != "false" && text != "inf" && text != "nan";
}

bool is_section(const std::string& key) {
  for (const Parameter& p : parameters()) {
    if (p.key.starts_with(key + ".")) return true;
  }
  return false;
}

Fault unknown(const std::string& key, toml::source_position where) {
  return {where, "unknown setting '" + key + "'" + did_you_mean_parameter(key)};
}

std::optional<Fault> assign(Settings& settings, const std::string& key, toml::source_position key_place,
                            const toml::node& node) {
  const Parameter* parameter = find_parameter(key);
  if (parameter == nullptr) return unknown(key, key_place);
  const std::optional<Value> value = read_value(node);
  const toml::source_position value_place = node.is_table() ? key_place : node.source().begin;
  if (!value) {
    return Fault{value_place, key + " must be " + expected_text(*parameter) + ", not " + describe(node)};
  }
  if (auto problem = check_value(*parameter, *value)) return Fault{value_place, *problem};
  parameter->set(settings, *value);
  return std::nullopt;
}

std::optional<Fault> assign_table(Settings& settings, const toml::table& table, const std::string& prefix) {
  for (const auto& [name, node] : table) {
    const std::string key = prefix.empty() ? std::string(name.str()) : prefix + "." + std::string(name.str());
    std::optional<Fault> fault;
    if (node.is_table() && is_section(key)) {
      fault = assign_table(settings, *node.as_table(), key);
    } else if (!node.is_table() && is_section(key)) {
      fault = Fault{name.source().begin, "'" + key + "' is a section: write [" + key + "]"};
    } else if (node.is_table() && find_parameter(key) == nullptr && !node.as_table()->empty()) {
      const auto first = node.as_table()->begin();
      fault = unknown(key + "." + std::string(first->first.str()), name.source().begin);
    } else {
      fault = assign(settings, key, name.source().begin, node);
    }
    if (fault) return fault;
  }
  return std::nullopt;
}

std::string comment_of(const Parameter& p, const Value& standard) {
  std::string text = p.help;
  if (const std::string range = range_text(p); !range.empty()) text += "; " + range;
  if (p.optional) text += " or \"auto\"";
  return text + " [" + to_text(standard) + "]";
}

}  // namespace

void load_config_text(Settings& settings, std::string_view text, const std::string& name) {
  if (const auto line = line_beyond_ascii(text)) {
    throw Error(place(name, {*line, 1}) + "a character beyond ASCII; only comments may contain them", ExitCode::usage);
  }
  toml::table table;
  try {
    table = toml::parse(text, name);
  } catch (const toml::parse_error& fault) {
    throw Error(place(name, fault.source().begin) + std::string(fault.description()), ExitCode::usage);
  }
  Settings changed = settings;
  if (auto fault = assign_table(changed, table, "")) {
    throw Error(place(name, fault->where) + fault->sentence, ExitCode::usage);
  }
  settings = changed;
}

// The file is read to its end, because a pipe has no size.
void load_config(Settings& settings, const std::filesystem::path& path) {
  const auto fail = [&](const std::string& why) { throw Error(path.string() + ": " + why, ExitCode::usage); };
  if (std::filesystem::is_directory(path)) fail("is a folder, not a configuration");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) fail("cannot read the configuration: " + system_reason(errno));
  std::string text(kMaxConfigBytes + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) fail("cannot read the configuration");
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > kMaxConfigBytes) fail("larger than 1 MiB, so not a configuration of ilot");
  load_config_text(settings, text, path.string());
}

void apply_assignment(Settings& settings, std::string_view assignment) {
  const auto fail = [&](const std::string& sentence) {
    throw Error("--set " + std::string(assignment.substr(0, 200)) + ": " + sentence, ExitCode::usage);
  };
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos || equals == 0) fail("expected KEY=VALUE, as in planes.epsilon=0.02");
  const std::string key(assignment.substr(0, equals));
  if (find_parameter(key) == nullptr) fail(unknown(key, {}).sentence);
  std::string text(assignment.substr(equals + 1));
  if (text.find_first_of("\r\n") != std::string::npos) fail("the value must stand on one line");
  if (line_beyond_ascii(text)) fail("a character beyond ASCII");
  if (is_word(text)) text = '"' + text + '"';
  try {
    const toml::table table = toml::parse("value = " + text);
    if (auto fault = assign(settings, key, {}, *table.get("value"))) fail(fault->sentence);
  } catch (const toml::parse_error&) {
    fail("'" + text + "' is not a value; examples: 0.02, 16, true, auto, [7, 18]");
  }
}

std::string print_config(const Settings& settings) {
  std::ostringstream out;
  out << "# Settings of ilot: meaning; range [default]. Lengths in metres, angles in degrees.\n"
      << "# Order: default, then this file, then --set.\n";
  const Settings standard;
  std::string section, advanced;
  for (const Parameter& p : parameters()) {
    const std::size_t dot = p.key.find('.');
    const std::string group = dot == std::string::npos ? "" : p.key.substr(0, dot);
    if (group != section) out << "\n[" << group << "]\n";
    if (p.advanced && group != advanced) out << "\n# Advanced: these defaults rarely need a change.\n";
    if (p.advanced) advanced = group;
    section = group;
    out << "# " << comment_of(p, p.get(standard)) << "\n"
        << (dot == std::string::npos ? p.key : p.key.substr(dot + 1)) << " = " << to_text(p.get(settings)) << "\n";
  }
  return out.str();
}

std::string parameters_markdown() {
  static constexpr const char* kHead = "| key | default | range | meaning |\n|---|---|---|---|\n";
  const std::string kAdvanced =
      "\n## Advanced\n\nDefaults that rarely need a change. Where each is from: [constants.md](constants.md).\n\n" +
      std::string(kHead);
  std::ostringstream out;
  out << "# Parameters\n\n"
      << "Generated from the table in `engine/settings/parameter_table.cpp`. Each is a key of the configuration "
         "file\n"
      << "(`--config`) and of `--set KEY=VALUE`. Lengths are metres and angles degrees, whatever the unit of "
         "the input.\n\n"
      << kHead;
  const Settings standard;
  for (const bool advanced : {false, true}) {
    if (advanced) out << kAdvanced;
    for (const Parameter& p : parameters()) {
      if (p.advanced != advanced) continue;
      std::string range = p.kind == ParameterKind::boolean ? "true or false" : range_text(p);
      if (p.optional) range += ", or `auto`";
      out << "| `" << p.key << "` | `" << to_text(p.get(standard)) << "` | " << range << " | " << p.help << " |\n";
    }
  }
  return out.str();
}

std::string settings_json(const Settings& settings) {
  std::string text;
  for (const Parameter& p : parameters()) {
    text += (text.empty() ? "\"" : ", \"") + p.key + "\": " + to_text(p.get(settings));
  }
  return "{" + text + "}";
}

std::uint64_t settings_hash(const Settings& settings) {
  std::uint64_t hash = 0xcbf29ce484222325ull;  // FNV-1a
  for (unsigned char byte : settings_json(settings)) hash = (hash ^ byte) * 0x100000001b3ull;
  return hash;
}

std::vector<std::string> differing_keys(const Settings& a, const Settings& b) {
  std::vector<std::string> keys;
  for (const Parameter& p : parameters()) {
    if (p.get(a) != p.get(b)) keys.push_back(p.key);
  }
  return keys;
}

}  // namespace ilot
