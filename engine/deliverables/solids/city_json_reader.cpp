// SPDX-License-Identifier: Apache-2.0
// CityJSON 1.0 to 2.0 (OGC 20-072r5) and CityJSONSeq: one header line, then one feature a line.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "engine/deliverables/solids/json_parts.h"
#include "engine/deliverables/solids/model_file.h"
#include "engine/error.h"

namespace ilot {
namespace {

using Json = nlohmann::json;

struct Transform {
  Vec3 scale{1, 1, 1}, translate;
};

double lod_of(const Json& geometry) {
  const Json& lod = json_field(geometry, "lod");
  if (lod.is_number()) return lod.get<double>();
  double value = -1;
  if (lod.is_string()) {
    const auto& text = lod.get_ref<const std::string&>();
    std::from_chars(text.data(), text.data() + text.size(), value);
  }
  return value;
}

FaceKind kind_of(const std::string& type) {
  if (type == "RoofSurface" || type == "OuterCeilingSurface") return FaceKind::roof;
  if (type == "WallSurface") return FaceKind::wall;
  return type == "GroundSurface" ? FaceKind::ground : FaceKind::unknown;
}

class CityJsonParser {
 public:
  explicit CityJsonParser(const std::string& name) : name_(name) {}

  void document(const Json& root) {
    const Json& type = json_field(root, "type");
    if (type == "CityJSON")
      transform_ = transform_of(json_field(root, "transform"));
    else if (type != "CityJSONFeature")
      fail("neither a CityJSON object nor a CityJSONFeature");
    vertices_ = vertices_of(json_field(root, "vertices"));
    const Json& objects = json_field(root, "CityObjects");
    if (!objects.is_object()) fail("CityObjects is missing or no object");
    for (const auto& [id, object] : objects.items()) add_object(objects, id, object);
  }

  void set_line(std::uint64_t line) { line_ = line; }

  ModelFile finish() {
    ModelFile file;
    for (std::size_t i = 0; i < models_.size(); ++i)
      if ((!any_building_ || is_building_[i]) && !models_[i].faces.empty())
        file.models.push_back(std::move(models_[i]));
    if (templates_) file.warnings.push_back(fmt::format("{}: {} geometry templates left out", name_, templates_));
    return file;
  }

  std::string place() const { return line_ ? fmt::format("{}:{}", name_, line_) : name_; }

  [[noreturn]] void fail(const std::string& what) const { throw Error(place() + ": " + what); }

 private:
  Vec3 vector_of(const Json& list, const std::string& what) const {
    double v[3];
    if (!list.is_array() || list.size() < 3) fail(what + " needs three numbers");
    for (std::size_t i = 0; i < 3; ++i) {
      if (!list[i].is_number() || !std::isfinite(v[i] = list[i].get<double>()))
        fail(what + " needs three finite numbers");
    }
    return {v[0], v[1], v[2]};
  }

  Transform transform_of(const Json& json) const {
    if (json.is_null()) return {};
    return {vector_of(json_field(json, "scale"), "transform.scale"),
            vector_of(json_field(json, "translate"), "transform.translate")};
  }

  std::vector<Vec3> vertices_of(const Json& list) const {
    if (!list.is_array()) fail("vertices is missing or no list");
    std::vector<Vec3> vertices;
    vertices.reserve(list.size());
    for (const Json& entry : list) {
      const Vec3 v = vector_of(entry, "a vertex");
      const auto& [s, t] = transform_;
      const Vec3 world{v.x * s.x + t.x, v.y * s.y + t.y, v.z * s.z + t.z};
      if (!std::isfinite(world.x + world.y + world.z)) fail("a vertex is not finite");
      vertices.push_back(world);
    }
    return vertices;
  }

  // Returns the building to which an object belongs: parents are followed upwards, and a loop of them ends the search.
  static std::string root_of(const Json& objects, std::string id) {
    for (std::size_t step = 0; step < 16; ++step) {
      const Json& parents = json_field(json_field(objects, id.c_str()), "parents");
      if (!parents.is_array() || parents.empty() || !parents[0].is_string()) break;
      id = parents[0].get<std::string>();
    }
    return id;
  }

  void add_object(const Json& objects, const std::string& id, const Json& object) {
    const Json& geometries = json_field(object, "geometry");
    if (geometries.is_null()) return;
    if (!geometries.is_array()) fail("geometry of '" + id + "' is no list");
    const Json* best = nullptr;
    for (const Json& geometry : geometries) {
      if (json_field(geometry, "type") == "GeometryInstance") {
        ++templates_;
      } else if (!best || lod_of(geometry) > lod_of(*best)) {
        best = &geometry;
      }
    }
    if (!best) return;
    const Json& type = json_field(object, "type");
    enter_model(root_of(objects, id), type.is_string() && type.get_ref<const std::string&>().starts_with("Building"));
    local_.clear();
    add_geometry(*best);
  }

  void enter_model(const std::string& name, bool building) {
    const auto [entry, added] = names_.try_emplace(name, models_.size());
    if (added) {
      models_.push_back({name, {}, {}});
      is_building_.push_back(false);
      shells_.push_back(0);
    }
    current_ = entry->second;
    is_building_[current_] = is_building_[current_] || building;
    any_building_ = any_building_ || building;
  }

  void add_geometry(const Json& geometry) {
    const Json& type = json_field(geometry, "type");
    const Json& boundaries = json_field(geometry, "boundaries");
    const Json& semantics = json_field(geometry, "semantics");
    surfaces_ = &json_field(semantics, "surfaces");
    const Json& values = json_field(semantics, "values");
    if (type == "MultiSurface" || type == "CompositeSurface")
      add_shell(boundaries, values);
    else if (type == "Solid")
      add_shells(boundaries, values);
    else if (type == "MultiSolid" || type == "CompositeSolid")
      for (std::size_t i = 0; i < list(boundaries).size(); ++i) add_shells(boundaries[i], child(values, i));
  }

  const Json& list(const Json& json) const {
    if (!json.is_array()) fail("boundaries are not nested as their type asks");
    return json;
  }

  static const Json& child(const Json& values, std::size_t i) {
    static const Json nothing;
    return values.is_array() && i < values.size() ? values[i] : nothing;
  }

  void add_shells(const Json& shells, const Json& values) {
    for (std::size_t i = 0; i < list(shells).size(); ++i) add_shell(shells[i], child(values, i));
  }

  void add_shell(const Json& faces, const Json& values) {
    const std::uint32_t shell = shells_[current_]++;
    for (std::size_t i = 0; i < list(faces).size(); ++i) add_face(faces[i], child(values, i), shell);
  }

  void add_face(const Json& rings, const Json& value, std::uint32_t shell) {
    PolygonFace face;
    face.shell = shell;
    std::size_t corners = 0;
    for (const Json& ring : list(rings)) {
      if ((corners += list(ring).size()) > kMaxCorners)
        fail(fmt::format("a face has more than {} corners", kMaxCorners));
      if (ring.size() < 3) fail("a ring has fewer than three corners");
      face.rings.emplace_back();
      for (const Json& corner : ring) face.rings.back().push_back(vertex(corner));
    }
    if (face.rings.empty()) fail("a face has no ring");
    const Json& surface = value.is_number_integer() && value >= 0 ? child(*surfaces_, value.get<std::size_t>()) : value;
    if (const Json& type = json_field(surface, "type"); type.is_string()) face.kind = kind_of(type.get<std::string>());
    models_[current_].faces.push_back(std::move(face));
  }

  std::uint32_t vertex(const Json& corner) {
    if (!corner.is_number_integer() || corner < 0 || corner >= vertices_.size())
      fail(fmt::format("a face names a vertex that is none of {}", vertices_.size()));
    const auto index = corner.get<std::uint32_t>();
    std::vector<Vec3>& own = models_[current_].vertices;
    const auto [entry, added] = local_.try_emplace(index, static_cast<std::uint32_t>(own.size()));
    if (added) own.push_back(vertices_[index]);
    return entry->second;
  }

  const std::string& name_;
  std::uint64_t line_ = 0;
  Transform transform_;
  std::vector<Vec3> vertices_;
  std::vector<PolygonModel> models_;
  std::vector<bool> is_building_;
  std::vector<std::uint32_t> shells_;  // number so far, per model
  std::unordered_map<std::string, std::size_t> names_;
  std::unordered_map<std::uint32_t, std::uint32_t> local_;  // of the current object: vertex of the file -> the model's
  const Json* surfaces_ = nullptr;
  std::size_t current_ = 0;
  std::uint64_t templates_ = 0;
  bool any_building_ = false;
};

}  // namespace

ModelFile parse_city_json(std::string_view text, const std::string& name) {
  CityJsonParser parser(name);
  if (!is_json_sequence(text)) {
    parser.document(parse_json(text, parser.place()));
    return parser.finish();
  }
  for (std::uint64_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view one = text.substr(0, end);
    parser.set_line(line);
    if (one.find_first_not_of(" \t\r") != one.npos) parser.document(parse_json(one, parser.place()));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parser.finish();
}

}  // namespace ilot
