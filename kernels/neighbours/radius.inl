// SPDX-License-Identifier: Apache-2.0
// Body of radius_search. Queries of one leaf share one sweep while few points are near and float32 holds the squared
// distances exactly; otherwise each sweeps for itself, float32 culls and integers decide.

namespace {

struct RadiusOut {
  std::uint32_t* at;
  std::uint32_t room;  // elements that may be overwritten
};

// False when the room may not do.
inline bool put_nearby(const Nearby& near, const Cloud& c, std::uint32_t query, float radius2, RadiusOut& out,
                       std::uint32_t& count) {
  float d2[kNearCapacity + 16];
  count = measure(near, c.x[query], c.y[query], c.z[query], radius2, d2);
  if (count + 16 > out.room) return false;
  const Wide limit = splat_wide(radius2);
  std::uint32_t* to = out.at;
  for (std::uint32_t i = 0; i < near.size; i += kWide) to += append_le(to, near.index + i, d2 + i, limit);
  return true;
}

inline bool put_alone(const Cloud& c, std::uint32_t query, std::int64_t radius2, RadiusOut& out, std::uint32_t& count) {
  const F8 qx = splat(c.x[query]), qy = splat(c.y[query]), qz = splat(c.z[query]), limit = splat(inflate(radius2));
  const auto whole = [](float v) { return std::int64_t{static_cast<std::int32_t>(v)}; };
  bool fits = true;
  count = 0;
  visit_leaves(c, box_around(c, &query, 1), inflate(radius2), [&](std::uint32_t leaf) {
    const std::uint32_t begin = leaf * 8;
    const F8 dx = load8(c.x + begin) - qx, dy = load8(c.y + begin) - qy, dz = load8(c.z + begin) - qz;
    std::uint32_t hits = mask_le(dx * dx + dy * dy + dz * dz, limit);
    if (c.size - begin < 8) hits &= (1u << (c.size - begin)) - 1;
    for (; hits != 0; hits &= hits - 1) {
      const std::uint32_t j = begin + static_cast<std::uint32_t>(__builtin_ctz(hits));
      const std::int64_t ex = whole(c.x[j]) - whole(c.x[query]), ey = whole(c.y[j]) - whole(c.y[query]),
                         ez = whole(c.z[j]) - whole(c.z[query]);
      if (ex * ex + ey * ey + ez * ez > radius2) continue;
      fits = count < out.room;
      if (!fits) break;
      out.at[count++] = j;
    }
    return fits ? inflate(radius2) : -1.0f;
  });
  return fits;
}

}  // namespace

std::uint32_t radius_search(const RadiusArgs& a) {
  const Cloud cloud{a.x, a.y, a.z, a.size, a.boxes, a.levels};
  const float radius2 = static_cast<float>(a.radius2);
  RadiusOut out{a.neighbours, a.capacity};
  Nearby near;
  for (std::uint32_t begin = 0; begin < a.query_count;) {
    const std::uint32_t end = end_of_group(a.queries, begin, a.query_count);
    const bool together = a.radius2 < kExactInFloat &&
                          collect_nearby(cloud, box_around(cloud, a.queries + begin, end - begin), radius2, near);
    for (std::uint32_t q = begin; q < end; ++q) {
      std::uint32_t& count = a.counts[q];
      const bool fits = together ? put_nearby(near, cloud, a.queries[q], radius2, out, count)
                                 : put_alone(cloud, a.queries[q], a.radius2, out, count);
      if (!fits) return q;
      out.at += count;
      out.room -= count;
    }
    begin = end;
  }
  return a.query_count;
}
