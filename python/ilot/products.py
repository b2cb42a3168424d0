# SPDX-License-Identifier: Apache-2.0
"""The products as functions. Their keywords are those of run() and the settings of the product's section, made from the declared ones;
the build writes them down for type checkers and editors in products.pyi."""
from __future__ import annotations

import difflib
import inspect
from typing import Any, Callable, Iterable

from ._types import Path, Setting
from .clouds import Cloud
from .runs import RunResult, parameters, run

PRODUCTS = ("planes", "roofs", "facades", "streets")
_RUN_WORDS = [word for word in inspect.signature(run).parameters if word != "products"]
_KINDS = {"boolean": "bool", "integer": "int", "number": "float", "integers": "Iterable[int]", "numbers": "Iterable[float]"}


def _annotation(setting: Setting) -> str:
    """The type of a setting; every keyword may be None, which is auto, or not given."""
    if setting["kind"] == "choice":
        return "Literal[" + ", ".join(f'"{word}"' for word in setting["choices"]) + "] | None"
    return _KINDS[setting["kind"]] + " | None"


def _arguments(name: str, keywords: dict[str, str], arguments: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """The settings among the keyword arguments of a product, and the arguments of run()."""
    settings = dict(arguments.pop("settings", None) or {})
    for word, key in keywords.items():
        if word in arguments:
            settings[key] = arguments.pop(word)
    for word in arguments:
        if word not in _RUN_WORDS:
            near = difflib.get_close_matches(word, [*keywords, *_RUN_WORDS], 1)
            raise TypeError(f"{name}() has no keyword {word}" + (f"; did you mean {near[0]}?" if near else ""))
    return settings, arguments


def _product(name: str) -> Callable[..., RunResult]:
    """Returns the function of one product."""
    own = [p for p in parameters() if p["key"].startswith(name + ".")]
    keywords = {p["key"].removeprefix(name + ".").replace(".", "_"): p["key"] for p in own}

    def make(inputs: Path | Cloud | Iterable[Path | Cloud], output: Path, **arguments: Any) -> RunResult:
        settings, rest = _arguments(name, keywords, arguments)
        return run(inputs, output, products=[name], settings=settings, **rest)

    lines = [f"    {word}: {p['help']} ({', '.join(t for t in (p['range'], p['unit']) if t)}) [{p['default']}]"
             for word, p in zip(keywords, own) if not p["advanced"]]
    make.__name__ = make.__qualname__ = name
    make.__doc__ = f"Makes {name} of the clouds: run() with these settings as keywords.\n\n" + "\n".join(lines)
    of_run = [p for word, p in inspect.signature(run).parameters.items() if word in _RUN_WORDS]
    more = [inspect.Parameter(word, inspect.Parameter.KEYWORD_ONLY, default=None, annotation=_annotation(p))
            for word, p in zip(keywords, own)]
    make.__signature__ = inspect.Signature(of_run + more, return_annotation="RunResult")  # type: ignore[attr-defined]
    return make


planes, roofs, facades, streets = (_product(name) for name in PRODUCTS)
