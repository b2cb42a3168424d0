// SPDX-License-Identifier: Apache-2.0
// Last in each isa_*.cpp: the bodies compiled there, under one name.
extern const Table kTable;
const Table kTable{kName,        count_inliers, knn,          neighbour_normals, hough_directions, shape_hits,
                   shape_leaves, radial_sums,   least_of_two, lower_by_step,     narrow_heights,   widen_codes};
