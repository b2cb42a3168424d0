// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/survey/survey_points.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "engine/formats/row_buffer.h"
#include "engine/pass/input_stretches.h"
#include "engine/pass/measured_cells.h"
#include "engine/pass/pass.h"
#include "engine/scale/survey/point_summary.h"
#include "engine/store/lattice_rows.h"

namespace ilot {
namespace {

using Inputs = std::vector<std::unique_ptr<PointReader>>;

constexpr std::uint64_t kBytesOfTask = (16u << 20) + kRowBytes;  // windows and cells of the measure; a buffer of rows
constexpr std::uint64_t kBytesOfRow = 64;  // where each lies in a square of its own, up to kMostSquares
constexpr std::size_t kTasksAtOnce = 32;   // at most; their sums are kept until all are done

std::uint64_t bytes_of(const InputStretch& stretch) {
  return kBytesOfTask + kBytesOfRow * std::min<std::uint64_t>(stretch.count, kMostSquares);
}

// The box that the heads of the inputs state, lattice steps; empty where one states none.
IndexBox stated_box(const Inputs& inputs, double unit) {
  IndexBox box = IndexBox::none();
  for (const auto& input : inputs) {
    const Vec3 low = input->info().declared_min, high = input->info().declared_max;
    constexpr double kFar = 0x1p50;
    for (const Vec3 p : {low, high}) {
      const Vec3 at{std::round(p.x / unit), std::round(p.y / unit), std::round(p.z / unit)};
      if (!(std::abs(at.x) < kFar && std::abs(at.y) < kFar && std::abs(at.z) < kFar)) return IndexBox::none();
      box.add({static_cast<std::int64_t>(at.x), static_cast<std::int64_t>(at.y), static_cast<std::int64_t>(at.z)});
    }
  }
  return box;
}

std::uint64_t rows_of(const Inputs& inputs) {
  std::uint64_t rows = 0;
  for (const auto& input : inputs) rows += input->info().points;
  return rows;
}

std::vector<InputStretch> all_stretches(const Inputs& inputs, const IndexParams& params) {
  std::vector<std::vector<RowRange>> rows;
  for (const auto& input : inputs) rows.push_back({{0, input->info().points}});
  return cut_inputs(inputs, rows, params.run_points);
}

// Makes a part of each stretch, some at once, and gives the parts to `take` in their order.
template <class Part, class Read, class Take>
void for_each_part(std::span<const InputStretch> stretches, std::uint64_t budget_bytes, const Part& empty,
                   const Read& read, const Take& take) {
  for (std::size_t first = 0; first < stretches.size();) {
    std::vector<PassTask> tasks;
    for (std::uint64_t bytes = 0; first + tasks.size() < stretches.size() && tasks.size() < kTasksAtOnce;) {
      const InputStretch& stretch = stretches[first + tasks.size()];
      bytes += bytes_of(stretch);
      if (!tasks.empty() && bytes > budget_bytes) break;
      tasks.push_back({bytes_of(stretch), stretch.count});
    }
    std::vector<Part> parts(tasks.size(), empty);
    run_pass(tasks, budget_bytes, [&](std::size_t i) { read(stretches[first + i], parts[i]); });
    for (const Part& part : parts) take(part);
    first += parts.size();
  }
}

void measure(const LatticePoint& p, bool classes, MeasuredCells& cells) {
  cells.add(p.at);
  if (!classes) return;
  cells.add_class(p.classification);
  cells.add_echoes(p.echoes);
}

// What is found in a stretch.
struct Part {
  PointSummary summary;
  std::optional<MeasuredCells> cells;  // where the heads of the inputs say where points are
  bool as_stated = true;               // no point was left out or lies outside of the stated box
  std::array<std::uint64_t, kRejections> rejected{};
  std::vector<Index3> off_lattice;
};

class Survey {
 public:
  Survey(const Inputs& inputs, const IndexParams& params, const PassContext& context)
      : inputs_(inputs),
        params_(params),
        context_(context),
        stated_(stated_box(inputs, params.unit)),
        all_{PointSummary(params.unit * context.metres_per_unit), {}, true, {}, {}} {
    filter_ = params.filter;
    filter_.keep.reset();
    chunks_ = chunks_of(inputs);
    if (!stated_.is_empty()) all_.cells.emplace(stated_, rows_of(inputs), params.unit * context.metres_per_unit);
  }

  PointSurvey survey() {
    limit_inputs(inputs_, kFieldZ | kFieldClass | kFieldFlags);
    const Part empty = all_;
    for_each_part(
        all_stretches(inputs_, params_), context_.budget_bytes, empty,
        [&](const InputStretch& stretch, Part& part) { read(stretch, part); }, [&](const Part& part) { take(part); });
    limit_inputs(inputs_, kAllFields);
    PointSurvey result;
    const InputLattice asked{params_.unit, params_.multiple};
    const Strays strays = params_.keep_strays ? Strays() : find_strays(all_.summary.cells());
    result.lattice =
        checked_lattice(asked, inputs_, off_lattice_, strays, context_.metres_per_unit, params_.finest_step);
    if (result.lattice == asked) fill(strays, result);
    return result;
  }

 private:
  void read(const InputStretch& stretch, Part& part) const {
    LatticeRowReader reader({*inputs_[stretch.file], stretch.file, stretch.first, stretch.count},
                            {params_.unit, params_.multiple}, filter_);
    for (LatticeRows rows; reader.next(rows); context_.advance(rows.rows)) {
      part.summary.add(rows.points, stretch.file, chunks_[stretch.file]);
      part.as_stated = part.as_stated && part.cells && rows.points.size() == rows.rows &&
                       std::ranges::all_of(rows.points, [&](const LatticePoint& p) { return stated_.contains(p.at); });
      if (!part.as_stated) continue;
      for (const LatticePoint& p : rows.points) measure(p, params_.classes != ClassColumns::none, *part.cells);
    }
    part.rejected = reader.rejected();
    part.off_lattice = reader.off_lattice();
  }

  void take(const Part& part) {
    all_.summary.add(part.summary);
    all_.as_stated = all_.as_stated && part.as_stated;
    if (all_.as_stated) all_.cells->add(*part.cells);
    for (std::size_t i = 0; i < kRejections; ++i) all_.rejected[i] += part.rejected[i];
    off_lattice_.push_back(part.off_lattice);
  }

  void fill(const Strays& strays, PointSurvey& result) {
    result.corner = least_corner(all_.summary.cells(), strays);
    result.tiles = all_.summary.tiles();
    auto [sums, left_out] = std::move(all_.summary).without(strays);
    result.rejected = all_.rejected;
    result.rejected[static_cast<std::size_t>(Rejection::stray)] = left_out;
    result.strays = strays;
    result.points = sums.points;
    result.box = sums.box();
    for (const auto& [code, count] : sums.classes) result.classes[code] = count;
    result.map = std::move(sums.map);
    result.chunks = chunks_;
    for (const auto& [chunk, box] : sums.chunks) result.chunks[chunk.first].boxes[chunk.second] = box;
    if (all_.as_stated && result.box == stated_ && result.points == rows_of(inputs_))
      result.measure = all_.cells->measure();
  }

  const Inputs& inputs_;
  const IndexParams& params_;
  const PassContext& context_;
  IndexFilter filter_;
  IndexBox stated_;
  std::vector<ChunkBoxes> chunks_;
  std::vector<std::vector<Index3>> off_lattice_;
  Part all_;
};

}  // namespace

PointSurvey survey_points(const Inputs& inputs, const IndexParams& params, const PassContext& context) {
  return Survey(inputs, params, context).survey();
}

CloudMeasure measure_points(const Inputs& inputs, const IndexParams& params, const PointSurvey& survey,
                            const PassContext& context) {
  if (survey.points == 0) return {};
  limit_inputs(inputs, kFieldZ | kFieldClass | kFieldFlags);
  MeasuredCells all(survey.box, survey.points, params.unit * context.metres_per_unit);
  const MeasuredCells empty = all;
  for_each_part(
      all_stretches(inputs, params), context.budget_bytes, empty,
      [&](const InputStretch& stretch, MeasuredCells& part) {
        LatticeRowReader reader({*inputs[stretch.file], stretch.file, stretch.first, stretch.count},
                                {params.unit, params.multiple}, params.filter);
        for (LatticeRows rows; reader.next(rows); context.advance(rows.rows))
          for (const LatticePoint& p : rows.points)
            if (!survey.strays.contains(p.at)) measure(p, params.classes != ClassColumns::none, part);
      },
      [&](const MeasuredCells& part) { all.add(part); });
  limit_inputs(inputs, kAllFields);
  return all.measure();
}

}  // namespace ilot
