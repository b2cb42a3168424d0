// SPDX-License-Identifier: Apache-2.0
// CityJSON 1.0 to 2.0 (OGC 20-072r5) and CityJSONSeq: one header line, then one feature a line.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
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

// True when a level of detail is the wanted one: "2" asks for 2, 2.0, 2.1, ...
bool is_level(const Json& lod, const std::string& wanted) {
  const std::string text = lod.is_number()   ? fmt::format("{}", lod.get<double>())
                           : lod.is_string() ? lod.get<std::string>()
                                             : std::string();
  return text == wanted || text.starts_with(wanted + ".");
}

// Returns the text that crs_from_text() takes for ".../EPSG/0/7415", "urn:ogc:def:crs:EPSG::7415" or "EPSG:7415".
std::string crs_text(const Json& metadata) {
  const Json& json = json_field(metadata, "referenceSystem");
  if (!json.is_string()) return "";
  const auto& text = json.get_ref<const std::string&>();
  const std::size_t at = text.find_last_of("/:");
  const std::string code = at == text.npos ? text : text.substr(at + 1);
  const bool whole = !code.empty() && code.find_first_not_of("0123456789") == code.npos;
  return whole && text.find("EPSG") != text.npos ? "EPSG:" + code : "";
}

class CityJsonParser {
 public:
  CityJsonParser(const std::string& name, const ModelReading& wanted) : name_(name), wanted_(wanted) {}

  void document(const Json& root) {
    const Json& type = json_field(root, "type");
    if (type == "CityJSON")
      head(root);
    else if (type != "CityJSONFeature")
      fail("neither a CityJSON object nor a CityJSONFeature");
    vertices_ = vertices_of(json_field(root, "vertices"), transform_);
    const Json& objects = json_field(root, "CityObjects");
    if (!objects.is_object()) fail("CityObjects is missing or no object");
    for (const auto& [id, object] : objects.items()) add_object(objects, id, object);
  }

  void set_line(std::uint64_t line) { line_ = line; }

  ModelFile finish() {
    ModelFile file;
    for (std::size_t i = 0; i < models_.size(); ++i)
      if ((!any_building_ || is_building_[i] || wanted_.every_object) && !models_[i].faces.empty())
        file.models.push_back(std::move(models_[i]));
    if (file.models.empty() && other_level_ > 0)
      throw Error(fmt::format("{}: no geometry of level of detail {}; there is {}", name_, wanted_.lod,
                              fmt::join(levels_, ", ")));
    if (other_level_)
      file.warnings.push_back(
          fmt::format("{}: {} objects without level of detail {} left out", name_, other_level_, wanted_.lod));
    file.crs = crs_;
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

  void head(const Json& root) {
    transform_ = transform_of(json_field(root, "transform"));
    crs_ = crs_text(json_field(root, "metadata"));
    const Json& templates = json_field(root, "geometry-templates");
    if (templates.is_null()) return;
    templates_ = json_field(templates, "templates");
    template_vertices_ = vertices_of(json_field(templates, "vertices-templates"), {});
  }

  std::vector<Vec3> vertices_of(const Json& list, const Transform& transform) const {
    if (!list.is_array()) fail("vertices is missing or no list");
    std::vector<Vec3> vertices;
    vertices.reserve(list.size());
    for (const Json& entry : list) {
      const Vec3 v = vector_of(entry, "a vertex");
      const auto& [s, t] = transform;
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
      const Json& shape = shape_of(geometry);
      const bool wanted = wanted_.lod.empty() || is_level(json_field(shape, "lod"), wanted_.lod);
      if (!wanted) levels_.insert(json_field(shape, "lod").dump());
      if (wanted && (!best || lod_of(shape) > lod_of(shape_of(*best)))) best = &geometry;
    }
    if (!best && !geometries.empty()) ++other_level_;
    if (!best) return;
    const Json& type = json_field(object, "type");
    object_type_ = type.is_string() ? type.get<std::string>() : "";
    enter_model(root_of(objects, id), object_type_.starts_with("Building"));
    local_.clear();
    place_.reset();
    if (json_field(*best, "type") == "GeometryInstance") place_ = place_of(*best);
    add_geometry(shape_of(*best));
  }

  // Returns the template of an instance; any other geometry is its own shape.
  const Json& shape_of(const Json& geometry) const {
    if (json_field(geometry, "type") != "GeometryInstance") return geometry;
    const Json& number = json_field(geometry, "template");
    if (!number.is_number_integer() || number < 0 || !templates_.is_array() || number >= templates_.size())
      fail("an instance names a geometry template that does not exist");
    const Json& shape = templates_[number.get<std::size_t>()];
    if (json_field(shape, "type") == "GeometryInstance") fail("a geometry template is an instance itself");
    return shape;
  }

  // How the vertices of a template get to their places: a matrix by rows, then the reference point.
  struct InstancePlace {
    std::array<double, 16> matrix{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    Vec3 point;

    Vec3 of(Vec3 v) const {
      const auto row = [&](std::size_t r) {
        return matrix[4 * r] * v.x + matrix[4 * r + 1] * v.y + matrix[4 * r + 2] * v.z + matrix[4 * r + 3];
      };
      return point + Vec3{row(0), row(1), row(2)};
    }
  };

  InstancePlace place_of(const Json& instance) const {
    InstancePlace place;
    const Json& matrix = json_field(instance, "transformationMatrix");
    if (!matrix.is_array() || matrix.size() != 16) fail("an instance needs a matrix of 16 numbers");
    for (std::size_t i = 0; i < 16; ++i) {
      if (!matrix[i].is_number() || !std::isfinite(place.matrix[i] = matrix[i].get<double>()))
        fail("an instance needs a matrix of 16 finite numbers");
    }
    const Json& at = json_field(instance, "boundaries");
    if (!at.is_array() || at.size() != 1) fail("an instance needs one reference point");
    place.point = vertices_[vertex_index(at[0], vertices_.size())];
    return place;
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
    const Json& values = json_field(semantics, "values");
    add_surfaces(json_field(semantics, "surfaces"));
    if (type == "MultiSurface" || type == "CompositeSurface")
      add_shell(boundaries, values);
    else if (type == "Solid")
      add_shells(boundaries, values);
    else if (type == "MultiSolid" || type == "CompositeSolid")
      for (std::size_t i = 0; i < list(boundaries).size(); ++i) add_shells(boundaries[i], child(values, i));
  }

  // Appends the semantic surfaces of a geometry, and one for faces without semantics before them.
  void add_surfaces(const Json& surfaces) {
    std::vector<ModelSurface>& own = models_[current_].surfaces;
    first_surface_ = own.size() + 1;
    surface_count_ = surfaces.is_array() ? surfaces.size() : 0;
    own.push_back({"", "", -1, object_type_, ""});
    for (std::size_t i = 0; i < surface_count_; ++i) {
      const auto text = [&](const char* key) {
        const Json& field = json_field(surfaces[i], key);
        return field.is_string() ? field.get<std::string>() : std::string();
      };
      ModelSurface surface{text("type"), text("id"), -1, object_type_, ""};
      const Json& parent = json_field(surfaces[i], "parent");
      if (parent.is_number_integer() && parent >= 0 && parent < surface_count_)
        surface.parent = static_cast<std::int32_t>(first_surface_ + parent.get<std::size_t>());
      own.push_back(std::move(surface));
    }
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
    const bool named = value.is_number_integer() && value >= 0 && value < surface_count_;
    const std::size_t surface = named ? first_surface_ + value.get<std::size_t>() : first_surface_ - 1;
    face.surface = static_cast<std::int32_t>(surface);
    face.kind = kind_of(models_[current_].surfaces[surface].type);
    models_[current_].faces.push_back(std::move(face));
  }

  std::uint32_t vertex_index(const Json& corner, std::size_t count) const {
    if (!corner.is_number_integer() || corner < 0 || corner >= count)
      fail(fmt::format("a face names a vertex that is none of {}", count));
    return corner.get<std::uint32_t>();
  }

  std::uint32_t vertex(const Json& corner) {
    const std::uint32_t index = vertex_index(corner, place_ ? template_vertices_.size() : vertices_.size());
    std::vector<Vec3>& own = models_[current_].vertices;
    const auto [entry, added] = local_.try_emplace(index, static_cast<std::uint32_t>(own.size()));
    if (added) own.push_back(place_ ? place_->of(template_vertices_[index]) : vertices_[index]);
    return entry->second;
  }

  const std::string& name_;
  ModelReading wanted_;
  std::uint64_t line_ = 0;
  Transform transform_;
  std::string crs_, object_type_;
  std::vector<Vec3> vertices_, template_vertices_;
  Json templates_;
  std::optional<InstancePlace> place_;                 // of the current object, where its geometry is an instance
  std::size_t first_surface_ = 0, surface_count_ = 0;  // of the current geometry
  std::set<std::string> levels_;                       // levels of detail that were not wanted
  std::vector<PolygonModel> models_;
  std::vector<bool> is_building_;
  std::vector<std::uint32_t> shells_;  // number so far, per model
  std::unordered_map<std::string, std::size_t> names_;
  std::unordered_map<std::uint32_t, std::uint32_t> local_;  // of the current object: vertex of the file -> the model's
  std::size_t current_ = 0;
  std::uint64_t other_level_ = 0;  // objects
  bool any_building_ = false;
};

}  // namespace

ModelFile parse_city_json(std::string_view text, const std::string& name, const ModelReading& wanted) {
  CityJsonParser parser(name, wanted);
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
