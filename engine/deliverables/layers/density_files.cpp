// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/density_files.h"

#include <cpl_conv.h>
#include <fmt/format.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "engine/deliverables/layers/silent_gdal.h"
#include "engine/error.h"
#include "engine/whole_file.h"
#include "kernels/core/quantile.h"

namespace ilot {
namespace {

constexpr int kPictureSide = 480;  // smallest side of a panel, in pixels of the picture
constexpr int kGap = 8;            // between panels

using Colour = std::array<std::uint8_t, 3>;

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw Error(path.string() + ": cannot be written: " + CPLGetLastErrorMsg());
}

GDALDriver& driver(const char* name) {
  GDALDriver* found = GetGDALDriverManager()->GetDriverByName(name);
  if (found == nullptr) throw Error(std::string("GDAL has no driver ") + name + "; install it with GDAL");
  return *found;
}

void write_band(GDALDataset& file, int number, const char* name, std::vector<float> values,
                const std::filesystem::path& path) {
  GDALRasterBand* band = file.GetRasterBand(number);
  band->SetDescription(name);
  band->SetNoDataValue(std::nan(""));
  if (band->RasterIO(GF_Write, 0, 0, file.GetRasterXSize(), file.GetRasterYSize(), values.data(), file.GetRasterXSize(),
                     file.GetRasterYSize(), GDT_Float32, 0, 0) != CE_None)
    fail(path);
}

std::vector<float> ratios(const DensityMap& map) {
  std::vector<float> ratio(map.measured.size());
  for (std::size_t i = 0; i < ratio.size(); ++i) ratio[i] = map.measured[i] / map.predicted[i];
  return ratio;
}

std::string text_of(Vec3 v) {
  return fmt::format("{} {} {}", v.x, v.y, v.z);
}

void write_tif(const std::filesystem::path& path, const DensityMap& map, double metres_per_unit) {
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  const GDALDatasetUniquePtr file(driver("GTiff").Create(path.c_str(), static_cast<int>(map.width),
                                                         static_cast<int>(map.height), 3, GDT_Float32, options.List()));
  if (!file) fail(path);
  const double pixel = map.pixel * metres_per_unit;
  double place[6] = {map.left * metres_per_unit, pixel, 0, map.top * metres_per_unit, 0, -pixel};
  file->SetGeoTransform(place);
  file->SetMetadataItem("plane_id", std::to_string(map.plane_id).c_str());
  file->SetMetadataItem("origin", text_of(map.origin).c_str());
  file->SetMetadataItem("right", text_of(map.right).c_str());
  file->SetMetadataItem("up", text_of(map.up).c_str());
  write_band(*file, 1, "measured", map.measured, path);
  write_band(*file, 2, "predicted", map.predicted, path);
  write_band(*file, 3, "measured / predicted", ratios(map), path);
  CPLErrorReset();
  file->FlushCache();
  if (CPLGetLastErrorType() >= CE_Failure) fail(path);
}

// Places with few points are dark, the densest are light. The square root keeps the sparse parts distinguishable.
Colour grey(float density, double densest) {
  if (std::isnan(density)) return {255, 255, 255};
  const auto level = static_cast<std::uint8_t>(std::min(230.0, 230 * std::sqrt(density / densest)));
  return {level, level, level};
}

// White where both agree, red where points are missing, blue where there are more points than predicted.
Colour difference(float measured, float predicted) {
  if (std::isnan(measured) || std::isnan(predicted)) return {200, 200, 200};
  const double d = (static_cast<double>(measured) - predicted) / (static_cast<double>(measured) + predicted);
  const auto level = [](double v) { return static_cast<std::uint8_t>(std::clamp(255 * v, 0.0, 255.0)); };
  return d < 0 ? Colour{level(1 + 0.2 * d), level(1 + d), level(1 + d)} : Colour{level(1 - d), level(1 - d), level(1)};
}

// Three panels side by side: measured and predicted (on one scale), and their difference.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bands[3];

  Picture(int w, int h) : width(w), height(h) {
    for (auto& b : bands) b.assign(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), 255);
  }
  void square(int x, int y, int side, Colour colour) {
    for (int r = y; r < y + side; ++r)
      for (std::size_t b = 0; b < 3; ++b)
        std::fill_n(bands[b].begin() + static_cast<std::ptrdiff_t>(r) * width + x, side, colour[b]);
  }
};

Picture picture_of(const DensityMap& map) {
  const int w = static_cast<int>(map.width), h = static_cast<int>(map.height);
  const int side = std::max(1, kPictureSide / std::max(w, h));
  double densest = 0;
  for (const auto* values : {&map.measured, &map.predicted})
    for (const float v : *values)
      if (v > densest) densest = v;
  Picture picture(3 * w * side + 2 * kGap, h * side);
  for (int r = 0; r < h; ++r)
    for (int c = 0; c < w; ++c) {
      const std::size_t i = static_cast<std::size_t>(r) * map.width + static_cast<std::size_t>(c);
      const bool outside = std::isnan(map.measured[i]);
      const Colour panels[3] = {grey(map.measured[i], densest), grey(map.predicted[i], densest),
                                outside ? Colour{255, 255, 255} : difference(map.measured[i], map.predicted[i])};
      for (int p = 0; p < 3; ++p) picture.square(p * (w * side + kGap) + c * side, r * side, side, panels[p]);
    }
  return picture;
}

void write_png(const std::filesystem::path& path, const DensityMap& map) {
  Picture picture = picture_of(map);
  const GDALDatasetUniquePtr image(driver("MEM").Create("", picture.width, picture.height, 3, GDT_Byte, nullptr));
  if (!image) fail(path);
  for (int b = 0; b < 3; ++b)
    if (image->GetRasterBand(b + 1)->RasterIO(GF_Write, 0, 0, picture.width, picture.height, picture.bands[b].data(),
                                              picture.width, picture.height, GDT_Byte, 0, 0) != CE_None)
      fail(path);
  const GDALDatasetUniquePtr file(driver("PNG").CreateCopy(path.c_str(), image.get(), 1, nullptr, nullptr, nullptr));
  if (!file) fail(path);
}

// Returns the value that this share of the values does not exceed; NaN when there are no values.
double quantile(std::vector<float> values, double share) {
  return values.empty() ? std::nan("") : static_cast<double>(lower_quantile(values, share));
}

std::string number(double value) {
  return std::isnan(value) ? "" : fmt::format("{:.4g}", value);
}

std::string line_of(const DensityMap& map, double metres_per_unit) {
  const auto known = [](std::vector<float> values) {
    std::erase_if(values, [](float v) { return std::isnan(v); });
    return values;
  };
  const std::vector<float> measured = known(map.measured), ratio = known(ratios(map));
  return fmt::format("{},{},{},{},{},{},{},{}\n", map.plane_id, number(map.pixel * metres_per_unit), measured.size(),
                     number(quantile(measured, 0.5)), number(quantile(known(map.predicted), 0.5)),
                     number(quantile(ratio, 0.1)), number(quantile(ratio, 0.5)), number(quantile(ratio, 0.9)));
}

}  // namespace

DensityFiles::DensityFiles(std::filesystem::path folder, double metres_per_unit)
    : folder_(std::move(folder)),
      metres_per_unit_(metres_per_unit),
      table_("plane_id,pixel_m,pixels,measured,predicted,ratio_p10,ratio_median,ratio_p90\n") {
  CPLSetErrorHandler(keep_silent);
  CPLSetConfigOption("GDAL_PAM_ENABLED", "NO");
  GDALRegister_GTiff();
  GDALRegister_MEM();
  GDALRegister_PNG();
  std::filesystem::create_directories(folder_);
}

void DensityFiles::add(const DensityMap& map) {
  const std::string name = fmt::format("plane-{:06}", map.plane_id);
  write_tif(folder_ / (name + ".tif"), map, metres_per_unit_);
  write_png(folder_ / (name + ".png"), map);
  table_ += line_of(map, metres_per_unit_);
}

void DensityFiles::finish() {
  write_whole_file(folder_ / "density.csv", table_);
}

}  // namespace ilot
