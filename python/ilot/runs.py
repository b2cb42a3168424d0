# SPDX-License-Identifier: Apache-2.0
"""Whole runs: the same as the command `ilot run`. Each product is a function whose keywords are its settings."""
from __future__ import annotations

import dataclasses
import difflib
import inspect
import math
import operator
import os
from typing import Any, Callable, Iterable

from . import _ilot
from ._types import Path, usage_fault
from .clouds import Cloud

_PRODUCTS = ("planes", "roofs", "facades", "streets")


@dataclasses.dataclass(frozen=True)
class RunResult:
    """What a run did, as run.json says it. exit: 0, or 3 where something was skipped."""
    exit: int
    folder: os.PathLike[str]
    products: list[str]
    points_read: int
    points_labelled: int
    points_unlabelled: int
    points_rejected: dict[str, int]  # reason -> points
    skipped: list[tuple[str, str, str]]  # (what, where, reason)
    warnings: list[str]
    chosen: dict[str, str]  # setting that was auto -> the value that was used
    files: list[os.PathLike[str]]  # of the result, relative to the folder
    clouds: list[os.PathLike[str]]  # labelled clouds, relative to the folder
    seconds: float
    peak_memory_bytes: int
    result_hash: str


def _setting_text(value: Any) -> str:
    """The value as TOML has it; None is auto. Values of NumPy count as those of Python."""
    if value is None:
        return "auto"
    if hasattr(value, "tolist"):
        listed = value.tolist()
        if not isinstance(listed, (bool, list)):
            return str(value)  # in the digits of its own precision
        value = listed
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_setting_text(v) for v in value) + "]"
    return str(value)


def _memory(memory: int | str) -> int | str:
    if isinstance(memory, str):
        return memory
    number = operator.index(memory)
    if not 0 <= number < 2**64:
        raise usage_fault(f"memory={number}: a number of bytes is expected, or text as \"512M\" or \"2G\"")
    return number


def _bounds(bounds: Iterable[float] | None) -> tuple[float, ...] | None:
    if bounds is None:
        return None
    corners = tuple(float(v) for v in bounds)
    if len(corners) != 4 or not all(math.isfinite(v) for v in corners):
        raise usage_fault(f"bounds={corners}: four finite numbers are expected, x0, y0, x1, y1")
    return corners


def _function(name: str, function: Any) -> Any:
    if function is not None and not callable(function):
        raise TypeError(f"{name}: a function is expected, not {type(function).__name__}")
    return function


def run(inputs: Path | Cloud | Iterable[Path | Cloud], output: Path, *, products: str | Iterable[str] = ("planes",),
        settings: dict[str, Any] | None = None, memory: int | str = "2G", threads: int = 0, footprints: Path = "",
        id_field: str = "", stations: Path = "", train: Path = "", edits: Path | Iterable[Path] = (),
        bounds: tuple[float, float, float, float] | None = None, crs: str = "", to_crs: str = "",
        existing: str = "refuse", strict: bool = False, keep_store: bool = False,
        clouds: bool = True, report: bool = True, store: Path = "",
        progress: Callable[[str, int, int, float], Any] | None = None,
        message: Callable[[str], Any] | None = None) -> RunResult:
    """Makes the products of the clouds in the folder `output`, which appears when it is whole. Returns a RunResult.

    inputs: a path or several (files, folders, patterns), or Clouds in memory. settings: {"planes.epsilon": 0.02}; parameters() lists them, None is
    auto. memory: bytes or "512M". bounds: (x0, y0, x1, y1) in CRS units. edits: tables of corrections by hand.
    existing: refuse, resume or overwrite. progress(stage, done, total,
    seconds) and message(line) are called while it works; what they raise stops the run and is raised again. Ctrl-C raises
    KeyboardInterrupt, and existing="resume" continues."""
    given = [inputs] if isinstance(inputs, (str, os.PathLike, Cloud)) else list(inputs)
    if isinstance(products, str):
        products = [products]
    if isinstance(edits, (str, os.PathLike)):
        edits = [edits]
    return RunResult(**_ilot.run([one for one in given if not isinstance(one, Cloud)], output, list(products),
                                 {key: _setting_text(v) for key, v in (settings or {}).items()}, arrays=[one for one in given if isinstance(one, Cloud)], memory=_memory(memory),
                                 threads=operator.index(threads), footprints=footprints, id_field=id_field,
                                 stations=stations, train=train, edits=list(edits), bounds=_bounds(bounds),
                                 crs=crs, to_crs=to_crs, existing=existing, strict=strict, keep_store=keep_store, clouds=clouds,
                                 report=report, store=store, progress=_function("progress", progress),
                                 message=_function("message", message)))


def read_run(folder: Path) -> RunResult:
    """Returns the RunResult of a finished run."""
    return RunResult(**_ilot.read_run(folder))


def parameters() -> list[dict[str, Any]]:
    """Returns all settings: a list of dicts of key, default, range, unit, help, advanced."""
    return _ilot.parameters()


_RUN_WORDS = [word for word in inspect.signature(run).parameters if word != "products"]


def _product(name: str) -> Callable[..., RunResult]:
    """Returns the function of one product. Its keywords are those of run() and the settings of the product's section."""
    prefix = name + "."
    own = [p for p in parameters() if p["key"].startswith(prefix)]
    keywords = {p["key"].removeprefix(prefix).replace(".", "_"): p["key"] for p in own}

    def make(inputs: Path | Cloud | Iterable[Path | Cloud], output: Path, **arguments: Any) -> RunResult:
        settings = dict(arguments.pop("settings", None) or {})
        for word, key in keywords.items():
            if word in arguments:
                settings[key] = arguments.pop(word)
        for word in arguments:
            if word not in _RUN_WORDS:
                near = difflib.get_close_matches(word, [*keywords, *_RUN_WORDS], 1)
                raise TypeError(f"{name}() has no keyword {word}" + (f"; did you mean {near[0]}?" if near else ""))
        return run(inputs, output, products=[name], settings=settings, **arguments)

    lines = [f"    {word}: {p['help']} ({', '.join(t for t in (p['range'], p['unit']) if t)}) [{p['default']}]"
             for word, p in zip(keywords, own) if not p["advanced"]]
    make.__name__ = make.__qualname__ = name
    make.__doc__ = f"Makes {name} of the clouds: run() with these settings as keywords.\n\n" + "\n".join(lines)
    of_run = [p for word, p in inspect.signature(run).parameters.items() if word in _RUN_WORDS]
    more = [inspect.Parameter(word, inspect.Parameter.KEYWORD_ONLY, default=None) for word in keywords]
    make.__signature__ = inspect.Signature(of_run + more, return_annotation=RunResult)  # type: ignore[attr-defined]
    return make


planes, roofs, facades, streets = (_product(name) for name in _PRODUCTS)
