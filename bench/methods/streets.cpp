// SPDX-License-Identifier: Apache-2.0
// What stands on streets [B5-B7], found and classed, on scenes `street`, judged by their truth: how many objects are
// found, which features tell them apart and in which order, and the confusion matrix of a cross-validation by block,
// with the document's features and with ours. With --model the machine that is trained on all of it.
// Usage: bench_streets STREET.laz... [--cache FOLDER] [--model FILE] [--only-model | --everything]
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>

#include "engine/evaluate/point_stream.h"
#include "engine/pass/index.h"
#include "engine/run/streets_product.h"
#include "engine/streets/whole_things.h"
#include "engine/whole_file.h"
#include "kernels/core/parallel.h"

namespace {

using namespace ilot;
namespace fs = std::filesystem;

const std::vector<std::string> kClasses{"car", "lamppost", "pedestrian", "other"};

PointLabel label_of(const std::string& name) {
  for (const auto& [value, label] : point_label_names())
    if (label == name) return static_cast<PointLabel>(value);
  throw std::runtime_error("no class " + name);
}

std::string name_of(PointLabel label) {
  return label == PointLabel::none ? "none" : point_label_names().at(static_cast<std::uint32_t>(label));
}

// What one cloud gave: things with their truth, and the objects that none of them is.
struct Street {
  std::vector<ThingSample> samples;
  std::vector<Thing> things;                     // of the samples: pixels and parts
  std::vector<std::uint32_t> object;             // which one a sample is; 0 = none
  std::vector<double> overlaps;                  // with it
  std::map<std::string, std::uint64_t> objects;  // seen, by class
  std::map<std::uint32_t, PointLabel> classes;   // of objects
  std::uint64_t blocks = 0, gaps = 0, found_gaps = 0, ground = 0, ground_found = 0;
};

struct TrueThing {
  std::string class_name, variant;
  std::uint64_t points = 0;
  bool touches = false;
  // Of the thing that is most of it.
  double overlap = 0;  // common points over those of both
  std::uint64_t common = 0, of_thing = 0;
};

struct TrueStreet {
  std::map<std::uint32_t, TrueThing> objects;
  std::vector<std::pair<Vec3, Vec3>> blocks;  // left sides, along the street
};

Vec3 vec(const nlohmann::json& j) {
  return {j[0].get<double>(), j[1].get<double>(), j[2].get<double>()};
}

TrueStreet read_street(const fs::path& cloud) {
  const fs::path path = fs::path(cloud).replace_extension(".truth.json");
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path.string() + ": no truth");
  const auto root = nlohmann::json::parse(file);
  TrueStreet street;
  for (const auto& o : root.at("objects"))
    street.objects[o.at("id")] = {o.at("class"), o.at("variant"), 0, !o.at("touches").empty()};
  for (const auto& b : root.at("blocks"))
    if (b.at("side") == "left") street.blocks.emplace_back(vec(b.at("from")), vec(b.at("to")));
  return street;
}

// The block that is nearest along the street.
std::uint32_t block_of(const TrueStreet& street, double x, double y) {
  const Vec3 from = street.blocks.front().first, to = street.blocks.back().second;
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const auto along = [&](double px, double py) {
    return ((px - from.x) * (to.x - from.x) + (py - from.y) * (to.y - from.y)) / length;
  };
  std::uint32_t best = 0;
  double least = INFINITY;
  for (std::uint32_t b = 0; b < street.blocks.size(); ++b) {
    const double s = along(x, y), a = along(street.blocks[b].first.x, street.blocks[b].first.y),
                 e = along(street.blocks[b].second.x, street.blocks[b].second.y);
    if (const double d = std::max({0.0, a - s, s - e}); d < least) least = d, best = b;
  }
  return best;
}

Street study(const fs::path& cloud) {
  TrueStreet truth = read_street(cloud);
  const fs::path folder = fs::temp_directory_path() / ("bench_streets_" + cloud.stem().string());
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::vector<std::unique_ptr<PointReader>> readers;
  readers.push_back(open_cloud(cloud));
  PassContext context;
  const IndexResult index = build_index(readers, {}, folder, context);
  const StreetsSettings settings;
  const FoundStreet found = find_street(index.store, settings, context);
  const StreetRaster& raster = found.tiles->raster();
  const Height least = raster.scale.units(settings.least_height);

  const CloudInfo& info = readers[0]->info();
  const ExtraField kind = *find_integer_field(info.layout, "true_class");
  const ExtraField element = *find_integer_field(info.layout, "true_element");
  const LatticeMap lattice(info.layout, raster.unit);
  std::map<std::size_t, std::pair<Image, Image>> tiles;  // level, things
  std::vector<std::map<std::uint32_t, std::uint64_t>> of_object(found.things.size() + 1), of_class = of_object;
  std::vector<std::uint64_t> points(found.things.size() + 1, 0);
  Street street;
  for_each_record(*readers[0], [&](const std::byte* record) {
    std::int32_t raw[3];
    std::memcpy(raw, record, sizeof raw);
    Index3 p;
    if (!lattice.map(raw[0], raw[1], raw[2], p)) return;
    const auto object = static_cast<std::uint32_t>(integer_of(record, element));
    const auto true_class = static_cast<std::uint32_t>(integer_of(record, kind));
    if (const auto entry = truth.objects.find(object); entry != truth.objects.end()) ++entry->second.points;
    const std::int64_t x = raster.column(p.x), y = raster.row(p.y), side = raster.grid.side;
    const auto tile = static_cast<std::size_t>(y / side * raster.grid.columns() + x / side);
    auto entry = tiles.find(tile);
    if (entry == tiles.end()) {
      if (tiles.size() > 60) tiles.clear();
      entry = tiles
                  .try_emplace(tile, layer_tile(found.tiles->layers(), "level", tile),
                               layer_tile(found.tiles->layers(), "things", tile))
                  .first;
    }
    const auto pixel = static_cast<std::size_t>(y % side * side + x % side);
    const Height level = entry->second.first.values[pixel];
    const bool on_ground = level != kNoHeight && p.z - level < least;
    street.ground += true_class == 1;
    street.ground_found += true_class == 1 && on_ground;
    const auto thing = static_cast<std::size_t>(entry->second.second.values[pixel]);
    if (thing == 0 || on_ground) return;
    ++points[thing];
    ++of_class[thing][true_class];
    if (truth.objects.count(object) != 0) ++of_object[thing][object];
  });
  for (const auto& [id, object] : truth.objects) street.objects[object.class_name] += object.points > 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    for (const std::uint32_t part : found.things[i - 1].parts) {
      if (part == 0) continue;
      points[i] += points[part];
      for (const auto& [c, n] : of_class[part]) of_class[i][c] += n;
      for (const auto& [o, n] : of_object[part]) of_object[i][o] += n;
    }
  }
  street.things = found.things;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Thing& thing = found.things[i - 1];
    ThingSample sample{thing.features, PointLabel::none, 0};
    sample.group = block_of(truth, raster.crs_x(thing.x), raster.crs_y(thing.y));
    street.object.push_back(0);
    street.overlaps.push_back(0);
    std::uint64_t most = 0;
    for (const auto& [true_class, count] : of_class[i])
      if (count > most) most = count, sample.label = true_class == 7 ? PointLabel::vegetation : PointLabel::none;
    for (const auto& [object, common] : of_object[i]) {
      TrueThing& o = truth.objects.at(object);
      const double overlap = static_cast<double>(common) / static_cast<double>(o.points + points[i] - common);
      if (overlap > o.overlap) o.overlap = overlap, o.common = common, o.of_thing = points[i];
      if (overlap < 0.5) continue;
      sample.label = label_of(o.class_name);
      street.object.back() = object;
      street.overlaps.back() = overlap;
    }
    street.samples.push_back(sample);
  }
  for (const auto& [id, o] : truth.objects)
    if (o.points > 0 && o.overlap < 0.5)
      fmt::print("  missed {} {} ({}{}): {} points, best thing has {} of them and {} in all\n", o.class_name, id,
                 o.variant, o.touches ? ", touching" : "", o.points, o.common, o.of_thing);
  street.blocks = truth.blocks.size();
  for (const StreetStretch& s : found.stretches) {
    fmt::print("  stretch of {:.0f} m: {} blocks, {} gaps\n", s.length, s.blocks.size(), s.gaps.size());
  }
  fs::remove_all(folder);
  return street;
}

void save(const Street& street, const fs::path& path) {
  std::string text = fmt::format("{} {} {}\n", street.blocks, street.ground, street.ground_found);
  for (const std::string& name : kClasses)
    text += fmt::format("{} ", street.objects.count(name) ? street.objects.at(name) : 0);
  text += "\n";
  for (const ThingSample& s : street.samples) {
    const std::size_t i = static_cast<std::size_t>(&s - street.samples.data());
    const Thing& t = street.things[i];
    text += fmt::format("{} {} {} {:.17g} {} {} {}", static_cast<int>(s.label), s.group, street.object[i],
                        street.overlaps[i], t.pixels, t.parts[0], t.parts[1]);
    for (const double f : s.features) text += fmt::format(" {:.17g}", f);
    text += "\n";
  }
  write_whole_file(path, text);
}

// A thing that overlaps an object well is no sample of its class where another overlaps it clearly better: it is a part
// of it, or it and something else.
void keep_best(Street& street) {
  constexpr double kClearly = 0.2;
  std::map<std::uint32_t, double> best;
  for (std::size_t i = 0; i < street.samples.size(); ++i) {
    best[street.object[i]] = std::max(best[street.object[i]], street.overlaps[i]);
    street.classes[street.object[i]] = street.samples[i].label;
  }
  for (std::size_t i = 0; i < street.samples.size(); ++i)
    if (street.object[i] != 0 && street.overlaps[i] < best[street.object[i]] - kClearly)
      street.samples[i].label = PointLabel::none;
}

Street load(const fs::path& path) {
  std::ifstream file(path);
  Street street;
  file >> street.blocks >> street.ground >> street.ground_found;
  for (const std::string& name : kClasses) file >> street.objects[name];
  int label = 0;
  for (ThingSample s; file >> label >> s.group;) {
    s.label = static_cast<PointLabel>(label);
    street.object.push_back(0), street.overlaps.push_back(0), street.things.push_back({});
    Thing& t = street.things.back();
    file >> street.object.back() >> street.overlaps.back() >> t.pixels >> t.parts[0] >> t.parts[1];
    for (double& f : s.features) file >> f;
    street.samples.push_back(s);
  }
  return street;
}

bool is_object(PointLabel label) {
  return label >= PointLabel::car && label <= PointLabel::other;
}

using Matrix = std::map<PointLabel, std::map<PointLabel, std::uint64_t>>;

Matrix matrix_of(const std::vector<ThingSample>& samples, const std::vector<PointLabel>& given) {
  Matrix m;
  for (std::size_t i = 0; i < samples.size(); ++i) ++m[samples[i].label][given[i]];
  return m;
}

void print_matrix(const Matrix& m) {
  std::set<PointLabel> columns;
  for (const auto& [row, cells] : m) {
    columns.insert(row);
    for (const auto& [column, n] : cells) columns.insert(column);
  }
  fmt::print("  {:12}", "true");
  for (const PointLabel c : columns) fmt::print("{:>12}", name_of(c));
  fmt::print("{:>10}\n", "right");
  std::uint64_t right = 0, all = 0;
  for (const auto& [row, cells] : m) {
    std::uint64_t total = 0;
    fmt::print("  {:12}", name_of(row));
    for (const PointLabel c : columns) {
      const std::uint64_t n = cells.count(c) ? cells.at(c) : 0;
      fmt::print("{:12}", n);
      total += n;
      right += c == row ? n : 0;
    }
    all += total;
    fmt::print("{:9.2f}%\n",
               100.0 * static_cast<double>(cells.count(row) ? cells.at(row) : 0) / static_cast<double>(total));
  }
  fmt::print("  total error {:.2f} %\n", 100.0 * static_cast<double>(all - right) / static_cast<double>(all));
}

// Shares that are right, by class and in total, to be averaged over seeds.
void note_shares(const Matrix& m, std::map<std::string, std::vector<double>>& shares) {
  std::uint64_t right = 0, all = 0;
  for (const auto& [row, cells] : m) {
    std::uint64_t total = 0;
    for (const auto& [column, n] : cells) total += n;
    const std::uint64_t own = cells.count(row) ? cells.at(row) : 0;
    shares[name_of(row)].push_back(100.0 * static_cast<double>(own) / static_cast<double>(total));
    right += own, all += total;
  }
  shares["total error"].push_back(100.0 * static_cast<double>(all - right) / static_cast<double>(all));
}

void print_intervals(const std::map<std::string, std::vector<double>>& shares) {
  constexpr double kStudent[] = {0, 0, 12.71, 4.30, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31, 2.26};
  for (const auto& [name, list] : shares) {
    const auto n = static_cast<double>(list.size());
    double sum = 0, squares = 0;
    for (const double v : list) sum += v;
    for (const double v : list) squares += (v - sum / n) * (v - sum / n);
    const double half =
        list.size() < 2 || list.size() > 10 ? 0 : kStudent[list.size()] * std::sqrt(squares / (n - 1) / n);
    fmt::print("  {:12} {:6.2f} +- {:.2f} %\n", name, sum / n, half);
  }
}

// Of each object that was found the thing that is most of it.
std::vector<ThingSample> objects_of(const Street& street) {
  std::map<std::uint32_t, std::size_t> best;
  for (std::size_t i = 0; i < street.samples.size(); ++i)
    if (street.object[i] != 0)
      if (const auto entry = best.try_emplace(street.object[i], i).first;
          street.overlaps[i] > street.overlaps[entry->second])
        entry->second = i;
  std::vector<ThingSample> out;
  for (const auto& [object, i] : best) out.push_back(street.samples[i]);
  return out;
}

void print_ranking(const std::vector<ThingSample>& samples, const ThingTrainingParams& params) {
  fmt::print("  features:");
  for (const std::size_t f : selected_features(samples, params)) fmt::print(" {},", thing_feature_name(f));
  fmt::print("\n");
}

void add(const Matrix& m, Matrix& all) {
  for (const auto& [row, cells] : m)
    for (const auto& [column, n] : cells) all[row][column] += n;
}

// What a run would give: the things that are whole, by class; all objects that points lie on count.
void judge_whole(const Street& street, const std::vector<ThingClass>& classes, Matrix& all,
                 std::map<std::string, std::vector<double>>& shares) {
  const std::vector<std::uint8_t> taken = whole_things(street.things, classes);
  Matrix m;
  std::map<std::string, std::uint64_t> detected;
  std::uint64_t found = 0, wrong = 0, right = 0, objects = 0;
  constexpr std::size_t kThresholds = 10;
  std::array<std::array<std::uint64_t, 2>, kThresholds> at{};  // wrong, right
  for (std::size_t i = 0; i < taken.size(); ++i) {
    if (taken[i] == 0 || !is_object(classes[i].label)) continue;
    for (std::size_t t = 0; t < kThresholds; ++t)
      if (classes[i].probability * 10 >= static_cast<double>(t)) ++at[t][street.object[i] != 0];
    ++found;
    if (street.object[i] == 0) {
      ++wrong;
      ++m[street.samples[i].label][classes[i].label];
      continue;
    }
    const PointLabel truth = street.classes.at(street.object[i]);
    ++m[truth][classes[i].label];
    ++detected[name_of(truth)];
    ++right;
  }
  for (std::size_t t = 3; t < kThresholds; ++t) {
    double objects_seen = 0;
    for (const auto& [name, n] : street.objects) objects_seen += static_cast<double>(n);
    const double wrong_at = static_cast<double>(at[t][0]), right_at = static_cast<double>(at[t][1]);
    fmt::print("  probability from 0.{}: recall {:.1f}, false {:.1f} %\n", t, 100 * right_at / objects_seen,
               100 * wrong_at / std::max(1.0, wrong_at + right_at));
  }
  Matrix judged = m;
  judged.erase(PointLabel::none), judged.erase(PointLabel::vegetation);
  note_shares(judged, shares);
  for (const auto& [name, n] : street.objects) {
    m[label_of(name)][PointLabel::none] += n - detected[name];
    objects += n;
  }
  add(m, all);
  shares["recall"].push_back(100.0 * static_cast<double>(right) / static_cast<double>(objects));
  shares["false"].push_back(100.0 * static_cast<double>(wrong) /
                            static_cast<double>(std::max<std::uint64_t>(1, found)));
}

// Samples of all streets, their blocks told apart.
std::vector<ThingSample> pooled(const std::vector<std::vector<ThingSample>>& streets) {
  std::vector<ThingSample> all;
  for (std::size_t s = 0; s < streets.size(); ++s)
    for (ThingSample sample : streets[s]) {
      sample.group += static_cast<std::uint32_t>(1000 * s);
      all.push_back(sample);
    }
  return all;
}

// One cross-validation over the blocks of all streets: what the document does with 4 classes of what was found, or what
// a run would give.
void judge(const std::vector<Street>& streets, const char* title, const ThingTrainingParams& params,
           bool objects_only) {
  fmt::print("\n{}\n", title);
  std::vector<std::vector<ThingSample>> samples;
  for (const Street& street : streets) samples.push_back(objects_only ? objects_of(street) : street.samples);
  const std::vector<ThingSample> all_samples = pooled(samples);
  print_ranking(all_samples, params);
  const std::vector<ThingClass> given = cross_validate(all_samples, params);
  std::map<std::string, std::vector<double>> shares;
  Matrix all;
  std::size_t first = 0;
  for (std::size_t s = 0; s < streets.size(); first += samples[s++].size()) {
    const std::vector<ThingClass> own(given.begin() + static_cast<std::ptrdiff_t>(first),
                                      given.begin() + static_cast<std::ptrdiff_t>(first + samples[s].size()));
    if (!objects_only) {
      judge_whole(streets[s], own, all, shares);
      continue;
    }
    std::vector<PointLabel> labels;
    for (const ThingClass& c : own) labels.push_back(c.label);
    const Matrix m = matrix_of(samples[s], labels);
    note_shares(m, shares);
    add(m, all);
  }
  print_matrix(all);
  print_intervals(shares);
}

void write_model(const std::vector<Street>& streets, const std::vector<std::string>& clouds, const fs::path& path) {
  std::vector<std::vector<ThingSample>> lists;
  for (const Street& street : streets) lists.push_back(street.samples);
  const std::vector<ThingSample> samples = pooled(lists);
  ThingTrainingParams params;
  ThingModel model = train_things(samples, params);
  std::string names;
  for (const std::string& c : clouds) names += " " + fs::path(c).filename().string();
  model.recipe = "bench_streets" + names + " --model things.model\n" +
                 fmt::format("{} things; {} folds by block; at most {} of a class\n", samples.size(), params.folds,
                             params.most_of_class);
  write_whole_file(path, thing_model_text(model));
  fmt::print("\n{}: {} support vectors, cost {}, gamma {}\n", path.string(), model.vectors.size(), model.cost,
             model.gamma);
}

int run(const std::vector<std::string>& arguments) {
  std::vector<std::string> clouds;
  fs::path cache, model;
  bool quick = false, everything = false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--cache" && i + 1 < arguments.size())
      cache = arguments[++i];
    else if (arguments[i] == "--model" && i + 1 < arguments.size())
      model = arguments[++i];
    else if (arguments[i] == "--only-model")
      quick = true;
    else if (arguments[i] == "--everything")
      everything = true;
    else
      clouds.push_back(arguments[i]);
  }
  if (clouds.empty()) throw std::runtime_error("usage: bench_streets STREET.laz... [--cache FOLDER] [--model FILE]");
  std::vector<Street> streets;
  for (const std::string& cloud : clouds) {
    const fs::path kept = cache.empty() ? fs::path() : cache / (fs::path(cloud).stem().string() + ".things");
    fmt::print("{}\n", cloud);
    if (!kept.empty() && fs::exists(kept)) {
      streets.push_back(load(kept));
    } else {
      streets.push_back(study(cloud));
      if (!kept.empty()) save(streets.back(), kept);
    }
    keep_best(streets.back());
    const Street& s = streets.back();
    std::map<PointLabel, std::uint64_t> counts;
    for (const ThingSample& sample : s.samples) ++counts[sample.label];
    fmt::print("  ground {:.2f} %;",
               100.0 * static_cast<double>(s.ground_found) / static_cast<double>(std::max<std::uint64_t>(1, s.ground)));
    for (const std::string& name : kClasses) fmt::print(" {} {}/{},", name, counts[label_of(name)], s.objects.at(name));
    fmt::print(" vegetation {}, none {}\n", counts[PointLabel::vegetation], counts[PointLabel::none]);
  }
  if (!quick) {
    ThingTrainingParams document;
    document.features = FeatureSet::document;
    fmt::print(
        "\ndocument: mean height, area, max accumulation, s.d. height, mode accumulation, s.d. accumulation;\n"
        "car 91.04, lamppost 100, pedestrian 96.97, other 62.50 %, total error 14.93 %\n");
    if (!everything) {
      judge(streets, "four classes of what was found, the document's features", document, true);
      judge(streets, "four classes of what was found, all features", {}, true);
    }
    judge(streets, "everything found, all features", {}, false);
  }
  if (!model.empty()) write_model(streets, clouds, model);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    int code = 0;
    with_threads(hardware_threads(), [&] { code = run({argv + 1, argv + argc}); });
    return code;
  } catch (const std::exception& e) {
    fmt::print(stderr, "bench_streets: {}\n", e.what());
    return 1;
  }
}
