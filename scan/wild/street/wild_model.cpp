// SPDX-License-Identifier: Apache-2.0
#include <map>

#include "scan/streets/object_classes.h"
#include "scan/wild/street/wild_street.h"

namespace ilot::scan {
namespace {

// The solids of an object where it stands, with its labels.
std::vector<Part> parts_of(WildStreetModel& model, const WildObject& object) {
  std::map<SurfaceId, SurfaceId> surface_of;  // by material
  const StreetClass own =
      object.is_tree() || object.is_plant() ? StreetClass::vegetation : class_of(artefact_class_of(object.kind->name));
  std::vector<Part> parts;
  for (const Solid& local : object.shape.solids) {
    Solid solid = placed(local, object.pose);
    for (SurfaceId& surface : solid.surfaces) {
      const auto [entry, fresh] = surface_of.try_emplace(surface, 0);
      if (fresh)
        entry->second = model.street.scene.add_surface(
            {static_cast<std::uint8_t>(own), 0, object.id, static_cast<Material>(surface)});
      surface = entry->second;
    }
    parts.push_back(solid);
  }
  return parts;
}

void add_object(WildStreetModel& model, const WildObject& object, double leaf_density) {
  std::vector<Part> parts = parts_of(model, object);
  if (object.moves() || object.comes_and_goes) {
    const Box3<Vec3> box = bounds_of(parts);
    model.moving.push_back({object.id, std::move(parts), box});
  } else {
    for (Part& part : parts) model.street.scene.parts.push_back(std::move(part));
  }
  for (const Crown& leaf : object.shape.leaves)
    model.leaves.push_back({{object.pose.place(leaf.centre), leaf.radii}, object.id, leaf_density});
}

}  // namespace

WildStreetModel build_wild_street(const WildStreet& street, const std::vector<WildObject>& objects, Draws& draws) {
  WildStreetModel model;
  add_wild_ground(model, street);
  for (const StreetPlot& plot : street.plots)
    if (plot.use == PlotUse::house) add_wild_house(model, street, plot, draws);
  if (street.layout == "court") add_court_ends(model, street, draws);
  for (const WildObject& object : objects) add_object(model, object, draws.number("street.leaf_density", object.id));
  return model;
}

}  // namespace ilot::scan
