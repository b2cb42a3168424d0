#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Arrays of wrong shape, type, order and length, that are empty, read-only, or hold NaN, in each function of the Python package that
takes arrays. ILOT_EXE names the program."""
import unittest

import numpy as np

import ilot
from scanned_case import ScannedCase


class Arrays(ScannedCase):
    def test_wrong_arrays_are_refused(self):
        x, y, z = self.places
        for bad, words in ((x.astype("f4"), "float32"), (x[::2], "contiguous"), (x.reshape(2, -1), "one dimension"),
                           (x[:-1].copy(), "different lengths"), (x.astype(">f8"), "float64"), (np.array([]), "lengths"),
                           (np.full_like(x, np.nan), "finite"), (list(x), "list"), (None, "NoneType"), (3.0, "float"),
                           (np.array(3.0), "one dimension"), (x.astype(object), "object"), (x[::-1], "contiguous"),
                           (np.ma.masked_array(x, x > x[0]), "mask"), (np.asfortranarray(x.reshape(2, -1)), "one dimension")):
            self.refused(words, ilot.estimate_normals, bad, y, z)
        empty = np.array([])
        self.refused("there are none", ilot.estimate_normals, empty, empty, empty)
        locked = x.copy()
        locked.flags.writeable = False
        ilot.estimate_normals(locked, y, z)  # arrays are read only
        self.refused("at least 3", ilot.find_planes, x, y, z, min_points=-3)
        with self.assertRaises(TypeError):
            ilot.nearest_neighbours(x, y, z, 2.5)
        self.refused("first=-1", ilot.read_cloud, self.cloud, first=-1)
        self.refused("'classes'", ilot.read_cloud, self.cloud, extra="classes")
        self.refused("uint8", ilot.write_cloud, self.folder / "w.laz", x, y, z, classification=x)
        self.assertFalse((self.folder / "w.laz").exists())

    def test_every_function_refuses_wrong_arrays(self):
        """Each function over points, write_cloud and a run on a Cloud, for each of its coordinates."""
        def of_run(x, y, z):
            ilot.run(ilot.Cloud(x, y, z), self.folder / "none", report=False)

        def written(x, y, z):
            ilot.write_cloud(self.folder / "none.laz", x, y, z)
        functions = {of_run: 3, written: 3, ilot.nearest_neighbours: 3, ilot.estimate_normals: 3, ilot.find_planes: 3, ilot.delaunay: 2,
                     (lambda x, y, z: ilot.euclidean_clusters(x, y, z, 1.0)): 3, (lambda x, y: ilot.alpha_shape(x, y, 2.0)): 2}
        good = [c[:5000].copy() for c in self.places]
        nan, infinite = good[0].copy(), good[0].copy()
        nan[17], infinite[4999] = np.nan, -np.inf
        bad = {"shape": (good[0].reshape(2, -1), "one dimension"), "scalar": (np.array(3.0), "one dimension"), "type": (good[0].astype("f4"), "float32"),
               "integers": (good[0].astype("i8"), "int64"), "byte order": (good[0].astype(">f8"), "float64"), "order": (self.places[0][:10000:2], "contiguous"),
               "backwards": (good[0][::-1], "contiguous"), "length": (good[0][:-1].copy(), "lengths"), "list": (list(good[0]), "list"),
               "none": (None, "NoneType"), "mask": (np.ma.masked_array(good[0]), "mask"), "nan": (nan, "finite"), "infinite": (infinite, "finite"),
               "empty": (np.array([]), "lengths")}
        for function, count in functions.items():
            for place in range(count):
                for what, (array, words) in bad.items():
                    given = good[:count]
                    given[place] = array
                    with self.subTest(function=getattr(function, "__name__", ""), place=place, what=what):
                        self.refused(words, function, *given)
            before = [c.copy() for c in good[:count]]
            locked = [c.copy() for c in before]
            for array in locked:
                array.flags.writeable = False
            if function is of_run:
                ilot.run(ilot.Cloud(*locked), self.folder / "read_only", report=False)
            elif function is not written:
                function(*locked)  # arrays are read only
            for one, other in zip(locked, before):
                self.assertTrue((one == other).all())
        self.assertFalse((self.folder / "none").exists() or (self.folder / "none.laz").exists())


if __name__ == "__main__":
    unittest.main()
