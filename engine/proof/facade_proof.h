// SPDX-License-Identifier: Apache-2.0
// Compares each edge and face of a facade's plan with the measured points.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/proof/facade_surfaces.h"
#include "engine/visibility/closest_point.h"
#include "kernels/core/lists_by_key.h"

namespace ilot {

struct FacadeProofParams {
  double reach_m = 0.03;       // greatest distance of a point from the surfaces that it supports, inclusive
  double edge_reach_m = 0.03;  // greatest distance of a point from an edge that it supports, inclusive
  double metres_per_unit = 1;
};

// Numbers of points and sums of their squared distances in whole micrometres. The sums do not depend on the order.
struct ProofTally {
  struct Sum {
    std::uint64_t points = 0, squares = 0;
    std::uint64_t stretches = 0;  // of an edge: a bit for each of up to 64 stretches, set where it has a point
  };
  std::vector<Sum> edges, faces;

  void add(const ProofTally& other);
};

// Assigns each point to the nearest surface of the plan, which is the wall or a face of an element (Embree's closest
// point). The point supports that face, and every near edge of the element to which the face belongs. A point of the
// wall supports edges of every element; a point of an element supports its own edges and those of the outline. If an
// edge is drawn at a wrong place, even by millimetres, its points lie off the surfaces that meet in it. If an edge is
// drawn where there is no surface, it has no points. Several threads may call add() at once. O(log faces) per point.
class FacadeProof {
 public:
  explicit FacadeProof(const Facade& facade, const FacadeProofParams& params = {});

  ProofTally no_points() const;

  // About the memory that this takes.
  std::uint64_t bytes() const;

  // Adds points in metres, in the axes of the facade.
  void add(std::span<const Vec3> points, ProofTally& tally) const;

  // Writes support, root mean square and covered share to the edges and faces of the facade. An outline without edges
  // gets edges, with the error of its size.
  void write(const ProofTally& tally, Facade& facade) const;

 private:
  struct Edge {
    std::uint32_t element = 0, number = 0;
    Vec3 a, b;
    bool outline = false;
    int stretches = 1;  // of equal length
  };
  void add_edges(const Facade& facade);
  void sort_edges();
  template <class Take>
  void for_bins_near(const Edge& e, const Take& take) const;
  std::span<const std::uint32_t> edges_near(Vec3 p) const;
  void add_to_edges(Vec3 p, std::uint64_t squares, std::uint32_t element, ProofTally& tally) const;
  std::size_t bin_of(double u, double v) const;

  FacadeProofParams params_;
  WallSurface wall_;
  std::vector<std::uint32_t> faces_;    // per tally entry: 5 * element + name, ascending
  std::vector<std::uint32_t> face_of_;  // index in faces_ of each triangle; the wall comes first
  ClosestPoint closest_;
  std::vector<Edge> edges_;
  double u0_ = 0, v0_ = 0;
  std::int64_t columns_ = 0, rows_ = 0;
  ListsByKey near_;  // the edges near each bin
};

}  // namespace ilot
