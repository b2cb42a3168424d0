// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "engine/deliverables/solids/city_json_schema.h"
#include "engine/deliverables/solids/solid_file.h"

namespace ilot {

// Gives the objects of a CityJSON text, or of a sequence line by line, and their faults to a sink.
class CityJsonSolids {
 public:
  CityJsonSolids(std::string name, const SolidFileSink& sink) : name_(std::move(name)), sink_(sink) {}

  // Reads a document or a feature. `line` is for messages, 0 = the file as a whole. Throws Error for broken JSON.
  void text(std::string_view text, std::uint64_t line);
  // Gives the faults of the file as a whole.
  void finish();

 private:
  using Json = nlohmann::json;
  void give(const std::vector<FormatFault>& faults) const;
  void add_objects(const Json& root);
  void add_geometries(const Json& objects, const std::string& id, CityObject& object, const Json& vertices);
  void add_geometry(const Json& geometry, const std::string& owner, CityObject& object, const Json& vertices);

  std::string name_;
  const SolidFileSink& sink_;
  CityJsonHead head_;
  Vec3 scale_{1, 1, 1}, translate_;
  Json templates_;
  bool any_head_ = false;
  std::map<std::uint64_t, std::uint32_t> local_;  // of the current object: vertex of the file -> its own
};

}  // namespace ilot
