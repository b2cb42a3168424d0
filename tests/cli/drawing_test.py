#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What other programs say to our drawings: ezdxf's audit and what it reads back, GDAL. ILOT_EXE names the program; a
Python that has ezdxf is looked for. Skips (77) without ezdxf, and says so."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

EXE = os.environ["ILOT_EXE"]
HOSTILE = ["F\u00e9n\u00eatre n\u00b0 1 \u2014 \u00e9tage", "100%%d %%%% %", "a^Ib^J", "\\U+0041 \\P {x}", "line\n  0\nEOF\n", "\U0001F3E0",
           "<svg onload=x> & \"quoted\"", "=SUM(A1)", " ", ""]

# Runs where ezdxf is installed: audits the drawing, then prints its contents.
AUDIT = """
import json, sys, ezdxf
from ezdxf.lldxf.encoding import decode_dxf_unicode
from ezdxf import recover
told = []
for path in sys.argv[1:]:
    read = ezdxf.readfile(path)
    audit = read.audit()
    again, recovered = recover.readfile(path)
    told.append({"errors": len(audit.errors) + len(recovered.errors), "fixes": len(audit.fixes) + len(recovered.fixes),
                 "units": read.header["$INSUNITS"], "layers": [l.dxf.name for l in read.layers],
                 "frozen": [l.dxf.name for l in read.layers if l.is_frozen()],
                 "texts": [decode_dxf_unicode(t.plain_text()) for t in read.modelspace().query("TEXT")],
                 "closed": [[list(p) for p in e.get_points("xyb")] for i in read.modelspace().query("INSERT")
                            for e in i.virtual_entities() if e.dxftype() == "LWPOLYLINE" and e.closed
                            and e.dxf.layer == "FAC-OPENING"],
                 "schedule": [{a.dxf.tag: a.dxf.text for a in i.attribs} for i in read.modelspace().query("INSERT")],
                 "dimensions": [[d.get_measurement(), len(read.blocks.get(d.dxf.geometry)), d.dxf.dimstyle]
                                for d in read.modelspace().query("DIMENSION")],
                 "images": [[i.image_def.dxf.filename, i.dxf.u_pixel.x * i.dxf.image_size.x]
                            for i in read.modelspace().query("IMAGE")],
                 "views": [[v.dxf.height, v.dxf.view_height, read.layout("Sheet").dxf.paper_width, v.dxf.width]
                           for v in read.layout("Sheet").query("VIEWPORT") if v.dxf.id > 1],
                 "overridden": len([e for e in read.modelspace() if e.dxf.hasattr("color") and e.dxf.layer != "FAC-TITLE"])})
print(json.dumps(told))
"""


def python_with_ezdxf():
    for candidate in (sys.executable, "/usr/bin/python3", shutil.which("python3")):
        if candidate and subprocess.run([candidate, "-c", "import ezdxf"], capture_output=True).returncode == 0:
            return candidate
    return None


def element(number, kind, x, z, width, height, **more):
    ring = [[651000 + x, 6861000, z], [651000 + x + width, 6861000, z], [651000 + x + width, 6861000, z + height],
            [651000 + x, 6861000, z + height]]
    edge = {"status": "seen", "points": 9, "rms_m": 0.002, "error_m": 0.004, "moved_m": 0}
    return {"id": number, "kind": kind, "opening": kind == "window", "family": 1, "row": 1, "column": 1, "status": "seen",
            "reason": "", "ring": ring, "edges": [dict(edge) for _ in ring], "arcs": [], "width_m": width,
            "height_m": height, "depth_m": -0.2, "width_error_m": 0.004, "height_error_m": 0.004,
            "depth_error_m": 0.002, "points": 100} | more


def facade():
    elements = [element(1, "window", 1, 1, 1.2, 2), element(2, "window", 4, 1, 1.2, 2, status="completed"),
                element(3, "window", 7, 1, 1.2, 2, status="occluded")]
    # A half circle over the first one, given by its ends alone.
    elements[0]["arcs"] = [{"centre": [651001.6, 6861000, 3], "radius_m": 0.6, "from_deg": 0, "to_deg": 180}]
    elements += [element(4 + i, kind or "x", 0.5 * i, 5, 0.4, 0.4, reason=kind, depth_m=0.05) for i, kind in enumerate(HOSTILE)]
    elements[4]["edges"][1]["status"] = "occluded"
    return {"type": "ilot facade", "version": 1, "facade": 1, "crs": "EPSG:2154",
            "frame": {"origin": [651000, 6861000, 0], "right": [1, 0, 0], "up": [0, 0, 1], "out": [0, -1, 0]},
            "width_m": 9, "height_m": 6, "elements": elements}


def run(*args):
    return subprocess.run([EXE, *map(str, args)], capture_output=True, text=True)


def expect(condition, what):
    if not condition:
        sys.exit(f"drawing_test: {what}")


def draw(folder):
    (folder / "in.json").write_text(json.dumps(facade()))
    drawings = []
    for number, title in enumerate(HOSTILE):
        out = folder / str(number)
        done = run("draw", folder / "in.json", "-o", out, "--title", title or "x", "--source", title or "x", "--section", "2",
                   "--scale", 20 + 30 * number)
        expect(done.returncode == 0, f"draw of {title!r}: {done.stderr}")
        drawings += [out / "facade-001.dxf", out / "facade-001-section-level-2.00.dxf"]
    judged = run("validate", *drawings, *folder.glob("*/*.obj"))
    expect(judged.returncode == 0, "our own validate: " + judged.stdout)
    return drawings


def check_audits(python, drawings):
    completed = subprocess.run([python, "-c", AUDIT, *map(str, drawings)], capture_output=True, text=True)
    expect(completed.returncode == 0, "ezdxf: " + completed.stderr)
    for path, read in zip(drawings, json.loads(completed.stdout)):
        expect(read["errors"] == 0 and read["fixes"] == 0, f"{path}: ezdxf has {read['errors']} errors, {read['fixes']} fixes")
        expect(read["units"] == 6, f"{path}: units {read['units']}")
        expect(sorted(read["frozen"]) == ["FAC-ERROR", "FAC-IRREGULAR"], f"{path}: frozen {read['frozen']}")
        expect(read["overridden"] == 0, f"{path}: {read['overridden']} entities do not take the colour of their layer")
    first = json.loads(completed.stdout)[0]
    check_structure(first)
    expect(HOSTILE[0] in first["texts"], f"the title came back as {first['texts'][-15:]}")
    expect(len(first["closed"]) == 1, f"{len(first['closed'])} closed openings are drawn; only one is seen whole")
    expect(abs(first["closed"][0][2][2] - 1) < 1e-3, "the arch is no half circle")
    expect(any("1.20 x 2.00" in text for text in first["texts"]), "no size of a window")
    sequences = json.loads(completed.stdout)[4]["texts"]
    expect("a^Ib^J" in sequences, f"a caret came back as {[t for t in sequences if t.startswith('a')]}")


def check_structure(read):
    """Dimensions, schedule and sheet of the first drawing, at 1 : 20, as ezdxf understands them."""
    for measured, pieces, style in read["dimensions"]:
        expect(measured > 0 and pieces == 6 and style == "ILOT", f"a dimension of {measured} with {pieces} pieces in {style}")
    expect(any(abs(measured - 1.2) < 1e-4 for measured, _, _ in read["dimensions"]), "no dimension measures a window")
    expect(len(read["schedule"]) == 2, f"{len(read['schedule'])} openings in the schedule, one of three was not seen")
    window = read["schedule"][0]
    expect(window["ID"] == "1" and window["WIDTH"] == "1.200" and window["ERROR"] == "4.0", f"the schedule has {window}")
    expect(len(read["views"]) == 1, f"{len(read['views'])} viewports")
    height, view_height, paper_width, width = read["views"][0]
    expect(abs(view_height * 1000 / height - 20) < 1e-3, f"the viewport has a scale of 1 : {view_height * 1000 / height}")
    expect(abs(paper_width - width) < 0.1, f"the viewport is {width} mm wide on paper of {paper_width}")


def check_image(python, folder):
    """The orthoimage is under the drawing, by its name alone, as large as the .pgw says."""
    cloud = folder / "wall.txt"
    cloud.write_text("".join(f"{651000 + 0.05 * i} 6861000 {0.05 * k} {i % 256} {k} 9\n" for i in range(180) for k in range(100)))
    done = run("draw", folder / "in.json", "-o", folder / "under", "--cloud", cloud)
    expect(done.returncode == 0, f"draw with a cloud: {done.stderr}")
    completed = subprocess.run([python, "-c", AUDIT, folder / "under/facade-001.dxf"], capture_output=True, text=True)
    expect(completed.returncode == 0, "ezdxf: " + completed.stderr)
    read = json.loads(completed.stdout)[0]
    expect(read["errors"] == 0 and read["fixes"] == 0, f"with an image ezdxf has {read['errors']} errors")
    expect([name for name, _ in read["images"]] == ["facade-001.png"], f"images {read['images']}")
    expect(abs(read["images"][0][1] - 8.7) < 0.2, f"the image is {read['images'][0][1]} m wide")


def check_gdal(drawing):
    if not shutil.which("ogrinfo"):
        print("drawing_test: no ogrinfo, GDAL's reading is not checked")
        return
    completed = subprocess.run(["ogrinfo", "-al", "-so", drawing], capture_output=True, text=True)
    expect(completed.returncode == 0 and "Feature Count" in completed.stdout, "ogrinfo: " + completed.stderr)


def check_pdf(drawing):
    if not shutil.which("pdftotext"):
        print("drawing_test: no pdftotext, another program's reading of the PDF is not checked")
        return
    completed = subprocess.run(["pdftotext", drawing.with_suffix(".pdf"), "-"], capture_output=True, text=True)
    expect(completed.returncode == 0 and not completed.stderr, "pdftotext: " + completed.stderr)
    expect(HOSTILE[0] in completed.stdout and "1.20 x 2.00" in completed.stdout, "the PDF's texts: " + completed.stdout)


def check_control(drawing, folder):
    text = drawing.read_text()
    moved = folder / "corrected.dxf"
    moved.write_text(text.replace("1.20000\n", "1.21000\n", 1) if "1.20000\n" in text else text)
    judged = run("evaluate", "--drawing", drawing, "--corrected", drawing, "--json")
    expect(judged.returncode == 0, "evaluate: " + judged.stderr)
    everything = json.loads(judged.stdout)["drawing"][-1]
    expect(everything["paired"] == everything["corrected"] > 0 and everything["moved"] == 0, f"the same drawing: {everything}")
    expect(run("evaluate", "--drawing", drawing).returncode == 2, "--drawing alone is a usage fault")


def check_usage(folder):
    expect(run("draw", folder / "in.json").returncode == 2, "draw without a folder")
    expect(run("draw", "-o", folder / "x").returncode == 2, "draw without a facade")
    expect(run("draw", folder / "in.json", folder / "in.json", "-o", folder / "x").returncode == 2, "one facade twice")
    unknown = run("draw", folder / "in.json", "-o", folder / "x", "--layers", "office")
    expect(unknown.returncode == 2 and "iso13567" in unknown.stderr, "unknown layers: " + unknown.stderr)
    expect(run("draw", folder / "none.json", "-o", folder / "x").returncode == 1, "a missing facade")
    (folder / "bad.dxf").write_text("hello\n")
    expect(run("validate", folder / "bad.dxf").returncode == 1, "a broken drawing is not valid")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        drawings = draw(folder)
        check_control(drawings[0], folder)
        check_usage(folder)
        check_gdal(drawings[0])
        check_pdf(drawings[0])
        python = python_with_ezdxf()
        if not python:
            print("drawing_test: SKIPPED: no Python with ezdxf (apt install python3-ezdxf); the audit was not made")
            sys.exit(77)
        check_audits(python, drawings)
        check_image(python, folder)
        print(f"{len(drawings)} drawings audited")


if __name__ == "__main__":
    main()
