// SPDX-License-Identifier: Apache-2.0
// What measured points say for each edge and face of a facade's plan.
#pragma once
#include <span>

#include "engine/proof/facade_surfaces.h"
#include "engine/visibility/closest_point.h"

namespace ilot {

struct FacadeProofParams {
  double reach_m = 0.03;       // from its surfaces, beyond which a point says nothing for them, inclusive
  double edge_reach_m = 0.03;  // from an edge, of points that say something for it, inclusive
  double metres_per_unit = 1;
};

// Points and their squared distances, in whole micrometres: sums that no order changes.
struct ProofTally {
  struct Sum {
    std::uint64_t points = 0, squares = 0;
    std::uint64_t stretches = 0;  // of an edge: a bit for each of up to 64 that has a point
  };
  std::vector<Sum> edges, faces;

  void add(const ProofTally& other);
};

// Each point goes to the nearest surface of the plan, the wall or a face of an element (Embree's closest point): it
// supports that face, and of what that face is a part of every edge that it lies near to. A point of the wall speaks
// for edges of every element, a point of an element for its own edges and the outline's. An edge that is drawn at the
// wrong place, if only by millimetres, is left with points that lie off the surfaces which meet in it; one that is
// drawn on nothing has no points. Several threads may ask at once. O(log faces) a point.
class FacadeProof {
 public:
  explicit FacadeProof(const Facade& facade, const FacadeProofParams& params = {});

  ProofTally no_points() const;

  // Points in metres in the axes of the facade.
  void add(std::span<const Vec3> points, ProofTally& tally) const;

  // Support, root mean square and cover into the edges and faces of the facade. An outline without edges gets them,
  // known to the error of its size.
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
  void add_to_edges(Vec3 p, std::uint64_t squares, std::uint32_t element, ProofTally& tally) const;
  std::size_t bin_of(double u, double v) const;

  FacadeProofParams params_;
  WallSurface wall_;
  std::vector<std::uint32_t> faces_;    // per tally: 5 * element + name, ascending
  std::vector<std::uint32_t> face_of_;  // of each triangle, in faces_; the wall's first
  ClosestPoint closest_;
  std::vector<Edge> edges_;
  double u0_ = 0, v0_ = 0;
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<std::vector<std::uint32_t>> bins_;  // edges that are near
};

}  // namespace ilot
