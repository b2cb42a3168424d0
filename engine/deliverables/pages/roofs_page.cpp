// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/pages/roofs_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "engine/deliverables/drawings/building_drawing.h"
#include "engine/markup.h"
#include "engine/whole_file.h"
#include "kernels/core/rng.h"

namespace ilot {
namespace {

constexpr std::uint64_t kMostFacesDrawn = 30000;
constexpr std::size_t kSamples = 12, kMostFallen = 200;
constexpr int kWidth = 300, kHeight = 230;  // pixels of a drawing

constexpr const char* kRoofsHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>Roofs</title><style>
body{font:14px/1.45 system-ui,sans-serif;color:#1d2433;background:#fff;margin:1.5rem auto;max-width:64rem;padding:0 1rem}
h1{font-size:1.4rem;margin:0 0 .3rem}h2{font-size:1.1rem;margin:1.6rem 0 .4rem}p{margin:.2rem 0;color:#5c667a}
.plan{width:100%;height:auto;max-height:80vh;border:1px solid #d5dae3}
.plan path{stroke:#1d2433;stroke-width:.6;vector-effect:non-scaling-stroke;fill-rule:evenodd}
.plan .lod12 path{stroke:#d27a12}.plan .footprint_only path{stroke:#c2272d;fill:#c2272d55}
.drawings{display:flex;flex-wrap:wrap;gap:.8rem}figure{margin:0;width:300px}figcaption{font-size:12px;color:#5c667a}
figure svg{background:#f3f5f8}figure path{stroke:#1d2433;stroke-width:.7;stroke-linejoin:round;fill-rule:evenodd}
.points circle{fill:#0b5fa5;opacity:.75}
table{border-collapse:collapse}td,th{padding:.2rem .6rem;text-align:left;border-bottom:1px solid #d5dae3}
</style></head><body>
)";

template <class T>
std::optional<T> attribute(const Building& b, const char* name) {
  for (const auto& [key, value] : b.attributes)
    if (key == name)
      if (const T* v = std::get_if<T>(&value)) return *v;
  return {};
}

// The rank is equal for equal ids at any place.
std::uint64_t random_rank(const std::string& id) {
  std::uint64_t hash = id.size();
  for (const char c : id) hash = mix64(hash ^ static_cast<unsigned char>(c));
  return hash;
}

std::string caption_of(const Building& first, const std::string& status, double share_off) {
  std::string caption = status;
  if (const auto faces = attribute<std::int64_t>(first, "roof_faces")) caption += fmt::format(", {} faces", *faces);
  if (const auto rmse = attribute<double>(first, "rmse_m")) caption += fmt::format(", RMSE {:.2f} m", *rmse);
  if (const auto points = attribute<std::int64_t>(first, "points")) caption += fmt::format(", {} points", *points);
  if (share_off > 0) caption += fmt::format(", {:.1f} % of them off", 100 * share_off);
  return caption;
}

}  // namespace

void RoofsPage::add(std::span<const Building> levels, std::span<const Vec3> points, double share_off) {
  const Building& first = levels.front();
  const Building& finest = levels.back();
  const std::string status = attribute<std::string>(first, "status").value_or("");
  const std::string caption = caption_of(first, status, share_off);
  ++buildings_;
  ++by_status_[status];
  if (status != "lod22" && fallen_.size() < kMostFallen)
    fallen_.push_back({first.id, status, attribute<std::string>(first, "reason").value_or("")});
  if (finest.vertices.empty()) return;
  if (faces_drawn_ < kMostFacesDrawn) draw_in_plan(finest, fmt::format("{}: {}", first.id, caption));
  if (status == "footprint_only") return;
  const Sample sample{first.id, caption, finest, {points.begin(), points.end()}};
  keep(choices_[0], -share_off, sample);
  keep(choices_[1], -static_cast<double>(finest.surfaces.size()), sample);
  keep(choices_[2], static_cast<double>(random_rank(first.id) >> 11), sample);
}

void RoofsPage::draw_in_plan(const Building& building, const std::string& caption) {
  if (drawn_ == 0) origin_ = building.vertices[0];
  for (const Vec3& v : building.vertices) {
    const double x = v.x - origin_.x, y = origin_.y - v.y;
    frame_ = {std::min(frame_[0], x), std::min(frame_[1], y), std::max(frame_[2], x), std::max(frame_[3], y)};
  }
  ++drawn_;
  for (const BuildingSurface& s : building.surfaces) faces_drawn_ += s.kind == SurfaceKind::roof;
  const std::string shape = building.lod == "1.2" ? "lod12" : building.lod == "2.2" ? "lod22" : "footprint_only";
  plan_ += fmt::format("<g class=\"{}\"><title>{}</title>{}</g>\n", shape, escaped_markup(caption),
                       plan_paths(building, origin_));
}

void RoofsPage::keep(Choice& choice, double rank, const Sample& sample) {
  if (choice.samples.size() == kSamples && rank >= std::prev(choice.samples.end())->first) return;
  choice.samples.emplace(rank, sample);
  if (choice.samples.size() > kSamples) choice.samples.erase(std::prev(choice.samples.end()));
}

void RoofsPage::finish() {
  std::string html = kRoofsHead;
  html += fmt::format("<h1>Roofs: {} buildings</h1>\n<p>", buildings_);
  for (const auto& [status, count] : by_status_) html += fmt::format("{} {} &nbsp; ", count, escaped_markup(status));
  html += "</p>\n";
  if (drawn_ > 0) {
    constexpr double kMargin = 0.02;
    const double width = frame_[2] - frame_[0], height = frame_[3] - frame_[1], by = kMargin * std::max(width, height);
    html += fmt::format("<h2>Plan</h2>\n<p>{:.0f} x {:.0f} m, north is up{}.</p>\n", width * metres_per_unit_,
                        height * metres_per_unit_,
                        drawn_ < buildings_ ? fmt::format("; {} of {} buildings are drawn", drawn_, buildings_) : "");
    html += fmt::format("<svg class=\"plan\" viewBox=\"{:.2f} {:.2f} {:.2f} {:.2f}\">\n{}</svg>\n", frame_[0] - by,
                        frame_[1] - by, width + 2 * by, height + 2 * by, plan_);
  }
  for (const Choice& choice : choices_) {
    if (choice.samples.empty()) continue;
    html += fmt::format("<h2>{}</h2>\n<div class=\"drawings\">\n", choice.title);
    for (const auto& [rank, s] : choice.samples)
      html += fmt::format("<figure>{}<figcaption>{}: {}</figcaption></figure>\n",
                          oblique_drawing(s.building, s.points, kWidth, kHeight), escaped_markup(s.id),
                          escaped_markup(s.caption));
    html += "</div>\n";
  }
  if (!fallen_.empty()) {
    html += "<h2>Not as LoD2.2</h2>\n<table><tr><th>building</th><th>status</th><th>reason</th></tr>\n";
    for (const auto& [id, status, reason] : fallen_)
      html += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", escaped_markup(id), escaped_markup(status),
                          escaped_markup(reason));
    html += "</table>\n";
    if (fallen_.size() == kMostFallen) html += "<p>The first ones; all are in the attributes.</p>\n";
  }
  write_whole_file(path_, html + "</body></html>\n");
}

}  // namespace ilot
