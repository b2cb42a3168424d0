# SPDX-License-Identifier: Apache-2.0
"""The compiled half of the package. Arrays that go in are contiguous, one-dimensional, and read where they are; those that come out
own their memory. The test `python_types` compares all of it with the module."""
import os
from typing import Any, Callable, Literal, TypedDict

import numpy as np
from numpy.typing import NDArray

from ._types import Attribute, Bytes, CloudInfo, Floats, FoundPlanes, Indices, Path, Place, Setting, Singles, Words
from .clouds import Cloud

version: str

class Error(RuntimeError):
    code: int

class _Run(TypedDict):
    exit: int
    folder: os.PathLike[str]
    products: list[str]
    points_read: int
    points_labelled: int
    points_unlabelled: int
    points_rejected: dict[str, int]
    skipped: list[tuple[str, str, str]]
    warnings: list[str]
    chosen: dict[str, str]
    files: list[os.PathLike[str]]
    clouds: list[os.PathLike[str]]
    seconds: float
    peak_memory_bytes: int
    result_hash: str

class _Plane(TypedDict):
    id: int
    normal: Place
    d: float
    points: int
    centroid: Place
    rms_m: float
    epsilon_m: float
    area_m2: float
    confidence: float
    outline: list[list[Floats]]

class _Element(TypedDict):
    id: int
    kind: str
    opening: bool
    family: int
    row: int
    column: int
    status: Literal["seen", "completed", "occluded", "by hand"]
    reason: str
    ring: Floats
    edge_error_m: Floats
    edge_status: list[Literal["seen", "completed", "occluded", "by hand"]]
    width_m: float
    height_m: float
    depth_m: float
    width_error_m: float
    height_error_m: float
    points: int

class _Facade(TypedDict):
    id: int
    crs: str
    origin: Place
    right: Place
    up: Place
    out: Place
    width_m: float
    height_m: float
    elements: list[_Element]

class _Object(TypedDict):
    id: int
    label: str
    probability: float | None
    base: Place
    middle: Place
    height_m: float
    length_m: float
    width_m: float
    heading_deg: float
    area_m2: float
    points: int
    by_hand: bool

class _Tree(TypedDict):
    id: int
    position: Place
    trunk_seen: bool
    height_m: float
    crown_radius_m: float
    crown_base_m: float
    trunk_radius_m: float
    unseen_share: float
    points: int

class _Kerb(TypedDict):
    id: int
    seen: bool
    line: Floats
    heights_m: Floats
    height_m: float
    length_m: float

class _Part(TypedDict):
    stretch: int
    number: int
    start: Place
    end: Place
    length_m: float
    height_m: float

class _Width(TypedDict):
    kerb: int
    number: int
    start: Place
    end: Place
    kerb_seen: bool
    ends_at: str
    width_m: float
    error_m: float
    passable_m: float
    passable_from_m: float
    unseen_share: float
    road_m: float

class _Pavement(TypedDict):
    id: int
    kerb: int
    ring: Floats
    length_m: float
    area_m2: float
    width_m: float
    passable_m: float
    unseen_share: float

class _Carriageway(TypedDict):
    id: int
    ring: Floats
    holes: list[Floats]
    area_m2: float
    width_m: float
    narrowest_m: float
    seen_share: float

class _Streets(TypedDict):
    objects: list[_Object]
    trees: list[_Tree]
    kerbs: list[_Kerb]
    blocks: list[_Part]
    gaps: list[_Part]
    widths: list[_Width]
    pavements: list[_Pavement]
    carriageways: list[_Carriageway]

_Level = tuple[str, Floats, list[tuple[Literal["roof", "wall", "ground"], list[list[int]]]]]

def read_cloud(path: Path, first: int, most: int | None, extra: list[str]) -> dict[str, NDArray[Any]]: ...
def info(path: Path) -> CloudInfo: ...
def write_cloud(path: Path, x: Floats, y: Floats, z: Floats, attributes: dict[str, Words | Bytes | None], crs: str,
                scale: float) -> None: ...
def nearest_neighbours(x: Floats, y: Floats, z: Floats, count: int, max_distance: float, step: float,
                       threads: int) -> tuple[Indices, Singles]: ...
def estimate_normals(x: Floats, y: Floats, z: Floats, count: int, max_distance: float, step: float,
                     threads: int) -> tuple[Singles, Singles, Singles, Singles]: ...
def euclidean_clusters(x: Floats, y: Floats, z: Floats, radius: float, step: float) -> tuple[Indices, int]: ...
def find_planes(x: Floats, y: Floats, z: Floats, epsilon: float | None, normal_angle_deg: float | None, min_points: int | None,
                connectivity: float | None, probability: float, seed: int, step: float, threads: int) -> FoundPlanes: ...
def delaunay(x: Floats, y: Floats, step: float) -> Indices: ...
def alpha_shape(x: Floats, y: Floats, reach: float, fill_holes: bool, step: float) -> tuple[list[list[Indices]], float]: ...
def run(inputs: list[Path], output: Path, products: list[str], settings: dict[str, str], *, arrays: list[Cloud], memory: int | str,
        threads: int, store: Path, bounds: tuple[float, float, float, float] | None, footprints: Path, id_field: str, stations: Path,
        train: Path, edits: list[Path], crs: str, to_crs: str, existing: str, strict: bool, keep_store: bool, clouds: bool,
        report: bool, progress: Callable[[str, int, int, float], Any] | None, message: Callable[[str], Any] | None) -> _Run: ...
def read_run(folder: Path) -> _Run: ...
def parameters() -> list[Setting]: ...
def read_planes(folder: Path) -> list[_Plane]: ...
def read_roofs(folder: Path) -> list[tuple[str, dict[str, Attribute], list[_Level]]]: ...
def read_facades(folder: Path) -> list[_Facade]: ...
def read_streets(folder: Path) -> _Streets: ...
