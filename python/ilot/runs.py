# SPDX-License-Identifier: Apache-2.0
"""Whole runs: the same as the command `ilot run`."""
from __future__ import annotations

import dataclasses
import math
import operator
import os
from typing import Any, Callable, Iterable

from . import _ilot
from ._types import Path, Setting, usage_fault
from .clouds import Cloud


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


def _bounds(bounds: Iterable[float] | None) -> tuple[float, float, float, float] | None:
    if bounds is None:
        return None
    corners = tuple(float(v) for v in bounds)
    if len(corners) != 4 or not all(math.isfinite(v) for v in corners):
        raise usage_fault(f"bounds={corners}: four finite numbers are expected, x0, y0, x1, y1")
    return corners[0], corners[1], corners[2], corners[3]


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


def parameters() -> list[Setting]:
    """Returns all settings: a list of dicts of key, kind, optional, choices, default, range, unit, help, advanced."""
    return _ilot.parameters()
