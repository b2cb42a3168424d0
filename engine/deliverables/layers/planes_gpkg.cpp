// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/planes_gpkg.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "engine/deliverables/layers/gpkg_file.h"

namespace ilot {
namespace {

std::unique_ptr<OGRLinearRing> closed_ring(Outline::Ring ring) {
  auto closed = std::make_unique<OGRLinearRing>();
  const int n = static_cast<int>(ring.size());
  closed->set3D(true);
  closed->setNumPoints(n + 1, FALSE);
  for (int i = 0; i <= n; ++i) {
    const Vec3& p = ring[static_cast<std::size_t>(i % n)];
    closed->setPoint(i, p.x, p.y, p.z);
  }
  return closed;
}

// Rings are passed on and freed one by one, because the ground of a large area has millions of corners.
std::unique_ptr<OGRMultiPolygon> geometry_of(Outline outline) {
  auto all = std::make_unique<OGRMultiPolygon>();
  all->set3D(true);
  for (Outline::Part& part : outline.parts) {
    auto polygon = std::make_unique<OGRPolygon>();
    polygon->set3D(true);
    for (Outline::Ring& ring : part) polygon->addRingDirectly(closed_ring(std::move(ring)).release());
    all->addGeometryDirectly(polygon.release());
  }
  return all;
}

}  // namespace

struct PlanesGpkg::Layer {
  GpkgFile file;
  OGRLayer& planes;

  Layer(const std::filesystem::path& path, const Crs& crs)
      : file(path), planes(file.add_layer("planes", wkbMultiPolygon25D, crs)) {
    GpkgFile::add_field(planes, "plane_id", OFTInteger64);
    GpkgFile::add_field(planes, "content_id", OFTString);
    GpkgFile::add_field(planes, "points", OFTInteger64);
    for (const char* name :
         {"nx", "ny", "nz", "d", "epsilon_m", "rms_m", "area_m2", "level_m", "up_m", "normal_spread_deg", "confidence"})
      GpkgFile::add_field(planes, name, OFTReal);
    GpkgFile::add_field(planes, "colour_class", OFTInteger);
    GpkgFile::add_field(planes, "neighbours", OFTInteger64);
    file.set_style(planes, style_of_planes());
  }
};

PlanesGpkg::PlanesGpkg(const std::filesystem::path& path, const Crs& crs)
    : layer_(std::make_unique<Layer>(path, crs)) {}

PlanesGpkg::~PlanesGpkg() = default;

void PlanesGpkg::add(const Segment& s, Outline outline) {
  OGRFeature feature(layer_->planes.GetLayerDefn());
  feature.SetField("plane_id", static_cast<GIntBig>(s.id));
  feature.SetField("content_id", fmt::format("{:016x}", s.content_id).c_str());
  feature.SetField("points", static_cast<GIntBig>(s.points));
  feature.SetField("nx", s.plane.n.x);
  feature.SetField("ny", s.plane.n.y);
  feature.SetField("nz", s.plane.n.z);
  feature.SetField("d", s.plane.d);
  feature.SetField("epsilon_m", s.epsilon_m);
  feature.SetField("rms_m", s.rms_m);
  feature.SetField("area_m2", s.area_m2);
  feature.SetField("level_m", s.level_m);
  feature.SetField("up_m", s.up_m);
  feature.SetField("normal_spread_deg", s.normal_spread_deg);
  feature.SetField("confidence", s.confidence);
  feature.SetField("colour_class", static_cast<int>(s.colour_class));
  feature.SetField("neighbours", static_cast<GIntBig>(s.neighbours));
  feature.SetGeometryDirectly(geometry_of(std::move(outline)).release());
  layer_->file.add(layer_->planes, feature);
}

void PlanesGpkg::finish() {
  layer_->file.finish();
}

}  // namespace ilot
