#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The notebooks of docs/notebooks: every cell runs, and prints what is stored. With Debian's nbclient they run in Jupyter, without it
their cells run one after the other in one interpreter. ILOT_EXE names the program. ILOT_UPDATE_GOLDEN=1 stores what they show."""
import contextlib
import importlib.util
import io
import json
import os
import pathlib
import sys
import tempfile
import unittest

EXE = pathlib.Path(os.environ["ILOT_EXE"]).resolve()
BOOKS = sorted((pathlib.Path(__file__).resolve().parents[2] / "docs/notebooks").glob("*.ipynb"))
JUPYTER = all(importlib.util.find_spec(name) for name in ("nbclient", "nbformat", "ipykernel"))
os.environ["PATH"] = f"{EXE.parent}{os.pathsep}{os.environ['PATH']}"
os.environ["MPLBACKEND"] = "Agg"


def printed(cell):
    """Not what goes to standard error: libraries warn there of what is slow on a busy machine."""
    return "".join("".join(output["text"]) for output in cell.get("outputs", ()) if output.get("name") == "stdout")


def pictures(cell):
    return sum("image/png" in output.get("data", {}) for output in cell.get("outputs", ()))


def run_in_jupyter(path, folder):
    import nbclient
    import nbformat
    os.environ.pop("MPLBACKEND", None)  # the kernel's own, which shows figures
    book = nbformat.read(path, 4)
    first = nbformat.v4.new_code_cell("%config InlineBackend.figure_formats = ['png']\nimport matplotlib; matplotlib.rcParams['savefig.dpi'] = 70")
    book.cells.insert(0, first)
    nbclient.NotebookClient(book, timeout=300, kernel_name="python3", resources={"metadata": {"path": str(folder)}}).execute()
    del book.cells[0]
    for number, cell in enumerate((c for c in book.cells if c.cell_type == "code"), 1):
        cell.execution_count = number
        cell.metadata.pop("execution", None)
    return book


def run_plainly(path, folder):
    """Returns the book with what its cells print; figures are drawn and not kept."""
    book, names = json.loads(path.read_text()), {"__name__": "__main__"}
    with contextlib.chdir(folder):
        for cell in book["cells"]:
            if cell["cell_type"] != "code":
                continue
            told = io.StringIO()
            with contextlib.redirect_stdout(told):
                exec(compile("".join(cell["source"]), path.name, "exec"), names)
            cell["outputs"] = [{"output_type": "stream", "name": "stdout", "text": [told.getvalue()]}]
    return book


class Notebooks(unittest.TestCase):
    def test_every_cell_prints_what_is_stored(self):
        self.assertEqual([path.stem for path in BOOKS], ["facades", "planes", "roofs", "streets"])
        for path in BOOKS:
            with self.subTest(path.stem), tempfile.TemporaryDirectory() as folder:
                stored = json.loads(path.read_text())
                made = run_in_jupyter(path, folder) if JUPYTER else run_plainly(path, folder)
                if os.environ.get("ILOT_UPDATE_GOLDEN"):
                    path.write_text(json.dumps(made, indent=1, ensure_ascii=False) + "\n")
                    continue
                for cell, now in zip(stored["cells"], made["cells"], strict=True):
                    self.assertEqual(printed(cell), printed(now), "".join(cell["source"]))
                    if JUPYTER:
                        self.assertEqual(pictures(cell), pictures(now))
                self.assertEqual(sum(map(pictures, stored["cells"])), 1, "a picture is stored")


if __name__ == "__main__":
    if importlib.util.find_spec("matplotlib") is None:
        print("SKIPPED: the notebooks need python3-matplotlib", file=sys.stderr)
        sys.exit(77)
    if not JUPYTER:
        print("no python3-nbclient and python3-ipykernel: cells run without Jupyter, pictures are not compared", file=sys.stderr)
    unittest.main()
