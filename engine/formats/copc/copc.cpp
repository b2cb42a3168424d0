// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/copc/copc.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>

#include "engine/formats/copc/copc_octree.h"
#include "engine/formats/file.h"

namespace ilot {
namespace {

constexpr int kDeepest = 30;

// The values of the octree in the info record.
struct Octree {
  Vec3 center;
  double halfsize = 0;
  std::uint64_t page = 0, page_bytes = 0;
};

struct Key {
  std::int32_t level = 0, x = 0, y = 0;
};

struct Node {
  Key key;
  std::uint64_t offset = 0, points = 0;
};

const Vlr* info_record(const CloudInfo& info) {
  for (const Vlr& vlr : info.vlrs)
    if (vlr.user_id == "copc" && vlr.record_id == 1 && vlr.payload.size() >= kInfoSize) return &vlr;
  return nullptr;
}

std::optional<Octree> read_octree(const CloudInfo& info) {
  const Vlr* vlr = info_record(info);
  if (!vlr) return std::nullopt;
  const std::byte* p = vlr->payload.data();
  const Octree tree{{load<double>(p), load<double>(p + 8), load<double>(p + 16)},
                    load<double>(p + 24),
                    load<std::uint64_t>(p + 40),
                    load<std::uint64_t>(p + 48)};
  const bool sound =
      std::isfinite(tree.center.x) && std::isfinite(tree.center.y) && std::isfinite(tree.halfsize) && tree.halfsize > 0;
  return sound ? std::optional(tree) : std::nullopt;
}

bool is_key(const Key& key, std::int32_t z) {
  if (key.level < 0 || key.level > kDeepest) return false;
  const std::int64_t side = std::int64_t{1} << key.level;
  const auto inside = [side](std::int32_t v) { return v >= 0 && v < side; };
  return inside(key.x) && inside(key.y) && inside(z);
}

// Reads the entries of one page; other pages that it names are added to `pages`. False: the page is damaged.
bool read_page(std::span<const std::byte> page, std::vector<Node>& nodes,
               std::vector<std::pair<std::uint64_t, std::uint64_t>>& pages) {
  for (std::size_t at = 0; at + kEntrySize <= page.size(); at += kEntrySize) {
    const std::byte* p = &page[at];
    const Key key{load<std::int32_t>(p), load<std::int32_t>(p + 4), load<std::int32_t>(p + 8)};
    const auto bytes = load<std::int32_t>(p + 24), points = load<std::int32_t>(p + 28);
    if (!is_key(key, load<std::int32_t>(p + 12)) || points < -1 || bytes < 0) return false;
    const auto offset = load<std::uint64_t>(p + 16);
    if (points > 0) nodes.push_back({key, offset, static_cast<std::uint64_t>(points)});
    if (points == -1) pages.emplace_back(offset, static_cast<std::uint64_t>(bytes));
  }
  return true;
}

// Returns all nodes with points in the order of the file; nullopt when a page is damaged, read twice, or outside the
// file.
std::optional<std::vector<Node>> read_hierarchy(const InputFile& file, const Octree& tree, std::size_t most_nodes) {
  std::vector<Node> nodes;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> pages{{tree.page, tree.page_bytes}};
  std::set<std::uint64_t> seen;
  std::uint64_t budget = file.size();  // pages do not overlap
  std::vector<std::byte> page;
  while (!pages.empty()) {
    const auto [offset, bytes] = pages.back();
    pages.pop_back();
    if (bytes > budget || bytes % kEntrySize != 0 || !seen.insert(offset).second) return std::nullopt;
    budget -= bytes;
    page.resize(static_cast<std::size_t>(bytes));
    if (file.read_at(offset, page) != bytes || !read_page(page, nodes, pages)) return std::nullopt;
    if (nodes.size() > most_nodes) return std::nullopt;
  }
  std::sort(nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.offset < b.offset; });
  return nodes;
}

// Checks that the chunks are in the order of the places of their nodes and have the same numbers of points.
bool describes(const std::vector<Node>& nodes, const std::vector<std::uint64_t>& boundaries) {
  if (nodes.size() + 1 != boundaries.size()) return false;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (boundaries[i + 1] - boundaries[i] != nodes[i].points) return false;
  return true;
}

// Tells whether the closed cube of a node, widened by `slack`, meets the closed box.
bool meets(const Octree& tree, const Key& key, const Area& area, double slack_x, double slack_y) {
  const double edge = std::ldexp(2 * tree.halfsize, -key.level);
  const double x = tree.center.x - tree.halfsize + key.x * edge, y = tree.center.y - tree.halfsize + key.y * edge;
  return x - slack_x <= area.max_x && area.min_x <= x + edge + slack_x && y - slack_y <= area.max_y &&
         area.min_y <= y + edge + slack_y;
}

}  // namespace

bool is_copc(const CloudInfo& info) {
  return info_record(info) != nullptr;
}

bool is_copc_name(const std::filesystem::path& path) {
  constexpr std::string_view kEnd = ".copc.laz";
  const std::string name = path.filename().string();
  if (name.size() <= kEnd.size()) return false;
  return std::equal(kEnd.begin(), kEnd.end(), name.end() - static_cast<std::ptrdiff_t>(kEnd.size()),
                    [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b); });
}

std::vector<RowRange> rows_in_box(const PointReader& reader, const Area& area) {
  const CloudInfo& info = reader.info();
  std::vector<RowRange> all{{0, info.points}};
  const std::optional<Octree> tree = read_octree(info);
  if (!tree) return all;
  const std::vector<std::uint64_t> boundaries = reader.boundaries();
  const auto nodes = read_hierarchy(InputFile(info.path), *tree, boundaries.size());
  if (!nodes || !describes(*nodes, boundaries)) return all;
  const double slack_x = 2 * std::abs(info.layout.scale[0]), slack_y = 2 * std::abs(info.layout.scale[1]);
  std::vector<RowRange> ranges;
  for (std::size_t i = 0; i < nodes->size(); ++i) {
    if (!meets(*tree, (*nodes)[i].key, area, slack_x, slack_y)) continue;
    if (!ranges.empty() && ranges.back().end == boundaries[i])
      ranges.back().end = boundaries[i + 1];
    else
      ranges.push_back({boundaries[i], boundaries[i + 1]});
  }
  return ranges;
}

}  // namespace ilot
