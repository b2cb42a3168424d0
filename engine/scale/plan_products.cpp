// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/plan_products.h"

#include <algorithm>

#include "engine/columns/colours_pass.h"
#include "engine/error.h"
#include "engine/products/planes/product.h"
#include "engine/products/roofs/product.h"
#include "engine/products/streets/product.h"
#include "engine/report/counted.h"
#include "engine/run/products.h"

namespace ilot {
namespace {

bool asks_for(const std::vector<std::string>& products, const Product& product) {
  return std::ranges::find(products, product.name) != products.end();
}

bool any(const Plan& plan, bool Product::*needs) {
  return std::ranges::any_of(products_to_make(plan.products), needs);
}

bool has_planes(const std::vector<std::string>& products) {
  return std::ranges::count(products_to_make(products), &planes_product()) > 0;
}

// Planes read colours for their classes alone.
bool asks_for_colours(const Plan& plan) {
  return std::ranges::any_of(products_to_make(plan.products), [&](const Product* product) {
    return product->reads_colours && (product != &planes_product() || plan.settings.planes.colour_classes > 0);
  });
}

void check_planes(const RunOptions& run) {
  if (!has_planes(run.products)) return;
  if (run.settings.planes.method == PlaneMethod::colour_ransac)
    throw Error(
        "planes.method = colour_ransac: its classes of colours depend on all points, and a plan does not "
        "freeze them; make planes with ilot run",
        ExitCode::usage);
}

bool is_of_roofs_alone(const std::vector<std::string>& products) {
  return products.size() == 1 && asks_for(products, roofs_product());
}

}  // namespace

void check_products(const PlanOptions& options) {
  const RunOptions& run = options.run;
  const bool roofs = asks_for(run.products, roofs_product());
  if (run.settings.roofs.dtm)
    throw Error("roofs.dtm: a plan makes no terrain model; make it with ilot run", ExitCode::usage);
  if (is_of_roofs_alone(run.products) && run.settings.classes.write && !options.labels)
    throw Error("classes.write: a plan of roofs alone writes no clouds; give --labels or leave it out",
                ExitCode::usage);
  if (!roofs && !run.footprints.empty())
    throw Error("--footprints " + run.footprints.string() + ": only the product roofs reads it; leave it out",
                ExitCode::usage);
  if (!run.stations.empty() && !has_planes(run.products))
    throw Error("--stations " + run.stations.string() + ": only planes and facades read it; leave it out",
                ExitCode::usage);
  check_planes(run);
}

bool makes_roofs(const Plan& plan) {
  return asks_for(plan.products, roofs_product());
}

bool carries_points(const Plan& plan) {
  return plan.labels || !is_of_roofs_alone(plan.products);
}

bool carries_roof_labels(const Plan& plan) {
  return makes_roofs(plan) && carries_points(plan);
}

bool searches_planes(const Plan& plan) {
  return has_planes(plan.products);
}

Settings settings_of_cells(const Plan& plan) {
  return settings_of_planes(plan.settings, asks_for(plan.products, planes_product()));
}

bool carries_class_codes(const Plan& plan) {
  return asks_for(plan.products, streets_product());
}

bool reads_colours(const Plan& plan) {
  return asks_for_colours(plan) && std::ranges::any_of(plan.inputs, &PlanInput::colours);
}

bool carries_colours(const Plan& plan, const PlanArea& area) {
  const auto coloured = [&](std::uint32_t input) { return plan.inputs[input].colours; };
  return asks_for_colours(plan) && std::ranges::any_of(area.inputs, coloured);
}

bool carries_stations(const Plan& plan, const PlanArea& area) {
  const auto told_by_rows = [&](std::uint32_t input) {
    const InputStations& stations = plan.inputs[input].stations;
    return stations.of_all == 0 && !stations.of_source.empty();
  };
  return plan.stations.size() > 1 && any(plan, &Product::reads_stations) &&
         std::ranges::any_of(area.inputs, told_by_rows);
}

std::uint64_t part_bytes_of_point(const Plan& plan, const PlanArea& area) {
  // Derived: code and place in the inputs; normal and label where planes are searched, and little for the planes.
  constexpr std::uint64_t kOfPoint = 16, kOfPlanes = 12;
  // Choice: the role, and a label of 20 bytes for one point in four.
  constexpr std::uint64_t kOfRoofs = 6;
  return kOfPoint + (searches_planes(plan) ? kOfPlanes : 0) + (carries_roof_labels(plan) ? kOfRoofs : 0) +
         (carries_class_codes(plan) ? sizeof(std::uint8_t) : 0) +
         (carries_colours(plan, area) ? sizeof(StoredColour) : 0) +
         (carries_stations(plan, area) ? sizeof(StationNumber) : 0);
}

double microseconds_of_point(const Plan& plan) {
  return (makes_roofs(plan) ? roofs_product().cost.microseconds : 0) +
         (searches_planes(plan) ? planes_product().cost.microseconds : 0);
}

std::string what_is_made(const Plan& plan) {
  std::string text;
  for (const std::string& product : plan.products)
    text += (text.empty() ? "" : ", ") +
            (product == roofs_product().name ? counted(plan.roofs.sites, "building") : product);
  return text;
}

}  // namespace ilot
