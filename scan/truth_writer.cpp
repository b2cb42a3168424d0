// SPDX-License-Identifier: Apache-2.0
#include "scan/truth_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace ilot::scan {
namespace {

constexpr std::size_t kChunk = 1 << 20;  // bytes that are copied at a time

std::string place_text(Vec3 p) {
  return fmt::format("[{:.4f},{:.4f},{:.4f}]", p.x, p.y, p.z);
}

std::string direction_text(Vec3 v) {
  return fmt::format("[{},{},{}]", v.x, v.y, v.z);
}

template <class Items, class Text>
std::string list_text(const Items& items, const Text& text_of) {
  std::string text = "[";
  for (std::size_t i = 0; i < items.size(); ++i) text += (i ? "," : "") + text_of(items[i]);
  return text + "]";
}

std::string ring_text(const std::vector<Vec3>& ring, Vec3 origin) {
  return list_text(ring, [&](Vec3 p) { return place_text(origin + p); });
}

std::string ids_text(const std::vector<std::uint32_t>& ids) {
  return list_text(ids, [](std::uint32_t id) { return std::to_string(id); });
}

std::string polygon_text(const TruePolygon& polygon, Vec3 origin) {
  std::string text = fmt::format(R"({{"building":{},"ring":{})", polygon.building, ring_text(polygon.ring, origin));
  if (!polygon.holes.empty())
    text += R"(,"holes":)" + list_text(polygon.holes, [&](const auto& hole) { return ring_text(hole, origin); });
  return text + "}";
}

std::string arc_text(const TrueArc& arc, Vec3 origin) {
  return fmt::format(R"({{"centre":{},"radius_m":{:.4f},"from_deg":{:.6f},"to_deg":{:.6f}}})",
                     place_text(origin + arc.centre), arc.radius, arc.from_deg, arc.to_deg);
}

std::string seen_text(const std::optional<TrueSight>& seen) {
  return seen ? fmt::format(R"(,"rays":{},"area_m2":{:.4f},"flush":{})", seen->rays, seen->area, seen->flush) : "";
}

std::string occluded_text(const std::optional<double>& share) {
  return share ? fmt::format(R"(,"occluded":{:.4f})", *share) : "";
}

std::string outline_text(const std::vector<Vec3>& outline, Vec3 origin) {
  return outline.empty() ? "" : R"(,"outline":)" + ring_text(outline, origin);
}

std::string object_text(const TrueObject& o, Vec3 origin) {
  return fmt::format(R"({{"id":{},"class":"{}",{}"variant":"{}","base":{},"box":{{"centre":{},"size":{},)"
                     R"("heading_deg":{}}},"touches":{},"points":{}{}{}{}{}}})",
                     o.id, o.object_class, o.group.empty() ? "" : fmt::format(R"("group":"{}",)", o.group), o.variant,
                     place_text(origin + o.base), place_text(origin + o.box_centre), direction_text(o.box_size),
                     o.heading_deg, ids_text(o.touches), o.points, occluded_text(o.occluded),
                     o.moves ? R"(,"moves":true)" : "", o.sometimes ? R"(,"sometimes":true)" : "",
                     outline_text(o.outline, origin));
}

}  // namespace

struct TruthWriter::Spool {
  Spool(std::string_view name, const std::filesystem::path& path) : kind(name), file(path) {}
  std::string kind;
  OutputFile file;      // never committed: it is deleted with the writer
  std::string pending;  // not yet written to the file
  bool empty = true;

  void flush() {
    file.append(std::as_bytes(std::span(pending)));
    pending.clear();
  }
};

TruthWriter::TruthWriter(const std::filesystem::path& path, const std::string& settings, const ScenePlace& place)
    : file_(path), origin_(place.origin) {
  append(fmt::format("{{\"scan\":{{{}}}", settings));
  if (place.crs.epsg) append(fmt::format(",\n\"crs\":\"EPSG:{}\"", place.crs.epsg));
}

TruthWriter::~TruthWriter() = default;

void TruthWriter::append(const std::string& text) {
  file_.append(std::as_bytes(std::span(text)));
}

void TruthWriter::add_line(std::string_view kind, const std::string& text) {
  auto spool = std::find_if(spools_.begin(), spools_.end(), [&](const auto& s) { return s->kind == kind; });
  if (spool == spools_.end()) {
    const std::filesystem::path path = file_.path().string() + "." + std::string(kind);
    spool = spools_.insert(spools_.end(), std::make_unique<Spool>(kind, path));
  }
  (*spool)->pending += ((*spool)->empty ? "" : ",\n") + text;
  (*spool)->empty = false;
  if ((*spool)->pending.size() > kChunk) (*spool)->flush();
}

void TruthWriter::noise(const TrueNoise& noise) {
  append(fmt::format(",\n\"noise\":{{\"range_m\":{},\"angle_deg\":{},\"divergence_mrad\":{},\"beam_diameter_m\":{}}}",
                     noise.range, noise.angle_deg, noise.divergence_mrad, noise.beam_diameter));
}

void TruthWriter::add_names(std::string_view kind, const std::map<int, std::string>& names) {
  std::string text;
  for (const auto& [value, name] : names) text += fmt::format("{}\"{}\":\"{}\"", text.empty() ? "" : ",", value, name);
  append(fmt::format(",\n\"{}\":{{{}}}", kind, text));
}

void TruthWriter::classes(const std::map<int, std::string>& names) {
  add_names("classes", names);
}

void TruthWriter::materials(const std::map<int, std::string>& names) {
  add_names("materials", names);
}

void TruthWriter::add(const TrueDraws& draws) {
  if (draws.distributions.empty()) return;
  append(fmt::format(",\n\"distributions_sha256\":\"{}\"", draws.distributions));
  for (const TrueDraw& d : draws.scene) {
    const std::string choice = d.choice.empty() ? "" : fmt::format(R"(,"choice":"{}")", d.choice);
    add_line("drawn", fmt::format(R"({{"name":"{}","value":{},"unit":"{}"{}{}}})", d.name, d.value, d.unit, choice,
                                  d.fixed ? R"(,"fixed":true)" : ""));
  }
  for (const TrueDrawSummary& d : draws.elements) {
    std::string choices;
    for (const auto& [name, count] : d.choices)
      choices += fmt::format("{}\"{}\":{}", choices.empty() ? "" : ",", name, count);
    const std::string counts = choices.empty() ? "" : ",\"choices\":{" + choices + "}";
    add_line("drawn_elements",
             fmt::format(R"({{"name":"{}","unit":"{}","per":"{}","elements":{},"least":{},"most":{},"mean":{}{}}})",
                         d.name, d.unit, d.per, d.elements, d.least, d.most, d.mean, counts));
  }
  for (const TrueShare& share : draws.shares)
    add_line("drawn_shares",
             fmt::format(R"({{"name":"{}","elements":{},"happened":{}}})", share.name, share.elements, share.happened));
}

void TruthWriter::add(const TrueStation& s) {
  add_line("stations", fmt::format(R"({{"id":{},"position":{},"step_horizontal_deg":{},"step_vertical_deg":{}}})", s.id,
                                   place_text(origin_ + s.position), s.step_horizontal_deg, s.step_vertical_deg));
}

void TruthWriter::add(const TruePlane& p) {
  const double d = p.plane.d - dot(p.plane.n, origin_);
  const std::string area = p.area > 0 ? fmt::format(R"(,"area_m2":{:.4f})", p.area) : "";
  add_line("planes",
           fmt::format(R"({{"id":{},"class":"{}","plane":[{},{},{},{}],"points":{},"element":{}{},"polygons":{}}})",
                       p.id, p.surface_class, p.plane.n.x, p.plane.n.y, p.plane.n.z, d, p.points, p.element, area,
                       list_text(p.polygons, [&](const auto& polygon) { return polygon_text(polygon, origin_); })));
}

void TruthWriter::add(const TrueShape& s) {
  std::string text = fmt::format(R"({{"id":{},"kind":"{}","point":{},"axis":{})", s.id, s.kind,
                                 place_text(origin_ + s.point), direction_text(s.axis));
  if (s.radius > 0) text += fmt::format(R"(,"radius_m":{})", s.radius);
  if (s.half_angle_deg > 0) text += fmt::format(R"(,"half_angle_deg":{})", s.half_angle_deg);
  if (s.length > 0) text += fmt::format(R"(,"length_m":{})", s.length);
  add_line("shapes", text + fmt::format(R"(,"points":{}}})", s.points));
}

void TruthWriter::add(const TrueElement& e) {
  std::string text = fmt::format(R"({{"id":{},"kind":"{}","facade":{},"row":{},"column":{},"ring":{})", e.id, e.kind,
                                 e.facade, e.row, e.column, ring_text(e.ring, origin_));
  if (!e.arcs.empty())
    text += R"(,"arcs":)" + list_text(e.arcs, [&](const TrueArc& arc) { return arc_text(arc, origin_); });
  add_line("elements", text + fmt::format(R"(,"width_m":{:.4f},"height_m":{:.4f},"depth_m":{:.4f},"points":{}{}}})",
                                          e.width, e.height, e.depth, e.points, seen_text(e.seen)));
}

void TruthWriter::add(const TrueOpening& o) {
  add_line("openings", fmt::format(R"({{"id":{},"element":{},"facade":{},"ring":{}{}}})", o.id, o.element, o.facade,
                                   ring_text(o.ring, origin_), seen_text(o.seen)));
}

void TruthWriter::add(const TrueControlPoint& p) {
  add_line("control_points", fmt::format(R"({{"group":"{}","element":{},"position":{}}})", p.group, p.element,
                                         place_text(origin_ + p.position)));
}

void TruthWriter::add(const TrueBuilding& b) {
  add_line("buildings",
           fmt::format(R"({{"id":{},"roof":"{}","footprint":{},"faces":{},"eave_m":{:.4f},"ridge_m":{:.4f},)"
                       R"("ground_m":{:.4f}}})",
                       b.id, b.roof, ring_text(b.footprint, origin_), ids_text(b.faces), b.eave, b.ridge, b.ground));
}

void TruthWriter::add(const TrueObject& o) {
  add_line("objects", object_text(o, origin_));
}

void TruthWriter::add_plant(const TrueObject& plant) {
  add_line("plants", object_text(plant, origin_));
}

void TruthWriter::add(const TrueTree& t) {
  add_line("trees", fmt::format(R"({{"id":{},"form":"{}","base":{},"height_m":{:.4f},"crown_base_m":{:.4f},)"
                                R"("crown_radius_m":{:.4f},"trunk_radius_m":{:.4f},"points":{}{}{}}})",
                                t.id, t.form, place_text(origin_ + t.base), t.height, t.crown_base, t.crown_radius,
                                t.trunk_radius, t.points, occluded_text(t.occluded), outline_text(t.outline, origin_)));
}

void TruthWriter::add(const TrueKerb& k) {
  add_line("kerbs", fmt::format(R"({{"line":{},"height_m":{:.4f}}})", ring_text(k.line, origin_), k.height));
}

void TruthWriter::add(const TruePavement& p) {
  const std::string facade = p.to_facade ? fmt::format(R"(,"to_facade_m":{:.4f})", *p.to_facade) : "";
  add_line("pavements",
           fmt::format(R"({{"line":{},"width_m":{:.4f}{}}})", ring_text(p.line, origin_), p.width, facade));
}

void TruthWriter::add(const TrueCarriageway& c) {
  add_line("carriageways", fmt::format(R"({{"ring":{}}})", ring_text(c.ring, origin_)));
}

void TruthWriter::add(const TrueBlock& b) {
  add_line("blocks", fmt::format(R"({{"id":{},"side":"{}","from":{},"to":{}}})", b.id, b.side,
                                 place_text(origin_ + b.from), place_text(origin_ + b.to)));
}

void TruthWriter::finish(const std::vector<std::pair<std::string, std::uint64_t>>& counts) {
  std::vector<std::byte> chunk(kChunk);
  for (const auto& spool : spools_) {
    spool->flush();
    append(",\n\"" + spool->kind + "\":[\n");
    const InputFile written(spool->file.path().string() + ".part");
    for (std::uint64_t at = 0; at < written.size();) {
      const std::size_t got = written.read_at(at, chunk);
      file_.append(std::span(chunk).first(got));
      at += got;
    }
    append("]");
  }
  std::string text;
  for (const auto& [name, count] : counts) text += fmt::format("{}\"{}\":{}", text.empty() ? "" : ",", name, count);
  append(",\n\"counts\":{" + text + "}}\n");
  file_.commit();
}

std::filesystem::path truth_path(const std::filesystem::path& cloud) {
  std::filesystem::path path = cloud;
  return path.replace_extension(".truth.json");
}

}  // namespace ilot::scan
