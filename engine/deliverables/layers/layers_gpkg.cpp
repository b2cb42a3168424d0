// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/layers_gpkg.h"

#include <cmath>
#include <memory>

#include "engine/deliverables/layers/gpkg_file.h"

namespace ilot {
namespace {

void add_points(OGRSimpleCurve& curve, const std::vector<Vec3>& points, bool flat) {
  for (const Vec3& p : points) flat ? curve.addPoint(p.x, p.y) : curve.addPoint(p.x, p.y, p.z);
}

std::unique_ptr<OGRGeometry> geometry_of(const LayerFeature& feature, LayerShape shape, bool flat) {
  if (shape == LayerShape::point) {
    const Vec3& p = feature.rings.at(0).at(0);
    return flat ? std::make_unique<OGRPoint>(p.x, p.y) : std::make_unique<OGRPoint>(p.x, p.y, p.z);
  }
  if (shape == LayerShape::line) {
    auto line = std::make_unique<OGRLineString>();
    add_points(*line, feature.rings.at(0), flat);
    return line;
  }
  auto polygon = std::make_unique<OGRPolygon>();
  for (const auto& ring : feature.rings) {
    auto closed = std::make_unique<OGRLinearRing>();
    add_points(*closed, ring, flat);
    closed->closeRings();
    polygon->addRingDirectly(closed.release());
  }
  return polygon;
}

OGRwkbGeometryType type_of(const Layer& layer) {
  constexpr OGRwkbGeometryType kFlat[] = {wkbPoint, wkbLineString, wkbPolygon};
  constexpr OGRwkbGeometryType kSpace[] = {wkbPoint25D, wkbLineString25D, wkbPolygon25D};
  return (layer.flat ? kFlat : kSpace)[static_cast<int>(layer.shape)];
}

void add_fields(const Layer& layer, OGRLayer& table) {
  constexpr OGRFieldType kTypes[] = {OFTInteger64, OFTReal, OFTString, OFTInteger};
  for (std::size_t i = 0; i < layer.fields.size(); ++i) {
    const std::size_t kind = layer.features.empty() ? 2 : layer.features[0].values.at(i).index();
    GpkgFile::add_field(table, layer.fields[i].c_str(), kTypes[kind], kind == 3 ? OFSTBoolean : OFSTNone);
  }
}

void set(OGRFeature& feature, int field, const AttributeValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) feature.SetField(field, static_cast<GIntBig>(*whole));
  if (const auto* text = std::get_if<std::string>(&value)) feature.SetField(field, text->c_str());
  if (const auto* truth = std::get_if<bool>(&value)) feature.SetField(field, *truth ? 1 : 0);
  if (const auto* real = std::get_if<double>(&value); real && std::isfinite(*real)) feature.SetField(field, *real);
}

}  // namespace

void write_layers(const std::filesystem::path& path, std::span<const Layer> layers, const Crs& crs) {
  GpkgFile file(path);
  std::vector<OGRLayer*> tables;
  for (const Layer& layer : layers) {
    tables.push_back(&file.add_layer(layer.name.c_str(), type_of(layer), crs));
    add_fields(layer, *tables.back());
  }
  for (std::size_t n = 0; n < layers.size(); ++n) {
    for (const LayerFeature& from : layers[n].features) {
      OGRFeature feature(tables[n]->GetLayerDefn());
      for (std::size_t i = 0; i < from.values.size(); ++i) set(feature, static_cast<int>(i), from.values[i]);
      feature.SetGeometryDirectly(geometry_of(from, layers[n].shape, layers[n].flat).release());
      file.add(*tables[n], feature);
    }
  }
  file.finish();
}

}  // namespace ilot
