// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/validate_las.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/error.h"
#include "engine/formats/las/las_claims.h"
#include "engine/formats/row_buffer.h"
#include "engine/pass/stop.h"

namespace ilot {
namespace {

struct Measured {
  std::uint64_t points = 0;
  std::array<std::uint64_t, 16> returns{};  // by return number
  std::uint64_t beyond_their_pulse = 0;     // points with a return number above the number of returns
  std::uint64_t times_not_finite = 0;
  std::array<std::int32_t, 3> min{INT32_MAX, INT32_MAX, INT32_MAX}, max{INT32_MIN, INT32_MIN, INT32_MIN};
};

struct Case {
  const CloudInfo& info;
  const LasClaims claims;
  Measured measured;
  std::vector<Finding> findings;

  void severe(const char* rule, std::string text) { findings.push_back({rule, std::move(text), true}); }
  void note(const char* rule, std::string text) { findings.push_back({rule, std::move(text), false}); }
};

void measure_row(const std::byte* row, const RecordLayout& layout, std::optional<std::size_t> time, Measured& m) {
  const PointFields fields = decode_fields({row, layout.record_length}, layout.point_format);
  const std::array<std::int32_t, 3> place{fields.x, fields.y, fields.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    m.min[axis] = std::min(m.min[axis], place[axis]);
    m.max[axis] = std::max(m.max[axis], place[axis]);
  }
  ++m.returns[fields.return_number];
  if (fields.return_number > fields.return_count) ++m.beyond_their_pulse;
  if (time && !std::isfinite(load<double>(row + *time))) ++m.times_not_finite;
  ++m.points;
}

Measured measure(PointReader& reader, const std::function<void(std::uint64_t)>& advance) {
  const RecordLayout& layout = reader.info().layout;
  const auto time = gps_time_offset(layout.point_format);
  const std::size_t length = layout.record_length;
  const std::size_t most = rows_at_a_time(length);
  std::vector<std::byte> rows(most * length);
  std::vector<std::uint8_t> valid(most);
  Measured m;
  for (std::size_t got = most; got == most;) {
    if (stop_requested()) throw Error("interrupted", ExitCode::interrupted);
    got = reader.read(m.points, rows, valid);
    for (std::size_t i = 0; i < got; ++i) measure_row(&rows[i * length], layout, time, m);
    if (advance) advance(got);
  }
  return m;
}

void check_header(Case& c) {
  const LasClaims& claims = c.claims;
  if (claims.header_bytes < claims.needed_header_bytes)
    c.severe("header-size", fmt::format("the header has {} bytes, version 1.{} requires {}", claims.header_bytes,
                                        c.info.version_minor, claims.needed_header_bytes));
  if (c.info.version_minor < claims.needed_minor || c.info.version_minor > 4)
    c.severe("version", fmt::format("version 1.{} does not go with point format {}", c.info.version_minor,
                                    c.info.layout.point_format));
  if (claims.whole_vlrs < claims.vlrs)
    c.severe("vlr-count", fmt::format("the header says {} VLRs, {} are whole", claims.vlrs, claims.whole_vlrs));
  if (!claims.extra_bytes_fault.empty()) c.severe("extra-bytes", claims.extra_bytes_fault);
  if (claims.extra_bytes_fault.empty() && claims.undescribed_bytes > 0)
    c.note("extra-bytes", fmt::format("no descriptor describes the last {} of {} bytes per point",
                                      claims.undescribed_bytes, c.info.layout.record_length));
}

void check_wkt_flag(Case& c) {
  const LasClaims& claims = c.claims;
  if (c.info.layout.point_format >= 6 && !claims.wkt_flag) {
    const std::string text =
        fmt::format("point format {} requires the WKT bit of the global encoding", c.info.layout.point_format);
    if (claims.has_geotiff || claims.has_wkt)
      c.severe("wkt-flag", text);
    else
      c.note("wkt-flag", text + "; there is no CRS");
  }
  if (claims.wkt_flag && !claims.has_wkt && claims.has_geotiff)
    c.severe("wkt-flag", "the WKT bit is set, but the CRS is given by GeoTIFF keys only");
}

void check_box_range(Case& c) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double scale = c.info.layout.scale[axis], offset = c.info.layout.offset[axis];
    for (const double value : {c.claims.min[axis], c.claims.max[axis]}) {
      const double raw = (value - offset) / scale;
      const bool fits = raw > INT32_MIN - 1.0 && raw < INT32_MAX + 1.0;
      const bool unset = value == 0 && c.claims.min[axis] == c.claims.max[axis];  // the box itself is checked later
      if (fits || unset) continue;
      c.severe("box-range", fmt::format("{} of the box is {}, which no 32-bit coordinate reaches (scale {}, offset {})",
                                        "xyz"[axis], value, scale, offset));
      return;
    }
  }
}

void check_count(Case& c) {
  const std::uint64_t points = c.measured.points;
  if (points < c.info.points)
    c.severe("points-damaged", fmt::format("the points from number {} on cannot be decoded", points));
  const std::uint64_t declared = c.claims.has_counts ? c.claims.count : c.claims.legacy_count;
  if (declared != points)
    c.severe("point-count", fmt::format("the header says {} points, {} can be read", declared, points));
  if (!c.claims.has_counts) return;
  const std::uint64_t legacy = c.claims.legacy_count;
  if (c.info.layout.point_format < 6 && points <= UINT32_MAX && legacy != points)
    c.severe("legacy-count", fmt::format("the legacy count is {}, it must be {}", legacy, points));
  if (c.info.layout.point_format < 6 && points <= UINT32_MAX) return;
  if (legacy != 0 && legacy != points)
    c.severe("legacy-count", fmt::format("the legacy count is {}, it must be 0 (points: {})", legacy, points));
  if (legacy != 0 && legacy == points)
    c.note("legacy-count", fmt::format("the legacy count is {}, it should be 0 for point format {}", legacy,
                                       c.info.layout.point_format));
}

template <std::size_t N>
void check_returns(Case& c, const std::array<std::uint64_t, N>& declared, const char* which) {
  for (std::size_t i = 0; i < N; ++i) {
    if (declared[i] == c.measured.returns[i + 1]) continue;
    c.severe("returns-count", fmt::format("the {} says {} points of return {}, there are {}", which, declared[i], i + 1,
                                          c.measured.returns[i + 1]));
    return;
  }
}

void check_all_returns(Case& c) {
  const bool legacy_unused =
      c.claims.legacy_count == 0 && c.claims.legacy_returns == decltype(c.claims.legacy_returns){};
  const bool legacy_wanted = c.info.layout.point_format < 6 && c.measured.points <= UINT32_MAX;
  if (legacy_wanted || !legacy_unused)
    check_returns(c, c.claims.legacy_returns, c.claims.has_counts ? "legacy header field" : "header");
  if (c.claims.has_counts) check_returns(c, c.claims.returns, "header");
  if (c.measured.beyond_their_pulse > 0)
    c.severe("return-number", fmt::format("{} points have a return number above their number of returns",
                                          c.measured.beyond_their_pulse));
  if (c.measured.returns[0] > 0)
    c.note("return-number", fmt::format("{} points have return number 0, counting begins at 1", c.measured.returns[0]));
}

void check_time(Case& c) {
  if (c.measured.times_not_finite > 0)
    c.severe("gps-time", fmt::format("{} points have a GPS time that is not finite", c.measured.times_not_finite));
}

// Half a scale step, and the possible rounding error of raw * scale + offset.
double box_tolerance(double scale, double offset, double value) {
  return 0.5 * scale + 8 * std::numeric_limits<double>::epsilon() * (std::abs(offset) + std::abs(value));
}

void check_box(Case& c) {
  if (c.measured.points == 0) return;
  const std::array<double, 3> zero{};
  bool inside_zero = true, wrong = false;
  std::string text;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double scale = c.info.layout.scale[axis], offset = c.info.layout.offset[axis];
    const double low = c.measured.min[axis] * scale + offset, high = c.measured.max[axis] * scale + offset;
    const bool fits = std::abs(c.claims.min[axis] - low) <= box_tolerance(scale, offset, low) &&
                      std::abs(c.claims.max[axis] - high) <= box_tolerance(scale, offset, high);
    inside_zero = inside_zero && low == 0 && high == 0;
    if (fits || wrong) continue;
    wrong = true;
    text = fmt::format("{} of the box goes from {} to {}, the points from {} to {}", "xyz"[axis], c.claims.min[axis],
                       c.claims.max[axis], low, high);
  }
  const bool all_zero = c.claims.min == zero && c.claims.max == zero && !inside_zero;
  if (all_zero && wrong) text = "the box is all zero; " + text;
  if (wrong) c.severe("box", text);
}

void keep_warnings(Case& c) {
  for (const std::string& warning : c.info.warnings) {
    if (warning != c.claims.extra_bytes_fault) c.note("reader", warning);
  }
}

}  // namespace

std::vector<Finding> validate_las(PointReader& reader, const std::function<void(std::uint64_t)>& advance) {
  const CloudInfo& info = reader.info();
  if (!has_las_header(info))
    throw Error(info.path.string() + ": is of format " + info.format + ", which has no header to validate",
                ExitCode::usage);
  Case c{info, claims_of(info), measure(reader, advance), {}};
  check_header(c);
  check_wkt_flag(c);
  check_box_range(c);
  check_count(c);
  check_all_returns(c);
  check_time(c);
  check_box(c);
  keep_warnings(c);
  return c.findings;
}

}  // namespace ilot
