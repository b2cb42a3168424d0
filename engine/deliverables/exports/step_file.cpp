// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/step_file.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "engine/report/sha256.h"
#include "engine/version.h"

namespace ilot {
namespace {

// Reads one character of UTF-8 from `at` on and moves `at` behind it. A broken one becomes U+FFFD.
std::uint32_t next_character(std::string_view text, std::size_t& at) {
  const auto first = static_cast<unsigned char>(text[at++]);
  const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
  if (first < 0x80) return first;
  if (more == 0) return 0xFFFD;
  std::uint32_t value = first & (0x3Fu >> more);
  for (int i = 0; i < more; ++i) {
    if (at >= text.size() || (static_cast<unsigned char>(text[at]) & 0xC0) != 0x80) return 0xFFFD;
    value = value << 6 | (static_cast<unsigned char>(text[at++]) & 0x3Fu);
  }
  return value;
}

StepId add_point(StepFile& file, Vec3 at) {
  return file.add("IFCCARTESIANPOINT(" + step_place(at) + ")");
}

StepId add_direction(StepFile& file, Vec3 along) {
  return file.add(fmt::format("IFCDIRECTION(({:.12f},{:.12f},{:.12f}))", along.x, along.y, along.z));
}

StepId add_axes(StepFile& file, Vec3 at, Vec3 axis, Vec3 right) {
  const StepId point = add_point(file, at), z = add_direction(file, axis), x = add_direction(file, right);
  return file.add(fmt::format("IFCAXIS2PLACEMENT3D(#{},#{},#{})", point, z, x));
}

StepId add_units(StepFile& file) {
  std::vector<StepId> units;
  for (const char* unit : {".LENGTHUNIT.,$,.METRE.", ".AREAUNIT.,$,.SQUARE_METRE.", ".VOLUMEUNIT.,$,.CUBIC_METRE.",
                           ".PLANEANGLEUNIT.,$,.RADIAN."})
    units.push_back(file.add(fmt::format("IFCSIUNIT(*,{})", unit)));
  return file.add("IFCUNITASSIGNMENT(" + step_list(units) + ")");
}

// Where metres of the model are in the CRS, in its unit.
void add_map(StepFile& file, const ExportFrame& frame, StepId context) {
  std::string unit = "$";
  if (frame.metres_per_unit != 1) {
    const StepId metre = file.add("IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.)"),
                 exponents = file.add("IFCDIMENSIONALEXPONENTS(1,0,0,0,0,0,0)"),
                 size = file.add(
                     fmt::format("IFCMEASUREWITHUNIT(IFCLENGTHMEASURE({:.12f}),#{})", frame.metres_per_unit, metre));
    unit = fmt::format("#{}", file.add(fmt::format("IFCCONVERSIONBASEDUNIT(#{},.LENGTHUNIT.,'unit of the CRS',#{})",
                                                   exponents, size)));
  }
  const StepId crs = file.add(fmt::format("IFCPROJECTEDCRS({},$,$,$,$,$,{})", step_text(frame.crs_name), unit));
  file.add(fmt::format("IFCMAPCONVERSION(#{},#{},{},{},{},$,$,{})", context, crs, step_real(frame.origin.x),
                       step_real(frame.origin.y), step_real(frame.origin.z),
                       frame.metres_per_unit == 1 ? "$" : fmt::format("{:.12f}", 1 / frame.metres_per_unit)));
}

}  // namespace

std::string step_text(std::string_view text) {
  std::string out = "'";
  for (std::size_t at = 0; at < text.size();) {
    const std::uint32_t c = next_character(text, at);
    if (c == '\'' || c == '\\')
      out += std::string(2, static_cast<char>(c));
    else if (c >= 32 && c < 127)
      out += static_cast<char>(c);
    else
      out += fmt::format("\\X4\\{:08X}\\X0\\", c);
  }
  return out + "'";
}

std::string step_real(double value) {
  return std::isfinite(value) ? fmt::format("{:.6f}", value) : "0.";
}

std::string step_place(Vec3 p) {
  return fmt::format("({},{},{})", step_real(p.x), step_real(p.y), step_real(p.z));
}

std::string step_list(const std::vector<StepId>& ids) {
  std::string text;
  for (const StepId id : ids) text += fmt::format("{}#{}", text.empty() ? "" : ",", id);
  return "(" + text + ")";
}

std::string ifc_guid(std::initializer_list<std::string_view> words) {
  constexpr std::string_view kDigits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$";
  constexpr int kLength = 22, kHex = 32;
  Sha256 hash;
  for (const std::string_view word : words) {
    hash.update(std::as_bytes(std::span(word)));
    hash.update(std::as_bytes(std::span("/", 1)));
  }
  const std::string hex = hash.hex().substr(0, kHex);
  unsigned __int128 value = 0;
  for (const char c : hex) value = value << 4 | static_cast<unsigned>(c <= '9' ? c - '0' : c - 'a' + 10);
  std::string guid(kLength, '0');
  for (int i = kLength - 1; i >= 0; --i, value >>= 6)
    guid[static_cast<std::size_t>(i)] = kDigits[static_cast<std::size_t>(value & 63)];
  return "'" + guid + "'";
}

StepFile::StepFile(const std::filesystem::path& path) : file_(path) {
  const std::string head = fmt::format(
      "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('ViewDefinition [NotAssigned]'),'2;1');\n"
      "FILE_NAME({},'',(''),(''),'ilot {}','ilot {}','');\nFILE_SCHEMA(('IFC4X3_ADD2'));\nENDSEC;\nDATA;\n",
      step_text(path.filename().string()), version(), version());
  file_.append(std::as_bytes(std::span(head)));
}

StepId StepFile::add(const std::string& entity) {
  const std::string line = fmt::format("#{}={};\n", ++last_, entity);
  file_.append(std::as_bytes(std::span(line)));
  return last_;
}

void StepFile::finish() {
  const std::string end = "ENDSEC;\nEND-ISO-10303-21;\n";
  file_.append(std::as_bytes(std::span(end)));
  file_.commit();
}

IfcModel ifc_start(StepFile& file, const ExportFrame& frame, const std::string& name) {
  IfcModel model;
  const StepId units = add_units(file), axes = add_axes(file, {}, {0, 0, 1}, {1, 0, 0});
  model.context = file.add(fmt::format("IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-05,#{},$)", axes));
  if (!frame.crs_name.empty()) add_map(file, frame, model.context);
  model.project = file.add(fmt::format("IFCPROJECT({},$,{},$,$,$,$,(#{}),#{})", ifc_guid({"project", name}),
                                       step_text(name), model.context, units));
  model.site_placement = ifc_placement(file, 0, {});
  const Vec3 o = frame.origin;
  const std::string where = fmt::format("The origin of the model is {} {} {} of the coordinates of the scan",
                                        step_real(o.x), step_real(o.y), step_real(o.z));
  model.site = file.add(fmt::format("IFCSITE({},$,'Site',{},$,#{},$,$,.ELEMENT.,$,$,$,$,$)", ifc_guid({"site", name}),
                                    step_text(where), model.site_placement));
  ifc_aggregate(file, name, model.project, {model.site});
  return model;
}

StepId ifc_placement(StepFile& file, StepId beside, Vec3 at, Vec3 axis, Vec3 right) {
  const StepId axes = add_axes(file, at, axis, right);
  return file.add(fmt::format("IFCLOCALPLACEMENT({},#{})", beside == 0 ? "$" : fmt::format("#{}", beside), axes));
}

StepId ifc_shape(StepFile& file, const IfcModel& model, const char* kind, StepId item) {
  const StepId body = file.add(fmt::format("IFCSHAPEREPRESENTATION(#{},'Body','{}',(#{}))", model.context, kind, item));
  return file.add(fmt::format("IFCPRODUCTDEFINITIONSHAPE($,$,(#{}))", body));
}

void ifc_aggregate(StepFile& file, std::string_view words, StepId whole, const std::vector<StepId>& parts) {
  if (!parts.empty())
    file.add(fmt::format("IFCRELAGGREGATES({},$,$,$,#{},{})", ifc_guid({"parts", words, std::to_string(whole)}), whole,
                         step_list(parts)));
}

void ifc_contain(StepFile& file, std::string_view words, StepId building, const std::vector<StepId>& elements) {
  if (!elements.empty())
    file.add(fmt::format("IFCRELCONTAINEDINSPATIALSTRUCTURE({},$,$,$,{},#{})", ifc_guid({"contained", words}),
                         step_list(elements), building));
}

void ifc_properties(StepFile& file, std::string_view words, StepId element, const char* set,
                    const IfcProperties& properties) {
  std::vector<StepId> values;
  for (const auto& [name, value] : properties)
    values.push_back(file.add(fmt::format("IFCPROPERTYSINGLEVALUE({},$,{},$)", step_text(name), value)));
  if (values.empty()) return;
  const StepId all =
      file.add(fmt::format("IFCPROPERTYSET({},$,'{}',$,{})", ifc_guid({set, words}), set, step_list(values)));
  file.add(fmt::format("IFCRELDEFINESBYPROPERTIES({},$,$,$,(#{}),#{})", ifc_guid({"of", set, words}), element, all));
}

}  // namespace ilot
