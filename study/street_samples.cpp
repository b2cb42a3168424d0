// SPDX-License-Identifier: Apache-2.0
#include "study/street_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "engine/pass/index.h"
#include "engine/pass/resident.h"
#include "engine/products/streets/ground/standing_form.h"
#include "engine/products/streets/make_streets.h"
#include "engine/proof/point_stream.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kTree = 7;  // true class
constexpr std::uint64_t kMemoryOfStudy = std::uint64_t{64}
                                         << 30;  // bytes; the candidates of all streets stay in memory
constexpr double kHighestTrunk = 2;              // metres above the ground; higher points of trees are crowns
constexpr double kHalf = 0.5;                    // share of an object; with less, a candidate is not the object
constexpr double kClearly = 0.2;                 // difference by which one overlap is clearly better than another

struct MatchedObject {
  std::string class_name, variant;
  std::uint64_t points = 0;
  bool touches = false;
  // The values below are for the object candidate that overlaps the object best.
  double overlap = 0;  // intersection over union of the points
  std::uint64_t common = 0, of_candidate = 0;
};

struct TrueStreet {
  std::map<std::uint32_t, MatchedObject> objects;
  std::vector<std::pair<Vec3, Vec3>> blocks;  // left sides of the blocks, along the street
  std::vector<Vec3> trees;                    // their bases, where the truth has them
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
  if (root.contains("trees"))
    for (const auto& t : root.at("trees")) street.trees.push_back(vec(t.at("base")));
  for (const auto& b : root.at("blocks"))
    if (b.at("side") == "left") street.blocks.emplace_back(vec(b.at("from")), vec(b.at("to")));
  return street;
}

// Returns the block that is nearest along the street.
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

// True points by object candidate, [0] is unused. At first the index is a part, then any candidate.
struct Shares {
  std::vector<std::map<std::uint32_t, std::uint64_t>> of_object, of_class;
  std::vector<std::uint64_t> points;

  explicit Shares(std::size_t candidates)
      : of_object(candidates + 1), of_class(candidates + 1), points(candidates + 1, 0) {}

  void add_joined(const std::vector<ObjectCandidate>& candidates) {
    for (std::size_t i = 1; i < points.size(); ++i) {
      for (const std::uint32_t part : candidates[i - 1].parts) {
        if (part == 0) continue;
        points[i] += points[part];
        for (const auto& [c, n] : of_class[part]) of_class[i][c] += n;
        for (const auto& [o, n] : of_object[part]) of_object[i][o] += n;
      }
    }
  }
};

// Trunks of trees, which stand alone after crowns are taken out or cut off. The truth does not number these objects.
class Trunks {
 public:
  explicit Trunks(const TrueStreet& truth) : bases_(!truth.trees.empty()) {
    for (const Vec3& t : truth.trees) places_.emplace_back(t.x, t.y);
  }

  // Returns the number of the trunk to which a point of a tree belongs; 0 = none, where the bases of trees are known.
  std::uint32_t at(double x, double y, TrueStreet& truth) {
    if (bases_) {
      for (std::size_t t = 0; t < places_.size(); ++t) {
        if (std::hypot(x - places_[t].first, y - places_[t].second) > kWidestKnown) continue;
        const auto number = static_cast<std::uint32_t>(kFirst + t);
        truth.objects.try_emplace(number, MatchedObject{"other", "trunk"});
        return number;
      }
      return 0;
    }
    std::size_t t = 0;
    while (t < places_.size() && std::hypot(x - places_[t].first, y - places_[t].second) > kWidest) ++t;
    const auto number = static_cast<std::uint32_t>(kFirst + t);
    if (t == places_.size()) {
      places_.emplace_back(x, y);
      truth.objects[number] = {"other", "trunk", 0, false};
    }
    return number;
  }

 private:
  static constexpr double kWidest = 1;         // metres
  static constexpr double kWidestKnown = 0.5;  // metres around a base
  static constexpr std::size_t kFirst = 1e6;   // above all numbers in a truth
  std::vector<std::pair<double, double>> places_;
  bool bases_;
};

// Returns what a run has found at the pixel of a point. It keeps few tiles in memory.
class PixelLookup {
 public:
  explicit PixelLookup(const FoundStreet& found) : tiles_(*found.tiles) {}

  struct Seen {
    Height level = kNoHeight;
    std::size_t candidate = 0;
    bool on_street = false;  // and not in a building
    Structure structure = Structure::none;

    // Where a point of this height went.
    PointPlace place(Height z, const RasterScale& scale) const {
      const Height above = level == kNoHeight ? 0 : z - level;
      if (above < scale.units(StreetsSettings{}.least_height)) return PointPlace::ground;
      if (is_overhead(structure) && above >= scale.units(kClearance)) return PointPlace::overhead;
      if (!on_street) return PointPlace::building;
      return candidate == 0 ? PointPlace::no_part : PointPlace::part;
    }
  };
  Seen at(Index3 p) {
    const TileRaster& raster = tiles_.raster();
    const std::int64_t x = raster.column(p.x), y = raster.row(p.y), side = raster.grid.side;
    const std::size_t tile = raster.grid.tile_with(x, y);
    if (tile == kNoTile) return {};
    auto entry = kept_.find(tile);
    if (entry == kept_.end()) {
      if (kept_.size() > 60) kept_.clear();
      entry = kept_
                  .try_emplace(tile, Kept{layer_tile(tiles_.layers(), "level", tile),
                                          layer_tile(tiles_.layers(), "candidates", tile),
                                          layer_tile(tiles_.layers(), "mask", tile),
                                          layer_tile(tiles_.cells().layers, "structure", tile)})
                  .first;
    }
    const Kept& kept = entry->second;
    const auto pixel = static_cast<std::size_t>(y % side * side + x % side);
    const std::size_t cell = tiles_.cells().cell_of(pixel, raster.grid.side);
    return {kept.level.values[pixel], static_cast<std::size_t>(kept.candidates.values[pixel]),
            kept.mask.values[pixel] == 1, static_cast<Structure>(kept.structure.values[cell])};
  }

 private:
  struct Kept {
    Image level, candidates, mask, structure;
  };
  const StreetTiles& tiles_;
  std::map<std::size_t, Kept> kept_;
};

// Reads all points. Counts which true points are in which candidate, and how much of the ground is found.
Shares compare(PointReader& reader, const FoundStreet& found, TrueStreet& truth, Street& street) {
  const CloudInfo& info = reader.info();
  const ExtraField kind = *find_integer_field(info.layout, "true_class");
  const ExtraField element = *find_integer_field(info.layout, "true_element");
  const TileRaster& raster = found.tiles->raster();
  const LatticeMap lattice(info.layout, raster.unit);
  Shares shares(found.candidates.size());
  PixelLookup look(found);
  Trunks trunks(truth);
  const Height highest = raster.scale.units(kHighestTrunk);
  for_each_record(reader, [&](const std::byte* record) {
    std::int32_t raw[3];
    std::memcpy(raw, record, sizeof raw);
    Index3 p;
    if (!lattice.map(raw[0], raw[1], raw[2], p)) return;
    auto object = static_cast<std::uint32_t>(integer_of(record, element));
    const auto true_class = static_cast<std::uint32_t>(integer_of(record, kind));
    const PixelLookup::Seen seen = look.at(p);
    const PointPlace place = seen.place(height_of(p.z), raster.scale);
    street.bounds.add({raster.column(p.x), raster.row(p.y), truth.objects.count(object) != 0 ? object : 0, place});
    if (true_class == kTree && seen.level != kNoHeight && p.z - seen.level < highest)
      object = trunks.at(static_cast<double>(p.x) * raster.unit, static_cast<double>(p.y) * raster.unit, truth);
    const auto entry = truth.objects.find(object);
    if (entry != truth.objects.end()) ++entry->second.points;
    street.ground += true_class == 1;
    street.ground_found += true_class == 1 && seen.level != kNoHeight && place == PointPlace::ground;
    if (place != PointPlace::part) return;  // what is overhead in the same pixel has its own label
    ++shares.points[seen.candidate];
    ++shares.of_class[seen.candidate][true_class];
    if (entry != truth.objects.end()) ++shares.of_object[seen.candidate][object];
  });
  shares.add_joined(found.candidates);
  return shares;
}

// Adds the samples according to the objects that overlap each candidate.
void add_samples(const FoundStreet& found, const Shares& shares, TrueStreet& truth, Street& street) {
  const TileRaster& raster = found.tiles->raster();
  for (std::size_t i = 1; i < shares.points.size(); ++i) {
    const ObjectCandidate& candidate = found.candidates[i - 1];
    TrainingSample sample{candidate.features, PointLabel::none, 0};
    sample.parts = {candidate.parts[0], candidate.parts[1]};
    sample.group = block_of(truth, raster.crs_x(candidate.x), raster.crs_y(candidate.y));
    street.object.push_back(0);
    street.overlaps.push_back(0);
    std::uint64_t most = 0;
    for (const auto& [true_class, count] : shares.of_class[i])
      if (count > most) most = count, sample.label = true_class == kTree ? PointLabel::vegetation : PointLabel::none;
    for (const auto& [object, common] : shares.of_object[i]) {
      MatchedObject& o = truth.objects.at(object);
      const double overlap = static_cast<double>(common) / static_cast<double>(o.points + shares.points[i] - common);
      if (overlap > o.overlap) o.overlap = overlap, o.common = common, o.of_candidate = shares.points[i];
      if (overlap < kHalf) continue;
      sample.label = label_of(o.class_name);
      street.object.back() = object;
      street.overlaps.back() = overlap;
    }
    street.samples.push_back(sample);
  }
  street.candidates = found.candidates;
}

// Returns for each object the greatest overlap that a union of separated parts has with it. The parts of the best union
// are those with the largest shares of points of the object.
std::map<std::uint32_t, double> best_unions(const FoundStreet& found, const Shares& shares, const TrueStreet& truth) {
  struct Part {
    std::uint64_t common, points;
  };
  std::map<std::uint32_t, std::vector<Part>> parts;
  for (std::size_t i = 1; i < shares.points.size(); ++i) {
    if (found.candidates[i - 1].parts[0] != 0) continue;
    for (const auto& [object, common] : shares.of_object[i]) parts[object].push_back({common, shares.points[i]});
  }
  std::map<std::uint32_t, double> best;
  for (auto& [object, list] : parts) {
    std::sort(list.begin(), list.end(),
              [](const Part& a, const Part& b) { return a.common * b.points > b.common * a.points; });
    std::uint64_t common = 0, points = 0;
    for (const Part& part : list) {
      common += part.common, points += part.points;
      const std::uint64_t of_either = truth.objects.at(object).points + points - common;
      best[object] = std::max(best[object], static_cast<double>(common) / static_cast<double>(of_either));
    }
  }
  return best;
}

void print_lost(const TrueStreet& truth, const FoundStreet& found) {
  for (const auto& [id, o] : truth.objects)
    if (o.points > 0 && o.overlap < kHalf)
      fmt::print("  missed {} {} ({}{}): {} points, best candidate has {} of them and {} in all\n", o.class_name, id,
                 o.variant, o.touches ? ", touching" : "", o.points, o.common, o.of_candidate);
  for (const StreetStretch& s : found.stretches)
    fmt::print("  stretch of {:.0f} m: {} blocks, {} gaps\n", s.length, s.blocks.size(), s.gaps.size());
}

}  // namespace

const std::vector<std::string>& object_classes() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& [value, name] : point_label_names())
      if (is_street_object(static_cast<PointLabel>(value))) all.push_back(name);
    return all;
  }();
  return names;
}

PointLabel label_of(const std::string& name) {
  if (const auto label = label_named(name)) return *label;
  throw std::runtime_error("no class " + name);
}

std::string name_of(PointLabel label) {
  return class_name_of(label, {});
}

Street study(const fs::path& cloud, const Leaving& leaving) {
  // Without a limit all unused memory is given back before each pass, which takes most of the time of a small street.
  set_memory_limit(kMemoryOfStudy);
  TrueStreet truth = read_street(cloud);
  const fs::path folder = fs::temp_directory_path() / ("bench_streets_" + cloud.stem().string() + leaving.name());
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::vector<std::unique_ptr<PointReader>> readers = open_street(cloud, leaving);
  PassContext context;
  const IndexResult index = build_index(readers, {}, folder, context);
  const FoundStreet found = find_street(index.store, {}, context);
  Street street;
  const Shares shares = compare(*readers[0], found, truth, street);
  for (const auto& [id, object] : truth.objects) street.objects[object.class_name] += object.points > 0;
  add_samples(found, shares, truth, street);
  street.unions = best_unions(found, shares, truth);
  street.blocks = truth.blocks.size();
  street.view = found.view;
  print_lost(truth, found);
  fs::remove_all(folder);
  return street;
}

void save(const Street& street, const fs::path& path) {
  std::string text = fmt::format("{} {} {}\n", street.blocks, street.ground, street.ground_found);
  for (const std::string& name : object_classes())
    text += fmt::format("{} ", street.objects.count(name) ? street.objects.at(name) : 0);
  text += "\n";
  for (std::size_t i = 0; i < street.samples.size(); ++i) {
    const TrainingSample& s = street.samples[i];
    const ObjectCandidate& t = street.candidates[i];
    text += fmt::format("{} {} {} {:.17g} {} {} {}", static_cast<int>(s.label), s.group, street.object[i],
                        street.overlaps[i], t.pixels, t.parts[0], t.parts[1]);
    for (const double f : s.features) text += fmt::format(" {:.17g}", f);
    text += "\n";
  }
  write_whole_file(path, text);
}

Street load(const fs::path& path) {
  std::ifstream file(path);
  Street street;
  file >> street.blocks >> street.ground >> street.ground_found;
  for (const std::string& name : object_classes()) file >> street.objects[name];
  int label = 0;
  for (TrainingSample s; file >> label >> s.group;) {
    s.label = static_cast<PointLabel>(label);
    street.object.push_back(0), street.overlaps.push_back(0), street.candidates.push_back({});
    ObjectCandidate& t = street.candidates.back();
    file >> street.object.back() >> street.overlaps.back() >> t.pixels >> t.parts[0] >> t.parts[1];
    for (double& f : s.features) file >> f;
    s.parts = {t.parts[0], t.parts[1]};
    street.samples.push_back(s);
  }
  return street;
}

std::map<std::uint32_t, std::size_t> best_samples(const Street& street) {
  std::map<std::uint32_t, std::size_t> best;
  for (std::size_t i = 0; i < street.samples.size(); ++i)
    if (street.object[i] != 0)
      if (const auto entry = best.try_emplace(street.object[i], i).first;
          street.overlaps[i] > street.overlaps[entry->second])
        entry->second = i;
  return best;
}

void set_roles(Street& street) {
  const auto best = best_samples(street);
  const std::size_t n = street.samples.size();
  std::vector<std::uint8_t> is_best(n, 0), below(n, 0), above(n, 0);
  for (const auto& [object, i] : best) {
    is_best[i] = 1;
    street.classes[object] = street.samples[i].label;
  }
  for (std::size_t i = n; i-- > 0;)
    for (const std::uint32_t part : street.candidates[i].parts)
      if (part != 0) below[part - 1] = below[i] | is_best[i];
  for (std::size_t i = 0; i < n; ++i) {
    for (const std::uint32_t part : street.candidates[i].parts)
      if (part != 0) above[i] |= above[part - 1] | is_best[part - 1];
    TrainingSample& s = street.samples[i];
    const std::uint32_t object = street.object[i];
    if (object != 0 && street.overlaps[i] >= street.overlaps[best.at(object)] - kClearly) continue;
    if (above[i] != 0)
      s.role = CandidateRole::merged;
    else if (below[i] != 0)
      s.role = CandidateRole::part;
  }
}

}  // namespace ilot
