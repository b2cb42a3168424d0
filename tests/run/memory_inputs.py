#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How the inputs of memory_cases.py are made: scenes of the scanner, text, and LAS files of any rows."""
import pathlib
import struct
import subprocess


class Inputs:
    """The inputs and options that a case gives to `ilot run`."""

    def __init__(self, paths, *options, exits=(0, 3), files=None):
        self.paths = [paths] if isinstance(paths, pathlib.Path) else list(paths)
        self.options = options
        self.exits = exits  # the exit codes that are right
        self.files = files  # greatest number of open files (ulimit -n)


class Maker:
    def __init__(self, exe, folder, scale):
        self.exe, self.folder, self.scale = exe, folder, scale

    def points(self, count, least=20000):
        return max(least, int(count * self.scale))

    def scan(self, scene, points, name="cloud", suffix=".las", **settings):
        path = self.folder / f"{name}{suffix}"
        chosen = [word for key, value in settings.items() for word in ("--set", f"scene.{key}={value}")]
        self.ilot("scan", scene, "-o", path, "--points", points, *chosen)
        return path

    def text(self, scene, points, name="cloud", **settings):
        """Returns x y z of a scene as lines."""
        las = self.scan(scene, points, name + "-scan", **settings)
        path = self.folder / f"{name}.csv"
        self.ilot("convert", las, path)
        with open(path) as file:
            next(file)
            lines = [" ".join(line.split(",", 3)[:3]) for line in file]
        las.unlink()
        path.unlink()
        return lines

    def write(self, lines, name="cloud.xyz"):
        path = self.folder / name
        path.write_text("".join(line.rstrip() + "\n" for line in lines))
        return path

    def ilot(self, *arguments):
        subprocess.run([self.exe, *map(str, arguments), "-q"], check=True, capture_output=True)


def las(path, rows, scale=0.001, offset=(651000.0, 6861000.0, 0.0), length=20):
    """Writes LAS 1.2 of format 0 from rows of integers (x, y, z). Records are padded to `length` bytes."""
    fill = bytes(length - 12)
    with open(path, "wb") as file:
        file.write(bytes(227))
        count = 0
        for x, y, z in rows:
            file.write(struct.pack("<3i", x, y, z) + fill)
            count += 1
        head = struct.pack("<4sHH16sBB32s32sHHHIIBHI5I", b"LASF", 0, 0, b"", 1, 2, b"test", b"test", 1, 2026, 227, 227,
                           0, 0, length, count, count, 0, 0, 0, 0)
        file.seek(0)
        file.write(head + struct.pack("<12d", scale, scale, scale, *offset, 0, 0, 0, 0, 0, 0))
    return path


def rescaled(path, out, factor):
    """Returns the same cloud with a scale that is `times` finer."""
    data = bytearray(path.read_bytes())
    start, = struct.unpack_from("<I", data, 96)
    length, = struct.unpack_from("<H", data, 105)
    scale = struct.unpack_from("<3d", data, 131)
    struct.pack_into("<3d", data, 131, *(s / factor for s in scale))
    for at in range(start, len(data) - length + 1, length):
        struct.pack_into("<3i", data, at, *(v * factor for v in struct.unpack_from("<3i", data, at)))
    out.write_bytes(data)
    path.unlink()
    return out
