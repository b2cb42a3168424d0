# SPDX-License-Identifier: Apache-2.0
"""Point clouds as arrays: LAS, LAZ, COPC, E57, PTX, PTS, PLY, PCD and text in; LAS, LAZ, COPC and PLY out."""
from __future__ import annotations

import dataclasses
import operator
import os
from typing import TYPE_CHECKING, Any, Iterable

from . import _ilot
from ._types import CloudInfo, Path, usage_fault

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ._types import Bytes, Floats, Words


@dataclasses.dataclass(frozen=True, eq=False)
class Cloud:
    """A cloud in memory as an input of run(), planes(), roofs() ...: its arrays are read where they are, so leave them unchanged
    until the run has ended.

    x, y, z: float64, CRS units, finite; the run rounds them to multiples of `scale`, as write_cloud() does. intensity, red, green,
    blue: uint16, classification: uint8 (ASPRS codes), or None. crs: "EPSG:2154", or empty. name: of the file with the labels of
    the points, which read_labels() gives as an array."""
    x: Floats
    y: Floats
    z: Floats
    intensity: Words | None = None
    classification: Bytes | None = None
    red: Words | None = None
    green: Words | None = None
    blue: Words | None = None
    crs: str = ""
    scale: float = 0.001
    name: str = "points"

    @property
    def attributes(self) -> dict[str, Words | Bytes | None]:
        """Its attributes by name; None where it has none."""
        return {"intensity": self.intensity, "classification": self.classification, "red": self.red, "green": self.green,
                "blue": self.blue}


def read_cloud(path: Path, *, first: int = 0, most: int | None = None, extra: Iterable[str] = ()) -> dict[str, NDArray[Any]]:
    """Returns a dict of arrays, one value a point: x, y, z (float64, CRS units), and, where the cloud has them, intensity,
    classification (ASPRS codes), red, green and blue; then the extra attributes that are asked for by name, as float64.
    `first` and `most` choose rows. Points with unusable coordinates are left out.

    >>> points = read_cloud("cloud.laz")
    >>> sorted(points)[-3:]
    ['x', 'y', 'z']
    """
    rows = [operator.index(first), operator.index(most) if most is not None else 0]
    if min(rows) < 0:
        raise usage_fault(f"first={rows[0]}, most={most}: rows are counted from 0")
    names = [extra] if isinstance(extra, str) else list(extra)
    return _ilot.read_cloud(os.fspath(path), rows[0], None if most is None else rows[1], names)


def info(path: Path) -> CloudInfo:
    """Returns what the points of a cloud really are, as `ilot info` says: number, bounds, classes, density (points/m2),
    sampling step (m), strays, warnings, and for each product whether the cloud suits it and why."""
    return _ilot.info(os.fspath(path))


def write_cloud(path: Path, x: Floats, y: Floats, z: Floats, *, intensity: Words | None = None,
                classification: Bytes | None = None, red: Words | None = None,
                green: Words | None = None, blue: Words | None = None, crs: str = "",
                scale: float = 0.001) -> None:
    """Writes .las, .laz, .copc.laz or .ply, which appears whole or not at all. x, y, z: float64, CRS units, rounded to
    multiples of `scale`. intensity, red, green, blue: uint16. classification: uint8. crs: "EPSG:2154", or empty."""
    attributes: dict[str, Words | Bytes | None] = {"intensity": intensity, "classification": classification, "red": red, "green": green, "blue": blue}
    _ilot.write_cloud(os.fspath(path), x, y, z, attributes, crs, scale)
