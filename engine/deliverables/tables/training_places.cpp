// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/tables/training_places.h"

#include <cpl_string.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "engine/deliverables/layers/spatial_reference.h"
#include "engine/error.h"
#include "engine/model/point_label.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 40;  // bytes of the name of a class

Error usage(const fs::path& path, const std::string& sentence) {
  return Error(path.string() + ": " + sentence, ExitCode::usage);
}

bool is_letter(unsigned char c) {
  return c >= 0x80 || std::isalnum(c) != 0 || std::string_view(" _-./").find(static_cast<char>(c)) != std::string::npos;
}

// The name of a class, as a file has it.
std::string checked(const fs::path& path, const std::string& name) {
  const auto label = label_named(name);
  if (label && *label != PointLabel::vegetation && !is_street_object(*label))
    throw usage(path, "'" + name + "' is no class of objects on a street");
  const bool good =
      CPLIsUTF8(name.c_str(), -1) && !name.empty() && name.size() <= kLongestName && name.front() != ' ' &&
      name.back() != ' ' &&
      std::all_of(name.begin(), name.end(), [](char c) { return is_letter(static_cast<unsigned char>(c)); });
  if (!good)
    throw usage(path, "'" + name.substr(0, kLongestName) +
                          "' is no name of a class: it needs 1 to 40 letters, digits, blanks and _ - . / in UTF-8");
  return name;
}

std::vector<TrainingPlace> read_truth_places(const fs::path& path) {
  std::ifstream file(path);
  const auto root = nlohmann::json::parse(file, nullptr, false);
  if (!root.is_object() || !root.contains("objects")) throw usage(path, "is no truth file with objects");
  std::vector<TrainingPlace> places;
  try {
    for (const auto& o : root.at("objects")) {
      const auto& at = o.contains("box") ? o.at("box").at("centre") : o.at("base");
      const Vec3 place{at.at(0).get<double>(), at.at(1).get<double>(), at.at(2).get<double>()};
      places.push_back({place, checked(path, o.at("class").get<std::string>())});
    }
  } catch (const nlohmann::json::exception& e) {
    throw usage(path, std::string("an object is broken: ") + e.what());
  }
  return places;
}

int class_field(OGRFeatureDefn& layer) {
  for (int i = 0; i < layer.GetFieldCount(); ++i)
    if (EQUAL(layer.GetFieldDefn(i)->GetNameRef(), "class")) return i;
  return -1;
}

std::vector<TrainingPlace> read_layer(const fs::path& path, OGRLayer& layer, const Crs& crs) {
  const int field = class_field(*layer.GetLayerDefn());
  if (field < 0) throw usage(path, "has no attribute 'class'");
  std::unique_ptr<OGRCoordinateTransformation> transformation;
  const auto target = spatial_reference(crs);
  if (const OGRSpatialReference* found = layer.GetSpatialRef(); found != nullptr && target != nullptr) {
    const std::unique_ptr<OGRSpatialReference> source(found->Clone());
    source->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    source->StripVertical(), target->StripVertical();
    if (!source->IsSame(target.get()))
      transformation.reset(OGRCreateCoordinateTransformation(source.get(), target.get()));
  }
  std::vector<TrainingPlace> places;
  for (const auto& feature : layer) {
    OGRGeometry* geometry = feature->GetGeometryRef();
    if (geometry == nullptr || geometry->IsEmpty()) continue;
    OGRPoint middle;
    if (geometry->Centroid(&middle) != OGRERR_NONE) continue;
    if (transformation && middle.transform(transformation.get()) != OGRERR_NONE) continue;
    if (!std::isfinite(middle.getX()) || !std::isfinite(middle.getY())) continue;
    places.push_back({{middle.getX(), middle.getY(), 0}, checked(path, feature->GetFieldAsString(field))});
  }
  return places;
}

}  // namespace

std::vector<TrainingPlace> read_training_places(const fs::path& path, const Crs& crs) {
  if (!fs::is_regular_file(path)) throw usage(path, "no such file");
  if (path.filename().string().ends_with(".truth.json")) return read_truth_places(path);
  GDALAllRegister();
  const GDALDatasetUniquePtr file(
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
  if (!file) throw usage(path, "is no vector file that can be read");
  for (OGRLayer* layer : file->GetLayers())
    if (layer->GetFeatureCount() > 0) return read_layer(path, *layer, crs);
  throw usage(path, "contains no feature");
}

}  // namespace ilot
