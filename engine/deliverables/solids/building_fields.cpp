// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/building_fields.h"

#include <fmt/format.h>

#include <algorithm>

namespace ilot {
namespace {

constexpr auto kWhole = FieldKind::whole;
constexpr auto kReal = FieldKind::real;
constexpr auto kText = FieldKind::text;
constexpr auto kTruth = FieldKind::truth;

constexpr BuildingField kBuildingFields[] = {
    {"status", kText, "", "`lod22`; `lod12`: one level roof only; `footprint_only`: no solid", nullptr},
    {"reason", kText, "", "in words, why not `lod22`", nullptr},
    {"points", kWhole, "", "of the building", nullptr},
    {"points_of", kText, "",
     "`unclassified`: there was none of class `classes.building`, those of classes 0, 1 and 12 were taken; where "
     "ground "
     "was measured those 1 m above it",
     nullptr},
    {"by_hand", kText, "", "what a person has corrected: classes of points that count for the building, faces merged",
     nullptr},
    {"h_ground", kReal, "CRS", "height of the floor; none where no point gives it", "rf_h_ground"},
    {"ground_source", kText, "",
     "`measured`: a tenth of the ground points (`classes.ground`) within 4 m around the outline lie below it; "
     "`nearby`: there were none, the same of those within 10 m, else 25 m, else 50 m (10 points at least), or the "
     "lowest point within the margin of the outline's edges where that is lower; `lowest_point`: that point; none "
     "where there is no point",
     nullptr},
    {"h_roof_min", kReal, "CRS", "height of the lowest point on roof faces (of all its points where there is no face)",
     "rf_h_roof_min"},
    {"h_roof_50", kReal, "CRS", "height that half of these points do not exceed", "rf_h_roof_50p"},
    {"h_roof_70", kReal, "CRS", "height that 70% of them do not exceed", "rf_h_roof_70p"},
    {"h_roof_max", kReal, "CRS", "height of the highest of them", "rf_h_roof_max"},
    {"area_m2", kReal, "m2", "of the outline", nullptr},
    {"volume_lod12_m3", kReal, "m3", "of the solid of LoD 1.2", "rf_volume_lod12"},
    {"volume_lod13_m3", kReal, "m3", "of the solid of LoD 1.3", "rf_volume_lod13"},
    {"volume_lod22_m3", kReal, "m3", "of the solid of LoD 2.2", "rf_volume_lod22"},
    {"party_wall_m2", kReal, "m2",
     "area of the walls of the highest level of detail that stand against another building: see `roofs.md`", nullptr},
    {"exterior_wall_m2", kReal, "m2", "area of all its other walls, those between two heights of its roof too",
     nullptr},
    {"storeys", kWhole, "",
     "rows of openings, one above another, that the facades of the run show in its walls: see `roofs.md`", nullptr},
    {"roof_faces", kWhole, "", "of LoD 2.2", "rf_roof_planes"},
    {"roof_type", kText, "",
     "`horizontal`, `multiple horizontal`, `slanted` (some face leans more than 5 degrees), `unknown` (no face), `no "
     "points`",
     "rf_roof_type"},
    {"coverage", kReal, "", "share of the outline, in cells two sampling steps wide, that contains a point", nullptr},
    {"rmse_m", kReal, "m",
     "root mean square distance of all points of the building from the solid of the highest level of detail, those "
     "on no face too",
     "rf_rmse_lod22"},
    {"p95_m", kReal, "m", "distance that 95 % of these points do not exceed", nullptr},
    {"explained", kReal, "", "share of these points within 0.2 m of the solid, or within epsilon where that is more",
     nullptr},
    {"largest_off_m2", kReal, "m2",
     "area in plan of the largest connected part most of whose points are farther away than that", nullptr},
    {"bare", kReal, "", "share of the roof, in cells of 0.5 m or two sampling steps, without a point within 1 m",
     nullptr},
    {"overshoot_m", kReal, "m", "how far the roof rises above all points within 1 m in plan", nullptr},
    {"quality", kText, "", "`good`, `check` or `bad`: see `roofs.md`", nullptr},
    {"quality_reason", kText, "", "in words, the figure that decided; none where the quality is good", nullptr},
    {"outline", kText, "", "what was wrong with the outline and has been mended", nullptr},
    {"unit_id", kWhole, "", "number of the building in this run, dense from 1: `unit_id` of its points", nullptr},
};

constexpr BuildingField kFaceFields[] = {
    {"plane_id", kWhole, "", "of roofs: number of the face, dense from 1 over all buildings", nullptr},
    {"slope_deg", kReal, "deg", "between the face and the level", "rf_slope"},
    {"azimuth_deg", kReal, "deg", "where the face looks, clockwise from north; none for level faces", "rf_azimuth"},
    {"area_m2", kReal, "m2", "in space, holes taken off", nullptr},
    {"h_roof_min", kReal, "CRS", "height of its lowest corner: of the eaves", "rf_h_roof_min"},
    {"h_roof_50", kReal, "CRS", "height that half of the face, seen from above, does not exceed", "rf_h_roof_50p"},
    {"h_roof_70", kReal, "CRS", "height that 70 % of it do not exceed", "rf_h_roof_70p"},
    {"h_roof_max", kReal, "CRS", "height of its highest corner: of the ridge", "rf_h_roof_max"},
};

// Additional attributes of roofer that follow from others.
constexpr char kBlockRmse[] = "rf_rmse_lod12";
constexpr BuildingField kRooferFields[] = {
    {kBlockRmse, kReal, "m", "`rmse_m` where `lod12` is the highest level of detail", nullptr},
    {"rf_success", kTruth, "", "a solid was made", nullptr},
    {"rf_extrusion_mode", kText, "",
     "`standard` for `lod22`, `lod11_fallback` for `lod12`, `skip` for `footprint_only`", nullptr},
    {"rf_nodata_frac", kReal, "", "1 - `coverage`", nullptr},
    {"rf_pt_density", kReal, "1/m2", "`points` over `area_m2`", nullptr},
};

std::string styled_name(const std::string& name, std::span<const BuildingField> fields, AttributeStyle style) {
  const auto field = std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.name == name; });
  return style == AttributeStyle::roofer && field != fields.end() && field->roofer ? field->roofer : name;
}

template <class T>
const T* value_of(const Attributes& attributes, const char* name) {
  for (const auto& [key, value] : attributes)
    if (key == name) return std::get_if<T>(&value);
  return nullptr;
}

void add_roofers_own(const Attributes& plain, Attributes& out) {
  if (const auto* status = value_of<std::string>(plain, "status")) {
    const bool none = *status == "footprint_only";
    out.emplace_back("rf_success", !none);
    out.emplace_back("rf_extrusion_mode", std::string(none                 ? "skip"
                                                      : *status == "lod22" ? "standard"
                                                                           : "lod11_fallback"));
  }
  if (const auto* coverage = value_of<double>(plain, "coverage")) out.emplace_back("rf_nodata_frac", 1 - *coverage);
  const auto* points = value_of<std::int64_t>(plain, "points");
  const auto* area = value_of<double>(plain, "area_m2");
  if (points && area && *area > 0) out.emplace_back("rf_pt_density", static_cast<double>(*points) / *area);
}

std::vector<std::pair<std::string, FieldKind>> columns_of(std::span<const BuildingField> fields, AttributeStyle style) {
  std::vector<std::pair<std::string, FieldKind>> columns;
  for (const BuildingField& f : fields) columns.emplace_back(styled_name(f.name, fields, style), f.kind);
  return columns;
}

std::string table_markdown(const char* title, std::span<const BuildingField> fields) {
  std::string text = fmt::format("| {} | unit | meaning | roofer's style |\n|---|---|---|---|\n", title);
  for (const BuildingField& f : fields)
    text += fmt::format("| `{}` | {} | {} | {} |\n", f.name, f.unit, f.meaning,
                        f.roofer ? fmt::format("`{}`", f.roofer) : "");
  return text;
}

}  // namespace

std::span<const BuildingField> building_fields() {
  return kBuildingFields;
}

std::span<const BuildingField> face_fields() {
  return kFaceFields;
}

Attributes styled_attributes(const Attributes& plain, AttributeStyle style) {
  if (style == AttributeStyle::plain) return plain;
  Attributes out;
  const auto* status = value_of<std::string>(plain, "status");
  const bool block = status != nullptr && *status == "lod12";
  for (const auto& [name, value] : plain)
    out.emplace_back(block && name == "rmse_m" ? kBlockRmse : styled_name(name, kBuildingFields, style), value);
  add_roofers_own(plain, out);
  return out;
}

std::vector<std::string> names_of(const BuildingField& field) {
  std::vector<std::string> names{field.name};
  if (field.roofer) names.push_back(field.roofer);
  if (names[0] == "rmse_m") names.push_back(kBlockRmse);
  return names;
}

std::vector<std::pair<std::string, FieldKind>> attribute_columns(AttributeStyle style) {
  std::vector<std::pair<std::string, FieldKind>> columns = columns_of(kBuildingFields, style);
  if (style == AttributeStyle::roofer)
    for (const BuildingField& f : kRooferFields) columns.emplace_back(f.name, f.kind);
  return columns;
}

bool is_measured(const std::string& name) {
  const auto has_name = [&](const BuildingField& f) { return name == f.name || (f.roofer && name == f.roofer); };
  return std::any_of(std::begin(kBuildingFields), std::end(kBuildingFields), has_name) ||
         std::any_of(std::begin(kFaceFields), std::end(kFaceFields), has_name) ||
         std::any_of(std::begin(kRooferFields), std::end(kRooferFields), has_name);
}

std::vector<std::pair<std::string, FieldKind>> face_columns(AttributeStyle style) {
  return columns_of(kFaceFields, style);
}

Attributes face_attributes(const SurfaceShape& shape, const FaceHeights& heights, AttributeStyle style) {
  Attributes out;
  const auto add = [&](const char* name, double value) {
    out.emplace_back(styled_name(name, kFaceFields, style), value);
  };
  add("slope_deg", shape.slope_deg);
  if (shape.azimuth_deg >= 0) add("azimuth_deg", shape.azimuth_deg);
  add("area_m2", shape.area_m2);
  add("h_roof_min", heights.min);
  add("h_roof_50", heights.half);
  add("h_roof_70", heights.seven_tenths);
  add("h_roof_max", heights.max);
  return out;
}

Attributes face_attributes(const Building& building, const BuildingSurface& surface, AttributeStyle style,
                           double metres_per_unit) {
  return face_attributes(surface_shape(building, surface, metres_per_unit), face_heights(building, surface), style);
}

std::string building_fields_markdown() {
  return table_markdown("attribute", kBuildingFields) + "\nOf a roof face:\n\n" +
         table_markdown("attribute", kFaceFields) + "\nWith `roofs.attribute_style = \"roofer\"` also:\n\n" +
         table_markdown("attribute", kRooferFields);
}

}  // namespace ilot
