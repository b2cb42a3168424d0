# SPDX-License-Identifier: Apache-2.0
"""The inputs of memory_matrix.py. Each made a run exceed its memory budget, or may do so.

A case writes its files into a folder and states the products and options with which they are run. Numbers of points are
proportional to `scale`, so a hundredth of the whole takes only seconds."""
import array
import math
import pathlib
import random
import struct

from memory_inputs import Inputs, Maker, las, rescaled

ALL = ("planes", "roofs", "facades", "streets")
CRS = ("--crs", "EPSG:2154")
CASES = {}


def case(*products):
    def keep(function):
        CASES[function.__name__] = (function, products or ALL)
        return function
    return keep


def moved(lines, dx, dy):
    for line in lines:
        x, y, z = map(float, line.split())
        yield f"{x + dx:.3f} {y + dy:.3f} {z:.3f}"


# Isolated points far from all others.

@case()
def stray_at_origin(m):
    return Inputs(m.write(["0 0 0"] + m.text("district", m.points(300000))), *CRS)


@case()
def stray_at_origin_last(m):
    return Inputs(m.write(m.text("district", m.points(300000)) + ["0 0 0"]), *CRS)


@case()
def rows_without_echo(m):
    return Inputs(m.write(["0 0 0"] * 10000 + m.text("district", m.points(300000))), *CRS)


def stray(m, scene, away):
    lines = m.text(scene, m.points(300000))
    return Inputs(m.write(lines + list(moved(lines[:1], away, away))), *CRS)


@case()
def stray_200_km(m):
    return stray(m, "district", 2e5)


@case()
def stray_1000_km(m):
    return stray(m, "district", 1e6)


@case()
def stray_1e9(m):
    return stray(m, "district", 1e9)


@case("planes", "streets")
def street_stray_at_origin(m):
    return Inputs(m.write(["0 0 0"] + m.text("street", m.points(200000))), *CRS)


@case("planes", "streets")
def street_stray_200_km(m):
    return stray(m, "street", 2e5)


@case()
def plane_behind_zero(m):
    rng = random.Random(1)
    rows = [f"{651000 + 20 * rng.random():.3f} {6861000 + 20 * rng.random():.3f} 50.003" for _ in range(40000)]
    return Inputs(m.write(["0 0 0"] + rows), *CRS)


@case()
def five_at_1e7(m):
    lines = m.text("district", m.points(300000))
    far = ["1e7 1e7 0", "-1e7 1e7 0", "1e7 -1e7 0", "-1e7 -1e7 0", "0 0 1e7"]
    return Inputs(m.write(lines + far), *CRS)


@case()
def hundred_strays(m):
    rng = random.Random(2)
    lines = m.text("district", m.points(300000))
    far = [f"{rng.uniform(-1e6, 2e6):.3f} {rng.uniform(5e6, 8e6):.3f} {rng.uniform(0, 100):.3f}" for _ in range(100)]
    return Inputs(m.write(far + lines), *CRS)


# Unusual extents, scales and records.

@case()
def fifty_thousand_over_4e9(m):
    rng = random.Random(3)
    rows = (tuple(rng.randrange(-2**31, 2**31) for _ in range(3)) for _ in range(50000))
    return Inputs(las(m.folder / "cloud.las", rows, 1.0, (0, 0, 0)), exits=(0, 1, 3))


@case()
def square_kilometre_at_1e5(m):
    rng = random.Random(4)
    rows = ((rng.randrange(10**8), rng.randrange(10**8), rng.randrange(10**6)) for _ in range(1247))
    return Inputs(las(m.folder / "cloud.las", rows, 1e-5))


@case()
def fine_scale(m):
    return Inputs(rescaled(m.scan("district", m.points(300000)), m.folder / "fine.las", 100))


@case()
def coarse_scale(m):
    rng = random.Random(5)
    rows = ((rng.randrange(300), rng.randrange(300), rng.randrange(5)) for _ in range(m.points(300000)))
    return Inputs(las(m.folder / "cloud.las", rows, 1.0))


@case()
def plain(m):
    return Inputs(m.scan("district", m.points(300000)))


@case()
def records_of_65535_bytes(m):
    """Makes records that have no space left for the fields of a labelled cloud."""
    rows = ((i % 8 * 1000, i // 8 * 1000, 0) for i in range(61))
    return Inputs(las(m.folder / "cloud.las", rows, length=65535), "--no-clouds")


@case()
def thousands_of_records_of_65400_bytes(m):
    rng = random.Random(6)
    rows = ((rng.randrange(10000), rng.randrange(10000), 0) for _ in range(max(200, int(4000 * m.scale))))
    return Inputs(las(m.folder / "cloud.las", rows, length=65400))


@case()
def two_clusters_50_km_apart(m):
    lines = m.text("district", m.points(300000))
    return Inputs(m.write(lines + list(moved(lines, 50000, 50000))), *CRS)


@case("planes", "streets")
def two_streets_50_km_apart(m):
    lines = m.text("street", m.points(400000))
    return Inputs(m.write(lines + list(moved(lines, 50000, -50000))), *CRS)


@case()
def corridor(m):
    """Makes a cloud of 20 km in a straight line, one metre wide."""
    rng = random.Random(7)
    rows = ((int(2e7 * rng.random()), int(2e7 * 0.3 * i / 1e6), rng.randrange(50)) for i in range(m.points(1000000)))
    rows = ((x, x // 3 + y % 1000, z) for x, y, z in rows)
    return Inputs(las(m.folder / "cloud.las", rows))


# Many points, in one unit or in blocks.

@case("planes")
def plane_of_10_million(m):
    rng = random.Random(8)
    rows = ((int(30000 * rng.random()), int(30000 * rng.random()), int(20 * rng.random()))
            for _ in range(m.points(10000000)))
    return Inputs(las(m.folder / "cloud.las", rows))


@case("roofs")
def building_of_10_million(m):
    return Inputs(m.scan("building", m.points(10000000)))


@case("facades")
def facade_of_10_million(m):
    path = m.scan("facade-haussmann", m.points(10000000))
    return Inputs(path, "--stations", path.with_suffix(".stations.csv"))


@case("facades")
def facade_of_19_million(m):
    path = m.scan("facade-haussmann", m.points(19000000))
    return Inputs(path, "--stations", path.with_suffix(".stations.csv"))


@case("streets")
def street_of_10_million(m):
    return Inputs(m.scan("street", m.points(10000000)))


@case()
def district_of_24_million(m):
    return Inputs(m.scan("district", m.points(24000000)), "--block-points", "1048576")


@case()
def district_in_small_blocks(m):
    return Inputs(m.scan("district", m.points(5000000)), "--block-points", "16384")


@case()
def town_of_roofs(m):
    return Inputs(m.scan("roofs", m.points(3000000)))


@case("planes", "streets")
def street_from_the_air(m):
    return Inputs(m.scan("street-air", m.points(2800000)))


# Files.

def tiles(m, count, files=None):
    """Splits the district into files, each a stretch of its rows."""
    whole = m.scan("district", max(10 * count, m.points(600000)))
    data = whole.read_bytes()
    start, = struct.unpack_from("<I", data, 96)
    length, = struct.unpack_from("<H", data, 105)
    rows = (len(data) - start) // length
    folder = m.folder / "tiles"
    folder.mkdir()
    paths = []
    for i in range(count):
        first, end = rows * i // count, rows * (i + 1) // count
        head = bytearray(data[:start])
        struct.pack_into("<I", head, 107, end - first)
        if head[25] >= 4:
            struct.pack_into("<Q", head, 247, end - first)
        paths.append(folder / f"tile-{i:04d}.las")
        paths[-1].write_bytes(bytes(head) + data[start + first * length:start + end * length])
    whole.unlink()
    return Inputs(folder, files=files)


@case()
def tiles_3000(m):
    return tiles(m, 3000, files=4096)


@case()
def tiles_1030_at_1024_open_files(m):
    return tiles(m, 1030, files=1024)


@case()
def compressed(m):
    return Inputs(m.scan("district", m.points(2000000), suffix=".laz"))


# Points that make large tables, or none.

@case()
def all_in_one_place(m):
    return Inputs(las(m.folder / "cloud.las", ((5, 5, 5) for _ in range(m.points(1000000)))), exits=(0, 1, 3))


@case()
def three_points(m):
    return Inputs(las(m.folder / "cloud.las", [(0, 0, 0), (1000, 0, 0), (0, 1000, 0)]), exits=(0, 1, 3))


@case()
def on_a_line(m):
    return Inputs(las(m.folder / "cloud.las", ((i, i, i) for i in range(m.points(500000)))))


@case()
def noise_in_a_cube(m):
    rng = random.Random(9)
    rows = ((int(1e5 * rng.random()), int(1e5 * rng.random()), int(3e4 * rng.random()))
            for _ in range(m.points(2000000)))
    return Inputs(las(m.folder / "cloud.las", rows))


@case()
def chessboard_of_planes(m):
    """Makes squares of two metres at two heights. Each gives a plane, an object and a border."""
    rng = random.Random(10)
    side = int(math.sqrt(m.points(4000000) / 50))

    def rows():
        for i in range(side):
            for j in range(side):
                z = 3000 * ((i + j) % 2) + 40 * ((7 * i + 13 * j) % 11)
                for _ in range(50):
                    yield int(1000 * (i + rng.random())), int(1000 * (j + rng.random())), z + rng.randrange(10)
    return Inputs(las(m.folder / "cloud.las", rows()))


@case("planes", "streets")
def posts_on_a_square(m):
    """Makes a post every two metres on flat ground: as many objects as fit on the ground."""
    rng = random.Random(11)
    side = max(10, int(math.sqrt(m.points(3000000) / 150)))

    def rows():
        for i in range(side):
            for j in range(side):
                for k in range(150):
                    if k < 60:
                        yield 2000 * i + rng.randrange(120), 2000 * j + rng.randrange(120), k * 40
                    else:
                        yield int(2000 * (i + rng.random())), int(2000 * (j + rng.random())), rng.randrange(20)
    return Inputs(las(m.folder / "cloud.las", rows()))


@case("planes", "streets")
def hedge_across_the_square(m):
    """Makes one connected object from corner to corner. Its box is the whole square."""
    rng = random.Random(12)
    width = int(150000 * min(1.0, max(0.2, math.sqrt(m.scale))))

    def rows():
        for i in range(m.points(2000000)):
            t = rng.random() * width
            if i % 4 == 0:
                yield int(t), int(t + 600 * rng.random()), int(1500 * rng.random())
            else:
                yield int(t), int(width * rng.random()), rng.randrange(20)
    return Inputs(las(m.folder / "cloud.las", rows()))


@case()
def not_numbers(m):
    lines = m.text("district", m.points(300000))
    return Inputs(m.write(lines[:1000] + ["nan nan nan", "inf 0 0", "1e300 1e300 0", "1e15 0 0"] + lines[1000:]), *CRS)


@case()
def binary_ply(m):
    """Writes coordinates as doubles, with the first vertex at 1e9."""
    rng = random.Random(13)
    values = array.array("d", [1e9, 1e9, 0])
    for _ in range(m.points(90000)):
        values.extend((651000 + 30 * rng.random(), 6861000 + 30 * rng.random(), 0.01 * rng.random()))
    path = m.folder / "cloud.ply"
    head = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(values) // 3}\n"
    path.write_bytes((head + "property double x\nproperty double y\nproperty double z\nend_header\n").encode() +
                     values.tobytes())
    return Inputs(path, *CRS)


@case()
def line_of_40_megabytes(m):
    lines = m.text("district", m.points(100000))
    return Inputs(m.write(lines + ["1" * (40 << 20)]), *CRS, exits=(0, 1, 3))
