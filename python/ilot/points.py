# SPDX-License-Identifier: Apache-2.0
"""Functions over points in memory. x, y, z: float64 arrays of one length. `step`: of the lattice that points are rounded to, 0 =
chosen from their extent (0.0001 up to 419 m). `threads`: 0 = all; no result depends on it."""
from __future__ import annotations

import operator
from typing import TYPE_CHECKING

from . import _ilot
from ._types import FoundPlanes, usage_fault

if TYPE_CHECKING:
    from ._types import Floats, Indices, Singles


def nearest_neighbours(x: Floats, y: Floats, z: Floats, count: int = 16, *, max_distance: float = 0.0, step: float = 0.0,
                       threads: int = 0) -> tuple[Indices, Singles]:
    """Returns (index, distance), both of shape (points, count), the nearest first, which is the point itself. Where fewer lie
    within max_distance (0 = however far), index is 2**32 - 1 and distance infinite."""
    return _ilot.nearest_neighbours(x, y, z, operator.index(count), float(max_distance), float(step), operator.index(threads))


def estimate_normals(x: Floats, y: Floats, z: Floats, count: int = 16, *, max_distance: float = 0.0, step: float = 0.0,
                     threads: int = 0) -> tuple[Singles, Singles, Singles, Singles]:
    """Returns (nx, ny, nz, curvature), float32: unit normals that point up, 0, 0, 0 where there is none, from the principal
    components of `count` neighbours; curvature is 0 on a plane and 1/3 in a ball."""
    return _ilot.estimate_normals(x, y, z, operator.index(count), float(max_distance), float(step), operator.index(threads))


def euclidean_clusters(x: Floats, y: Floats, z: Floats, radius: float, *, step: float = 0.0) -> tuple[Indices, int]:
    """Returns (id, count): points at most `radius` apart are in one cluster, numbered from 0 by first appearance."""
    return _ilot.euclidean_clusters(x, y, z, float(radius), float(step))


def find_planes(x: Floats, y: Floats, z: Floats, *, epsilon: float | None = None, normal_angle_deg: float | None = None,
                min_points: int | None = None, connectivity: float | None = None, probability: float = 0.99, seed: int = 0,
                step: float = 0.0, threads: int = 0) -> FoundPlanes:
    """Finds planes by random sample consensus. What is None is chosen from the points. Returns a dict: label (uint32 a point,
    0 = none, else 1 + row of planes), planes of shape (n, 4): nx, ny, nz, d with n . p + d = 0, and the values that were
    used. Every labelled point lies within epsilon of its plane."""
    if min_points is not None and operator.index(min_points) < 3:
        raise usage_fault(f"min_points={min_points}: at least 3")
    if operator.index(seed) < 0:
        raise usage_fault(f"seed={seed}: at least 0")
    lengths = [None if v is None else float(v) for v in (epsilon, normal_angle_deg, connectivity)]
    return _ilot.find_planes(x, y, z, lengths[0], lengths[1], min_points, lengths[2], float(probability), seed, float(step),
                             operator.index(threads))


def delaunay(x: Floats, y: Floats, *, step: float = 0.0) -> Indices:
    """Returns the Delaunay triangulation in plan: corners of shape (triangles, 3), which turn left."""
    return _ilot.delaunay(x, y, float(step))


def alpha_shape(x: Floats, y: Floats, reach: float, *, fill_holes: bool = False,
                step: float = 0.0) -> tuple[list[list[Indices]], float]:
    """Returns (polygons, area): the triangles of circumradius `reach` at most, joined. A polygon is a list of rings of indices
    of points: its outer ring counter-clockwise, then its holes clockwise."""
    return _ilot.alpha_shape(x, y, float(reach), bool(fill_holes), float(step))
