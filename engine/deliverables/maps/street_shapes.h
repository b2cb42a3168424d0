// SPDX-License-Identifier: Apache-2.0
// What is drawn of a street on its map. All formats of the map are written from it.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/street.h"
#include "kernels/geometry/flat.h"
#include "kernels/geometry/flat_box.h"

namespace ilot {

struct MapColour {
  std::uint8_t red = 0, green = 0, blue = 0;
};

// Areas, lines and circles. Places and sizes are metres on the ground, y to the north.
struct MapShape {
  std::vector<std::vector<FlatPoint>> lines;  // an area: its ring, then its holes; none: a circle
  bool closed = true;
  FlatPoint centre;
  double radius = 0;
  std::optional<MapColour> fill, stroke;
  bool clear = false;  // the fill has kClearOpacity (pdf_file.h)
  double width = 0;    // of the stroke
  double dash = 0;     // length of the dashes and of the gaps between them; 0: none
  std::string title;   // what it is, for people

  FlatBox box() const;
};

struct MapNumber {
  FlatPoint place;       // the middle of the object
  double reach = 0;      // metres; half of its least side
  std::uint32_t id = 0;  // object_id
};

// The later shapes are on top of the earlier ones.
struct StreetShapes {
  Vec3 origin;  // CRS; the place (0, 0)
  FlatBox box;  // of everything, all zero for an empty plan
  std::vector<MapShape> shapes;
  std::vector<MapNumber> numbers;
};

// O(vertices).
StreetShapes street_shapes(const StreetPlan& plan, double metres_per_unit);

// A kind of thing on the map: a sample in a box of 2 by 1 around the origin, and its name with its number.
struct LegendRow {
  std::vector<MapShape> sample;
  std::string name;
};

// A sample of areas of this colour.
std::vector<MapShape> area_sample(MapColour colour);

// The kinds that are on the map, classes of objects first.
std::vector<LegendRow> street_legend(const StreetPlan& plan);

// A row of a table: the colour, the name and the number of each kind.
struct KindCount {
  MapColour colour;
  std::string name;
  std::size_t count = 0;
};
std::vector<KindCount> street_kinds(const StreetPlan& plan);

}  // namespace ilot
