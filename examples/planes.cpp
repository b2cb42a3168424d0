// SPDX-License-Identifier: Apache-2.0
// The planes of a run, with their neighbours and outlines.
// Usage: planes RUN_FOLDER
#include <ilot/error.h>
#include <ilot/planes.h>

#include <cstdio>

int main(int argc, char** argv) try {
  if (argc < 2) return 2;
  const ilot::PlaneSet set = ilot::read_planes(argv[1]);
  for (std::size_t i = 0; i < set.segments.size(); ++i) {
    const ilot::Segment& s = set.segments[i];
    std::printf("plane %u: %llu points, %.2f m2, normal %.3f %.3f %.3f, outline of %zu parts\n", s.id,
                static_cast<unsigned long long>(s.points), s.area_m2, s.plane.n.x, s.plane.n.y, s.plane.n.z,
                set.outlines[i].parts.size());
  }
  for (const ilot::PlaneNeighbours& pair : set.neighbours)
    if (pair.touching == ilot::Touching::edge)
      std::printf("planes %u and %u meet at %.1f degrees over %.1f m\n", pair.a, pair.b, pair.angle_deg,
                  pair.contact_m);
  return set.segments.empty() ? 1 : 0;
} catch (const ilot::Error& fault) {
  std::fprintf(stderr, "%s\n", fault.what());
  return static_cast<int>(fault.code());
}
