// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/small_image.h"

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <vector>

#include "engine/deliverables/layers/silent_gdal.h"

namespace ilot {
namespace {

// The six numbers of a world file: width of a pixel, two turns, minus its height, middle of the first pixel.
std::optional<FlatBox> place_of_image(const std::filesystem::path& world_file, int width, int height) {
  std::ifstream file(world_file);
  std::array<double, 6> w{};
  for (double& value : w)
    if (!(file >> value)) return std::nullopt;
  const double left = w[4] - w[0] / 2, top = w[5] - w[3] / 2;
  return FlatBox{{left, top + w[3] * height}, {left + w[0] * width, top}};
}

using Pixels = std::vector<GByte>;  // red, green, blue, alpha

std::optional<Pixels> read_pixels(GDALDataset& image, int width, int height) {
  Pixels pixels(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255);
  const int bands = std::min(4, image.GetRasterCount());
  GDALRasterIOExtraArg how;
  INIT_RASTERIO_EXTRA_ARG(how);
  how.eResampleAlg = GRIORA_Average;
  if (bands < 3 || image.RasterIO(GF_Read, 0, 0, image.GetRasterXSize(), image.GetRasterYSize(), pixels.data(), width,
                                  height, GDT_Byte, bands, nullptr, 4, GSpacing{4} * width, 1, &how) != CE_None)
    return std::nullopt;
  for (std::size_t i = 0; i < pixels.size(); i += 4)
    for (std::size_t c = 0; c < 3; ++c)
      pixels[i + c] = static_cast<GByte>((pixels[i + c] * pixels[i + 3] + 255 * (255 - pixels[i + 3])) / 255);
  return pixels;
}

std::string jpeg_of(const Pixels& pixels, int width, int height) {
  constexpr const char* kName = "/vsimem/ilot-small.jpg";
  const GDALDatasetUniquePtr picture(
      GetGDALDriverManager()->GetDriverByName("MEM")->Create("", width, height, 3, GDT_Byte, nullptr));
  if (!picture || picture->RasterIO(GF_Write, 0, 0, width, height, const_cast<GByte*>(pixels.data()), width, height,
                                    GDT_Byte, 3, nullptr, 4, GSpacing{4} * width, 1, nullptr) != CE_None)
    return {};
  CPLStringList options;
  options.SetNameValue("QUALITY", "70");
  const GDALDatasetUniquePtr copy(GetGDALDriverManager()->GetDriverByName("JPEG")->CreateCopy(
      kName, picture.get(), FALSE, options.List(), nullptr, nullptr));
  if (!copy) return {};
  vsi_l_offset size = 0;
  const std::unique_ptr<GByte, decltype(&VSIFree)> bytes(VSIGetMemFileBuffer(kName, &size, TRUE), &VSIFree);
  VSIUnlink((std::string(kName) + ".aux.xml").c_str());
  return bytes ? std::string(reinterpret_cast<const char*>(bytes.get()), size) : std::string();
}

}  // namespace

std::optional<SmallImage> small_image(const std::filesystem::path& png, int most_pixels) {
  CPLPushErrorHandler(keep_silent);
  GDALRegister_MEM();
  GDALRegister_PNG();
  GDALRegister_JPEG();
  std::optional<SmallImage> result;
  const char* drivers[] = {"PNG", nullptr};
  const GDALDatasetUniquePtr image(GDALDataset::Open(png.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers));
  std::filesystem::path world = png;
  if (image) {
    const int wide = image->GetRasterXSize(), high = image->GetRasterYSize();
    const double scale = std::min(1.0, static_cast<double>(most_pixels) / std::max(wide, high));
    const int width = std::max(1, static_cast<int>(wide * scale)), height = std::max(1, static_cast<int>(high * scale));
    const auto place = place_of_image(world.replace_extension(".pgw"), wide, high);
    const auto pixels = read_pixels(*image, width, height);
    if (place && pixels) result = SmallImage{jpeg_of(*pixels, width, height), *place};
    if (result && result->jpeg.empty()) result.reset();
  }
  CPLPopErrorHandler();
  return result;
}

}  // namespace ilot
