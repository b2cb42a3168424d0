// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/validate_shell.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "kernels/core/portable_math.h"
#include "kernels/meshes/self_intersection.h"

namespace ilot {
namespace {

constexpr double kMostSteps = 68719476736.0;  // 2^36

// Numbers the vertices in order of use; near ones become one. Distances are computed in double precision, as in
// val3dity, because many files have vertices that are exactly one tolerance apart.
class Snapping {
 public:
  Snapping(std::span<const Vec3> vertices, const ValidityLattice& lattice, double snap)
      : vertices_(vertices), lattice_(lattice), snap_(snap) {}

  std::uint32_t number(std::uint32_t vertex) {
    const auto [entry, fresh] = known_.try_emplace(vertex, 0);
    if (fresh) entry->second = place(shifted(vertices_[vertex]));
    return entry->second;
  }

  std::vector<Index3> lattice_points() const {
    std::vector<Index3> points;
    for (const Vec3& p : kept_)
      points.push_back({std::llround(p.x / lattice_.step), std::llround(p.y / lattice_.step),
                        std::llround((p.z - lattice_.origin.z) / lattice_.step)});
    return points;
  }

 private:
  // Heights are not shifted, because they would round to other doubles.
  Vec3 shifted(Vec3 p) const { return {p.x - lattice_.origin.x, p.y - lattice_.origin.y, p.z}; }

  bool near(Vec3 a, Vec3 b) const {
    const Vec3 d = a - b;
    return dot(d, d) <= snap_ * snap_;
  }

  std::uint32_t place(Vec3 p) {
    const auto fresh = static_cast<std::uint32_t>(kept_.size());
    std::uint32_t found = fresh;
    for (auto i = along_x_.lower_bound(p.x - 2 * snap_); i != along_x_.end() && i->first <= p.x + 2 * snap_; ++i)
      if (i->second < found && near(kept_[i->second], p)) found = i->second;
    if (found < fresh) return found;
    kept_.push_back(p);
    along_x_.emplace(p.x, fresh);
    return fresh;
  }

  std::span<const Vec3> vertices_;
  const ValidityLattice& lattice_;
  double snap_;
  std::vector<Vec3> kept_;
  std::multimap<double, std::uint32_t> along_x_;
  std::unordered_map<std::uint32_t, std::uint32_t> known_;
};

// Checks a shell step by step, until a step finds faults.
class ShellCheck {
 public:
  ShellCheck(const SolidShell& shell, const ValidityLattice& lattice, const ValidityParams& params,
             const std::string& name)
      : shell_(shell), lattice_(lattice), params_(params), name_(name) {}

  CheckedShell run(std::span<const Vec3> vertices, ShellRule rule) {
    snap(vertices);
    check_faces();
    if (!sound()) return std::move(out_);
    triangulate();
    check_bends();
    if (sound() && rule != ShellRule::faces) check_surface(rule);
    return std::move(out_);
  }

 private:
  bool sound() const { return out_.faults.empty(); }

  void fault(int code, const std::string& what) {
    out_.faults.push_back({code, name_.empty() || what.empty() ? name_ + what : name_ + ", " + what});
  }

  std::string face_name(std::size_t face) const {
    return shell_[face].id.empty() ? fmt::format("face {}", face) : "face " + shell_[face].id;
  }

  std::string place(Index3 p) const {
    const Vec3 at = lattice_.origin +
                    lattice_.step * Vec3{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
    return fmt::format("near ({:.3f}, {:.3f}, {:.3f})", at.x, at.y, at.z);
  }

  void snap(std::span<const Vec3> vertices) {
    Snapping snapping(vertices, lattice_, params_.snap);
    for (const SolidFace& face : shell_) {
      faces_.push_back(face.rings);
      for (auto& ring : faces_.back())
        for (std::uint32_t& i : ring) i = snapping.number(i);
    }
    out_.vertices.points = snapping.lattice_points();
    out_.vertices.step = lattice_.step;
  }

  void check_faces() {
    for (std::size_t f = 0; f < faces_.size(); ++f)
      for (const Fault& found : validate_face(out_.vertices, faces_[f], params_))
        fault(found.code, face_name(f) + (found.where.empty() ? "" : ", " + found.where));
  }

  void triangulate() {
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const std::vector<TriangleCorners> cut = triangulate_face(out_.vertices, faces_[f]);
      out_.triangles.insert(out_.triangles.end(), cut.begin(), cut.end());
      face_of_.insert(face_of_.end(), cut.size(), static_cast<std::uint32_t>(f));
    }
  }

  void check_bends() {
    const double least = cos_degrees(params_.plane_normals_deg);
    const std::span<const TriangleCorners> all = out_.triangles;
    for (std::size_t first = 0, last = 0; first < all.size(); first = last) {
      while (last < all.size() && face_of_[last] == face_of_[first]) ++last;
      if (least_normals_cosine(out_.vertices, all.subspan(first, last - first)) < least)
        fault(204, face_name(face_of_[first]));
    }
  }

  void check_surface(ShellRule rule) {
    if (rule == ShellRule::closed && faces_.size() < 4) return fault(301, fmt::format("{} faces", faces_.size()));
    check_fit();
    if (!sound()) return;
    rule == ShellRule::closed ? check_closed() : check_one_sheet();
    if (!sound()) return;
    const auto meeting = meeting_triangles(out_.triangles, out_.vertices.points);
    if (!meeting.empty()) fault(306, face_name(face_of_[meeting[0]]) + " " + place(centre(meeting[0])));
  }

  void check_fit() {
    const auto fits = fit_triangles(out_.triangles, static_cast<std::uint32_t>(out_.vertices.points.size()));
    for (std::size_t t = 0; t < fits.size(); ++t)
      if (fits[t] != TriangleFit::fits) fault(fits[t] == TriangleFit::reversed ? 307 : 303, face_name(face_of_[t]));
  }

  std::uint32_t pieces() const {
    return count_pieces(out_.triangles, static_cast<std::uint32_t>(out_.vertices.points.size()));
  }

  void check_closed() {
    if (pieces() > 1) return fault(305, fmt::format("{} pieces", pieces()));
    const auto open = open_edges(out_.triangles);
    if (!open.empty()) fault(302, place(out_.vertices.points[open[0].first]));
  }

  // Checks that the shell is one sheet. A vertex where two sheets touch has more than one incoming edge of the border.
  void check_one_sheet() {
    if (pieces() > 1) return fault(305, fmt::format("{} pieces", pieces()));
    std::map<std::uint32_t, int> border;
    for (const auto& [from, to] : open_edges(out_.triangles)) ++border[from], ++border[to];
    for (const auto& [vertex, edges] : border)
      if (edges > 2) fault(303, place(out_.vertices.points[vertex]));
  }

  Index3 centre(std::uint32_t triangle) const {
    const auto& [a, b, c] = out_.triangles[triangle];
    const auto& v = out_.vertices.points;
    return {(v[a].x + v[b].x + v[c].x) / 3, (v[a].y + v[b].y + v[c].y) / 3, (v[a].z + v[b].z + v[c].z) / 3};
  }

  const SolidShell& shell_;
  const ValidityLattice& lattice_;
  const ValidityParams& params_;
  const std::string& name_;
  std::vector<FaceRings> faces_;
  std::vector<std::uint32_t> face_of_;  // per triangle
  CheckedShell out_;
};

}  // namespace

ValidityLattice lattice_of(std::span<const Vec3> vertices) {
  ValidityLattice lattice;
  if (vertices.empty()) return lattice;
  Vec3 low = vertices[0], high = low;
  for (const Vec3& v : vertices) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
  lattice.origin = low;
  const double widest = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  while (!(widest < kMostSteps * lattice.step)) lattice.step *= 10;
  return lattice;
}

CheckedShell check_shell(std::span<const Vec3> vertices, const SolidShell& shell, ShellRule rule,
                         const ValidityLattice& lattice, const ValidityParams& params, const std::string& name) {
  return ShellCheck(shell, lattice, params, name).run(vertices, rule);
}

}  // namespace ilot
