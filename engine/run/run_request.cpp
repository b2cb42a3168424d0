// SPDX-License-Identifier: Apache-2.0
#include "engine/run/run_request.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "engine/formats/arrays/array_reader.h"
#include "engine/formats/file.h"
#include "engine/formats/remote_file.h"
#include "engine/report/path_text.h"
#include "engine/report/sha256.h"
#include "engine/settings/config.h"
#include "engine/version.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string sum_of(const json& value) {
  Sha256 sum;
  const std::string text = value.dump();
  sum.update(std::as_bytes(std::span(text)));
  return sum.hex();
}

json file_json(const fs::path& path) {
  if (is_remote(path)) {
    const RemoteFile file(path);
    return {{"path", path_text(path)}, {"bytes", file.size()}, {"modified", file.modified()}, {"ends", ends_of(path)}};
  }
  std::error_code ignored;
  return {{"path", path_text(fs::absolute(path).lexically_normal())},
          {"bytes", fs::file_size(path, ignored)},
          {"modified", fs::last_write_time(path, ignored).time_since_epoch().count()},
          {"ends", fs::is_regular_file(path, ignored) ? json(ends_of(path)) : json()}};
}

json named_file(const fs::path& path) {
  return path.empty() ? json() : file_json(path);
}

// The content of a table counts, not its date.
json edits_json(const std::vector<fs::path>& paths) {
  json list = json::array();
  for (const fs::path& path : paths) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    Sha256 sum;
    sum.update(std::as_bytes(std::span(text)));
    list.push_back(sum.hex());
  }
  return list;
}

// Clouds in memory follow those of files, in the order of the options.
json inputs_json(const RunOptions& options, const RunInputs& inputs) {
  json list = json::array();
  auto in_memory = options.arrays.begin();
  for (const auto& reader : inputs.readers) {
    const CloudInfo& info = reader->info();
    list.push_back(is_in_memory(info) ? json{{"path", info.path.string()}, {"content", content_sum(*in_memory++)}}
                                      : file_json(info.path));
    list.back()["points"] = reader->info().points;
  }
  return list;
}

json stations_json(const std::vector<Station>& stations) {
  json list = json::array();
  for (const Station& s : stations)
    list.push_back(
        {s.position.x, s.position.y, s.position.z, s.azimuth_step, s.elevation_step, s.axis.x, s.axis.y, s.axis.z});
  return sum_of(list);
}

json area_json(const std::optional<Area>& area) {
  if (!area) return nullptr;
  return {{"box", {area->min_x, area->min_y, area->max_x, area->max_y}}, {"rings", sum_of(area->rings)}};
}

// The block size is left out, because that of the first run is used.
json settings_of(const RunOptions& options) {
  Settings settings = options.settings;
  settings.index.block_points = 0;
  return json::parse(settings_json(settings));
}

class Names {
 public:
  void add(const std::string& name) { text_ += (text_.empty() ? "" : ", ") + name; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

const json* input_of(const json& inputs, const json& path) {
  for (const json& input : inputs)
    if (input.value("path", json()) == path) return &input;
  return nullptr;
}

// Names up to three of the inputs: "inputs (a.laz changed, b.laz added and 5 more)".
std::string changed_inputs(const json& before, const json& now) {
  constexpr std::size_t kNamed = 3;
  std::vector<std::string> changes;
  const auto note = [&](const json& input, const char* how) {
    changes.push_back(fs::path(input.value("path", "")).filename().string() + how);
  };
  for (const json& input : now) {
    const json* was = input_of(before, input["path"]);
    if (was == nullptr) note(input, " added");
    if (was != nullptr && *was != input) note(input, " changed");
  }
  for (const json& input : before)
    if (input_of(now, input.value("path", json())) == nullptr) note(input, " left out");
  std::string text;
  for (std::size_t i = 0; i < std::min(changes.size(), kNamed); ++i) text += (i == 0 ? "" : ", ") + changes[i];
  if (changes.size() > kNamed) text += " and " + std::to_string(changes.size() - kNamed) + " more";
  return "inputs (" + text + ")";
}

}  // namespace

std::string ends_of(const fs::path& path) {
  constexpr std::size_t kEnd = 4096;
  const InputFile file(path);
  std::array<std::byte, kEnd> bytes;
  Sha256 sum;
  sum.update(std::span(bytes).first(file.read_at(0, bytes)));
  sum.update(std::span(bytes).first(file.read_at(file.size() - std::min<std::uint64_t>(file.size(), kEnd), bytes)));
  return sum.hex();
}

std::string run_request(const RunOptions& options, const RunInputs& inputs) {
  const json request{{"version", version()},
                     {"git_hash", git_hash()},
                     {"inputs", inputs_json(options, inputs)},
                     {"settings", settings_of(options)},
                     {"area", area_json(options.area)},
                     {"footprints", named_file(options.footprints)},
                     {"id_field", options.id_field},
                     {"train", named_file(options.train)},
                     {"edits", edits_json(options.edits)},
                     {"stations", stations_json(inputs.stations)},
                     {"products", options.products},
                     {"crs", options.crs},
                     {"to_crs", options.to_crs},
                     {"text_dialect", options.dialect ? words_of(*options.dialect) : ""},
                     {"clouds", options.clouds}};
  return request.dump();
}

std::string request_differences(const std::string& before_text, const std::string& now_text, Compare what) {
  const json before = json::parse(before_text, nullptr, false), now = json::parse(now_text);
  if (!before.is_object()) return "everything";
  Names names;
  for (const auto& [key, value] : now.items()) {
    const json was = before.value(key, json());
    if (was == value || (key == "clouds" && what == Compare::store)) continue;
    if (key == "settings" && was.is_object()) {
      for (const auto& [name, setting] : value.items())
        if (was.value(name, json()) != setting) names.add(name);
    } else if (key == "inputs" && was.is_array()) {
      names.add(changed_inputs(was, value));
    } else {
      names.add(key);
    }
  }
  return names.text();
}

}  // namespace ilot
