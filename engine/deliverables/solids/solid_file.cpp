// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/solid_file.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <utility>

#include "engine/deliverables/solids/city_json_solids.h"
#include "engine/deliverables/solids/model_file.h"
#include "engine/error.h"

namespace ilot {
namespace {

std::ifstream opened(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) throw Error(path.string() + ": no such file", ExitCode::usage);
  std::ifstream file(path, std::ios::binary);
  if (!file.is_open()) throw Error(path.string() + ": cannot be read");
  return file;
}

CityObject solid_of(PolygonModel&& model) {
  CityObject object{std::move(model.name), "", std::move(model.vertices), {}};
  SolidShell shell;
  for (PolygonFace& face : model.faces) shell.push_back({std::move(face.rings), ""});
  object.primitives.push_back({PrimitiveKind::solid, "", object.id, {{std::move(shell)}}});
  return object;
}

void read_sequence(const std::filesystem::path& path, const SolidFileSink& sink) {
  std::ifstream file = opened(path);
  CityJsonSolids solids(path.string(), sink);
  std::string line;
  for (std::uint64_t number = 1; std::getline(file, line); ++number)
    if (line.find_first_not_of(" \t\r") != line.npos) solids.text(line, number);
  if (file.bad()) throw Error(path.string() + ": cannot be read");
  solids.finish();
}

}  // namespace

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file = opened(path);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) throw Error(path.string() + ": cannot be read");
  return text;
}

bool is_solid_file(const std::filesystem::path& path) {
  constexpr const char* kExtensions[] = {".obj", ".off", ".poly", ".json", ".jsonl"};
  return std::find(std::begin(kExtensions), std::end(kExtensions), lower_extension(path)) != std::end(kExtensions);
}

void read_solids(const std::filesystem::path& path, const SolidFileSink& sink) {
  const std::string extension = lower_extension(path);
  if (extension == ".obj") {
    for (PolygonModel& model : parse_obj(read_text(path), path.string(), path.stem().string(), 1).models)
      sink.object(solid_of(std::move(model)));
  } else if (extension == ".off") {
    sink.object(parse_off(read_text(path), path.string()));
  } else if (extension == ".poly") {
    sink.object(parse_poly(read_text(path), path.string()));
  } else if (extension == ".jsonl") {
    read_sequence(path, sink);
  } else if (extension == ".json") {
    CityJsonSolids solids(path.string(), sink);
    solids.text(read_text(path), 0);
    solids.finish();
  } else {
    throw Error(path.string() + ": not a model that can be read: .obj, .off, .poly, .json or .jsonl (CityJSON)",
                ExitCode::usage);
  }
}

}  // namespace ilot
