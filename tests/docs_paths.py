#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the pages are right about the source tree. Every link and every path of a file or folder in a page must
exist. Every folder with source files must have a README, whatever its depth, and must not have too many files."""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
TOPS = ("kernels", "engine", "training", "scan", "tools", "study", "bench", "tests", "docs", "include", "examples", "python", "c_api", "qgis")
LINK = re.compile(r"\]\(([^)#:\s]+)(?:#[^)]*)?\)")
CODE = re.compile(r"`([\w./-]+)`")
HAS_CODE = re.compile(r"\.(h|cpp|inl|in|py|sh|cmake)$")
MOST_FILES = 40
SOURCE = re.compile(r"^[\w/-]+\.(h|cpp|inl|py|sh|md)$")


def files():
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True)
    if listed.returncode == 0:
        return listed.stdout.split()
    return [path.relative_to(ROOT).as_posix() for top in TOPS for path in (ROOT / top).rglob("*") if path.is_file()]


def faults(pages, names):
    """pages: name -> text. names: names of all files. Returns one line for each fault."""
    folders = {parent.as_posix() for name in names for parent in pathlib.PurePosixPath(name).parents}
    known = set(names) | folders
    endings = {"/".join(parts[i:]) for name in names for parts in [name.split("/")] for i in range(len(parts))}
    for page, text in sorted(pages.items()):
        base = pathlib.PurePosixPath(page).parent
        for target in LINK.findall(text):
            path = pathlib.PurePosixPath(*normal(base / target))
            if path.as_posix() not in known and path.as_posix() != ".":
                yield f"{page}: links to {target}, which does not exist"
        for word in CODE.findall(text):
            word = word.rstrip("/")
            if re.search(r"[A-Z]{4}", word) or word.startswith("bench/results") or word == "results.md":
                continue  # a pattern of names, or the output of a program
            if word.split("/")[0] in TOPS and "/" in word and word not in known and word + ".h" not in known:
                yield f"{page}: names {word}, which does not exist"
            elif SOURCE.match(word) and word not in endings:
                yield f"{page}: names {word}, and no file is called that"


def normal(path):
    parts = []
    for part in path.parts:
        if part == ".." and parts:
            parts.pop()
        elif part != ".":
            parts.append(part)
    return parts


def sources_of_folders(names):
    """Returns the number of files of each folder that has source files, and the names of these folders alone."""
    counts, with_sources = {}, set()
    for name in names:
        folder = name.rsplit("/", 1)[0] if "/" in name else ""
        if folder.split("/")[0] in TOPS and folder != "docs":
            counts[folder] = counts.get(folder, 0) + 1
            if HAS_CODE.search(name):
                with_sources.add(folder)
    return {folder: counts[folder] for folder in sorted(with_sources)}


def faults_of_folders(names):
    """Every folder with sources has a README and at most MOST_FILES files. The folders of tests/ that mirror a folder of the
    sources need no README: what is in the mirrored folder is said there, and how it is tested in tests/README.md."""
    sources = sources_of_folders(names)
    folders = {parent.as_posix() for name in names for parent in pathlib.PurePosixPath(name).parents}
    for folder, count in sources.items():
        mirrored = folder.removeprefix("tests/") if folder.startswith("tests/") else None
        covered = mirrored in folders
        if not covered and f"{folder}/README.md" not in names:
            yield f"{folder}: has no README.md"
        if count > MOST_FILES:
            yield f"{folder}: has {count} files, at most {MOST_FILES} are allowed"


def self_test():
    bad = {"docs/a.md": "[x](b.md) `engine/none.h` `gone.h`"}
    found = list(faults(bad, ["docs/a.md", "engine/run/run.h"]))
    if len(found) != 3:
        sys.exit(f"docs_paths: the checker finds {found} where three paths are wrong")
    if list(faults({"docs/a.md": "[x](../engine/run/run.h) `run.h` `engine/run`"}, ["docs/a.md", "engine/run/run.h"])):
        sys.exit("docs_paths: the checker complains of good pages")
    crowded = [f"kernels/core/{i}.h" for i in range(MOST_FILES + 1)]
    found = list(faults_of_folders(["scan/a/b/c.cpp", "tests/engine/run/run_test.cpp", "engine/run/run.h", "tests/run/d.py",
                                    "engine/run/README.md", "kernels/core/README.md", *crowded]))
    if [fault.split(":")[0] for fault in found] != ["kernels/core", "scan/a/b", "tests/run"]:
        sys.exit(f"docs_paths: the checker finds {found} of three wrong folders")


def main():
    self_test()
    names = files()
    pages = {name: (ROOT / name).read_text(encoding="utf-8") for name in names if name.endswith(".md")}
    wrong = [*faults(pages, names), *faults_of_folders(names)]
    print("\n".join(wrong))
    print(f"{len(pages)} pages read, {len(wrong)} faults")
    return 1 if wrong or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
