# SPDX-License-Identifier: Apache-2.0
"""Types of arguments and results. Those of NumPy stand in annotations alone, so that `import ilot` need not load it: that would take
more than all else in it."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Literal, TypedDict

from . import _ilot

Path = str | os.PathLike[str]
Place = tuple[float, float, float]  # x, y, z
Attribute = int | float | str | bool
if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    Floats = NDArray[np.float64]
    Singles = NDArray[np.float32]
    Indices = NDArray[np.uint32]
    Words = NDArray[np.uint16]
    Bytes = NDArray[np.uint8]


class CloudInfo(TypedDict):
    """What info() says of a cloud."""
    path: os.PathLike[str]
    format: str  # las, laz, copc ...
    points: int  # rows of the file
    declared_points: int  # that its header gives
    crs: str | None  # "EPSG:2154", else WKT
    metres_per_unit: float
    scale: Place
    has_colour: bool
    extra: list[str]  # names of attributes that read_cloud(extra=) takes
    warnings: list[str]
    min: Place
    max: Place
    valid_points: int  # with usable coordinates
    rejected: int
    strays: int  # that stand alone, far from all others
    classes: dict[int, int]  # ASPRS code -> points
    area_m2: float  # in plan, where there are points
    density: float  # points/m2
    sampling_step_m: float
    suits: dict[str, tuple[bool, str]]  # product -> whether the cloud suits it, and why


class FoundPlanes(TypedDict):
    """What find_planes() returns."""
    label: Indices  # one a point: 0 = none, else 1 + row of planes
    planes: Floats  # of shape (n, 4): nx, ny, nz, d with n . p + d = 0
    epsilon: float  # this and the rest: the values that were used
    normal_angle_deg: float
    connectivity: float
    min_points: int


class Setting(TypedDict):
    """One of parameters()."""
    key: str  # "planes.epsilon"
    kind: Literal["boolean", "integer", "number", "integers", "numbers", "choice"]
    optional: bool  # None is a value: chosen from the data
    choices: list[str]  # of a choice
    default: str  # as TOML has it
    range: str
    unit: str
    help: str
    advanced: bool  # its default rarely needs a change


def usage_fault(sentence: str) -> _ilot.Error:
    """An ilot.Error of code 2: what was asked for cannot be."""
    fault = _ilot.Error(sentence)
    fault.code = 2
    return fault
