// SPDX-License-Identifier: Apache-2.0
#include "engine/run/inputs/input_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/report/progress.h"

namespace ilot {
namespace {

constexpr std::uint64_t kStretches = 10, kRows = 50;  // of each file

void add_rows(PointReader& reader, std::uint64_t first, std::uint64_t count, std::vector<Vec3>& places) {
  const RecordLayout& layout = reader.info().layout;
  std::vector<std::byte> rows(count * layout.record_length);
  std::vector<std::uint8_t> valid(count);
  const std::size_t got = reader.read(first, rows, valid);
  for (std::size_t i = 0; i < got; ++i) {
    if (valid[i] == 0) continue;
    const auto axis = [&](std::size_t a) {
      return load<std::int32_t>(&rows[i * layout.record_length + 4 * a]) * layout.scale[a] + layout.offset[a];
    };
    places.push_back({axis(0), axis(1), axis(2)});
  }
}

std::vector<Vec3> sample_of(PointReader& reader) {
  const std::uint64_t points = reader.info().points;
  std::vector<Vec3> places;
  if (!reader.random_access()) {
    add_rows(reader, 0, std::min(points, kStretches * kRows), places);
    return places;
  }
  for (std::uint64_t s = 0; s < kStretches; ++s) {
    const std::uint64_t first = points * s / kStretches, end = points * (s + 1) / kStretches;
    if (first < end) add_rows(reader, first, std::min(kRows, end - first), places);
  }
  return places;
}

void widen(PlaceBox& box, std::vector<Vec3>& places, double Vec3::*axis, double PlaceBox::*low,
           double PlaceBox::*high) {
  std::sort(places.begin(), places.end(), [&](const Vec3& a, const Vec3& b) { return a.*axis < b.*axis; });
  const std::size_t beside = places.size() / 100;
  box.*low = std::min(box.*low, places[beside].*axis);
  box.*high = std::max(box.*high, places[places.size() - 1 - beside].*axis);
}

std::string range_text(double low, double high) {
  const auto number = [](double v) {
    const auto whole = static_cast<std::uint64_t>(std::min(std::abs(std::round(v)), 1e18));
    return (v < 0 && whole > 0 ? "-" : "") + grouped(whole);
  };
  constexpr double kSmall = 1000;  // below it decimals are needed to distinguish places
  if (std::abs(low) < kSmall && std::abs(high) < kSmall) return fmt::format("{:.3f} to {:.3f}", low, high);
  return number(low) + " to " + number(high);
}

}  // namespace

std::string PlaceBox::text() const {
  return "x " + range_text(min_x, max_x) + ", y " + range_text(min_y, max_y);
}

std::optional<PlaceBox> sampled_box(const std::vector<std::unique_ptr<PointReader>>& readers) {
  std::optional<PlaceBox> box;
  for (const auto& reader : readers) {
    std::vector<Vec3> places = sample_of(*reader);
    if (places.empty()) continue;
    if (!box) {
      const Vec3 middle = places[places.size() / 2];
      box = PlaceBox{middle.x, middle.y, middle.x, middle.y, middle};
    }
    widen(*box, places, &Vec3::x, &PlaceBox::min_x, &PlaceBox::max_x);
    widen(*box, places, &Vec3::y, &PlaceBox::min_y, &PlaceBox::max_y);
  }
  return box;
}

std::string why_no_point(const std::optional<Area>& area, const std::vector<std::unique_ptr<PointReader>>& readers) {
  const std::string rejected = "no point is left to work on: all were rejected";
  const auto box = area ? sampled_box(readers) : std::nullopt;
  if (!box) return rejected + " (see classes.noise)";
  const PlaceBox asked{area->min_x, area->min_y, area->max_x, area->max_y, {}};
  const PlaceBox exchanged{area->min_y, area->min_x, area->max_y, area->max_x, {}};
  std::string sentence = rejected + "; the area is " + asked.text() + ", the clouds are around " + box->text() +
                         " (see also classes.noise)";
  if (!widened(*box).touches(asked) && widened(*box).touches(exchanged))
    sentence += "; with x and y exchanged the area meets the clouds: give X0,Y0,X1,Y1";
  return sentence;
}

PlaceBox widened(const PlaceBox& box) {
  const double width = box.max_x - box.min_x, height = box.max_y - box.min_y;
  PlaceBox wide = box;
  wide.min_x -= width;
  wide.max_x += width;
  wide.min_y -= height;
  wide.max_y += height;
  return wide;
}

}  // namespace ilot
