// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/facade_image.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

#include "engine/deliverables/drawings/facade_plan.h"
#include "engine/deliverables/layers/silent_gdal.h"
#include "engine/error.h"
#include "engine/whole_file.h"
#include "kernels/core/parallel.h"
#include "kernels/rasters/front_image.h"

namespace ilot {
namespace {

constexpr double kStep = 1e-4;  // metres, of distances from the wall
constexpr double kCounted = 4;  // metres along a side of the parts whose points are counted together
// Choice: wider than the gaps between points of sparse scans, narrower than what of a wall was not seen.
constexpr double kCovered = 0.25;  // metres along a side of the cells that have points or not
// Derived: with two points along each side hardly a cell has none by chance: e to the power of -4, 2 %.
constexpr double kAcross = 2;  // points along a side of such a cell
// Choice: 2 MiB a part; without tiles a facade is one part, and of one longer than a kilometre the cells are larger.
constexpr double kMostCells = 4096;  // along a side of a part

FlatBox extent_of(const Facade& facade, const FacadeImageParams& params) {
  const FlatPoint origin = flat_place(facade, facade.origin, params.metres_per_unit);
  FlatBox box = FlatBox::none();
  for (const FacadeElement& e : facade.elements)
    for (const Vec3& corner : e.ring) box.add(flat_place(facade, corner, params.metres_per_unit));
  if (box.is_empty()) box = {origin, {origin.x + facade.width_m, origin.y + facade.height_m}};
  return box.grown(params.around_m);
}

// Returns the box in CRS units around everything that may be visible in a part of the drawing.
Box3<Vec3> box_about(const Facade& facade, const FlatBox& part, const FacadeImageParams& params) {
  constexpr double kRounding = 0.001;  // metres: no point at the border may be lost
  const double units = 1 / params.metres_per_unit;
  auto box = Box3<Vec3>::none();
  for (const double x : {part.min.x - kRounding, part.max.x + kRounding})
    for (const double y : {part.min.y - kRounding, part.max.y + kRounding})
      for (const double out : {-params.behind_m - kRounding, params.front_m + kRounding}) {
        const Vec3 p = facade.origin + (x * units) * facade.right + (y * units - facade.origin.z) * facade.up +
                       (out * units) * facade.out;
        box.add(p);
      }
  return box;
}

double pieces_of(double length, double longest) {
  constexpr double kMost = 64;
  return std::clamp(std::ceil(length / longest), 1.0, kMost);
}

// Divides a box along both axes; an end does not belong to a part when the next part begins there.
std::vector<FlatBox> parts_of(const FlatBox& box, double longest) {
  const double across = pieces_of(box.width(), longest), up = pieces_of(box.height(), longest);
  std::vector<FlatBox> parts;
  const auto at = [](double from, double to, double step, double steps) {
    return step == steps ? to : from + (to - from) * (step / steps);
  };
  for (double r = 0; r < up; ++r)
    for (double c = 0; c < across; ++c)
      parts.push_back({at(box.min.x, box.max.x, c, across), at(box.min.y, box.max.y, r, up),
                       at(box.min.x, box.max.x, c + 1, across), at(box.min.y, box.max.y, r + 1, up)});
  return parts;
}

// What of a part of the drawing has points.
struct Cover {
  std::uint64_t points = 0;
  double area = 0;  // square metres
};

Cover cover_of(const Facade& facade, const PointSource& source, const FlatBox& extent, const FlatBox& part,
               const FacadeImageParams& params) {
  // The cells of a whole are those of its parts.
  const auto cells = [](double length) {
    const double pieces = pieces_of(length, kCounted);
    return std::clamp(pieces * std::ceil(length / pieces / kCovered), 1.0, kMostCells);
  };
  const double columns = cells(part.width()), rows = cells(part.height());
  std::vector<bool> covered(static_cast<std::size_t>(columns * rows));
  Cover cover;
  const auto within = [](double v, double low, double high, double last) {
    return v >= low && (v < high || (v == high && high == last));
  };
  const auto cell = [](double v, double low, double length, double count) {
    return length > 0 && std::isfinite(length) ? std::min(std::floor((v - low) / length * count), count - 1) : 0;
  };
  source(box_about(facade, part, params), [&](std::span<const ImagePoint> points) {
    for (const ImagePoint& point : points) {
      const FlatPoint p = flat_place(facade, point.position, params.metres_per_unit);
      const double out = params.metres_per_unit * dot(point.position - facade.origin, facade.out);
      if (!within(p.x, part.min.x, part.max.x, extent.max.x) || !within(p.y, part.min.y, part.max.y, extent.max.y) ||
          !(out <= params.front_m && out >= -params.behind_m))
        continue;
      ++cover.points;
      covered[static_cast<std::size_t>(cell(p.y, part.min.y, part.height(), rows) * columns +
                                       cell(p.x, part.min.x, part.width(), columns))] = true;
    }
  });
  const auto count = static_cast<double>(std::count(covered.begin(), covered.end(), true));
  cover.area = part.width() * part.height() * count / (columns * rows);
  return cover;
}

// Returns the mean distance of points where there are some, rounded up to 1, 2 or 5 in its decade.
double mean_distance(const Facade& facade, const PointSource& source, const FlatBox& extent,
                     const FacadeImageParams& params) {
  const std::vector<FlatBox> parts = params.tile > 0 ? parts_of(extent, kCounted) : std::vector<FlatBox>{extent};
  std::vector<Cover> covers(parts.size());
  parallel_for(parts.size(), [&](std::size_t i) { covers[i] = cover_of(facade, source, extent, parts[i], params); });
  Cover all;
  for (const Cover& cover : covers) all.points += cover.points, all.area += cover.area;
  const auto distance_in = [&](double area) {
    return std::sqrt(area / static_cast<double>(std::max<std::uint64_t>(all.points, 1)));
  };
  double distance = distance_in(all.area);
  // Cells without a point say nothing where points are too sparse.
  if (all.points == 0 || distance > kCovered / kAcross) distance = distance_in(extent.width() * extent.height());
  for (double decade = 0.001; decade < 1; decade *= 10)
    for (const double step : {1.0, 2.0, 5.0})
      if (step * decade >= distance && step * decade > 0.0015) return step * decade;
  return 1;
}

// Returns an image whose pixels have corners at multiples of their size.
FacadeImage blank_image(const FlatBox& extent, double pixel_m, const FacadeImageParams& params) {
  FacadeImage image;
  for (image.pixel_m = pixel_m;; image.pixel_m *= 2) {
    const double s = image.pixel_m;
    const double left = std::floor(extent.min.x / s), right = std::max(std::ceil(extent.max.x / s), left + 1);
    const double low = std::floor(extent.min.y / s), high = std::max(std::ceil(extent.max.y / s), low + 1);
    if (!std::isfinite(right - left) || !std::isfinite(high - low)) throw Error("a facade of no finite extent");
    if ((right - left) * (high - low) > static_cast<double>(params.most_pixels)) continue;
    image.width = static_cast<std::uint32_t>(right - left);
    image.height = static_cast<std::uint32_t>(high - low);
    image.place = {left * s, low * s, right * s, high * s};
    return image;
  }
}

// Columns [c0, c1) and rows [r0, r1) of a picture.
struct PixelBox {
  std::uint32_t c0 = 0, c1 = 0, r0 = 0, r1 = 0;
  std::uint32_t width() const { return c1 - c0; }
  std::uint32_t height() const { return r1 - r0; }
  PixelBox grown(std::uint32_t by, std::uint32_t columns, std::uint32_t rows) const {
    return {c0 > by ? c0 - by : 0, std::min(columns - c1, by) + c1, r0 > by ? r0 - by : 0,
            std::min(rows - r1, by) + r1};
  }
};

std::vector<PixelBox> tiles_of(const FacadeImage& image, std::uint32_t side) {
  if (side == 0) return {{0, image.width, 0, image.height}};
  std::vector<PixelBox> tiles;
  for (std::uint32_t r = 0; r < image.height; r += std::min(side, image.height - r))
    for (std::uint32_t c = 0; c < image.width; c += std::min(side, image.width - c))
      tiles.push_back({c, c + std::min(side, image.width - c), r, r + std::min(side, image.height - r)});
  return tiles;
}

class Projector {
 public:
  Projector(const Facade& facade, const FacadeImage& image, const PixelBox& part, const FacadeImageParams& params)
      : facade_(facade), image_(image), part_(part), params_(params) {}

  // Returns the points in the part of the image, for one piece of the source.
  std::span<const FrontPoint> operator()(std::span<const ImagePoint> points) {
    placed_.clear();
    for (const ImagePoint& point : points) {
      const FlatPoint p = flat_place(facade_, point.position, params_.metres_per_unit);
      const double out = params_.metres_per_unit * dot(point.position - facade_.origin, facade_.out);
      const double column = std::floor((p.x - image_.place.min.x) / image_.pixel_m);
      const double row = std::floor((image_.place.max.y - p.y) / image_.pixel_m);
      if (!(column >= part_.c0 && column < part_.c1 && row >= part_.r0 && row < part_.r1)) continue;
      if (!(out <= params_.front_m && out >= -params_.behind_m)) continue;
      const auto pixel =
          (static_cast<std::uint32_t>(row) - part_.r0) * part_.width() + static_cast<std::uint32_t>(column) - part_.c0;
      placed_.push_back({pixel, static_cast<std::int32_t>(std::lround(out / kStep)), colour(point, out)});
    }
    return placed_;
  }

 private:
  std::array<std::uint8_t, 3> colour(const ImagePoint& point, double out) const {
    if (params_.shade == ImageShade::colour) return point.colour;
    // The wall is grey; a quarter of a metre in front of it is white, the same distance behind it is black.
    const double share = std::clamp(0.5 + out / 0.5, 0.0, 1.0);
    const auto grey = static_cast<std::uint8_t>(std::lround(255 * share));
    return {grey, grey, grey};
  }
  const Facade& facade_;
  const FacadeImage& image_;
  const PixelBox part_;
  const FacadeImageParams& params_;
  std::vector<FrontPoint> placed_;
};

struct PaintedPixels {
  std::uint64_t points = 0, filled = 0, empty = 0;
};

// Paints a tile and the margin around it that closing its gaps may need; only the tile is kept.
PaintedPixels paint(const Facade& facade, const PointSource& source, const PixelBox& tile,
                    const FacadeImageParams& params, FacadeImage& image) {
  const PixelBox part = tile.grown(static_cast<std::uint32_t>(params.fill_rounds), image.width, image.height);
  const double s = image.pixel_m, left = image.place.min.x, top = image.place.max.y;
  const Box3<Vec3> box =
      box_about(facade, {left + part.c0 * s, top - part.r1 * s, left + part.c1 * s, top - part.r0 * s}, params);
  FrontImage front(static_cast<std::size_t>(part.width()) * part.height());
  Projector project(facade, image, part, params);
  source(box, [&](std::span<const ImagePoint> points) { keep_front(front, project(points)); });
  const auto band = static_cast<std::int32_t>(std::lround(params.band_m / kStep));
  source(box, [&](std::span<const ImagePoint> points) { add_colours(front, project(points), band); });
  std::vector<std::uint8_t> rgba = mean_colours(front);
  PaintedPixels painted;
  const auto for_each_row = [&](const auto& visit) {
    for (std::uint32_t r = tile.r0; r < tile.r1; ++r)
      visit(r, static_cast<std::size_t>(r - part.r0) * part.width() + tile.c0 - part.c0);
  };
  for_each_row([&](std::uint32_t, std::size_t first) {
    for (std::size_t i = first; i < first + tile.width(); ++i) {
      painted.points += front.count[i];
      painted.filled += front.count[i] == 0;
    }
  });
  fill_gaps(rgba, part.width(), part.height(), params.fill_rounds);
  for_each_row([&](std::uint32_t r, std::size_t first) {
    const std::uint8_t* from = rgba.data() + 4 * first;
    for (std::size_t i = 0; i < tile.width(); ++i) painted.empty += from[4 * i + 3] == 0;
    std::copy_n(from, 4 * tile.width(), image.rgba.data() + 4 * (static_cast<std::size_t>(r) * image.width + tile.c0));
  });
  painted.filled -= painted.empty;
  return painted;
}

std::string world_file(const FacadeImage& image) {
  const double s = image.pixel_m;
  std::string text;
  for (const double v : {s, 0.0, 0.0, -s, image.place.min.x + s / 2, image.place.max.y - s / 2})
    text += decimal(v, 9) + "\n";
  return text;
}

// Returns the image as a GDAL dataset without a copy: the image must outlive it. Null when GDAL refuses.
GDALDatasetUniquePtr picture_of(const FacadeImage& image) {
  GDALDatasetUniquePtr picture(GetGDALDriverManager()->GetDriverByName("MEM")->Create(
      "", static_cast<int>(image.width), static_cast<int>(image.height), 0, GDT_Byte, nullptr));
  for (std::size_t band = 0; picture && band < 4; ++band) {
    char place[64] = {};
    CPLPrintPointer(place, const_cast<std::uint8_t*>(image.rgba.data() + band), sizeof place - 1);
    CPLStringList options;
    options.SetNameValue("DATAPOINTER", place);
    options.SetNameValue("PIXELOFFSET", "4");
    options.SetNameValue("LINEOFFSET", std::to_string(4 * static_cast<std::uint64_t>(image.width)).c_str());
    if (picture->AddBand(GDT_Byte, options.List()) != CE_None) return nullptr;
  }
  if (picture) picture->GetRasterBand(4)->SetColorInterpretation(GCI_AlphaBand);
  return picture;
}

}  // namespace

FacadeImage facade_image(const Facade& facade, const PointSource& source, const FacadeImageParams& params) {
  const FlatBox extent = extent_of(facade, params);
  FacadeImage image =
      blank_image(extent, params.pixel_m > 0 ? params.pixel_m : mean_distance(facade, source, extent, params), params);
  image.rgba.resize(4 * static_cast<std::size_t>(image.width) * image.height);
  const std::vector<PixelBox> tiles = tiles_of(image, params.tile);
  std::vector<PaintedPixels> painted(tiles.size());
  parallel_for(tiles.size(), [&](std::size_t i) { painted[i] = paint(facade, source, tiles[i], params, image); });
  for (const PaintedPixels& p : painted) {
    image.points += p.points;
    image.filled += p.filled;
    image.empty += p.empty;
  }
  return image;
}

void write_facade_image(const std::filesystem::path& path, const FacadeImage& image) {
  CPLPushErrorHandler(keep_silent);
  GDALRegister_MEM();
  GDALRegister_PNG();
  // Each file has its own name, because facades may be written in parallel.
  static std::atomic<std::uint64_t> written{0};
  const std::string name = "/vsimem/ilot-" + std::to_string(written++) + ".png";
  GDALDatasetUniquePtr picture = picture_of(image);
  if (picture) {
    const GDALDatasetUniquePtr copy(GetGDALDriverManager()->GetDriverByName("PNG")->CreateCopy(
        name.c_str(), picture.get(), FALSE, nullptr, nullptr, nullptr));
    if (!copy) picture.reset();
  }
  const std::string fault = CPLGetLastErrorMsg();
  CPLPopErrorHandler();
  vsi_l_offset size = 0;
  const std::unique_ptr<GByte, decltype(&VSIFree)> png(VSIGetMemFileBuffer(name.c_str(), &size, TRUE), &VSIFree);
  VSIUnlink((name + ".aux.xml").c_str());
  if (!picture || !png || size == 0) throw Error(path.string() + ": cannot be written: " + fault);
  write_whole_file(path, {reinterpret_cast<const char*>(png.get()), size});
  std::filesystem::path world = path;
  write_whole_file(world.replace_extension(".pgw"), world_file(image));
}

}  // namespace ilot
