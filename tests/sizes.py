#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that no function has more than 60 lines, from its first line to its last brace, and no source file more than
400. Functions are found by their braces, so this needs no compiler."""
import ast
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
MOST_LINES_OF_FUNCTION, MOST_LINES_OF_FILE = 60, 400
TOPS = ("kernels", "engine", "training", "scan", "tools", "study", "bench", "tests", "include", "examples", "python", "c_api", "qgis")
SHORT_FUNCTIONS = ("kernels", "engine", "training", "scan", "tools", "python", "c_api", "qgis")  # benches, studies and tests may have longer mains
CODE = (".h", ".cpp", ".inl", ".in", ".py", ".sh", ".cmake")
# What must not be read as code: comments, raw strings, strings, characters, lines of the preprocessor.
NO_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|^[ \t]*#(?:\\\n|[^\n])*',
                     re.S | re.M)
CPP = re.compile(r"\.(h|cpp|inl)(\.in)?$")
SCOPE = re.compile(r"\b(namespace|struct|class|union)\b(?!.*\()|\bextern\b\s*$", re.S)
LISTS = "other", "function"  # braces that may be a member's initial value in front of a constructor's body


def blanked(text):
    """Returns the text with everything that is no code replaced by spaces; lines stay where they are."""
    return NO_CODE.sub(lambda found: re.sub(r"[^\n]", " ", found.group(0)), text)


def functions(text):
    """Yields (first line, number of lines, first line's text) of each function of C++ code that is in no other one."""
    code = blanked(text)
    open_braces, begin = [], 0  # kind and place of each open brace; where the statement begins that is read now
    for place in (found.start() for found in re.finditer(r"[{};]", code)):
        if code[place] == "{":
            head = code[begin:place]
            kind = "function" if "(" in head else "other"
            if head.count("(") > head.count(")"):
                kind = "argument"
            if SCOPE.search(head):
                kind = "scope"
            open_braces.append((kind, begin))
        elif code[place] == "}" and open_braces:
            kind, start = open_braces.pop()
            if any(other != "scope" for other, _ in open_braces):
                continue
            after = code[place + 1:place + 200].lstrip()
            if kind == "argument" or kind in LISTS and after[:1] in (",", "{"):
                begin = start
                continue
            if kind == "function":
                start += len(code[start:]) - len(code[start:].lstrip())
                yield code.count("\n", 0, start) + 1, code.count("\n", start, place) + 1, text[start:].split("\n")[0]
        if all(kind == "scope" for kind, _ in open_braces):
            begin = place + 1


def python_functions(text):
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield node.lineno, node.end_lineno - node.lineno + 1, f"def {node.name}"


def faults(files):
    """files: name -> text. Yields one line for each fault."""
    for name, text in sorted(files.items()):
        lines = text.count("\n") + (not text.endswith("\n") and text != "")
        if lines > MOST_LINES_OF_FILE:
            yield f"{name}: has {lines} lines, at most {MOST_LINES_OF_FILE} are allowed"
        if name.split("/")[0] not in SHORT_FUNCTIONS:
            continue
        found = python_functions(text) if is_python(name, text) else functions(text) if CPP.search(name) else ()
        for line, count, head in found:
            if count > MOST_LINES_OF_FUNCTION:
                yield f"{name}:{line}: {head.strip()} ... has {count} lines, at most {MOST_LINES_OF_FUNCTION} are allowed"


def is_python(name, text):
    return name.endswith(".py") or text.startswith("#!/usr/bin/env python3")


def self_test():
    body = "  a();\n" * 59
    long_ones = [f"void f() {{\n{body}}}\n", f"struct S {{\n  S() : a{{1}}, b{{2}} {{\n{body}}}\n}};\n",
                 f"namespace a {{\nauto t = {{1}};\nint g(int b = {{}}) noexcept {{ // }}\n{body}}}\n}}\n",
                 f"const char* h() {{\nreturn R\"x(\n}}\n)x\";\n{body}}}\n", "x\n" * 401]
    for text in long_ones:
        if len(list(faults({"engine/a.cpp": text}))) != 1:
            sys.exit(f"sizes: the checker misses the fault in\n{text[:60]}")
    good = f"void f() {{\n{body[8:]}}}\nvoid g() {{\n  if (a) {{\n{body[:160]}  }}\n}}\nint table[] = {{\n{'1,' * 9}\n}};\n"
    if list(faults({"engine/a.cpp": good, "tests/b.cpp": long_ones[0], "scan/c.py": "def f():\n    return 1\n"})):
        sys.exit("sizes: the checker complains of good code")


def main():
    self_test()
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True)
    names = listed.stdout.split() if listed.returncode == 0 else [
        path.relative_to(ROOT).as_posix() for top in TOPS for path in (ROOT / top).rglob("*") if path.is_file()]
    files = {}
    for name in names:
        path = ROOT / name
        if name.split("/")[0] in TOPS and path.is_file() and (path.suffix in CODE or path.suffix == ""):
            files[name] = path.read_text(encoding="utf-8")
    wrong = list(faults(files))
    print("\n".join(wrong))
    print(f"{len(files)} files read, {len(wrong)} faults")
    return 1 if wrong or not files else 0


if __name__ == "__main__":
    sys.exit(main())
