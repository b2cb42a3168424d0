#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the functions of products with all their keywords as type checkers read them: product_stubs.py products.pyi. The build calls
it with the package that it has just made in PYTHONPATH, so that the keywords are those that the library declares."""
import inspect
import pathlib
import sys

sys.path.pop(0)  # the folder of this script has the sources of the package, without what is compiled
from ilot import products

HEAD = """# SPDX-License-Identifier: Apache-2.0
# Made by python/product_stubs.py from the declared settings.
from typing import Any, Callable, Iterable, Literal

from ._types import Path
from .clouds import Cloud
from .runs import RunResult

PRODUCTS: tuple[str, ...]
"""


def function_of(name):
    signature = inspect.signature(getattr(products, name))
    lines, starred = [], False
    for parameter in signature.parameters.values():
        if parameter.kind is inspect.Parameter.KEYWORD_ONLY and not starred:
            lines.append("*")
            starred = True
        default = "" if parameter.default is inspect.Parameter.empty else " = ..."
        lines.append(f"{parameter.name}: {parameter.annotation}{default}")
    return f"def {name}(\n    " + ",\n    ".join(lines) + f",\n) -> {signature.return_annotation}: ...\n"


def main():
    pathlib.Path(sys.argv[1]).write_text("\n".join([HEAD, *map(function_of, products.PRODUCTS)]), encoding="utf-8")


if __name__ == "__main__":
    main()
