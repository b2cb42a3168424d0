# SPDX-License-Identifier: Apache-2.0
"""ilot: laser scans of cities into planes, roofs, facades and street objects.

    import ilot
    result = ilot.run("town.laz", "out", products=["roofs"], footprints="town.gpkg")
    for building in ilot.read_roofs("out"):
        print(building.id, building.attributes["h_roof_max"])

Coordinates are those of the CRS of the clouds. Points are one-dimensional contiguous arrays of float64; other arrays are
refused with the call of numpy that makes them. Every fault is ilot.Error with a sentence and the exit code of the program
(`code`: 1 failed, 2 usage, 130 interrupted). Long calls release the interpreter's lock. The same input gives the same bytes as
the program ilot, whatever the threads."""
from ._ilot import Error
from ._ilot import version as __version__
from ._types import CloudInfo, FoundPlanes, Setting
from .clouds import Cloud, info, read_cloud, write_cloud
from .points import (alpha_shape, delaunay, estimate_normals, euclidean_clusters, find_planes, nearest_neighbours)
from .products import facades, planes, roofs, streets
from .results import (Building, Carriageway, Element, Facade, FacadePart, Pavement, PavementWidth, PlaneSegment, StreetKerb, StreetObject, Streets,
                      StreetTree, Surface, read_facades, read_labels, read_planes, read_roofs, read_streets)
from .runs import RunResult, parameters, read_run, run

__all__ = ["Building", "Carriageway", "Cloud", "CloudInfo", "Element", "Error", "Facade", "FacadePart", "FoundPlanes", "Pavement",
           "PavementWidth", "PlaneSegment", "RunResult", "Setting", "StreetKerb", "StreetObject", "StreetTree", "Streets", "Surface", "__version__", "alpha_shape",
           "delaunay", "estimate_normals", "euclidean_clusters", "facades", "find_planes", "info", "nearest_neighbours",
           "parameters", "planes", "read_cloud", "read_facades", "read_labels", "read_planes", "read_roofs", "read_run",
           "read_streets", "roofs", "run", "streets", "write_cloud"]
