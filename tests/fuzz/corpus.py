#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""corpus.py OUT: small seeds for every fuzz target, OUT/TARGET/*. ILOT_EXE names the program that scans and converts;
with ILOT_DATA, its small conformance files serve as well. Same program, same seeds."""
import os
import pathlib
import struct
import subprocess
import sys
import tempfile

EXE = os.environ["ILOT_EXE"]
DATA = os.environ.get("ILOT_DATA")
LARGEST = 32768  # bytes; larger seeds only slow the fuzzer down
TARGET_OF = {".las": "las_file_fuzz", ".laz": "laz_file_fuzz", ".ply": "ply_fuzz", ".pcd": "pcd_fuzz",
             ".ptx": "ptx_fuzz", ".e57": "e57_fuzz", ".xyz": "text_fuzz", ".csv": "text_fuzz", ".pts": "text_fuzz",
             ".txt": "text_fuzz"}
CHOICE = {".csv": b"\1", ".pts": b"\2"}  # first byte of text seeds: the extension, else .xyz

PCD = """# .PCD v0.7
VERSION 0.7
FIELDS x y z intensity rgb
SIZE 4 4 4 4 4
TYPE F F F F U
COUNT 1 1 1 1 1
WIDTH 3
HEIGHT 1
VIEWPOINT 0 0 0 1 0 0 0
POINTS 3
DATA """
PTX = """2
3
1 2 3
1 0 0
0 1 0
0 0 1
1 0 0 0
0 1 0 0
0 0 1 0
1 2 3 1
""" + "".join(f"{i} {i * 0.5} {i - 2} 0.{i} {i} 20 30\n" for i in range(6))
PTS = "3\n1 2 3 -100 10 20 30\n4 5 6 200 40 50 60\n7 8 9 0 1 2 3\n1\n1 1 1 5 5 5 5\n"
AREAS = ["POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0), (2 2, 3 2, 3 3, 2 2))", "SRID=2154;MULTIPOLYGON (((0 0, 1 0, 1 1, 0 0)))",
         '{"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":{"type":"MultiPolygon",'
         '"coordinates":[[[[0,0],[5,0],[5,5],[0,0]]]]}}]}',
         '{"type":"Polygon","coordinates":[[[0,0,1],[5,0,1],[5,5,1],[0,0,1]]]}', "0,0,10,20.5"]

FACE = '"boundaries":[[[0,1,2]],[[0,2,1]]],"semantics":{"surfaces":[{"type":"RoofSurface"}],"values":[0,null]}'
CITY = ('{"type":"CityJSON","version":"2.0","transform":{"scale":[0.001,0.001,0.001],"translate":[1,2,3]},'
        '"CityObjects":{%s},"vertices":[[0,0,0],[9,0,0],[9,9,5]]}')
BUILDING = '"b":{"type":"Building","geometry":[{"type":"MultiSurface","lod":"2.2",' + FACE + "}]}"
SOLID = ('"p":{"type":"BuildingPart","parents":["b"],"geometry":[{"type":"Solid","lod":1,"boundaries":[[[[0,1,2]],'
         '[[2,1,0]]]]}]}')
CITIES = [CITY % BUILDING, CITY % (BUILDING + "," + SOLID),
          CITY % "" + "\n" + (CITY % SOLID).replace("CityJSON", "CityJSONFeature")]
CUBE = " ".join(f"{x} {y} {z}" for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)))
FACES = ("0 3 2 1", "4 5 6 7", "0 1 5 4", "1 2 6 5", "2 3 7 6", "3 0 4 7")
NUMBERED = "".join(f"{i} " + " ".join(CUBE.split()[3 * i:3 * i + 3]) + "\n" for i in range(8))
SOLIDS = ["j" + city for city in CITIES] + [
    "oOFF\n8 6 0\n" + CUBE + "\n" + "".join(f"4 {f}\n" for f in FACES),
    "p8 3 0 0\n" + NUMBERED + "6 0\n" + "".join(f"1 0\n4 {f}\n" for f in FACES) + "0\n0\n"]
OBJS = ["o a\nv 0 0 0\nv 1 0 0\nv 1 1 2.5e1\nf 1 2 3\ng b\nv 0 0 1\nf 1/1 -1//2 2/3/4 3\n"]
TRUTHS = ['{"classes":{"1":"wall"},"planes":[{"id":1,"class":"wall","plane":[0,0,1,-2],"polygons":[{"building":1,'
          '"ring":[[0,0,0],[1,0,0],[1,1,0]],"holes":[[[0,0,0],[1,0,0],[1,1,0]]]}]}],"openings":[{"id":1,"facade":1,'
          '"ring":[[0,0,0],[1,0,0],[1,1,0]]}],"control_points":[{"group":"sill_top","element":1,"position":[1,2,3]}],'
          '"objects":[{"id":3,"class":"car","points":5}],"buildings":[{"id":1}]}']
FACADES = ['{"type":"ilot facade","version":1,"facade":1,"crs":"","frame":{"origin":[0,0,0],"right":[1,0,0],"up":[0,0,1],'
           '"out":[0,-1,0]},"width_m":9,"height_m":5,"elements":[{"id":1,"kind":"window","opening":true,"family":1,'
           '"row":1,"column":1,"status":"seen","reason":"","ring":[[0,0,0],[1,0,0],[1,0,1]],"edges":[],"arcs":[{"centre":'
           '[0,0,0],"radius_m":1,"from_deg":0,"to_deg":90}],"width_m":1,"height_m":1,"depth_m":0,"width_error_m":0,'
           '"height_error_m":0,"depth_error_m":0,"points":3}]}']
DXFS = ["0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n9\n$INSUNITS\n70\n6\n0\nENDSEC\n0\nSECTION\n2\nTABLES\n0\nTABLE\n2\n"
        "LAYER\n0\nLAYER\n2\nFAC-OPENING\n0\nENDTAB\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n5\nA\n8\nFAC-OPENING\n70\n"
        "1\n10\n0\n20\n0\n42\n0.5\n10\n1\n20\n1\n0\nPOLYLINE\n8\n0\n70\n1\n0\nVERTEX\n10\n1\n20\n2\n0\nSEQEND\n0\nLINE\n10\n0\n20\n0\n11\n"
        "1\n21\n1\n0\nARC\n8\nFAC-DETAIL\n10\n1\n20\n1\n40\n2\n50\n0\n51\n90\n0\nTEXT\n1\na\n10\n1\n20\n1\n0\nENDSEC\n0\nEOF\n"]
LAYERS = ['preset = "aia"\n[layers.opening]\nname = "WINDOWS"\ncolour = 3\nlineweight_mm = 0.35\npattern = "dashed"\n'
          'shown = false\n[layers.error]\nshown = true\n']


def pcd_seeds():
    rows = struct.pack("<" + "ffffI" * 3, *(v for i in range(3) for v in (i, 2.5 * i, -i, 7, 0x102030)))
    turned = b"".join(rows[i * 20 + 4 * c:i * 20 + 4 * c + 4] for c in range(5) for i in range(3))
    literal = b"".join(bytes([len(part) - 1]) + part for part in (turned[at:at + 32] for at in range(0, 60, 32)))
    yield PCD.encode() + b"ascii\n" + b"".join(b"%d 2.5 -1 7 1056816\n" % i for i in range(3))
    yield PCD.encode() + b"binary\n" + rows
    yield PCD.encode() + b"binary_compressed\n" + struct.pack("<II", len(literal), 60) + literal


def e57_seed():
    """One scan of three points, single precision. The target itself gives the pages their checksums."""
    points = struct.pack("<3f", 0, 1, 2)
    packet = struct.pack("<6H", 0, 0, 3, 12, 12, 12)[4:] + 3 * points
    size = 4 + len(packet) + -(4 + len(packet)) % 4
    packet = (struct.pack("<BBH", 1, 0, size - 1) + packet).ljust(size, b"\0")
    section = struct.pack("<B7xQQQ", 1, 32 + size, 80, 0) + packet
    axes = "".join(f'<cartesian{axis} type="Float" precision="single"/>' for axis in "XYZ")
    xml = ('<?xml version="1.0"?>\n<e57Root type="Structure"><data3D type="Vector"><vectorChild type="Structure">'
           '<name type="String"><![CDATA[a]]></name><points type="CompressedVector" fileOffset="48" recordCount="3">'
           f'<prototype type="Structure">{axes}</prototype><codecs type="Vector"/></points></vectorChild></data3D>'
           "</e57Root>\n").encode()
    head = struct.pack("<8sIIQQQQ", b"ASTM-E57", 1, 0, 1024, 48 + len(section), len(xml), 1024)
    return (head + section + xml).ljust(1020, b"\0") + bytes(4)


def scanned():
    """A few hundred points of the scanner in every format that is written, each whole and cut."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        town = folder / "town.laz"
        subprocess.run([EXE, "scan", "district", "-o", town, "--points", "120", "-q"], check=True)
        for extension in (".laz", ".las", ".ply", ".csv", ".xyz"):
            path = folder / f"copy{extension}"
            subprocess.run([EXE, "convert", town, path, "-q"], check=True)
            whole = path.read_bytes()
            for part in (1, 0.95, 0.5, 0.1):
                yield extension, whole[:int(len(whole) * part)]


def written_here():
    for seed in pcd_seeds():
        yield ".pcd", seed
    yield ".ptx", PTX.encode()
    yield ".pts", PTS.encode()
    yield ".e57", e57_seed()
    for extension, seed in ((".ply", b"ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                             b"property float z\nproperty uchar red\nend_header\n1 2 3 4\n5 6 7 8\n"),
                            (".txt", b'"X";"Y";"Z";"Intensity"\n1;2;3;4\n5;;6;7\n')):
        yield extension, seed


def delivered():
    for path in sorted(pathlib.Path(DATA, "conformance").rglob("*")) if DATA else []:
        if path.suffix in TARGET_OF and path.is_file() and path.stat().st_size <= LARGEST:
            yield path.suffix, path.read_bytes()


def settings():
    printed = subprocess.run([EXE, "run", "--print-config"], check=True, capture_output=True).stdout
    return [printed, b"planes.epsilon=0.02\n", b"[classes]\nnoise = [7, 18]\n", b'[planes]\nepsilon = "auto"\n']


def main():
    out = pathlib.Path(sys.argv[1])
    numbers = {}

    def keep(target, content):
        numbers[target] = numbers.get(target, 0) + 1
        (out / target).mkdir(parents=True, exist_ok=True)
        (out / target / f"seed-{numbers[target]:03}").write_bytes(content)

    for source in (scanned, written_here, delivered):
        for extension, content in source():
            target = TARGET_OF[extension]
            keep(target, CHOICE.get(extension, b"\0") + content if target == "text_fuzz" else content)
    for content in settings():
        keep("settings_fuzz", content)
    for target, seeds in (("area_fuzz", AREAS), ("city_json_fuzz", CITIES), ("obj_fuzz", OBJS), ("truth_fuzz", TRUTHS),
                          ("facade_fuzz", FACADES), ("solids_fuzz", SOLIDS),
                          ("dxf_fuzz", DXFS), ("layers_fuzz", LAYERS)):
        for seed in seeds:
            keep(target, seed.encode())
    keep("laz_chunk_fuzz", bytes([3, 2, 9, 0, 0]) + bytes(range(200)))
    for target, number in sorted(numbers.items()):
        print(f"{target}: {number} seeds")


if __name__ == "__main__":
    main()
