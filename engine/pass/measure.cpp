// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/error.h"
#include "engine/formats/row_buffer.h"
#include "engine/pass/sampled_windows.h"
#include "engine/pass/stop.h"
#include "engine/store/strays.h"

namespace ilot {
namespace {

using Visit = std::function<void(const std::byte* row)>;

// Calls visit for each valid row; returns the number of invalid rows.
std::uint64_t for_each_row(PointReader& reader, const std::function<void(std::uint64_t)>& advance, const Visit& visit) {
  const std::size_t length = reader.info().layout.record_length;
  const std::size_t most = rows_at_a_time(length);
  std::vector<std::byte> rows(most * length);
  std::vector<std::uint8_t> valid(most);
  std::uint64_t rejected = 0;
  for (std::uint64_t first = 0; first < reader.info().points;) {
    if (stop_requested()) throw Error("interrupted", ExitCode::interrupted);
    const auto asked = static_cast<std::size_t>(std::min<std::uint64_t>(most, reader.info().points - first));
    const std::size_t got = reader.read(first, std::span(rows).first(asked * length), std::span(valid).first(asked));
    for (std::size_t i = 0; i < got; ++i) {
      if (valid[i] != 0) visit(&rows[i * length]);
      if (valid[i] == 0) ++rejected;
    }
    if (advance) advance(got);
    first += got;
    if (got < asked) break;
  }
  return rejected;
}

Vec3 world(const RecordLayout& layout, const std::byte* row) {
  const auto axis = [&](std::size_t i) { return load<std::int32_t>(row + 4 * i) * layout.scale[i] + layout.offset[i]; };
  return {axis(0), axis(1), axis(2)};
}

bool coloured(const std::byte* row, std::size_t offset) {
  return (load<std::uint16_t>(row + offset) | load<std::uint16_t>(row + offset + 2) |
          load<std::uint16_t>(row + offset + 4)) != 0;
}

void grow(Vec3& min, Vec3& max, Vec3 p) {
  min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
  max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
}

// The points of one file in steps of its finest scale.
class FileLattice {
 public:
  explicit FileLattice(const CloudInfo& info)
      : unit_(std::min({info.layout.scale[0], info.layout.scale[1], info.layout.scale[2]})), map_(info.layout, unit_) {}
  double unit() const { return unit_; }
  std::optional<Index3> at(const std::byte* row) const {
    Index3 p;
    if (!map_.map(load<std::int32_t>(row), load<std::int32_t>(row + 4), load<std::int32_t>(row + 8), p)) return {};
    return p;
  }

 private:
  double unit_;
  LatticeMap map_;
};

// First reading: counts, the box of all points and the strays.
CloudMeasure count(PointReader& reader, const FileLattice& lattice, const std::function<void(std::uint64_t)>& advance,
                   Strays& strays) {
  const CloudInfo& info = reader.info();
  const std::size_t standard = standard_size(info.layout.point_format);
  const auto colour = rgb_offset(info.layout.point_format);
  constexpr double kFar = std::numeric_limits<double>::infinity();
  CloudMeasure m;
  m.all_min = {kFar, kFar, kFar};
  m.all_max = {-kFar, -kFar, -kFar};
  CoarseCells cells(coarse_bits(lattice.unit() * info.crs.metres_per_unit));
  m.rejected = for_each_row(reader, advance, [&](const std::byte* row) {
    grow(m.all_min, m.all_max, world(info.layout, row));
    const PointFields fields = decode_fields({row, standard}, info.layout.point_format);
    ++m.points;
    ++m.classes[fields.classification];
    m.last_returns += fields.return_number >= fields.return_count;
    if (colour) m.with_colour += coloured(row, *colour);
    if (const auto at = lattice.at(row)) cells.add(*at);
  });
  if (m.points == 0) m.all_min = m.all_max = {};
  m.min = m.all_min;
  m.max = m.all_max;
  if (!info.crs.geographic) strays = find_strays(cells);
  return m;
}

// Additional reading when there are strays: the box of the other points.
void leave_out(const Strays& strays, PointReader& reader, const FileLattice& lattice,
               const std::function<void(std::uint64_t)>& advance, CloudMeasure& m) {
  bool first = true;
  for_each_row(reader, advance, [&](const std::byte* row) {
    const Vec3 p = world(reader.info().layout, row);
    const auto at = lattice.at(row);
    if (at && strays.contains(*at)) {
      ++m.strays;
    } else {
      if (first) m.min = m.max = p;
      grow(m.min, m.max, p);
      first = false;
    }
  });
}

}  // namespace

CloudMeasure measure_cloud(PointReader& reader, const std::function<void(std::uint64_t)>& advance) {
  const CloudInfo& info = reader.info();
  const FileLattice lattice(info);
  Strays strays;
  CloudMeasure m = count(reader, lattice, advance, strays);
  if (m.points == 0) return m;
  if (!strays.cells().empty()) leave_out(strays, reader, lattice, advance, m);
  const auto total = static_cast<double>(m.points - m.strays);
  const double metres = info.crs.metres_per_unit, metres_z = info.crs.metres_per_unit_z;
  const MeasureGrid cells = density_cells(m.min, m.max, total);
  std::vector<bool> occupied(cells.columns * cells.rows);
  SampledWindows chosen(step_windows(m.min, m.max, total), m.min, {metres, metres, metres_z});
  std::uint64_t last_returns = 0;
  for_each_row(reader, advance, [&](const std::byte* row) {
    const auto at = m.strays > 0 ? lattice.at(row) : std::nullopt;
    if (at && strays.contains(*at)) return;
    const Vec3 p = world(info.layout, row);
    const PointFields f = decode_fields({row, standard_size(info.layout.point_format)}, info.layout.point_format);
    last_returns += f.return_number >= f.return_count;
    occupied[cells.cell(p)] = true;
    chosen.add(p);
  });
  const auto full = static_cast<double>(std::count(occupied.begin(), occupied.end(), true));
  m.occupied_area = full * cells.side * cells.side * metres * metres;
  m.density = total / m.occupied_area;
  m.last_return_density = static_cast<double>(last_returns) / m.occupied_area;
  m.sampling_step = chosen.median_step();
  return m;
}

}  // namespace ilot
