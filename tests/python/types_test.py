#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The types of the Python package are true: the stub of the compiled module has its names and parameters, what its functions are given
and return has the types of the stub, public functions and dataclasses those of their annotations, and products.pyi all settings. With
mypy the package passes --strict, and wrong calls do not. ILOT_EXE names the program."""
import ast
import dataclasses
import inspect
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import types
import typing
import unittest
import unittest.mock

import numpy as np
from numpy.typing import NDArray

import ilot
from ilot import _ilot, _types, clouds, points, products, results, runs

EXE = os.environ["ILOT_EXE"]
ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = pathlib.Path(ilot.__file__).parent
# What stands below TYPE_CHECKING in the sources.
NAMES = {"np": np, "NDArray": NDArray, "Floats": NDArray[np.float64], "Singles": NDArray[np.float32], "Indices": NDArray[np.uint32],
         "Words": NDArray[np.uint16], "Bytes": NDArray[np.uint8], "Callable": typing.Callable, "Iterable": typing.Iterable,
         "Literal": typing.Literal, "_ilot": _ilot}


def stub(name):
    """The names that a stub defines, as objects with annotations."""
    tree = ast.parse((PACKAGE / name).read_text(encoding="utf-8"))
    tree.body = [part for part in tree.body if not isinstance(part, ast.ImportFrom) or part.module != "_types"]
    space = {"__name__": "ilot._stub", "__package__": "ilot", **vars(_types), **NAMES}
    before = set(space)
    exec(compile("from __future__ import annotations\n" + ast.unparse(tree), name, "exec"), space)
    of_imports = {a.asname or a.name for part in tree.body if isinstance(part, (ast.ImportFrom, ast.Import)) for a in part.names}
    return {k: v for k, v in space.items() if k not in before | of_imports and k != "annotations"}, space


STUB, SPACE = stub("_ilot.pyi")


def hints_of(thing):
    known = {**SPACE, **NAMES}
    module = sys.modules.get(thing.__module__)
    if module:  # forward references of a TypedDict are looked up there alone
        with unittest.mock.patch.dict(vars(module), {k: v for k, v in known.items() if k not in vars(module) and not k.startswith("__")}):
            return typing.get_type_hints(thing, {**known, **vars(module)})
    return typing.get_type_hints(thing, known)


def of_union(value, kinds, where):
    return [] if any(not faults(value, kind, where) for kind in kinds) else [f"{where}: {value!r} is none of {kinds}"]


def of_array(value, hint, where):
    wanted = typing.get_args(typing.get_args(hint)[1])[0]
    good = isinstance(value, np.ndarray) and (wanted is typing.Any or value.dtype == wanted or (wanted is np.void and value.dtype.names))
    return [] if good else [f"{where}: an array of {wanted} is expected, not {getattr(value, 'dtype', type(value))}"]


def of_record(fields, hints, where):
    if set(fields) != set(hints):
        return [f"{where}: has {sorted(set(fields) ^ set(hints))} that its type has not, or the other way round"]
    return [fault for name, value in fields.items() for fault in faults(value, hints[name], f"{where}.{name}")]


def of_container(value, hint, where):
    origin, inner = typing.get_origin(hint), typing.get_args(hint)
    if not isinstance(value, origin):
        return [f"{where}: {origin.__name__} is expected, not {type(value).__name__}"]
    if origin is dict:
        return [f for k, v in value.items() for f in faults(k, inner[0], where) + faults(v, inner[1], f"{where}[{k!r}]")]
    if origin is list:
        return [f for v in value for f in faults(v, inner[0], where + "[]")]
    if len(value) != len(inner):
        return [f"{where}: {len(value)} values, not {len(inner)}"]
    return [f for i, (v, kind) in enumerate(zip(value, inner)) for f in faults(v, kind, f"{where}[{i}]")]


def faults(value, hint, where):
    """What of a value is not as its type says."""
    origin = typing.get_origin(hint)
    if hint is typing.Any:
        return []
    if origin in (typing.Union, types.UnionType):
        return of_union(value, typing.get_args(hint), where)
    if origin is typing.Literal:
        return [] if value in typing.get_args(hint) else [f"{where}: {value!r}"]
    if origin is np.ndarray:
        return of_array(value, hint, where)
    if typing.is_typeddict(hint):
        return of_record(value, hints_of(hint), where) if isinstance(value, dict) else [f"{where}: no dict"]
    if dataclasses.is_dataclass(hint):
        fields = {f.name: getattr(value, f.name) for f in dataclasses.fields(hint)} if type(value) is hint else {}
        return of_record(fields, hints_of(hint), where)
    if origin in (list, tuple, dict):
        return of_container(value, hint, where)
    if origin is not None:  # PathLike, Callable
        return [] if isinstance(value, origin) else [f"{where}: {value!r}"]
    return [] if type(value) is hint else [f"{where}: {value!r} is no {hint}"]


class Types(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.room = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.room.name)
        cls.cloud, air = cls.folder / "street.laz", cls.folder / "air.laz"
        for scene, count, path in (("street", 150000, cls.cloud), ("street-air", 40000, air)):
            subprocess.run([EXE, "scan", scene, "-o", path, "--points", str(count), "--set", "scene.blocks=1", "-q"], check=True)
        cls.result = ilot.run([cls.cloud, air], cls.folder / "out", products=products.PRODUCTS, report=False)

    @classmethod
    def tearDownClass(cls):
        cls.room.cleanup()

    def test_the_stub_has_all_names(self):
        there = {name for name in dir(_ilot) if not name.startswith("__")}
        self.assertEqual({name for name in STUB if not name.startswith("_")} | {"version"}, there)
        self.assertIn("version", SPACE["__annotations__"])

    def test_the_stub_has_all_parameters(self):
        """pybind11 writes the signature of a function into the first line of its documentation."""
        checked = 0
        for name, function in STUB.items():
            if not inspect.isfunction(function):
                continue
            true = ast.parse(f"def {getattr(_ilot, name).__doc__.splitlines()[0]}: ...").body[0].args
            stated = inspect.signature(function).parameters.values()
            named = [p for p in stated if p.kind is not inspect.Parameter.KEYWORD_ONLY]
            self.assertEqual([p.name for p in named], [a.arg for a in true.args], name)
            self.assertEqual(len(named) < len(stated), true.kwarg is not None, name)
            for argument, stated_type in zip(true.args, named):
                kind = ast.unparse(argument.annotation)
                if kind in ("int", "float", "str", "bool"):
                    self.assertEqual(stated_type.annotation, kind, f"{name}: {argument.arg}")
                checked += 1
        self.assertGreater(checked, 50)

    def test_the_stub_has_the_keywords_of_run(self):
        stated = {p.name for p in inspect.signature(STUB["run"]).parameters.values() if p.kind is inspect.Parameter.KEYWORD_ONLY}
        taken = set(re.findall(r'more\["(\w+)"\]', (ROOT / "python/module/bind_runs.cpp").read_text()))
        call, = [c for c in ast.walk(ast.parse(inspect.getsource(runs.run))) if isinstance(c, ast.Call) and ast.unparse(c.func) == "_ilot.run"]
        self.assertEqual(stated, taken)
        self.assertEqual(stated, {k.arg for k in call.keywords})

    def calls(self, seen):
        """Everything public is called once; `seen` notes what the module is given and returns."""
        def noting(name, function):
            def call(*given, **keywords):
                result = function(*given, **keywords)
                bound = inspect.signature(STUB[name]).bind(*given, **keywords)  # fails where the stub does not take the call
                seen.append((name, bound.arguments, result))
                return result
            return call
        patches = {name: noting(name, getattr(_ilot, name)) for name, f in STUB.items() if inspect.isfunction(f)}
        with unittest.mock.patch.multiple(_ilot, **patches):
            yield from self.public_calls()

    def public_calls(self):
        cloud = ilot.read_cloud(self.cloud, first=10, most=20000, extra=["Amplitude"] if "Amplitude" in ilot.info(self.cloud)["extra"] else ())
        x, y, z = cloud["x"], cloud["y"], cloud["z"]
        yield ilot.read_cloud, cloud
        yield ilot.info, ilot.info(self.cloud)
        yield ilot.write_cloud, ilot.write_cloud(self.folder / "w.laz", x, y, z, intensity=cloud.get("intensity"))
        yield ilot.nearest_neighbours, ilot.nearest_neighbours(x, y, z, 3)
        yield ilot.estimate_normals, ilot.estimate_normals(x, y, z)
        yield ilot.euclidean_clusters, ilot.euclidean_clusters(x, y, z, 1)
        yield ilot.find_planes, ilot.find_planes(x, y, z, epsilon=0.1)
        yield ilot.delaunay, ilot.delaunay(x, y)
        yield ilot.alpha_shape, ilot.alpha_shape(x, y, 2)
        yield ilot.parameters, ilot.parameters()
        in_memory = ilot.Cloud(x, y, z, crs="EPSG:2154")
        yield ilot.run, ilot.run([in_memory, str(self.folder / "w.laz")], self.folder / "both", bounds=(0, 0, 1e7, 1e7), report=False,
                                 existing="overwrite", progress=lambda *_: None, message=lambda _: None, settings={"planes.epsilon": 0.1})
        yield ilot.read_labels, ilot.read_labels(self.folder / "both")
        for read in (ilot.read_run, ilot.read_planes, ilot.read_roofs, ilot.read_facades, ilot.read_streets):
            yield read, read(self.folder / "out")

    def test_values_have_the_types_that_are_stated(self):
        seen, called, wrong = [], set(), []
        for function, result in self.calls(seen):
            called.add(function.__name__)
            wrong += faults(result, hints_of(function)["return"], function.__name__)
        for name, given, result in seen:
            hints = hints_of(STUB[name])
            wrong += faults(result, hints["return"], f"_ilot.{name}")
            for word, value in given.items():
                if word != "clouds" or name != "run":
                    wrong += faults(value, hints[word], f"_ilot.{name}({word})")
        self.assertEqual(wrong, [])
        functions = {name for name in ilot.__all__ if inspect.isfunction(getattr(ilot, name))}
        self.assertEqual(functions - called, set(products.PRODUCTS))
        self.assertEqual({name for name, _, _ in seen}, {name for name, f in STUB.items() if inspect.isfunction(f)})
        streets = ilot.read_streets(self.folder / "out")
        self.assertTrue(streets.objects and streets.trees and streets.kerbs and streets.blocks)
        self.assertTrue(ilot.read_planes(self.folder / "out") and ilot.read_roofs(self.folder / "out"))
        self.assertTrue(any(facade.elements for facade in ilot.read_facades(self.folder / "out")))

    def test_a_wrong_type_is_a_fault(self):
        """The checks above can fail."""
        floats = NAMES["Floats"]
        for value, hint in ((np.zeros(3, "f4"), floats), ([1.0], floats), (1, float), (True, int), ((1.0, 2.0), _types.Place),
                            ("door", typing.Literal["roof"]), ([1, "a"], list[int]), ({"a": 1.5}, dict[str, int]), (None, int | str),
                            ({"label": 0}, _types.FoundPlanes), (3, results.Surface), (results.Surface("roof", [[0.5]]), results.Surface)):
            self.assertTrue(faults(value, hint, "here"), (value, hint))

    def test_every_public_function_states_all_its_types(self):
        for module in (clouds, points, results, runs):
            for name, function in vars(module).items():
                if inspect.isfunction(function) and function.__module__ == module.__name__:
                    self.assertEqual(set(hints_of(function)) - {"return"}, set(inspect.signature(function).parameters), name)
                    self.assertIn("return", hints_of(function), name)

    def test_products_have_all_settings(self):
        stated, _ = stub("products.pyi")
        of_run = [word for word in inspect.signature(ilot.run).parameters if word != "products"]
        words = {"boolean": "bool", "integer": "int", "number": "float", "integers": "Iterable[int]", "numbers": "Iterable[float]"}
        for product in products.PRODUCTS:
            own = {p["key"].removeprefix(product + ".").replace(".", "_"): p for p in ilot.parameters() if p["key"].startswith(product + ".")}
            there = inspect.signature(stated[product]).parameters
            self.assertEqual(list(there), of_run + list(own), product)
            self.assertEqual(list(inspect.signature(getattr(ilot, product)).parameters), list(there))
            for word, setting in own.items():
                kind = words.get(setting["kind"]) or f"Literal[{', '.join(repr(c) for c in setting['choices'])}]"
                self.assertEqual(there[word].annotation, f"{kind} | None", word)
                self.assertIs(there[word].kind, inspect.Parameter.KEYWORD_ONLY)

    @unittest.skipUnless(shutil.which("mypy"), "no mypy (apt install mypy)")
    def test_mypy(self):
        def told(*arguments):
            return subprocess.run(["mypy", "--python-executable", sys.executable, "--cache-dir", self.folder / "mypy", "--strict", *arguments],
                                  env={**os.environ, "MYPYPATH": str(PACKAGE.parent)}, cwd=self.folder, capture_output=True, text=True).stdout
        self.assertIn("Success", told("-p", "ilot"))
        script = self.folder / "use.py"
        script.write_text("import ilot\n"
                          "result = ilot.roofs('a.laz', 'out', detail=0.1, lod13_step=None, threads=2, edits=['e.csv'])\n"
                          "vertices, surfaces = ilot.read_roofs(result.folder)[0].levels['2.2']\n"
                          "print(vertices[0, 0] + 1.0, [s.kind for s in surfaces], ilot.info('a.laz')['density'] * 2)\n")
        self.assertIn("Success", told("use.py"))
        for line, word in (("ilot.roofs('a.laz', 'out', detial=0.1)", "detial"), ("ilot.planes('a', 'b', method='hugh')", "Literal"),
                           ("ilot.info('a.laz')['densitty']", "densitty"), ("ilot.read_planes('out')[0].normal[3]", "range"),
                           ("ilot.estimate_normals([1.0], [1.0], [1.0])", "List[float]"), ("ilot.run('a', 'b', threads='2')", "threads")):
            script.write_text(f"import ilot\n{line}\n")
            self.assertIn(word, told("use.py"), line)


if __name__ == "__main__":
    unittest.main()
