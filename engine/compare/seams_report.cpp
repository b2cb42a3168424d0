// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/compare/evaluate.h"
#include "engine/compare/seams.h"
#include "engine/error.h"
#include "engine/proof/point_stream.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

SeamCells cells_of_run(const fs::path& result) {
  std::ifstream file(result / "run.json");
  if (!file) throw Error((result / "run.json").string() + ": cannot be read; --seams needs the output folder of a run");
  const auto record = nlohmann::json::parse(file, nullptr, false);
  SeamCells cells;
  try {
    const auto& stated = record.at("cells");
    cells = {stated.at("unit").get<double>(), stated.at("edge_steps").get<std::int64_t>(),
             stated.at("most_points").get<std::uint64_t>()};
  } catch (const nlohmann::json::exception&) {
    throw Error((result / "run.json").string() + ": does not state the cells in which planes were searched; run again");
  }
  const auto edge = static_cast<std::uint64_t>(cells.edge);
  if (!(cells.unit > 0) || cells.edge < 1 || (edge & (edge - 1)) != 0 || cells.points == 0)
    throw Error((result / "run.json").string() + ": the cells that it states are not possible; run again");
  return cells;
}

struct LabelledRows {
  SeamPoints points;
  double metres_per_unit = 1;
};

LabelledRows read_rows(const fs::path& result, double unit) {
  const ResultFiles files = find_results(result);
  if (files.clouds.empty()) throw Error(result.string() + ": contains no points/; --seams needs labelled clouds");
  LabelledRows rows;
  for (const fs::path& cloud : files.clouds) {
    const std::unique_ptr<PointReader> reader = open_cloud(cloud);
    reader->limit_to(kFieldZ | kFieldExtra);
    const RecordLayout& layout = reader->info().layout;
    const ExtraField plane = require_field(reader->info(), "plane_id", FieldType::u32);
    rows.metres_per_unit = reader->info().crs.metres_per_unit;
    for_each_record(*reader, [&](const std::byte* record) {
      const Vec3 p = position_of(record, layout);
      rows.points.places.push_back({std::llround(p.x / unit), std::llround(p.y / unit), std::llround(p.z / unit)});
      rows.points.plane.push_back(load<std::uint32_t>(record + plane.offset));
    });
  }
  return rows;
}

std::string share_text(std::optional<double> share) {
  return share ? fmt::format("{:.1f} %", 100 * *share) : "-";
}

OrderedJson share_json(std::optional<double> share) {
  return share ? OrderedJson(*share) : OrderedJson();
}

}  // namespace

Seams evaluate_seams(const fs::path& result, const std::optional<fs::path>& other, const SeamParams& params) {
  const SeamCells cells = cells_of_run(result);
  const LabelledRows rows = read_rows(result, cells.unit);
  Seams seams = measure_seams(rows.points, cells, params, rows.metres_per_unit);
  if (!other) return seams;
  const LabelledRows others = read_rows(*other, cells_of_run(*other).unit);
  if (others.points.plane.size() != rows.points.plane.size())
    throw Error(other->string() + ": has other rows than " + result.string() +
                "; both must be runs over the same rows");
  seams.pairs = compare_pairs(rows.points, others.points.plane, cells.unit * rows.metres_per_unit, params);
  return seams;
}

std::string seams_text(const Seams& seams) {
  const auto line = [](const char* where, const CutCounts& c) {
    return fmt::format("  {:<28}{:>9} stretches {:>9} cut {:>8}\n", where, c.stretches, c.cut, share_text(c.share()));
  };
  std::string text = "neighbours on different planes, along\n";
  text += line("borders of cells", seams.borders);
  text += line("the same lines, shifted", seams.elsewhere);
  const std::optional<double> at = seams.borders.share(), else_where = seams.elsewhere.share();
  if (at && else_where && *else_where > 0) text += fmt::format("  ratio {:.2f}\n", *at / *else_where);
  text += fmt::format("points {}, without a plane {:.2f} %, planes {}\n", seams.points,
                      100.0 * static_cast<double>(seams.unlabelled) / static_cast<double>(seams.points), seams.planes);
  if (seams.pairs)
    text += fmt::format("pairs of neighbours {}, equal in both runs {}, on different planes {} and {}\n",
                        seams.pairs->pairs, share_text(seams.pairs->share()), seams.pairs->different,
                        seams.pairs->different_other);
  return text;
}

std::string seams_json(const Seams& seams) {
  const auto counts = [](const CutCounts& c) {
    return OrderedJson{{"stretches", c.stretches}, {"cut", c.cut}, {"share", share_json(c.share())}};
  };
  OrderedJson json{{"points", seams.points},
                   {"unlabelled", seams.unlabelled},
                   {"planes", seams.planes},
                   {"borders", counts(seams.borders)},
                   {"elsewhere", counts(seams.elsewhere)}};
  if (seams.pairs)
    json["pairs"] = {{"pairs", seams.pairs->pairs},
                     {"equal", seams.pairs->equal},
                     {"share", share_json(seams.pairs->share())},
                     {"different", seams.pairs->different},
                     {"different_other", seams.pairs->different_other}};
  return json.dump(2) + "\n";
}

}  // namespace ilot
