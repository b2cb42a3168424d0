// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/roofs_gml.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/deliverables/solids/city_json.h"
#include "engine/markup.h"
#include "engine/version.h"

namespace ilot {
namespace {

constexpr const char* kHead =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<CityModel xmlns=\"http://www.opengis.net/citygml/2.0\" xmlns:gml=\"http://www.opengis.net/gml\"\n"
    " xmlns:bldg=\"http://www.opengis.net/citygml/building/2.0\" "
    "xmlns:gen=\"http://www.opengis.net/citygml/generics/2.0\"\n"
    " xmlns:xlink=\"http://www.w3.org/1999/xlink\" xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\"\n"
    " xsi:schemaLocation=\"http://www.opengis.net/citygml/building/2.0 "
    "http://schemas.opengis.net/citygml/building/2.0/building.xsd http://www.opengis.net/citygml/generics/2.0 "
    "http://schemas.opengis.net/citygml/generics/2.0/generics.xsd\">\n";

// XML has no control characters.
std::string xml_text(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32) c = ' ';
  return escaped_markup(text);
}

std::string ring_text(const Building& building, const std::vector<std::uint32_t>& ring) {
  std::string text = "<gml:LinearRing><gml:posList srsDimension=\"3\">";
  for (std::size_t i = 0; i <= ring.size(); ++i) {  // the first corner again at the end
    const Vec3 v = building.vertices[ring[i % ring.size()]];
    text += fmt::format("{}{:.4f} {:.4f} {:.4f}", i ? " " : "", v.x, v.y, v.z);
  }
  return text + "</gml:posList></gml:LinearRing>";
}

std::string polygon_text(const Building& building, const BuildingSurface& surface, const std::string& id) {
  std::string text = id.empty() ? "<gml:Polygon>" : fmt::format("<gml:Polygon gml:id=\"{}\">", id);
  for (std::size_t i = 0; i < surface.rings.size(); ++i) {
    const char* side = i ? "interior" : "exterior";
    text += fmt::format("<gml:{0}>{1}</gml:{0}>", side, ring_text(building, surface.rings[i]));
  }
  return text + "</gml:Polygon>";
}

std::string member(const std::string& polygon) {
  return "<gml:surfaceMember>" + polygon + "</gml:surfaceMember>\n";
}

// Names of polygons: those of the building's number, because an id may have any characters and XML names may not.
std::string polygon_id(std::uint64_t building, std::size_t surface) {
  return fmt::format("b{}_s{}", building, surface + 1);
}

std::string solid_text(const char* property, const std::string& srs, const std::string& members) {
  return fmt::format(
      "<bldg:{0}><gml:Solid{1}><gml:exterior><gml:CompositeSurface>\n{2}</gml:CompositeSurface></gml:exterior>"
      "</gml:Solid></bldg:{0}>\n",
      property, srs, members);
}

// The solid names the polygons that its bounding surfaces have.
std::string lod2_text(const Building& level, std::uint64_t number, const std::string& srs) {
  std::string members, boundary;
  for (std::size_t i = 0; i < level.surfaces.size(); ++i) {
    const BuildingSurface& surface = level.surfaces[i];
    const std::string id = polygon_id(number, i);
    members += fmt::format("<gml:surfaceMember xlink:href=\"#{}\"/>\n", id);
    const std::string plane =
        surface.plane_id == 0
            ? ""
            : fmt::format("<gen:intAttribute name=\"plane_id\"><gen:value>{}</gen:value></gen:intAttribute>",
                          surface.plane_id);
    boundary += fmt::format(
        "<bldg:boundedBy><bldg:{0}>{1}<bldg:lod2MultiSurface><gml:MultiSurface{2}>\n{3}</gml:MultiSurface>"
        "</bldg:lod2MultiSurface></bldg:{0}></bldg:boundedBy>\n",
        surface_type(surface.kind), plane, srs, member(polygon_text(level, surface, id)));
  }
  return solid_text("lod2Solid", srs, members) + boundary;
}

std::string polygons(const Building& level) {
  std::string members;
  for (const BuildingSurface& surface : level.surfaces) members += member(polygon_text(level, surface, ""));
  return members;
}

// Levels in the order of the schema: footprint, lod1, lod2. It has one place for LoD1, which LoD1.2 takes.
std::string geometry_text(const BuildingModel& model, std::uint64_t number, const std::string& srs) {
  std::string text;
  for (const char first : {'0', '1', '2'})
    for (const Building& level : model.levels) {
      if (level.surfaces.empty() || level.lod[0] != first || level.lod == "1.3") continue;
      if (first == '0')
        text += fmt::format("<bldg:lod0FootPrint><gml:MultiSurface{}>\n{}</gml:MultiSurface></bldg:lod0FootPrint>\n",
                            srs, polygons(level));
      if (first == '1') text += solid_text("lod1Solid", srs, polygons(level));
      if (first == '2') text += lod2_text(level, number, srs);
    }
  return text;
}

std::string attribute_text(const std::string& name, const AttributeValue& value) {
  const auto text = [&](const char* kind, const std::string& written) {
    return fmt::format("<gen:{0} name=\"{1}\"><gen:value>{2}</gen:value></gen:{0}>\n", kind, xml_text(name), written);
  };
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return text("intAttribute", fmt::format("{}", *whole));
  if (const auto* number = std::get_if<double>(&value)) {
    return std::isfinite(*number) ? text("doubleAttribute", fmt::format("{}", *number)) : "";
  }
  if (const auto* truth = std::get_if<bool>(&value)) return text("stringAttribute", *truth ? "true" : "false");
  return text("stringAttribute", xml_text(std::get<std::string>(value)));
}

}  // namespace

RoofsGml::RoofsGml(const std::filesystem::path& path, const ExportFrame& frame) : file_(path) {
  if (!frame.crs_name.empty() && frame.crs.epsg != 0)
    // This form of the name means east before north; the form urn:ogc:def:crs: means the order that EPSG gives.
    srs_ = fmt::format(" srsName=\"EPSG:{}\" srsDimension=\"3\"", frame.crs.epsg);
  append(kHead + fmt::format("<gml:description>Buildings from a point cloud, ilot {}</gml:description>\n", version()));
}

void RoofsGml::append(const std::string& text) {
  file_.append(std::as_bytes(std::span(text)));
}

void RoofsGml::add(const BuildingModel& model) {
  ++building_;
  std::string text = fmt::format("<cityObjectMember><bldg:Building gml:id=\"b{}\"><gml:name>{}</gml:name>\n", building_,
                                 xml_text(model.id));
  for (const auto& [name, value] : model.attributes) text += attribute_text(name, value);
  append(text + geometry_text(model, building_, srs_) + "</bldg:Building></cityObjectMember>\n");
}

void RoofsGml::finish() {
  append("</CityModel>\n");
  file_.commit();
}

}  // namespace ilot
