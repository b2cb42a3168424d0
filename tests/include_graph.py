#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reads the includes and checks the allowed dependencies: tools -> engine -> kernels -> the public headers, which
include only each other. It also checks the entry points of the folders."""
import pathlib
import re
import sys

# The layer "ilot" is the folder include/ilot. Its files are named as they are included.
LAYER_SEES = {
    "ilot": {"ilot"},
    "kernels": {"kernels"},
    "engine": {"engine", "kernels"},
    "training": {"training", "engine", "kernels"},
    "scan": {"scan", "engine", "kernels"},
    "python": {"python"},
    "c_api": {"c_api"},
    "tools": {"tools", "scan", "training", "engine", "kernels"},
    "study": {"study", "tests", "tools", "scan", "training", "engine", "kernels"},
    "bench": {"bench", "tests", "tools", "engine", "kernels"},
    "tests": {"tests", "tools", "scan", "training", "engine", "kernels"},
}
# Folders of the engine by height. A folder includes itself and lower ones.
HEIGHT = {"cloud": 0, "settings": 0, "model": 1, "report": 1, "formats": 1, "store": 2, "units": 3, "pass": 3, "tiles": 4,
          "visibility": 4, "columns": 4, "deliverables": 4, "validity": 5, "proof": 5, "products/planes": 6,
          "products/roofs": 7, "products/facades": 7, "products/streets": 7, "labels": 8, "compare": 8, "products": 5, "run": 9, "replay": 10, "scale": 10, "api": 10}
# Folders that may include engine/api. It converts the types of the engine into public ones and is called through
# include/ilot.
SEE_API = {"engine/api", "tools", "tests", "study"}
# Headers of the standard library that the public headers may include: all that have neither a folder nor an extension.
STANDARD = re.compile(r"^[a-z_]+$")
C_STANDARD = {"ilot/ilot.h": {"stddef.h", "stdint.h"}}  # the header for C sees that of C
EVERYWHERE = {"engine/compressed.h", "engine/error.h", "engine/flat_area.h", "engine/geos_context.h", "engine/json_fault.h", "engine/markup.h", "engine/system_reason.h", "engine/version.h", "engine/whole_file.h",
              "engine/whole_file_writer.h", "engine/pass/stop.h"}
PRODUCTS = {"products/roofs", "products/facades", "products/streets"}
PURE = re.compile(r"^engine/products/\w+/\w+/")  # steps of a product: plain data in and out
KERNEL_HEIGHT = {"core": 0, "geometry": 1, "simd": 1, "classifiers": 2, "neighbours": 2, "planes": 3, "shapes": 4,
                 "plane_methods": 5, "delaunay": 3, "outlines": 4, "meshes": 4, "rasters": 4, "morphology": 5}
CLOUD_FORMATS = re.compile(r"\b(las|laz|copc|e57|ply|pcd|ptx|LAS|LAZ|COPC|E57|PLY|PCD|PTX)\b|LASF")
DRAWING_FORMATS = re.compile(r"\b(dxf|DXF|CityJSON|GDAL|gdal\w*|ogr\w*|OGR\w*)\b")
TALKING = re.compile(r"<iostream>|\bstd::(cout|cerr|clog|printf|exit)\b|\b(printf|puts|abort|exit|_exit)\s*\(")
# Functions of the maths library that machines round differently.
LIBM = re.compile(r"\bstd::(hypot|sin|cos|tan|asin|acos|atan2?|sinh|cosh|tanh|exp2?|expm1|log|log2|log10|log1p|pow|cbrt|erfc?|[lt]gamma)\(")
INTRINSICS = re.compile(r"#\s*include\s*<(\w*intrin|arm_neon|arm_sve)\.h>|\b_mm\d*_\w+\(")
TYPE = re.compile(r"^(?:template[^\n]*\n)?(?:struct|class|enum class) (\w+)\b[^;{]*\{", re.M)
NAMESPACE = re.compile(r"^namespace ([\w:]+) \{", re.M)
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)


def strip_comments(text):
    return re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S)


def folder(path):
    """Returns the folder group of a file of a layer. Each product is a group of its own."""
    parts = path.split("/")
    if parts[1] == "products" and len(parts) > 3:
        return "/".join(parts[1:3])
    return parts[1] if len(parts) > 2 else ""


def faults_of(name, text):
    code = strip_comments(text)
    layer, room = name.split("/")[0], folder(name)
    for included in INCLUDE.findall(code):
        top = included.split("/")[0]
        if top in ("tbb", "oneapi") and name != "kernels/core/parallel.cpp":
            yield f"includes {included}: only kernels/core/parallel.cpp may"
        if layer == "ilot" and top != "ilot" and not STANDARD.match(included) and included not in C_STANDARD.get(name, ()):
            yield f"includes {included}: public headers see each other and the standard library alone"
        if top not in LAYER_SEES or top == "ilot":
            continue
        if included.startswith("engine/api/") and layer not in SEE_API and f"{layer}/{room}" not in SEE_API:
            yield f"includes {included}: engine/api is called through include/ilot"
        if layer != "ilot" and top not in LAYER_SEES[layer]:
            yield f"includes {included}: {layer} does not see {top}"
        other = folder(included)
        if layer == top == "kernels" and KERNEL_HEIGHT[other] > KERNEL_HEIGHT[room]:
            yield f"includes {included}: kernels/{other} stands above kernels/{room}"
        if layer == top == "engine" and included not in EVERYWHERE and room:
            if HEIGHT[other] > HEIGHT[room]:
                yield f"includes {included}: engine/{other} stands above engine/{room}"
            if room in PRODUCTS and other in PRODUCTS - {room}:
                yield f"includes {included}: products do not know each other"
            if PURE.match(name) and other in ("formats", "deliverables"):
                yield f"includes {included}: steps of products know no file format"
            if room.startswith("products") and other == "compare":
                yield f"includes {included}: no product judges itself"
    if INTRINSICS.search(code) and not name.startswith("kernels/simd/"):
        yield "uses intrinsics: only kernels/simd may"
    if (layer == "kernels" or name.startswith("engine/products/")) and LIBM.search(code):
        yield f"calls {LIBM.search(code).group(0)}): results would hang on the machine; kernels/core/portable_math.h and geometry/flat.h do not"
    if layer in ("ilot", "kernels", "engine"):
        if TALKING.search(code):
            yield f"prints or exits ({TALKING.search(code).group(0).strip()}): library code never does"
        text_alone = INCLUDE.sub("", code)
        # PLY is a format of models too.
        if room != "formats" and not name.startswith("engine/deliverables/exports/") and CLOUD_FORMATS.search(text_alone):
            yield f"names {CLOUD_FORMATS.search(text_alone).group(0)}: only engine/formats may"
        if room != "deliverables" and DRAWING_FORMATS.search(code):
            yield f"names {DRAWING_FORMATS.search(code).group(0)}: only engine/deliverables may"


def cycle_in(graph):
    state, stack = {}, []

    def visit(node):
        state[node] = "open"
        stack.append(node)
        for after in sorted(graph.get(node, ())):
            if state.get(after) == "open":
                return stack[stack.index(after):] + [after]
            if after not in state:
                found = visit(after)
                if found:
                    return found
        state[node] = "done"
        stack.pop()
        return None

    for start in sorted(graph):
        if start not in state:
            found = visit(start)
            if found:
                return found
    return None


def names_taken_twice(files):
    """Finds types with the same name in two headers. The linker joins their functions, so one of the two would run the
    functions of the other."""
    headers = {}
    for name, text in sorted(files.items()):
        if not name.endswith(".h") or name.split("/")[0] not in ("ilot", "kernels", "engine"):
            continue
        code = strip_comments(text)
        space = NAMESPACE.search(code)
        for type_name in set(TYPE.findall(code)):
            headers.setdefault((space.group(1) if space else "", type_name), []).append(name)
    for (_, type_name), where in sorted(headers.items()):
        if len(where) > 1:
            yield f"{where[1]}: defines {type_name}, as {where[0]} does"


def check(files):
    """files: name -> text. Returns the list of faults, one line each."""
    faults = []
    for name, text in sorted(files.items()):
        faults += [f"{name}: {fault}" for fault in faults_of(name, text)]
    folders = {name.split("/")[0] for name in files}
    for name, text in sorted(files.items()):
        for included in INCLUDE.findall(strip_comments(text)):
            if included.split("/")[0] in folders and "/" in included and included not in files:
                faults.append(f"{name}: includes {included}, which does not exist")
    graph = {name: {i for i in INCLUDE.findall(strip_comments(text)) if i in files} for name, text in files.items()}
    cycle = cycle_in(graph)
    if cycle:
        faults.append("cycle: " + " -> ".join(cycle))
    return faults + list(names_taken_twice(files))


def self_test():
    """Tests that the checker finds known faults."""
    bad = {
        "kernels/core/a.h": '#include "engine/error.h"\n',
        "kernels/core/b.h": '#include "kernels/planes/c.h"\n',
        "kernels/planes/c.h": "#include <tbb/parallel_for.h>\n",
        "kernels/planes/d.h": "#include <immintrin.h>\n",
        "engine/store/e.cpp": 'auto x = "laz";\n',
        "engine/store/f.cpp": '#include "engine/run/run.h"\n',
        "engine/products/roofs/g.cpp": '#include "engine/products/facades/x.h"\n',
        "engine/products/roofs/sites/o.cpp": '#include "engine/formats/reader.h"\n',
        "engine/run/h.cpp": "#include <iostream>\n",
        "engine/run/i.h": '#include "engine/run/j.h"\n',
        "engine/run/j.h": '#include "engine/run/i.h"\n',
        "engine/run/k.cpp": "#include <gdal.h>\n",
        "engine/cloud/l.cpp": '#include "tools/ilot/console.h"\n',
        "engine/model/m.h": "namespace ilot {\nstruct Twice {\n};\n}\n",
        "engine/store/p.h": '#include "engine/store/gone.h"\n',
        "engine/store/n.h": "namespace ilot {\nclass Twice final {\n};\n}\n",
        "ilot/p.h": '#include "kernels/core/types.h"\n',
        "ilot/q.h": "#include <gdal/gdal.h>\n",
        "ilot/r.h": "namespace ilot {\nstruct Public {\n};\n}\n",
        "kernels/core/s.h": "namespace ilot {\nstruct Public {\n};\n}\n",
        "engine/run/t.cpp": '#include "engine/api/u.h"\n',
        "scan/v.cpp": '#include "engine/api/u.h"\n',
        "c_api/w.cpp": '#include "engine/error.h"\n',
        "ilot/x.h": "#include <stdint.h>\n",
    }
    faults = "\n".join(check(bad))
    for name in bad:
        if name not in faults:
            sys.exit(f"include_graph: the checker misses the fault in {name}")
    good = {
        "ilot/a.h": '#include <span>\n#include "ilot/b.h"\n',
        "ilot/b.h": "",
        "engine/api/c.cpp": '#include "engine/api/d.h"\n',
        "engine/api/d.h": "",
        "engine/formats/las.cpp": '// tbb\n#include "engine/cloud/record.h"\n',
        "engine/cloud/record.h": "// LAS\n",
    }
    if check(good):
        sys.exit("include_graph: the checker complains of good code: " + "; ".join(check(good)))


def main():
    self_test()
    root = pathlib.Path(sys.argv[1])
    files = {}
    for layer in LAYER_SEES:
        top = root / "include" if layer == "ilot" else root
        for path in (top / layer).rglob("*"):
            if path.suffix in (".h", ".cpp", ".inl"):
                files[path.relative_to(top).as_posix()] = path.read_text(encoding="utf-8")
    faults = check(files)
    for fault in faults:
        print(fault)
    print(f"{len(files)} files read, {len(faults)} faults")
    sys.exit(1 if faults or not files else 0)


if __name__ == "__main__":
    main()
