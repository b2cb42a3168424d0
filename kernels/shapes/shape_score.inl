// SPDX-License-Identifier: Apache-2.0
// Bodies of shape scoring: first the balls near a shape, then the points in them. The distance to a shape changes no
// faster than the point moves. So a ball whose centre is farther away than epsilon plus its radius contains no hit.

namespace {

// V has eight lanes or the widest.
template <typename V>
struct ShapeLanes {
  V ox, oy, oz, ux, uy, uz, radius, sine, cosine;
};

inline ShapeLanes<F8> load_shape(const float* s) {
  return {splat(s[0]), splat(s[1]), splat(s[2]), splat(s[3]), splat(s[4]),
          splat(s[5]), splat(s[6]), splat(s[7]), splat(s[8])};
}
inline ShapeLanes<Wide> load_shape_wide(const float* s) {
  return {splat_wide(s[0]), splat_wide(s[1]), splat_wide(s[2]), splat_wide(s[3]), splat_wide(s[4]),
          splat_wide(s[5]), splat_wide(s[6]), splat_wide(s[7]), splat_wide(s[8])};
}

// The vector from the shape's axis to the point (plane: along the axis; sphere: from the centre).
template <typename V>
struct AcrossLanes {
  V x, y, z, along, length;
};

template <int kKind, typename V>
inline AcrossLanes<V> across(const ShapeLanes<V>& s, V x, V y, V z) {
  const V vx = x - s.ox, vy = y - s.oy, vz = z - s.oz;
  if constexpr (kKind == 1) return {vx, vy, vz, vx, root(vx * vx + vy * vy + vz * vz)};
  const V h = vx * s.ux + vy * s.uy + vz * s.uz;
  if constexpr (kKind == 0) return {vx, vy, vz, h, h};
  const V qx = vx - h * s.ux, qy = vy - h * s.uy, qz = vz - h * s.uz;
  return {qx, qy, qz, h, root(qx * qx + qy * qy + qz * qz)};
}

template <int kKind, typename V>
inline V shape_distance(const ShapeLanes<V>& s, const AcrossLanes<V>& a) {
  if constexpr (kKind == 0) return magnitude(a.along);
  if constexpr (kKind == 3) return magnitude(a.length * s.cosine - a.along * s.sine);
  return magnitude(a.length - s.radius);
}

// How well normals agree, multiplied by the distance from the axis except for planes.
template <int kKind, typename V>
inline V shape_agreement(const ShapeLanes<V>& s, const AcrossLanes<V>& a, V nx, V ny, V nz) {
  if constexpr (kKind == 0) return magnitude(nx * s.ux + ny * s.uy + nz * s.uz);
  const V out = nx * a.x + ny * a.y + nz * a.z;
  if constexpr (kKind == 3) {
    const V along = nx * s.ux + ny * s.uy + nz * s.uz;
    return magnitude(out * s.cosine - a.length * s.sine * along);
  }
  return magnitude(out);
}
template <int kKind, typename V>
inline V least_agreement(V cosine, const AcrossLanes<V>& a) {
  if constexpr (kKind == 0) return cosine;
  return cosine * a.length;
}

template <int kKind>
inline std::uint32_t near_balls(const ShapeLanes<F8>& s, const float* group, F8 margin) {
  const AcrossLanes<F8> a = across<kKind>(s, load8(group), load8(group + 8), load8(group + 16));
  return mask_le(shape_distance<kKind>(s, a), load8(group + 24) + margin);
}

// Leaves that may have points near the plane with normals that agree. For others the angle between the plane's normal
// and the axis of the leaf is at least the sum of both angles, or all points are too far away. A point's offset from
// the centre of the ball of the leaf has a part along the axis, within its slab, and a rest that is at most the radius.
inline std::uint32_t agreeing_leaves(const ShapeLanes<F8>& s, const ShapeArgs& args, std::uint32_t group) {
  // Derived: twice the rounding of the square of a cosine in float32.
  constexpr float kSquareRounding = 2e-6f;
  const float *ball = args.balls[0] + kBallGroup * group, *cone = args.cones + kConeGroup * group;
  const F8 centre = across<0>(s, load8(ball), load8(ball + 8), load8(ball + 16)).along;
  const F8 along = load8(cone) * s.ux + load8(cone + 8) * s.uy + load8(cone + 16) * s.uz, cosine = magnitude(along);
  const F8 least = splat(args.angle_cosine) * load8(cone + 24) - splat(args.angle_sine) * load8(cone + 32) -
                   splat(args.cosine_rounding);
  const F8 sine = root(max8(splat(0), splat(1) - along * along) + splat(kSquareRounding));
  // The slack twice: that of the test in float32, and that of points_on_shape, which looks as much farther.
  const F8 reach = splat(args.max_distance + 2 * args.slack) + cosine * load8(cone + 48) + sine * load8(ball + 24);
  return mask_le(least, cosine) & mask_le(magnitude(centre + along * load8(cone + 40)), reach);
}

template <int kKind>
inline std::uint32_t add_leaves(const ShapeLanes<F8>& s, const ShapeArgs& args, std::uint32_t group, F8 margin,
                                std::uint32_t count) {
  std::uint32_t near = near_balls<kKind>(s, args.balls[0] + kBallGroup * group, margin);
  if constexpr (kKind == 0)
    if (near != 0) near &= agreeing_leaves(s, args, group);
  const Pick8 leaves = pick8(near);
  put_numbers(args.leaves + count, leaves, group * 8);
  return count + leaves.count;
}

template <int kKind>
inline std::uint32_t collect_balls(const ShapeArgs& args) {
  const ShapeLanes<F8> s = load_shape(args.shape);
  const F8 margin = splat(args.max_distance + args.slack);
  struct Pending {
    std::uint32_t group, members;  // mask still to visit
  };
  Pending stack[16];
  int level = args.levels - 1;
  std::uint32_t count = 0;
  if (level == 0) {
    for (std::uint32_t g = args.first_group; g < args.groups; ++g) count = add_leaves<kKind>(s, args, g, margin, count);
    return count;
  }
  stack[level] = {0, near_balls<kKind>(s, args.balls[level], margin)};
  while (level < args.levels) {
    Pending& top = stack[level];
    if (top.members == 0) {
      ++level;
      continue;
    }
    const std::uint32_t ball = top.group * 8 + static_cast<std::uint32_t>(__builtin_ctz(top.members));
    top.members &= top.members - 1;
    if (level == 1) {
      count = add_leaves<kKind>(s, args, ball, margin, count);
    } else {
      --level;
      stack[level] = {ball, near_balls<kKind>(s, args.balls[level] + kBallGroup * ball, margin)};
    }
  }
  return count;
}

template <int kKind>
inline std::uint32_t count_hits(const ShapeArgs& args) {
  const ShapeLanes<Wide> s = load_shape_wide(args.shape);
  const Wide epsilon = splat_wide(args.max_distance), cosine = splat_wide(args.min_cos);
  WideCount counts = zero_wide_count();
  for (std::uint32_t l = 0; l < args.leaf_count; ++l) {
    const std::size_t begin = std::size_t{64} * args.leaves[l];
    for (std::size_t j = begin; j < begin + 64; j += kWide) {
      const auto a = across<kKind>(s, load_wide(args.x + j), load_wide(args.y + j), load_wide(args.z + j));
      const Wide agreement =
          shape_agreement<kKind>(s, a, load_wide(args.nx + j), load_wide(args.ny + j), load_wide(args.nz + j));
      count_both_le(counts, shape_distance<kKind>(s, a), epsilon, least_agreement<kKind>(cosine, a), agreement);
    }
  }
  return total(counts);
}

template <int kKind>
inline std::uint32_t list_hits(const ShapeArgs& args) {
  const ShapeLanes<F8> s = load_shape(args.shape);
  const F8 epsilon = splat(args.max_distance), cosine = splat(args.min_cos);
  std::uint32_t found = 0;
  for (std::uint32_t l = 0; l < args.leaf_count; ++l) {
    const std::size_t begin = std::size_t{64} * args.leaves[l];
    for (std::size_t j = begin; j < begin + 64; j += 8) {
      const auto a = across<kKind>(s, load8(args.x + j), load8(args.y + j), load8(args.z + j));
      const F8 agreement = shape_agreement<kKind>(s, a, load8(args.nx + j), load8(args.ny + j), load8(args.nz + j));
      const Pick8 hits =
          pick8(mask_le(shape_distance<kKind>(s, a), epsilon) & mask_le(least_agreement<kKind>(cosine, a), agreement));
      put_numbers(args.found + found, hits, static_cast<std::uint32_t>(j));
      found += hits.count;
    }
  }
  return found;
}

template <int kKind>
inline std::uint32_t hit_points(const ShapeArgs& args) {
  return args.found == nullptr ? count_hits<kKind>(args) : list_hits<kKind>(args);
}

}  // namespace

std::uint32_t shape_leaves(const ShapeArgs& args) {
  switch (args.kind) {
    case 1:
      return collect_balls<1>(args);
    case 2:
      return collect_balls<2>(args);
    case 3:
      return collect_balls<3>(args);
    default:
      return collect_balls<0>(args);
  }
}

std::uint32_t shape_hits(const ShapeArgs& args) {
  switch (args.kind) {
    case 1:
      return hit_points<1>(args);
    case 2:
      return hit_points<2>(args);
    case 3:
      return hit_points<3>(args);
    default:
      return hit_points<0>(args);
  }
}

// The last line exports the bodies compiled here under one name.
extern const ShapeScoreBody kShapeScore;
const ShapeScoreBody kShapeScore{shape_hits, shape_leaves};
