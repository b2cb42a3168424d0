// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/candidate_relations.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ilot {
namespace {

double of(const ObjectCandidate& candidate, CandidateFeature f) {
  return candidate.features[static_cast<std::size_t>(f)];
}
double of(const ObjectCandidate& candidate, ComponentFeature f) {
  return candidate.features[static_cast<std::size_t>(f)];
}
void set(ObjectCandidate& candidate, CandidateFeature f, double value) {
  candidate.features[static_cast<std::size_t>(f)] = value;
}

// Sets the features of a candidate that is in no join and joins no others.
void set_single(ObjectCandidate& t) {
  const double box = of(t, CandidateFeature::length) * of(t, CandidateFeature::width);
  set(t, CandidateFeature::fill, box > 0 ? of(t, ComponentFeature::area) / box : 0);
  for (const auto f : {CandidateFeature::lesser_share, CandidateFeature::top_step, CandidateFeature::mean_step,
                       CandidateFeature::rise})
    set(t, f, 0);
  set(t, CandidateFeature::joined_share, 1);
  set(t, CandidateFeature::joined_fill, of(t, CandidateFeature::fill));
  set(t, CandidateFeature::joined_length, of(t, CandidateFeature::length));
}

void set_joined(const ObjectCandidate& whole, const ObjectCandidate& other, ObjectCandidate& part) {
  const double area = of(whole, ComponentFeature::area);
  set(part, CandidateFeature::joined_share, area > 0 ? of(part, ComponentFeature::area) / area : 0);
  set(part, CandidateFeature::rise, of(part, ComponentFeature::max_height) - of(other, ComponentFeature::max_height));
  set(part, CandidateFeature::joined_fill, of(whole, CandidateFeature::fill));
  set(part, CandidateFeature::joined_length, of(whole, CandidateFeature::length));
}

// Sets the features of the join that contains a candidate and is in no other. Parts come before their joins.
void set_roots(std::span<ObjectCandidate> candidates) {
  std::vector<std::size_t> root(candidates.size());
  for (std::size_t i = candidates.size(); i-- > 0;) {
    root[i] = std::max(root[i], i);
    for (const std::uint32_t part : candidates[i].parts)
      if (part != 0) root[part - 1] = root[i];
    const ObjectCandidate& whole = candidates[root[i]];
    const double area = of(whole, ComponentFeature::area);
    set(candidates[i], CandidateFeature::root_share, area > 0 ? of(candidates[i], ComponentFeature::area) / area : 0);
    set(candidates[i], CandidateFeature::root_length, of(whole, CandidateFeature::length));
  }
}

}  // namespace

void relate_candidates(std::span<ObjectCandidate> candidates) {
  for (ObjectCandidate& t : candidates) set_single(t);
  for (ObjectCandidate& t : candidates) {
    if (t.parts[0] == 0) continue;
    ObjectCandidate &a = candidates[t.parts[0] - 1], &b = candidates[t.parts[1] - 1];
    const auto step = [&](ComponentFeature f) { return std::abs(of(a, f) - of(b, f)); };
    const double area = of(t, ComponentFeature::area);
    const double lesser = std::min(of(a, ComponentFeature::area), of(b, ComponentFeature::area));
    set(t, CandidateFeature::lesser_share, area > 0 ? lesser / area : 0);
    set(t, CandidateFeature::top_step, step(ComponentFeature::max_height));
    set(t, CandidateFeature::mean_step, step(ComponentFeature::mean_height));
    set_joined(t, b, a);
    set_joined(t, a, b);
  }
  set_roots(candidates);
}

}  // namespace ilot
