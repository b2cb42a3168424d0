# SPDX-License-Identifier: Apache-2.0
# Functions over points in memory. x, y, z: numbers of one length, finite. Numbers of points begin at 1.

coordinates <- function(...) {
  values <- Map(numbers, list(...), c("x", "y", "z")[seq_len(...length())])
  if (length(unique(lengths(values))) != 1) stop("x, y and z have different lengths", call. = FALSE)
  values
}

# list(index, distance): matrices of a row a point, the nearest first; NA and Inf where there is none.
nearest_neighbours <- function(x, y, z, count = 16, max_distance = 0) {
  p <- coordinates(x, y, z)
  found <- .Call(neighbours_r, p[[1]], p[[2]], p[[3]], as.integer(count), as.double(max_distance))
  list(index = matrix(found[[1]], ncol = count, byrow = TRUE), distance = matrix(found[[2]], ncol = count, byrow = TRUE))
}

# A data frame of nx, ny, nz (of unit length, pointing up; zeros: none) and curvature.
estimate_normals <- function(x, y, z, count = 16, max_distance = 0) {
  p <- coordinates(x, y, z)
  found <- .Call(normals_r, p[[1]], p[[2]], p[[3]], as.integer(count), as.double(max_distance))
  normals <- matrix(found[[1]], ncol = 3, byrow = TRUE)
  data.frame(nx = normals[, 1], ny = normals[, 2], nz = normals[, 3], curvature = found[[2]])
}

# The number of the cluster of each point, from 1 by first appearance.
euclidean_clusters <- function(x, y, z, radius) {
  p <- coordinates(x, y, z)
  .Call(clusters_r, p[[1]], p[[2]], p[[3]], as.double(radius))
}

# list(label, planes): label 0 = none, else the row of planes, a matrix of nx, ny, nz, d with n . p + d = 0. NA: chosen.
find_planes <- function(x, y, z, epsilon = NA, normal_angle_deg = NA, connectivity = NA, min_points = 0, seed = 0) {
  p <- coordinates(x, y, z)
  if (min_points < 0 || seed < 0) stop("min_points and seed: at least 0", call. = FALSE)
  found <- .Call(planes_r, p[[1]], p[[2]], p[[3]], as.double(epsilon), as.double(normal_angle_deg), as.double(connectivity),
                 as.integer(min_points), as.double(seed))
  list(label = found[[1]], planes = matrix(found[[2]], ncol = 4, byrow = TRUE, dimnames = list(NULL, c("nx", "ny", "nz", "d"))))
}

# A matrix of three numbers of points a triangle, which turn left.
delaunay <- function(x, y) {
  p <- coordinates(x, y)
  matrix(.Call(delaunay_r, p[[1]], p[[2]]), ncol = 3, byrow = TRUE)
}
