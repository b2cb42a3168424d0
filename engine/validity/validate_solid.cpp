// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/validate_solid.h"

#include <fmt/format.h>

#include <utility>

#include "kernels/core/union_find.h"

namespace ilot {
namespace {

std::string joined(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + ", " + b;
}

SolidBoundary reversed(SolidBoundary shell) {
  for (TriangleCorners& t : shell.triangles) std::swap(t[1], t[2]);
  return shell;
}

void append(SolidBoundary& to, const SolidBoundary& more) {
  const auto first = static_cast<std::uint32_t>(to.vertices.size());
  to.vertices.insert(to.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const auto& [a, b, c] : more.triangles) to.triangles.push_back({a + first, b + first, c + first});
}

// Compares an inner shell, as the solid that it cuts out, with the solid within the outer shell.
int inner_shell_fault(const SolidBoundary& outer, const SolidBoundary& inner) {
  const SolidRelation r = relate_solids(outer, inner);
  if (r.b_outside_a || r.share_opposite) return r.interiors_overlap() ? 401 : 403;
  return r.share_same ? 401 : 0;
}

int inner_shells_fault(const SolidBoundary& a, const SolidBoundary& b) {
  const SolidRelation r = relate_solids(a, b);
  if (r.equal()) return 402;
  return r.interiors_overlap() || r.share_opposite ? 401 : 0;
}

// Checks the shells, each of which is valid by itself: first their orientations, then how they lie to each other.
Faults check_shells(const std::vector<SolidBoundary>& shells, const std::string& name) {
  Faults faults;
  for (std::size_t i = 0; i < shells.size(); ++i)
    if (volume_sign(shells[i].triangles, shells[i].vertices) != (i == 0 ? 1 : -1))
      faults.push_back({405, joined(name, fmt::format("shell {}", i))});
  if (!faults.empty()) return faults;
  for (std::size_t i = 1; i < shells.size(); ++i) {
    if (const int code = inner_shell_fault(shells[0], reversed(shells[i])))
      faults.push_back({code, joined(name, fmt::format("shells 0 and {}", i))});
    for (std::size_t k = i + 1; k < shells.size(); ++k)
      if (const int code = inner_shells_fault(reversed(shells[i]), reversed(shells[k])))
        faults.push_back({code, joined(name, fmt::format("shells {} and {}", i, k))});
  }
  return faults;
}

struct CheckedSolid {
  Faults faults;
  SolidBoundary boundary;
};

CheckedSolid check_solid(std::span<const Vec3> vertices, const SolidShells& shells, const ValidityLattice& lattice,
                         const ValidityParams& params, const std::string& name) {
  CheckedSolid out;
  std::vector<SolidBoundary> sound;
  bool empty = shells.empty();
  for (const SolidShell& shell : shells) empty = empty || shell.empty();
  if (empty) return {{{902, name}}, {}};
  for (std::size_t i = 0; i < shells.size(); ++i) {
    const std::string shell_name = shells.size() > 1 ? joined(name, fmt::format("shell {}", i)) : name;
    CheckedShell shell = check_shell(vertices, shells[i], ShellRule::closed, lattice, params, shell_name);
    out.faults.insert(out.faults.end(), shell.faults.begin(), shell.faults.end());
    sound.push_back({std::move(shell.vertices.points), std::move(shell.triangles)});
  }
  if (!out.faults.empty()) return out;
  out.faults = check_shells(sound, name);
  for (const SolidBoundary& shell : sound) append(out.boundary, shell);
  return out;
}

// Checks the solids of a composite. Equal pairs stop the check, then overlapping pairs. The solids of a composite must
// be connected by common surfaces.
Faults check_composite(const std::vector<SolidBoundary>& solids, const std::string& name) {
  Faults same, overlaps;
  std::vector<std::uint32_t> parents(solids.size());
  UnionFind sets(parents);
  std::size_t pieces = solids.size();
  for (std::uint32_t i = 0; i < solids.size(); ++i) {
    for (std::uint32_t k = i + 1; k < solids.size(); ++k) {
      const SolidRelation r = relate_solids(solids[i], solids[k]);
      const std::string pair = joined(name, fmt::format("solids {} and {}", i, k));
      if (r.equal()) same.push_back({502, pair});
      if (r.interiors_overlap()) overlaps.push_back({501, pair});
      if (r.share_opposite && sets.unite(i, k)) --pieces;
    }
  }
  if (!same.empty()) return same;
  if (!overlaps.empty()) return overlaps;
  if (pieces > 1) return {{503, joined(name, fmt::format("{} parts", pieces))}};
  return {};
}

CheckedPrimitive check_surfaces(std::span<const Vec3> vertices, const Primitive& primitive,
                                const ValidityLattice& lattice, const ValidityParams& params, const std::string& name) {
  const ShellRule rule = primitive.kind == PrimitiveKind::multi_surface ? ShellRule::faces : ShellRule::surface;
  CheckedPrimitive out;
  for (const SolidShells& shells : primitive.solids)
    for (const SolidShell& shell : shells)
      for (Fault& fault : check_shell(vertices, shell, rule, lattice, params, name).faults)
        out.faults.push_back(std::move(fault));
  return out;
}

bool is_surface(PrimitiveKind kind) {
  return kind == PrimitiveKind::multi_surface || kind == PrimitiveKind::composite_surface;
}

}  // namespace

CheckedPrimitive check_primitive(std::span<const Vec3> vertices, const Primitive& primitive,
                                 const ValidityLattice& lattice, const ValidityParams& params,
                                 const std::string& name) {
  if (is_surface(primitive.kind)) return check_surfaces(vertices, primitive, lattice, params, name);
  CheckedPrimitive out;
  for (std::size_t i = 0; i < primitive.solids.size(); ++i) {
    const std::string solid_name = primitive.solids.size() > 1 ? joined(name, fmt::format("solid {}", i)) : name;
    CheckedSolid solid = check_solid(vertices, primitive.solids[i], lattice, params, solid_name);
    out.faults.insert(out.faults.end(), solid.faults.begin(), solid.faults.end());
    out.solids.push_back(std::move(solid.boundary));
  }
  if (primitive.solids.empty()) out.faults.push_back({902, name});
  if (out.faults.empty() && primitive.kind == PrimitiveKind::composite_solid)
    out.faults = check_composite(out.solids, name);
  return out;
}

}  // namespace ilot
