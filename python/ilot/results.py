# SPDX-License-Identifier: Apache-2.0
"""The results of a run, read back. Planes, buildings and objects have __geo_interface__, so that
geopandas.GeoDataFrame.from_features(list) makes a table of them; their geometry is in plan, in the CRS of the clouds."""
from __future__ import annotations

import dataclasses
import math
import os
from typing import TYPE_CHECKING, Any, Iterable, Literal

from . import _ilot
from ._types import Attribute, Path, Place

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ._types import Floats

Status = Literal["seen", "completed", "occluded", "by hand"]


def _feature(geometry: dict[str, Any], properties: dict[str, Any]) -> dict[str, Any]:
    return {"type": "Feature", "geometry": geometry, "properties": properties}


def _closed(ring: Iterable[Any]) -> list[tuple[float, float]]:
    """A ring of a GeoJSON geometry in plan: the first corner comes again at the end."""
    corners = [(float(p[0]), float(p[1])) for p in ring]
    return corners + corners[:1]


@dataclasses.dataclass(frozen=True)
class PlaneSegment:
    """A plane and its outline. n . p + d = 0 with the unit vector `normal`, which points up."""
    id: int
    normal: Place
    d: float
    points: int
    centroid: Place
    rms_m: float
    epsilon_m: float  # none of its points is farther away
    area_m2: float
    confidence: float
    outline: list[list[Floats]]  # parts of rings of shape (corners, 3): the outer ring, then its holes

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        geometry = {"type": "MultiPolygon", "coordinates": [[_closed(r) for r in part] for part in self.outline]}
        properties = {f.name: getattr(self, f.name) for f in dataclasses.fields(self)
                      if f.name not in ("normal", "centroid", "outline")}
        return _feature(geometry, properties)


@dataclasses.dataclass(frozen=True)
class Surface:
    kind: Literal["roof", "wall", "ground"]
    rings: list[list[int]]  # of indices of vertices: the outer ring counter-clockwise seen from outside, then its holes


@dataclasses.dataclass(frozen=True)
class Building:
    """A building. levels: {"2.2": (vertices of shape (n, 3), surfaces)}, the highest level of detail last."""
    id: str
    attributes: dict[str, Attribute]  # docs/outputs.md has their meanings and units
    levels: dict[str, tuple[Floats, list[Surface]]]

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        """The roof of the highest level in plan, else the outline on the ground."""
        rings = []
        if self.levels:
            vertices, surfaces = next(reversed(self.levels.values()))
            kind = "roof" if any(s.kind == "roof" for s in surfaces) else "ground"
            rings = [[_closed(vertices[i] for i in ring) for ring in s.rings] for s in surfaces if s.kind == kind]
        return _feature({"type": "MultiPolygon", "coordinates": rings}, {"id": self.id, **self.attributes})


@dataclasses.dataclass(frozen=True)
class Element:
    """A window, door, sill, balcony, band ... of a facade."""
    id: int
    kind: str
    opening: bool  # a hole in the wall
    family: int  # equal elements share it; 0 = none
    row: int
    column: int
    status: Status
    reason: str
    ring: Floats  # array of shape (corners, 3)
    edge_error_m: Floats  # array: bound on the place of each edge
    edge_status: list[Status]
    width_m: float
    height_m: float
    depth_m: float
    width_error_m: float
    height_error_m: float
    points: int


@dataclasses.dataclass(frozen=True)
class Facade:
    """A wall with its elements. right, up, out: its axes of unit length."""
    id: int
    crs: str
    origin: Place
    right: Place
    up: Place
    out: Place
    width_m: float
    height_m: float
    elements: list[Element]


@dataclasses.dataclass(frozen=True)
class StreetObject:
    id: int
    # car, van, two_wheeler, pedestrian, lamppost, sign, bollard, bin, bench, planter, fence, cabinet, other, or a class
    # of one's own (train)
    label: str
    probability: float | None  # of that class; None where a person decided it
    base: Place  # on the ground
    middle: Place  # of its extent, on the ground
    height_m: float
    length_m: float
    width_m: float
    heading_deg: float  # of the length, from x towards y
    area_m2: float
    points: int
    by_hand: bool  # a person decided its class or its extent (edits)

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        """The extent of the object in plan."""
        angle = math.radians(self.heading_deg)
        along = (math.cos(angle) * self.length_m / 2, math.sin(angle) * self.length_m / 2)
        across = (-math.sin(angle) * self.width_m / 2, math.cos(angle) * self.width_m / 2)
        corners = [(self.middle[0] + a * along[0] + b * across[0], self.middle[1] + a * along[1] + b * across[1])
                   for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        properties = {f.name: getattr(self, f.name) for f in dataclasses.fields(self) if f.name not in ("base", "middle")}
        return _feature({"type": "Polygon", "coordinates": [_closed(corners)]}, properties)


@dataclasses.dataclass(frozen=True)
class StreetTree:
    """A tree of at least three metres."""
    id: int
    position: Place  # of the trunk's axis at the ground; of the middle of the crown where no trunk was seen
    trunk_seen: bool  # something narrow stands below the crown and reaches up to it
    height_m: float  # of the highest point above the ground at the position
    crown_radius_m: float  # of the circle with the area of the crown in plan
    crown_base_m: float  # above the ground; a tenth of the crown in plan reaches lower
    trunk_radius_m: float  # at 0.3 to 3.3 m above the ground; 0 = no trunk was seen
    unseen_share: float  # of the crown's sides: parts of 45 degrees and half a metre without a point
    points: int  # of the crown

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        """Its place in plan."""
        properties = {f.name: getattr(self, f.name) for f in dataclasses.fields(self) if f.name != "position"}
        return _feature({"type": "Point", "coordinates": self.position[:2]}, properties)


@dataclasses.dataclass(frozen=True)
class StreetKerb:
    """A step of the ground between road and pavement, or a part of it that was not seen."""
    id: int
    seen: bool  # False: the straight line between the ends of two seen kerbs
    line: Floats  # array of shape (vertices, 3), on the upper edge
    heights_m: Floats  # array: of the step at each vertex
    height_m: float  # their median
    length_m: float  # in plan

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        """Its line in plan."""
        properties = {f.name: getattr(self, f.name) for f in dataclasses.fields(self) if f.name not in ("line", "heights_m")}
        return _feature({"type": "LineString", "coordinates": [(float(p[0]), float(p[1])) for p in self.line]}, properties)


@dataclasses.dataclass(frozen=True)
class FacadePart:
    """A part of a line of facades: a block, or the gap between two."""
    stretch: int
    number: int  # along the stretch
    start: Place
    end: Place
    length_m: float
    height_m: float

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        """Its line in plan."""
        properties = {f.name: getattr(self, f.name) for f in dataclasses.fields(self) if f.name not in ("start", "end")}
        return _feature({"type": "LineString", "coordinates": [self.start[:2], self.end[:2]]}, properties)


@dataclasses.dataclass(frozen=True)
class PavementWidth:
    """The width of a pavement across one metre of a kerb."""
    kerb: int  # id of the kerb
    number: int  # along the kerb, from 1
    start: Place  # on the kerb's upper edge
    end: Place  # on the ground where the pavement ends
    kerb_seen: bool
    ends_at: str  # open, unsure, wall, barrier, step
    width_m: float  # in plan; of an open end to the last ground that was seen
    error_m: float  # nine in ten widths are as near to the true one, if this is what ends the pavement
    passable_m: float  # the widest part of it that no object reaches into, up to 2.2 m above the ground
    passable_from_m: float  # where that part begins, from the kerb
    unseen_share: float  # of the width
    road_m: float  # from the kerb across the carriageway to the next kerb; 0 = none within 30 m

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        """Its line in plan."""
        properties = {f.name: getattr(self, f.name) for f in dataclasses.fields(self) if f.name not in ("start", "end")}
        return _feature({"type": "LineString", "coordinates": [self.start[:2], self.end[:2]]}, properties)


@dataclasses.dataclass(frozen=True)
class Pavement:
    """Pavement between a kerb and what ends it, along places whose widths have an end."""
    id: int
    kerb: int  # id of the kerb
    ring: Floats  # array of shape (vertices, 3): along the kerb, then back along the ends
    length_m: float  # along the kerb
    area_m2: float  # in plan
    width_m: float  # median of its widths
    passable_m: float  # the least of its passable widths
    unseen_share: float  # mean over its widths

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        """Its outline in plan."""
        properties = {f.name: getattr(self, f.name) for f in dataclasses.fields(self) if f.name != "ring"}
        corners = [(float(p[0]), float(p[1])) for p in self.ring]
        return _feature({"type": "Polygon", "coordinates": [_closed(corners)]}, properties)


@dataclasses.dataclass(frozen=True)
class Carriageway:
    """Road between kerbs that face each other, in plan."""
    id: int
    ring: Floats  # array of shape (vertices, 3): along the kerbs; heights are 0
    holes: list[Floats]  # islands, and what no kerb faces
    area_m2: float
    width_m: float  # median of the ways across, from kerb to kerb
    narrowest_m: float  # the least of them
    seen_share: float  # of the ways across: both kerbs were seen

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        """Its outline in plan."""
        properties = {f.name: getattr(self, f.name) for f in dataclasses.fields(self) if f.name not in ("ring", "holes")}
        rings = [_closed([(float(p[0]), float(p[1])) for p in ring]) for ring in (self.ring, *self.holes)]
        return _feature({"type": "Polygon", "coordinates": rings}, properties)


@dataclasses.dataclass(frozen=True)
class Streets:
    """What was found on streets. Objects, trees, kerbs, pavements and carriageways are by id from 1, blocks and gaps along their stretch, widths along
    their kerb."""
    objects: list[StreetObject]
    trees: list[StreetTree]
    kerbs: list[StreetKerb]
    blocks: list[FacadePart]
    gaps: list[FacadePart]
    widths: list[PavementWidth]
    pavements: list[Pavement]
    carriageways: list[Carriageway]


def read_labels(folder: Path) -> dict[str, NDArray[np.void]]:
    """Returns the labels of the points of each Cloud that was an input, by its name: structured arrays of one record a point, in the
    order of the points, mapped from the files (nothing is read before it is used). Fields are those that docs/outputs.md lists
    for labelled clouds: plane_id, residual, unit_id ... Of inputs that are files, read_cloud(labelled, extra=["plane_id"]) gives
    them."""
    import numpy as np
    top = os.fspath(folder)
    clouds = [os.fspath(cloud) for cloud in _ilot.read_run(top)["clouds"]]
    return {os.path.basename(cloud).removesuffix(".npy"): np.load(os.path.join(top, cloud), mmap_mode="r")
            for cloud in clouds if cloud.endswith(".npy")}


def read_planes(folder: Path) -> list[PlaneSegment]:
    """Returns a list of PlaneSegment, by id from 1."""
    return [PlaneSegment(**one) for one in _ilot.read_planes(folder)]


def read_roofs(folder: Path) -> list[Building]:
    """Returns a list of Building, in the order of the file."""
    return [Building(name, attributes, {lod: (vertices, [Surface(*s) for s in surfaces]) for lod, vertices, surfaces in levels})
            for name, attributes, levels in _ilot.read_roofs(folder)]


def read_facades(folder: Path) -> list[Facade]:
    """Returns a list of Facade, the largest wall first."""
    return [Facade(f["id"], f["crs"], f["origin"], f["right"], f["up"], f["out"], f["width_m"], f["height_m"],
                   [Element(**e) for e in f["elements"]]) for f in _ilot.read_facades(folder)]


def read_streets(folder: Path) -> Streets:
    """Returns Streets: objects, trees, kerbs, pavements and their widths, carriageways, and the blocks and gaps of lines of facades. Each list makes a
    table of GeoPandas."""
    found = _ilot.read_streets(folder)
    return Streets([StreetObject(**one) for one in found["objects"]], [StreetTree(**one) for one in found["trees"]],
                   [StreetKerb(**one) for one in found["kerbs"]], [FacadePart(**one) for one in found["blocks"]],
                   [FacadePart(**one) for one in found["gaps"]], [PavementWidth(**one) for one in found["widths"]],
                   [Pavement(**one) for one in found["pavements"]], [Carriageway(**one) for one in found["carriageways"]])
