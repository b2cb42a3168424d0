// SPDX-License-Identifier: Apache-2.0
// The table of all settings: key, field, range, unit and meaning of each. Defaults are those of the fields.
#include <type_traits>
#include <utility>

#include "engine/settings/field_value.h"
#include "engine/settings/parameters.h"

namespace ilot {
namespace {

template <class Access>
Parameter make(const char* key, Access access, ValueRange range, const char* unit, const char* help) {
  using F = FieldValue<std::remove_cvref_t<decltype(access(std::declval<Settings&>()))>>;
  return {key,
          F::kKind,
          F::kOptional,
          range,
          {},
          unit,
          help,
          [access](const Settings& s) { return F::get(access(s)); },
          [access](Settings& s, const Value& value) { F::set(access(s), value); }};
}

template <class Access>
Parameter make_advanced(const char* key, Access access, ValueRange range, const char* unit, const char* help) {
  Parameter parameter = make(key, access, range, unit, help);
  parameter.advanced = true;
  return parameter;
}

Parameter with_choices(Parameter parameter, std::span<const std::string_view> choices) {
  parameter.choices = choices;
  return parameter;
}

#define ILOT_FIELD(path) \
  [](auto& s) -> auto& { \
    return s.path;       \
  }

using Parameters = std::vector<Parameter>;

Parameters general_parameters() {
  return {
      make("seed", ILOT_FIELD(seed), {0, 0x1p53 - 1}, "", "varies the random draws; any value is reproducible"),
      make("index.block_points", ILOT_FIELD(index.block_points), {256, 0x1p26}, "points",
           "most points in one block of the store; results do not depend on it"),
      make("index.finest_step", ILOT_FIELD(index.finest_step), {0.00001, 0.1}, "m",
           "coordinates in finer steps than this are rounded to it"),
      make("index.keep_strays", ILOT_FIELD(index.keep_strays), {}, "",
           "keep points that stand alone, hundreds of metres from all others, such as rays written as 0 0 0"),
      make("normals.neighbours", ILOT_FIELD(normals.neighbours), {3, 64}, "points",
           "nearest points that a normal is fitted to"),
      make("normals.max_radius", ILOT_FIELD(normals.max_radius), {0.001, 1000}, "m",
           "neighbours farther away than this are not used"),
      make("normals.write", ILOT_FIELD(normals.write), {}, "", "write NormalX, NormalY and NormalZ with the points"),
  };
}

Parameters planes_parameters() {
  return {
      with_choices(make("planes.method", ILOT_FIELD(planes.method), {}, "", "how planes are found"), kPlaneMethods),
      make("planes.epsilon", ILOT_FIELD(planes.epsilon), {0.0001, 10}, "m",
           "greatest distance of a labelled point from its plane"),
      make("planes.normal_angle", ILOT_FIELD(planes.normal_angle), {0.1, 90}, "deg",
           "greatest angle between a point's normal and that of its plane"),
      make("planes.min_points", ILOT_FIELD(planes.min_points), {3, 1e9}, "points", "fewest points of a plane"),
      make("planes.connectivity", ILOT_FIELD(planes.connectivity), {0.001, 100}, "m",
           "parts of a plane farther apart than this are two planes"),
      make("planes.join_angle", ILOT_FIELD(planes.join_angle), {0, 45}, "deg",
           "planes that meet at a cell border are joined up to this angle"),
      make("planes.probability", ILOT_FIELD(planes.probability), {0.5, 0.999999}, "",
           "that the best plane was among those tried"),
      with_choices(make("planes.cleaning", ILOT_FIELD(planes.cleaning), {}, "",
                        "which points take no part in the search for planes"),
                   kCleanings),
      with_choices(make("planes.epsilon_by", ILOT_FIELD(planes.epsilon_by), {}, "", "what epsilon is chosen by"),
                   kEpsilonBy),
      make("planes.colour_classes", ILOT_FIELD(planes.colour_classes), {0, 16}, "",
           "classes that colours are parted into where points have them"),
      make("planes.curved", ILOT_FIELD(planes.curved), {}, "",
           "spheres, cylinders and cones are looked for too; planes lie on the points that these leave"),
      make("planes.curved_points", ILOT_FIELD(planes.curved_points), {30, 1e9}, "points",
           "fewest points of a sphere, cylinder or cone"),
  };
}

Parameters boundaries_parameters() {
  return {
      make("boundaries.gamma", ILOT_FIELD(boundaries.gamma), {0.1, 100}, "",
           "threshold around a point over the sampling step there: gaps wider than twice that are openings"),
      make("boundaries.threshold", ILOT_FIELD(boundaries.threshold), {0.001, 1000}, "m",
           "one threshold for all points, whatever the sampling step"),
      with_choices(make("boundaries.step", ILOT_FIELD(boundaries.step), {}, "",
                        "sampling step as the stations' angular steps predict it, or as neighbours show it"),
                   kStepSources),
      with_choices(make("boundaries.rule", ILOT_FIELD(boundaries.rule), {}, "",
                        "what of a triangle must not exceed the threshold"),
                   kBoundaryRules),
      with_choices(make("boundaries.edge_length", ILOT_FIELD(boundaries.edge_length), {}, "",
                        "longest_edge: edges as projected on the plane, or between the points themselves"),
                   kEdgeLengths),
      with_choices(make("boundaries.erosion", ILOT_FIELD(boundaries.erosion), {}, "",
                        "gaps open an outline everywhere, or only from the outside: then it has no holes"),
                   kErosions),
      make("boundaries.tolerance", ILOT_FIELD(boundaries.tolerance), {0, 10}, "m",
           "outlines lose the vertices that move them by less than this"),
      make(
          "boundaries.density_maps", ILOT_FIELD(boundaries.density_maps), {0, 1000}, "planes",
          "those with the most points, whose density is written as rasters beside what stations predict; auto: 4 where "
          "angular steps are known, else none"),
  };
}

Parameters roofs_parameters() {
  return {
      make("roofs.trust_classes", ILOT_FIELD(roofs.trust_classes), {}, "",
           "false looks for ground and buildings by shape, as where no point is of classes.building"),
      make("roofs.cluster_distance", ILOT_FIELD(roofs.cluster_distance), {0.01, 100}, "m",
           "building points farther apart in plan are two buildings, without footprints"),
      make("roofs.cluster_points", ILOT_FIELD(roofs.cluster_points), {3, 1e9}, "points",
           "fewest points of a building, without footprints"),
      make("roofs.margin", ILOT_FIELD(roofs.margin), {0, 5}, "m",
           "points outside of the outline and so near to it count where they lie on a plane of the building"),
      make("roofs.epsilon", ILOT_FIELD(roofs.epsilon), {0.001, 10}, "m",
           "greatest distance of a point from its roof face"),
      make("roofs.min_points", ILOT_FIELD(roofs.min_points), {3, 1e9}, "points", "fewest points of a roof face"),
      make("roofs.least_face_area", ILOT_FIELD(roofs.least_face_area), {0, 1e6}, "m2",
           "smaller roof faces go to their neighbour"),
      make("roofs.detail", ILOT_FIELD(roofs.detail), {0, 10}, "m",
           "roof faces that differ by less are drawn as one; 0 draws every plane that is found"),
      make("roofs.superstructures", ILOT_FIELD(roofs.superstructures), {}, "",
           "false leaves out what stands on the main roof: dormers, chimneys"),
      make("roofs.lod13_step", ILOT_FIELD(roofs.lod13_step), {0, 100}, "m",
           "parts of a roof that differ by less in height are one in LoD1.3; 0: no LoD1.3"),
      make("roofs.dtm", ILOT_FIELD(roofs.dtm), {}, "",
           "true writes a terrain model beside the roofs: the heights of the ground as a GeoTIFF"),
      with_choices(make("roofs.attribute_style", ILOT_FIELD(roofs.attribute_style), {}, "",
                        "what attributes of buildings are called: docs/outputs.md"),
                   kAttributeStyles),
  };
}

Parameters advanced_roofs() {
  return {
      make_advanced("roofs.ground_within", ILOT_FIELD(roofs.advanced.ground_within), {0.01, 5}, "m",
                    "points so near to the surface of the ground are ground, where classes are found by shape"),
      make_advanced("roofs.least_height", ILOT_FIELD(roofs.advanced.least_height), {0.2, 20}, "m",
                    "lower points are no buildings, where classes are found by shape"),
      make_advanced("roofs.smoothness", ILOT_FIELD(roofs.advanced.smoothness), {0.001, 0.333}, "",
                    "greatest curvature of the points of a roof, where classes are found by shape"),
      make_advanced("roofs.normal_angle", ILOT_FIELD(roofs.advanced.normal_angle), {1, 90}, "deg",
                    "greatest angle between a point's normal and that of its roof face"),
      make_advanced("roofs.same_angle", ILOT_FIELD(roofs.advanced.same_angle), {0, 45}, "deg",
                    "roof faces that touch are joined up to this angle"),
      make_advanced("roofs.least_epsilon", ILOT_FIELD(roofs.advanced.least_epsilon), {0.001, 10}, "m",
                    "least value of roofs.epsilon where it is auto"),
      make_advanced("roofs.most_epsilon", ILOT_FIELD(roofs.advanced.most_epsilon), {0.001, 10}, "m",
                    "greatest value of roofs.epsilon where it is auto"),
      make_advanced("roofs.main_roof_area", ILOT_FIELD(roofs.advanced.main_roof_area), {0, 1000}, "m2",
                    "without superstructures, faces below this and below roofs.main_roof_share are left out"),
      make_advanced("roofs.main_roof_share", ILOT_FIELD(roofs.advanced.main_roof_share), {0, 1}, "",
                    "share of the largest face, see roofs.main_roof_area"),
      make_advanced("roofs.border_cost", ILOT_FIELD(roofs.advanced.border_cost), {0, 100}, "m2",
                    "cost of a metre of border between two faces, in area of points that contradict it"),
      make_advanced("roofs.wall_cost", ILOT_FIELD(roofs.advanced.wall_cost), {0, 100}, "m2",
                    "cost of a square metre of wall between two faces, up to a height of 0.5 m"),
      make_advanced("roofs.overshoot", ILOT_FIELD(roofs.advanced.overshoot), {0, 10}, "m",
                    "height to which a face may rise above its highest point"),
      make_advanced("roofs.block_height", ILOT_FIELD(roofs.advanced.block_height), {0, 1}, "",
                    "quantile of the heights of the points that gives the top of a block of LoD1.2"),
  };
}

Parameters streets_parameters() {
  return {
      with_choices(make("streets.view", ILOT_FIELD(streets.view), {}, "",
                        "where the street was scanned from: chooses the pixel and the model that names objects"),
                   kStreetViews),
      make("streets.pixel", ILOT_FIELD(streets.pixel), {0.01, 10}, "m", "of the images from above"),
      make("streets.flat", ILOT_FIELD(streets.flat), {0.01, 100}, "m",
           "heights of neighbouring pixels of the ground differ by at most this"),
      make("streets.longest_gap", ILOT_FIELD(streets.longest_gap), {0, 10}, "m",
           "gaps between scan lines are closed up to this"),
      make("streets.longest_link", ILOT_FIELD(streets.longest_link), {0, 100}, "m",
           "shadows that cut the ground apart are crossed up to this"),
      make("streets.least_height", ILOT_FIELD(streets.least_height), {0.01, 10}, "m",
           "what is lower is part of the ground"),
      make("streets.least_area", ILOT_FIELD(streets.least_area), {0, 100}, "m2",
           "smaller peaks are no objects of their own; from the air smaller objects are dropped"),
      make("streets.rise", ILOT_FIELD(streets.rise), {0, 10}, "m",
           "what rises so far above the pass to a higher object is an object of its own"),
      make("streets.trust_classes", ILOT_FIELD(streets.trust_classes), {}, "",
           "objects with points of classes.vegetation are vegetation, unless sure objects have them too"),
  };
}

Parameters advanced_streets() {
  return {
      make_advanced("streets.gap_step", ILOT_FIELD(streets.advanced.gap_step), {0.001, 5}, "m",
                    "greatest difference in height between the two sides of a gap between scan lines"),
      make_advanced("streets.highest_kerb", ILOT_FIELD(streets.advanced.highest_kerb), {0, 2}, "m",
                    "greatest height of a plateau that is pavement"),
      make_advanced("streets.least_pavement", ILOT_FIELD(streets.advanced.least_pavement), {0, 1000}, "m2",
                    "smaller plateaus are objects, not pavement"),
      make_advanced("streets.facade_height", ILOT_FIELD(streets.advanced.facade_height), {0.5, 50}, "m",
                    "lower pixels show no facade, where the blocks of the city are found"),
      make_advanced("streets.facade_length", ILOT_FIELD(streets.advanced.facade_length), {1, 1000}, "m",
                    "lines with less facade along them are left out"),
      make_advanced("streets.cross_street_depth", ILOT_FIELD(streets.advanced.cross_street_depth), {0.5, 100}, "m",
                    "a cross street cuts at least this deep into the heights along a line of facades"),
      make_advanced("streets.cross_street_width", ILOT_FIELD(streets.advanced.cross_street_width), {0.5, 100}, "m",
                    "narrower gaps in a line of facades are no cross streets"),
      make_advanced("streets.block_distance", ILOT_FIELD(streets.advanced.block_distance), {1, 500}, "m",
                    "objects farther from all lines of facades belong to no block"),
  };
}

Parameters facades_parameters() {
  return {
      make("facades.least_width", ILOT_FIELD(facades.least_width), {0.1, 1000}, "m", "narrower walls are no facades"),
      make("facades.least_height", ILOT_FIELD(facades.least_height), {0.1, 1000}, "m", "lower walls are no facades"),
      make("facades.bias", ILOT_FIELD(facades.bias), {0, 1}, "m", "walls whose planes differ by less are one facade"),
      make("facades.gap", ILOT_FIELD(facades.gap), {0, 100}, "m", "parts of a facade lie apart by at most this"),
      make("facades.relief", ILOT_FIELD(facades.relief), {0, 5}, "m",
           "what stands so far before a facade, along it, belongs to it"),
      make("facades.least_opening", ILOT_FIELD(facades.least_opening), {0.05, 10}, "m",
           "narrower or lower holes are no windows"),
      make("facades.alike", ILOT_FIELD(facades.alike), {0, 1}, "m",
           "sizes and lines that differ by less may have been meant equal"),
      make("facades.regularise", ILOT_FIELD(facades.regularise), {}, "",
           "rows, columns and families line up, each edge within its own error"),
      make("facades.keep_unlikely", ILOT_FIELD(facades.keep_unlikely), {}, "",
           "openings that are more likely none are drawn as openings, not as possible ones"),
      make("facades.scale", ILOT_FIELD(facades.scale), {1, 10000}, "", "drawings are 1 : scale on paper"),
      with_choices(make("facades.layers", ILOT_FIELD(facades.layers), {}, "",
                        "whose layers drawings have; ilot draw takes an office's own"),
                   kLayerNames),
      with_choices(make("facades.language", ILOT_FIELD(facades.language), {}, "", "language of the texts of drawings"),
                   kSheetLanguageNames),
      make("facades.sections", ILOT_FIELD(facades.sections), {-1e6, 1e6}, "CRS units",
           "heights that facades are also cut at"),
      make("facades.upright_sections", ILOT_FIELD(facades.upright_sections), {-1e4, 1e4}, "m",
           "distances from the left end of each facade that upright cuts go through it at"),
      make("facades.section_lines", ILOT_FIELD(facades.section_lines), {-1e9, 1e9}, "CRS units",
           "x0, y0, x1, y1 of each line that facades are also cut along, upright"),
      make("facades.side", ILOT_FIELD(facades.side), {1, 1e6}, "",
           "numbers of facades that are drawn from the other side than was decided"),
  };
}

Parameters advanced_facades() {
  return {
      make_advanced("facades.lean", ILOT_FIELD(facades.advanced.lean), {0.1, 45}, "deg",
                    "greatest angle of a facade to the vertical"),
      make_advanced("facades.relief_behind", ILOT_FIELD(facades.advanced.relief_behind), {0, 5}, "m",
                    "planes along a facade that are this far behind it or less belong to it"),
      make_advanced("facades.large_part", ILOT_FIELD(facades.advanced.large_part), {0, 1000}, "m2",
                    "smaller planes beside the plane of a facade are relief, whatever facades.bias"),
      make_advanced("facades.shadow", ILOT_FIELD(facades.advanced.shadow), {0, 5}, "m",
                    "parts of an opening are joined across shadows up to this width"),
      make_advanced("facades.least_reveal", ILOT_FIELD(facades.advanced.least_reveal), {0.005, 1}, "m",
                    "shallower holes in the wall are no openings"),
      make_advanced("facades.room_depth", ILOT_FIELD(facades.advanced.room_depth), {0.1, 50}, "m",
                    "points farther behind the wall are not used to find openings"),
      make_advanced("facades.room_depth_square", ILOT_FIELD(facades.advanced.room_depth_square), {0.1, 50}, "m",
                    "the same where no stations are known and rays are taken to be perpendicular to the wall"),
      make_advanced("facades.hidden_above", ILOT_FIELD(facades.advanced.hidden_above), {0.05, 10}, "m",
                    "the wall must continue within this distance above an opening: signs and blinds can hide it"),
      make_advanced("facades.arch_misfit", ILOT_FIELD(facades.advanced.arch_misfit), {0.01, 1}, "",
                    "greatest residuals of a circle at the top of an opening, as a share of those of a level line"),
      make_advanced("facades.door_height", ILOT_FIELD(facades.advanced.door_height), {0.5, 10}, "m",
                    "lower openings are no doors"),
      make_advanced("facades.door_sill", ILOT_FIELD(facades.advanced.door_sill), {0, 5}, "m",
                    "openings that begin higher above the foot of the wall are no doors"),
  };
}

Parameters advanced_elements() {
  return {
      make_advanced("facades.balcony_depth", ILOT_FIELD(facades.advanced.balcony_depth), {0.01, 5}, "m",
                    "elements that stand out less are no balconies"),
      make_advanced("facades.balcony_width", ILOT_FIELD(facades.advanced.balcony_width), {0.05, 10}, "m",
                    "narrower elements that stand out so far are brackets"),
      make_advanced("facades.balcony_height", ILOT_FIELD(facades.advanced.balcony_height), {0.1, 10}, "m",
                    "higher elements that stand out so far are protrusions"),
      make_advanced("facades.least_relief", ILOT_FIELD(facades.advanced.least_relief), {0.001, 1}, "m",
                    "planes that stand out less are part of the wall"),
      make_advanced("facades.least_relief_size", ILOT_FIELD(facades.advanced.least_relief_size), {0.005, 10}, "m",
                    "narrower or lower relief is not drawn"),
      make_advanced("facades.most_relief", ILOT_FIELD(facades.advanced.most_relief), {0.1, 10}, "m",
                    "what is farther before or behind the wall does not belong to it"),
      make_advanced("facades.joint_depth_from", ILOT_FIELD(facades.advanced.joint_depth_from), {0.0005, 0.1}, "m",
                    "the sides of stones are found from points at this depth in their joints or deeper"),
      make_advanced("facades.joint_depth_to", ILOT_FIELD(facades.advanced.joint_depth_to), {0.001, 0.2}, "m",
                    "the sides of stones are found from points at this depth in their joints or less"),
      make_advanced("facades.joint_width", ILOT_FIELD(facades.advanced.joint_width), {0.001, 0.5}, "m",
                    "wider gaps between stones are no joints"),
      make_advanced("facades.bulge", ILOT_FIELD(facades.advanced.bulge), {0.001, 1}, "m",
                    "greatest height or depth of a bulge or hollow of the wall"),
      make_advanced("facades.bulge_area", ILOT_FIELD(facades.advanced.bulge_area), {0.001, 100}, "m2",
                    "smaller bulges and hollows are not drawn"),
      make_advanced("facades.line_up", ILOT_FIELD(facades.advanced.line_up), {0, 5}, "m",
                    "greatest distance between the middles of the elements of one column"),
      make_advanced("facades.dormer_width", ILOT_FIELD(facades.advanced.dormer_width), {0.1, 10}, "m",
                    "narrower upright planes in a roof are no dormers"),
      make_advanced("facades.dormer_height", ILOT_FIELD(facades.advanced.dormer_height), {0.1, 10}, "m",
                    "lower upright planes in a roof are no dormers"),
      make_advanced("facades.dormer_most_width", ILOT_FIELD(facades.advanced.dormer_most_width), {0.5, 100}, "m",
                    "wider upright planes in a roof are storeys that are set back"),
      make_advanced("facades.dormer_behind", ILOT_FIELD(facades.advanced.dormer_behind), {0, 20}, "m",
                    "greatest distance of a dormer behind its facade"),
      make_advanced("facades.dormer_reach", ILOT_FIELD(facades.advanced.dormer_reach), {0.1, 50}, "m",
                    "greatest height of dormers above the top of their facade"),
      make_advanced("facades.corner_reach", ILOT_FIELD(facades.advanced.corner_reach), {0, 5}, "m",
                    "facades that end so near to the line in which they meet are joined there"),
      make_advanced("facades.corner_angle", ILOT_FIELD(facades.advanced.corner_angle), {1, 90}, "deg",
                    "facades that turn by less do not form a corner"),
      make_advanced("facades.storey_step", ILOT_FIELD(facades.advanced.storey_step), {0.1, 20}, "m",
                    "greatest distance between two walls of one front, one above the other"),
  };
}

Parameters classes_parameters() {
  return {
      make("classes.ground", ILOT_FIELD(classes.ground), {0, 255}, "", "class codes of the ground"),
      make("classes.building", ILOT_FIELD(classes.building), {0, 255}, "", "class codes of buildings"),
      make("classes.noise", ILOT_FIELD(classes.noise), {0, 255}, "", "class codes of points that no product uses"),
      make("classes.vegetation", ILOT_FIELD(classes.vegetation), {0, 255}, "", "class codes of vegetation"),
      make("classes.write", ILOT_FIELD(classes.write), {}, "",
           "true: points of the classes 0 and 1 get class 2 on the ground and 6 on buildings in the labelled clouds"),
  };
}

}  // namespace

std::vector<Parameter> parameter_table() {
  Parameters table;
  for (const auto section : {general_parameters, planes_parameters, boundaries_parameters, roofs_parameters,
                             advanced_roofs, streets_parameters, advanced_streets, facades_parameters, advanced_facades,
                             advanced_elements, classes_parameters})
    for (Parameter& p : section()) table.push_back(std::move(p));
  return table;
}

#undef ILOT_FIELD

}  // namespace ilot
