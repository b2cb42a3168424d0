# SPDX-License-Identifier: Apache-2.0
"""Point clouds as arrays: LAS, LAZ, COPC, E57, PTX, PTS, PLY, PCD and text in; LAS, LAZ, COPC and PLY out."""
from . import _ilot


def read_cloud(path, *, first=0, most=None, extra=()):
    """Returns a dict of arrays, one value a point: x, y, z (float64, CRS units), and, where the cloud has them, intensity,
    classification (ASPRS codes), red, green and blue; then the extra attributes that are asked for by name, as float64.
    `first` and `most` choose rows. Points with unusable coordinates are left out.

    >>> points = read_cloud("cloud.laz")
    >>> sorted(points)[-3:]
    ['x', 'y', 'z']
    """
    return _ilot.read_cloud(path, first, most, list(extra))


def info(path):
    """Returns what the points of a cloud really are, as `ilot info` says: number, bounds, classes, density (points/m2),
    sampling step (m), strays, warnings, and for each product whether the cloud suits it and why."""
    return _ilot.info(path)


def write_cloud(path, x, y, z, *, intensity=None, classification=None, red=None, green=None, blue=None, crs="", scale=0.001):
    """Writes .las, .laz, .copc.laz or .ply, which appears whole or not at all. x, y, z: float64, CRS units, rounded to
    multiples of `scale`. intensity, red, green, blue: uint16. classification: uint8. crs: "EPSG:2154", or empty."""
    attributes = {"intensity": intensity, "classification": classification, "red": red, "green": green, "blue": blue}
    _ilot.write_cloud(path, x, y, z, attributes, crs, scale)
