// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <functional>
#include <set>

#include "engine/model/object_colours.h"
#include "engine/model/point_label.h"
#include "engine/replay/tile_replay.h"

namespace ilot {
namespace {

using ColourOfHeight = std::function<PictureColour(Height)>;

// The ramp goes from dark blue over green and yellow to red.
PictureColour ramp(double share) {
  constexpr PictureColour kStops[] = {{40, 60, 130}, {40, 140, 150}, {90, 180, 80}, {240, 200, 60}, {200, 50, 40}};
  const double at = std::clamp(share, 0.0, 1.0) * 4;
  const auto low = std::min<std::size_t>(static_cast<std::size_t>(at), 3);
  const double part = at - static_cast<double>(low);
  PictureColour colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = static_cast<std::uint8_t>(kStops[low][c] * (1 - part) + kStops[low + 1][c] * part);
  return colour;
}

// Returns the value of an image below which this share of the values is.
Height quantile(const Image& image, double share) {
  std::vector<Height> values;
  for (const Height v : image.values)
    if (v != kNoHeight) values.push_back(v);
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

class TilePictures {
 public:
  explicit TilePictures(const TileReplay& replay) : replay_(replay), side_(replay.steps.raster->grid.side) {}

  // Calls `colour` for pixels that have a value other than `none`.
  void add(const char* layer, const std::string& title, Height none, const ColourOfHeight& colour,
           std::vector<PictureWord> legend = {}) {
    const auto found = replay_.images.find(layer);
    if (found == replay_.images.end()) return;
    Picture picture = begin(layer, title);
    add_ground(picture);
    PictureRaster raster = blank();
    for (std::uint32_t y = 0; y < side_; ++y)
      for (std::uint32_t x = 0; x < side_; ++x) {
        const Height v = found->second.values[std::size_t{side_ - 1 - y} * side_ + x];
        const std::size_t i = std::size_t{y} * side_ + x;
        raster.shown[i] = v != none && v != kNoHeight;
        if (raster.shown[i] != 0) raster.colours[i] = colour(v);
      }
    picture.rasters.push_back(std::move(raster));
    picture.legend = std::move(legend);
    pictures_.push_back(std::move(picture));
  }

  // Adds heights from `low` to `high` metres.
  void add_heights(const char* layer, const std::string& title, double low, double high) {
    const double unit = replay_.steps.raster->scale.unit;
    std::vector<PictureWord> legend;
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      char text[64];
      std::snprintf(text, sizeof text, "%.2f m", low + share * (high - low));
      legend.push_back({ramp(share), text});
    }
    const double range = std::max(high - low, unit);
    add(
        layer, title, kNoHeight, [&](Height v) { return ramp((v * unit - low) / range); }, std::move(legend));
  }

  // The range is from the 2 % quantile of the pixels to the 98 % quantile.
  void add_heights(const char* layer, const std::string& title) {
    const auto found = replay_.images.find(layer);
    if (found == replay_.images.end()) return;
    const double unit = replay_.steps.raster->scale.unit;
    add_heights(layer, title, quantile(found->second, 0.02) * unit, quantile(found->second, 0.98) * unit);
  }

  // Adds the selected object candidates, coloured by their class.
  void add_objects();

  std::vector<Picture> take() { return std::move(pictures_); }

 private:
  Picture begin(const std::string& layer, const std::string& title) const {
    char number[16];
    std::snprintf(number, sizeof number, "%02zu-", pictures_.size() + 1);
    const std::string name =
        "tile " + std::to_string(replay_.window.row) + "," + std::to_string(replay_.window.column) + ": ";
    return {number + layer, name + title, {}, {}, {}, {}, {}, true};
  }
  // Adds the ground in a pale colour, as a background for the objects.
  void add_ground(Picture& picture) const {
    const auto mask = replay_.images.find("mask");
    if (mask == replay_.images.end()) return;
    PictureRaster raster = blank();
    for (std::uint32_t y = 0; y < side_; ++y)
      for (std::uint32_t x = 0; x < side_; ++x) {
        const std::size_t i = std::size_t{y} * side_ + x;
        raster.shown[i] = mask->second.values[std::size_t{side_ - 1 - y} * side_ + x] == 1;
        raster.colours[i] = {232, 238, 226};
      }
    picture.rasters.push_back(std::move(raster));
  }
  PictureRaster blank() const {
    const double pixel = replay_.steps.raster->scale.pixel;
    const std::size_t size = std::size_t{side_} * side_;
    return {{0, pixel * side_}, pixel, side_, side_, std::vector<PictureColour>(size), std::vector<std::uint8_t>(size)};
  }

  const TileReplay& replay_;
  std::uint32_t side_;
  std::vector<Picture> pictures_;
};

PictureColour colour_of_label(PointLabel label) {
  if (!is_street_object(label)) return colour_of_number(static_cast<std::uint64_t>(label));
  const auto [red, green, blue] = object_colour(label);
  return {red, green, blue};
}

void TilePictures::add_objects() {
  const StreetSteps& steps = replay_.steps;
  std::set<PointLabel> seen;
  const auto class_of = [&](Height part) -> const CandidateClass& {
    return steps.classes[steps.candidate_of_part[static_cast<std::size_t>(part)] - 1];
  };
  add("candidates", "classes of the candidates that were taken as whole", 0, [&](Height part) {
    const PointLabel label = class_of(part).label;
    seen.insert(label);
    return colour_of_label(label);
  });
  if (pictures_.empty() || !pictures_.back().name.ends_with("candidates")) return;
  Picture& picture = pictures_.back();
  picture.name = picture.name.substr(0, 3) + "objects";
  for (const PointLabel label : seen) picture.legend.push_back({colour_of_label(label), class_name_of(label, {})});
}

}  // namespace

std::vector<Picture> pictures_of(const TileReplay& replay) {
  const auto number = [](Height v) { return colour_of_number(static_cast<std::uint64_t>(v)); };
  TilePictures pictures(replay);
  pictures.add_heights("range", "highest point of each pixel");
  pictures.add_heights("closed", "short gaps closed and holes filled");
  pictures.add_heights("filled", "linked over shadows and filled");
  pictures.add("zones", "flat zones of the tile by number", 0, number);
  pictures.add("mask", "the ground and what stands on it, without buildings", 0,
               [](Height) {
                 return PictureColour{120, 170, 110};
               },
               {{{120, 170, 110}, "ground"}});
  pictures.add_heights("height", "candidates: height above the ground, up to 4 m", 0, 4);
  pictures.add_heights("level", "the ground below what stands on it");
  pictures.add("components", "candidates that hang together", 0, number);
  pictures.add("candidates", "parts as they were separated", 0, number);
  pictures.add_objects();
  return pictures.take();
}

}  // namespace ilot
