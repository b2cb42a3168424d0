// SPDX-License-Identifier: Apache-2.0
// What is known of a point cloud, and what the products say of a point. Plain values; clouds.h fills them.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ilot/geometry.h"

namespace ilot {

// Coordinate reference system as far as the engine needs it.
struct Crs {
  std::string wkt;             // empty when unknown
  int epsg = 0;                // 0 when unknown
  std::string name;            // for people
  bool geographic = false;     // degrees: no product works on these
  double metres_per_unit = 1;  // horizontal
  double metres_per_unit_z = 1;
  bool unit_assumed = true;  // nothing said what the unit is: metres are assumed
};

// Where a scanner stood, in world coordinates, and how it turned.
struct Station {
  std::string name;
  Vec3 position;
  double azimuth_step = 0, elevation_step = 0;  // radians between profiles and between their points; 0 = unknown
  Vec3 axis{0, 0, 1};                           // that it turned about, of unit length
  std::uint16_t source_id = 0;                  // point_source_id of its points; 0 = not told
};

// One of several scans in a file; its rows follow those of the scan before it.
struct ScanPart {
  std::string name;
  std::uint64_t points = 0;
};

// How a text file writes its numbers.
enum class Separator : std::uint8_t { blank, tab, comma, semicolon };

struct TextDialect {
  Separator separator = Separator::blank;  // blank: any run of blanks and tabs
  char decimal = '.';                      // or ','
  char thousands =
      0;  // ',' '.' '\'' or ' ' (also the no-break blanks of Unicode and Latin-1); 0: digits are not grouped
  friend bool operator==(const TextDialect&, const TextDialect&) = default;
};

// "semicolon,decimal-comma,thousands-blank": a separator is needed, decimal-point and no thousands are the default.
// Throws Error of ExitCode::usage naming the words there are.
TextDialect dialect_of_words(const std::string& words);

// What the points of a cloud really are, as measured.
struct CloudMeasure {
  std::uint64_t points = 0;        // valid ones; 0: the rest is zero
  std::uint64_t rejected = 0;      // coordinates not finite or out of range
  std::uint64_t last_returns = 0;  // points that are the last echo of their pulse, or say nothing about echoes
  std::uint64_t with_colour = 0;   // points with any colour channel above 0
  std::uint64_t strays = 0;        // valid points that stand alone, far from all others (engine/store/strays.h)
  Vec3 min, max;                   // of the valid points without strays, in the units of the CRS
  Vec3 all_min, all_max;           // with them
  std::array<std::uint64_t, 256> classes{};  // points per class code

  // Horizontal, without strays, over the cells (16 points each on average, at most 512 x 512) that hold any point.
  double occupied_area = 0;  // square metres
  double density = 0;        // all returns per square metre
  double last_return_density = 0;
  double sampling_step = 0;  // metres; median distance to the nearest point elsewhere, over up to 32 windows
};

// Whether a cloud suits a product, and why: half a sentence.
struct CloudSuitability {
  std::string product;  // planes, roofs, facades, streets
  bool yes = false;
  std::string reason;
};

// What the products say of a point: the extra byte `label` of the clouds that a run writes (docs/outputs.md).
enum class PointLabel : std::uint8_t {
  none = 0,  // values from 100 on are classes of one's own (--train), in the order of their names
  ground = 1,
  roof = 2,
  wall = 3,
  vegetation = 4,
  facade = 5,  // seen from the street: walls and all that is fixed to them
  window = 6,
  door = 7,
  sill = 8,
  balcony = 9,
  car = 10,
  lamppost = 11,
  pedestrian = 12,
  other = 13,  // stands on the ground and is none of these
  van = 14,    // and lorry, bus, caravan
  two_wheeler = 15,
  sign = 16,  // and traffic light
  bollard = 17,
  bin = 18,  // and container
  bench = 19,
  planter = 20,
  fence = 21,    // and railing, free-standing wall
  cabinet = 22,  // and other closed boxes: meter, letter box, charging post
};

// "none", "ground", "car" ...: the name of the enumerator, as files have it; "own 100" for one's own.
std::string label_name(PointLabel label);

}  // namespace ilot
