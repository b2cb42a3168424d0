// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/facade_image.h"

#include <cpl_vsi.h>
#include <gdal_priv.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "engine/deliverables/facade_plan.h"
#include "engine/error.h"
#include "engine/whole_file.h"
#include "kernels/rasters/front_image.h"

extern "C" void GDALRegister_PNG();
extern "C" void GDALRegister_MEM();

namespace ilot {
namespace {

constexpr double kStep = 1e-4;  // metres, of distances from the wall

DrawingBox extent_of(const Facade& facade, const FacadeImageParams& params) {
  const FlatPoint origin = flat_place(facade, facade.origin, params.metres_per_unit);
  DrawingBox box{origin.x, origin.y, origin.x + facade.width_m, origin.y + facade.height_m};
  bool empty = true;
  for (const FacadeElement& e : facade.elements)
    for (const Vec3& corner : e.ring) {
      const FlatPoint p = flat_place(facade, corner, params.metres_per_unit);
      if (empty) box = {p.x, p.y, p.x, p.y};
      empty = false;
      box = {std::min(box.min_x, p.x), std::min(box.min_y, p.y), std::max(box.max_x, p.x), std::max(box.max_y, p.y)};
    }
  const double by = params.around_m;
  return {box.min_x - by, box.min_y - by, box.max_x + by, box.max_y + by};
}

// The mean distance of points, rounded up to 1, 2 or 5 in its decade.
double mean_distance(const Facade& facade, const PointSource& source, const DrawingBox& extent,
                     const FacadeImageParams& params) {
  std::uint64_t inside = 0;
  source([&](std::span<const ImagePoint> points) {
    for (const ImagePoint& point : points) {
      const FlatPoint p = flat_place(facade, point.position, params.metres_per_unit);
      const double out = params.metres_per_unit * dot(point.position - facade.origin, facade.out);
      inside += p.x >= extent.min_x && p.x <= extent.max_x && p.y >= extent.min_y && p.y <= extent.max_y &&
                out <= params.front_m && out >= -params.behind_m;
    }
  });
  const double distance =
      std::sqrt(extent.width() * extent.height() / static_cast<double>(std::max<std::uint64_t>(inside, 1)));
  for (double decade = 0.001; decade < 1; decade *= 10)
    for (const double step : {1.0, 2.0, 5.0})
      if (step * decade >= distance && step * decade > 0.0015) return step * decade;
  return 1;
}

// Pixels with corners at multiples of their size.
FacadeImage blank_image(const DrawingBox& extent, double pixel_m, const FacadeImageParams& params) {
  FacadeImage image;
  for (image.pixel_m = pixel_m;; image.pixel_m *= 2) {
    const double s = image.pixel_m;
    const double left = std::floor(extent.min_x / s), right = std::max(std::ceil(extent.max_x / s), left + 1);
    const double low = std::floor(extent.min_y / s), high = std::max(std::ceil(extent.max_y / s), low + 1);
    if (!std::isfinite(right - left) || !std::isfinite(high - low)) throw Error("a facade of no finite extent");
    if ((right - left) * (high - low) > static_cast<double>(params.most_pixels)) continue;
    image.width = static_cast<std::uint32_t>(right - left);
    image.height = static_cast<std::uint32_t>(high - low);
    image.place = {left * s, low * s, right * s, high * s};
    return image;
  }
}

class Projector {
 public:
  Projector(const Facade& facade, const FacadeImage& image, const FacadeImageParams& params)
      : facade_(facade), image_(image), params_(params) {}

  // Points that fall into the image, for one piece of the source.
  std::span<const FrontPoint> operator()(std::span<const ImagePoint> points) {
    placed_.clear();
    for (const ImagePoint& point : points) {
      const FlatPoint p = flat_place(facade_, point.position, params_.metres_per_unit);
      const double out = params_.metres_per_unit * dot(point.position - facade_.origin, facade_.out);
      const double column = std::floor((p.x - image_.place.min_x) / image_.pixel_m);
      const double row = std::floor((image_.place.max_y - p.y) / image_.pixel_m);
      if (!(column >= 0 && column < image_.width && row >= 0 && row < image_.height)) continue;
      if (!(out <= params_.front_m && out >= -params_.behind_m)) continue;
      const auto pixel = static_cast<std::uint32_t>(row) * image_.width + static_cast<std::uint32_t>(column);
      placed_.push_back({pixel, static_cast<std::int32_t>(std::lround(out / kStep)), colour(point, out)});
    }
    return placed_;
  }

 private:
  std::array<std::uint8_t, 3> colour(const ImagePoint& point, double out) const {
    if (params_.shade == ImageShade::colour) return point.colour;
    // The wall is grey; a quarter of a metre before it is white, as much behind it black.
    const double share = std::clamp(0.5 + out / 0.5, 0.0, 1.0);
    const auto grey = static_cast<std::uint8_t>(std::lround(255 * share));
    return {grey, grey, grey};
  }
  const Facade& facade_;
  const FacadeImage& image_;
  const FacadeImageParams& params_;
  std::vector<FrontPoint> placed_;
};

std::string world_file(const FacadeImage& image) {
  const double s = image.pixel_m;
  std::string text;
  for (const double v : {s, 0.0, 0.0, -s, image.place.min_x + s / 2, image.place.max_y - s / 2})
    text += decimal(v, 9) + "\n";
  return text;
}

void keep_silent(CPLErr, CPLErrorNum, const char*) {}

}  // namespace

FacadeImage facade_image(const Facade& facade, const PointSource& source, const FacadeImageParams& params) {
  const DrawingBox extent = extent_of(facade, params);
  FacadeImage image =
      blank_image(extent, params.pixel_m > 0 ? params.pixel_m : mean_distance(facade, source, extent, params), params);
  FrontImage front(static_cast<std::size_t>(image.width) * image.height);
  Projector project(facade, image, params);
  source([&](std::span<const ImagePoint> points) { keep_front(front, project(points)); });
  const auto band = static_cast<std::int32_t>(std::lround(params.band_m / kStep));
  source([&](std::span<const ImagePoint> points) { add_colours(front, project(points), band); });
  for (const std::uint32_t count : front.count) image.points += count;
  image.rgba = mean_colours(front);
  image.filled = fill_gaps(image.rgba, image.width, image.height, params.fill_rounds);
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.empty += image.rgba[i] == 0;
  return image;
}

void write_facade_image(const std::filesystem::path& path, const FacadeImage& image) {
  CPLPushErrorHandler(keep_silent);
  GDALRegister_MEM();
  GDALRegister_PNG();
  const int width = static_cast<int>(image.width), height = static_cast<int>(image.height);
  GDALDatasetUniquePtr picture(
      GetGDALDriverManager()->GetDriverByName("MEM")->Create("", width, height, 4, GDT_Byte, nullptr));
  std::string png;
  CPLErr failed =
      picture ? picture->RasterIO(GF_Write, 0, 0, width, height, const_cast<std::uint8_t*>(image.rgba.data()), width,
                                  height, GDT_Byte, 4, nullptr, 4, 4 * static_cast<GSpacing>(width), 1, nullptr)
              : CE_Failure;
  if (failed == CE_None) {
    picture->GetRasterBand(4)->SetColorInterpretation(GCI_AlphaBand);
    // A name of its own for each, since facades may be written side by side.
    static std::atomic<std::uint64_t> written{0};
    const std::string name = "/vsimem/ilot-" + std::to_string(written++) + ".png";
    GDALDatasetUniquePtr copy(GetGDALDriverManager()->GetDriverByName("PNG")->CreateCopy(
        name.c_str(), picture.get(), FALSE, nullptr, nullptr, nullptr));
    failed = copy ? CE_None : CE_Failure;
    copy.reset();
    vsi_l_offset size = 0;
    if (GByte* bytes = VSIGetMemFileBuffer(name.c_str(), &size, TRUE)) {
      png.assign(reinterpret_cast<const char*>(bytes), size);
      VSIFree(bytes);
    }
    VSIUnlink((name + ".aux.xml").c_str());
  }
  CPLPopErrorHandler();
  if (failed != CE_None || png.empty()) throw Error(path.string() + ": cannot be written: " + CPLGetLastErrorMsg());
  write_whole_file(path, png);
  std::filesystem::path world = path;
  write_whole_file(world.replace_extension(".pgw"), world_file(image));
}

}  // namespace ilot
