// SPDX-License-Identifier: Apache-2.0
#include "engine/run/inputs/area_in_crs.h"

#include <algorithm>
#include <cmath>

#include "engine/error.h"
#include "engine/formats/crs.h"
#include "engine/formats/crs_transform.h"
#include "engine/run/inputs/input_crs.h"
#include "engine/run/inputs/input_places.h"

namespace ilot {
namespace {

bool could_be_degrees(const Area& area) {
  return !area.rings.empty() && area.min_x >= -180 && area.max_x <= 180 && area.min_y >= -90 && area.max_y <= 90;
}

}  // namespace

Area area_in_crs(const Area& area, const RunInputs& inputs, Progress& progress, RunRecord& record) {
  if (!could_be_degrees(area)) return area;
  const auto box = sampled_box(inputs.readers);
  const PlaceBox asked{area.min_x, area.min_y, area.max_x, area.max_y, {}};
  if (!box || widened(*box).touches(asked)) return area;
  if (inputs.crs.wkt.empty() && inputs.crs.epsg == 0)
    throw Error("--within: the polygons are in degrees (" + asked.text() + "), the clouds are not (" + box->text() +
                    ") and say no CRS; give it with --crs EPSG:n",
                ExitCode::usage);
  Area moved = area;
  const CrsTransform transform(crs_from_epsg(4326), inputs.crs);
  moved.min_x = moved.min_y = INFINITY;
  moved.max_x = moved.max_y = -INFINITY;
  for (AreaRing& ring : moved.rings)
    for (auto& [x, y] : ring) {
      Vec3 place{x, y, 0};
      transform.apply(std::span(&place, 1));
      x = place.x;
      y = place.y;
      moved.min_x = std::min(moved.min_x, x);
      moved.max_x = std::max(moved.max_x, x);
      moved.min_y = std::min(moved.min_y, y);
      moved.max_y = std::max(moved.max_y, y);
    }
  if (!std::isfinite(moved.max_x - moved.min_x) || !std::isfinite(moved.max_y - moved.min_y))
    throw Error(
        "--within: the polygons (" + asked.text() + ", taken as degrees) have no place in " + crs_name(inputs.crs),
        ExitCode::usage);
  const std::string note =
      "the polygons of --within are taken as degrees (WGS 84) and moved to " + crs_name(inputs.crs);
  progress.note(note);
  record.warnings.push_back(note);
  return moved;
}

}  // namespace ilot
