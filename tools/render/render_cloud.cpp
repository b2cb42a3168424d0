// SPDX-License-Identifier: Apache-2.0
#include "tools/render/render_cloud.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "engine/error.h"
#include "engine/formats/reader.h"
#include "engine/formats/row_buffer.h"
#include "tools/render/colours.h"

namespace ilot::render {
namespace {

using Visit = std::function<void(std::span<const std::byte>, Vec3)>;

// Calls visit for every valid point within the bounds, in file order.
void for_each_point(const std::filesystem::path& path, const RenderOptions& options, const Visit& visit) {
  const std::unique_ptr<PointReader> reader = open_cloud(path);
  const RecordLayout& layout = reader->info().layout;
  const std::size_t length = layout.record_length;
  const std::size_t most = rows_at_a_time(length);
  std::vector<std::byte> records(most * length);
  std::vector<std::uint8_t> valid(most);
  for (std::uint64_t first = 0; first < reader->info().points;) {
    const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(most, reader->info().points - first));
    const std::size_t got =
        reader->read(first, std::span(records).first(wanted * length), std::span(valid).first(wanted));
    for (std::size_t i = 0; i < got; ++i) {
      if (!valid[i]) continue;
      const std::span<const std::byte> record(&records[i * length], length);
      const PointFields f = decode_fields(record, layout.point_format);
      const Vec3 p{f.x * layout.scale[0] + layout.offset[0], f.y * layout.scale[1] + layout.offset[1],
                   f.z * layout.scale[2] + layout.offset[2]};
      if (const auto& b = options.bounds; b && (p.x < (*b)[0] || p.y < (*b)[1] || p.x > (*b)[2] || p.y > (*b)[3]))
        continue;
      visit(record, p);
    }
    if (got < wanted) break;
    first += got;
  }
}

// The extent that the first reading measures.
struct Extent {
  double left = std::numeric_limits<double>::infinity(), right = -left;
  double bottom = left, top = -left;
  double near = -left;  // towards the eye
  ColourRange colours{left, -left, 0};
  std::uint64_t points = 0;
};

Extent measure(const std::filesystem::path& path, const RenderOptions& options, const ViewAxes& axes,
               const RecordLayout& layout) {
  Extent e;
  for_each_point(path, options, [&](std::span<const std::byte> record, Vec3 p) {
    const double u = dot(axes.right, p), v = dot(axes.up, p);
    e.left = std::min(e.left, u);
    e.right = std::max(e.right, u);
    e.bottom = std::min(e.bottom, v);
    e.top = std::max(e.top, v);
    e.near = std::max(e.near, dot(axes.towards, p));
    e.colours.low = std::min(e.colours.low, p.z);
    e.colours.high = std::max(e.colours.high, p.z);
    note_colour(record, layout, e.colours);
    ++e.points;
  });
  if (e.points == 0) throw Error(path.string() + ": no point lies within the bounds");
  return e;
}

}  // namespace

Image render_cloud(const std::filesystem::path& path, const RenderOptions& options) {
  const ViewAxes axes = axes_of(options.view);
  const RecordLayout layout = open_cloud(path)->info().layout;
  const Extent e = measure(path, options, axes, layout);
  const double longer = std::max({e.right - e.left, e.top - e.bottom, 1e-3});
  const double pixel = longer / options.size;
  const int width = static_cast<int>((e.right - e.left) / pixel) + 1;
  const int height = static_cast<int>((e.top - e.bottom) / pixel) + 1;
  // Squares are large enough to close the gaps between evenly spread points.
  const double per_point = static_cast<double>(width) * height / static_cast<double>(e.points);
  const int radius = std::clamp(static_cast<int>(0.75 * std::sqrt(per_point)), 0, 5);

  const Colouring colour = colouring(options.by, layout, e.colours);
  // Depths are floats: they start at the nearest point, not at the origin of the national grid.
  const Vec3 corner = e.left * axes.right + e.top * axes.up + e.near * axes.towards;
  Canvas canvas(width, height);
  for_each_point(path, options, [&](std::span<const std::byte> record, Vec3 p) {
    const Vec3 offset = p - corner;
    const int column = static_cast<int>(dot(axes.right, offset) / pixel);
    const int row = static_cast<int>(-dot(axes.up, offset) / pixel);
    canvas.draw(column, row, static_cast<float>(dot(axes.towards, offset)), colour(record), radius);
  });
  return canvas.shaded(pixel);
}

}  // namespace ilot::render
