# SPDX-License-Identifier: Apache-2.0
"""Readers of what `ilot export` writes, made from the specifications alone: nothing of ilot reads its own files here."""
import collections
import json
import math
import struct


class Solid:
    """The polygons of a building in CityJSON, full coordinates."""
    def __init__(self, vertices, faces, kinds):
        self.vertices, self.faces, self.kinds = vertices, faces, kinds

    def used(self):
        return {self.vertices[i] for face in self.faces for ring in face for i in ring}

    def volume(self):
        """Rings of flat faces as fans from a vertex: signed, so that they need not be convex, and holes count themselves."""
        at = self.vertices[self.faces[0][0][0]]
        return sum(six_volumes(minus(self.vertices[ring[0]], at), minus(self.vertices[a], at), minus(self.vertices[b], at))
                   for face in self.faces for ring in face for a, b in zip(ring[1:], ring[2:])) / 6


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def six_volumes(a, b, c):
    return dot(a, cross(b, c))


def city_models(path):
    """id -> (attributes, {lod: Solid}) of a CityJSONSeq."""
    models = {}
    with open(path, encoding="utf-8") as file:
        head = json.loads(file.readline())["transform"]
        for line in file:
            feature = json.loads(line)
            vertices = [tuple(t + s * c for t, s, c in zip(head["translate"], head["scale"], v)) for v in feature["vertices"]]
            thing = feature["CityObjects"][feature["id"]]
            levels = {}
            for geometry in thing["geometry"]:
                if geometry["type"] != "Solid":
                    continue
                surfaces = geometry["semantics"]["surfaces"]
                kinds = [surfaces[i]["type"] for i in geometry["semantics"]["values"][0]]
                levels[geometry["lod"]] = Solid(vertices, geometry["boundaries"][0], kinds)
            models[feature["id"]] = (thing["attributes"], levels)
    return models


def fan(vertices, face):
    """The corners of a face as triangles about its first corner: signed, so that holes and notches are taken off."""
    first = vertices[face[0][0]]
    return [(first, vertices[a], vertices[b]) for ring in face for a, b in zip(ring, ring[1:] + ring[:1])]


def area(vertices, face):
    triangles = fan(vertices, face)
    sums = [cross(minus(b, a), minus(c, a)) for a, b, c in triangles]
    return length(tuple(sum(s[k] for s in sums) for k in range(3))) / 2


def mesh_faults(triangles):
    """How many directed edges have not exactly one opposite; triangles of corners that are equal where they meet."""
    edges = collections.Counter((t[i], t[(i + 1) % 3]) for t in triangles for i in range(3))
    return sum(1 for (a, b), n in edges.items() if edges[(b, a)] != n)


def mesh_volume(triangles):
    at = triangles[0][0]
    return sum(six_volumes(*(minus(c, at) for c in t)) for t in triangles) / 6


def read_stl(path):
    data = path.read_bytes()
    count = struct.unpack_from("<I", data, 80)[0]
    assert len(data) == 84 + 50 * count, "the length of an STL follows from its count"
    words = data[:80].split(b"\0")[0].decode().split(" add ")
    offset = tuple(float(w) for w in words[1].split())
    triangles = []
    for i in range(count):
        numbers = struct.unpack_from("<12f", data, 84 + 50 * i)
        triangles.append(tuple(tuple(numbers[3 + 3 * k:6 + 3 * k]) for k in range(3)))
    return offset, triangles


def read_ply(path):
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    lines = data[:end].decode().splitlines()
    counts = {w[1]: int(w[2]) for w in map(str.split, lines) if w[0] == "element"}
    vertices = [struct.unpack_from("<3d", data, end + 24 * i) for i in range(counts["vertex"])]
    at, faces = end + 24 * counts["vertex"], []
    for i in range(counts["face"]):
        n, a, b, c, _, _, _, kind, building = struct.unpack_from("<B3I4BI", data, at + 21 * i)
        assert n == 3
        faces.append(((a, b, c), kind, building))
    assert at + 21 * counts["face"] == len(data)
    return lines, vertices, faces


class Glb:
    COMPONENTS = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}
    NUMBERS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}

    def __init__(self, data):
        magic, version, size, length, kind = struct.unpack_from("<4s4I", data)
        assert (magic, version, size, kind) == (b"glTF", 2, len(data), 0x4E4F534A)
        self.json = json.loads(data[20:20 + length])
        binary, kind = struct.unpack_from("<II", data, 20 + length)
        assert kind == 0x004E4942
        self.binary = data[28 + length:28 + length + binary]

    def view(self, number):
        view = self.json["bufferViews"][number]
        return self.binary[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]

    def accessor(self, number):
        accessor = self.json["accessors"][number]
        n = self.NUMBERS[accessor["type"]]
        values = struct.unpack_from(f"<{n * accessor['count']}{self.COMPONENTS[accessor['componentType']]}",
                                    self.view(accessor["bufferView"]))
        return values if n == 1 else [values[i:i + n] for i in range(0, len(values), n)]

    def meshes(self):
        """(node, primitives with corners) of every node with a mesh; corners placed by all nodes above, y up."""
        def walk(number, above):
            node = self.json["nodes"][number]
            def place(p):
                p = turned(node.get("rotation"), p)
                return above(tuple(a + b for a, b in zip(p, node.get("translation", (0, 0, 0)))))
            if "mesh" in node:
                yield node, [self.corners(p, place) for p in self.json["meshes"][node["mesh"]]["primitives"]]
            for child in node.get("children", []):
                yield from walk(child, place)
        for number in self.json["scenes"][self.json["scene"]]["nodes"]:
            yield from walk(number, lambda p: p)

    def corners(self, primitive, place):
        attributes = {name: self.accessor(n) for name, n in primitive["attributes"].items()}
        places = [place(p) for p in attributes["POSITION"]]
        indices = self.accessor(primitive["indices"])
        return {"triangles": [tuple(places[i] for i in indices[k:k + 3]) for k in range(0, len(indices), 3)],
                "corners": [indices[k:k + 3] for k in range(0, len(indices), 3)], "attributes": attributes,
                "material": primitive["material"], "extensions": primitive.get("extensions", {})}


def turned(q, p):
    if q is None:
        return p
    u, w = q[:3], q[3]
    t = tuple(2 * c for c in cross(u, p))
    return tuple(a + w * b + c for a, b, c in zip(p, t, cross(u, t)))


def length(v):
    return math.sqrt(dot(v, v))


def property_table(glb, table):
    """A table of EXT_structural_metadata: its name, and the values of each property."""
    schema = glb.json["extensions"]["EXT_structural_metadata"]["schema"]["classes"][table["class"]]["properties"]
    assert set(schema) == set(table["properties"])
    columns, n = {"name": table["name"]}, table["count"]
    for name, of in table["properties"].items():
        data = glb.view(of["values"])
        if schema[name]["type"] == "STRING":
            offsets = struct.unpack_from(f"<{n + 1}I", glb.view(of["stringOffsets"]))
            columns[name] = [data[a:b].decode() for a, b in zip(offsets, offsets[1:])]
        else:
            form = "B" if schema[name]["type"] == "ENUM" else {"FLOAT64": "d", "INT64": "q"}[schema[name]["componentType"]]
            columns[name] = struct.unpack(f"<{n}{form}", data)
    return columns


class SubtreeFile:
    """A file of the availability of implicit tiling, by OGC 22-025r4."""
    def __init__(self, data, levels):
        magic, version, length, binary = struct.unpack_from("<4sIQQ", data)
        assert (magic, version, len(data)) == (b"subt", 1, 24 + length + binary) and length % 8 == binary % 8 == 0
        self.json = json.loads(data[24:24 + length])
        assert self.json["buffers"] == [{"byteLength": binary}]
        self.binary = data[24 + length:]
        count = (4 ** levels - 1) // 3
        self.tiles = self.bits(self.json["tileAvailability"], count)
        self.contents = self.bits(self.json["contentAvailability"][0], count)
        self.below = self.bits(self.json["childSubtreeAvailability"], 4 ** levels)
        table = self.json["propertyTables"][self.json["tileMetadata"]]
        assert table["count"] == sum(self.tiles)
        boxes, errors = (self.doubles(table["properties"][name]["values"]) for name in ("box", "geometric_error_m"))
        rows = iter(range(table["count"]))
        self.metadata = [next(rows) if there else None for there in self.tiles]
        self.boxes, self.errors = [boxes[i:i + 12] for i in range(0, len(boxes), 12)], errors

    def view(self, number):
        view = self.json["bufferViews"][number]
        assert view["byteOffset"] % 8 == 0
        return self.binary[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]

    def bits(self, available, count):
        if "constant" in available:
            return [available["constant"] == 1] * count
        data = self.view(available["bitstream"])
        assert len(data) == (count + 7) // 8
        bits = [data[i // 8] >> (i % 8) & 1 == 1 for i in range(count)]
        assert sum(bits) == available["availableCount"] and not any(data[i // 8] >> (i % 8) & 1 for i in range(count, 8 * len(data)))
        return bits

    def doubles(self, number):
        return struct.unpack(f"<{len(self.view(number)) // 8}d", self.view(number))


def morton(x, y, bits):
    return sum((x >> b & 1) << 2 * b | (y >> b & 1) << 2 * b + 1 for b in range(bits))


def read_tileset(folder):
    """Returns tileset.json with its implicit tiles as explicit ones: each has what its metadata says, its `level`, the `square` and
    the error that follow from the root alone, and the name of the `subtree` that it was in. `subtrees` counts these."""
    tileset = json.loads((folder / "tileset.json").read_text())
    root, names = tileset["root"], set()
    tiling = root["implicitTiling"]
    assert (tiling["subdivisionScheme"], root["refine"]) == ("QUADTREE", "ADD")
    semantics = {k: p["semantic"] for k, p in tileset["schema"]["classes"]["tile"]["properties"].items()}
    assert semantics == {"box": "TILE_BOUNDING_BOX", "geometric_error_m": "TILE_GEOMETRIC_ERROR"}
    levels, box = tiling["subtreeLevels"], root["boundingVolume"]["box"]

    def named(template, level, x, y):
        return template.format(level=level, x=x, y=y)

    def subtree(level, x, y):
        name = named(tiling["subtrees"]["uri"], level, x, y)
        names.add(name)
        return SubtreeFile((folder / name).read_bytes(), levels), name

    def tile(file, name, level, x, y):
        local = level % levels
        lx, ly = x & (1 << local) - 1, y & (1 << local) - 1
        index = (4 ** local - 1) // 3 + morton(lx, ly, local)
        assert file.tiles[index] and level < tiling["availableLevels"]
        row, share = file.metadata[index], 0.5 ** level
        low = [box[k] - box[3 + 4 * k] + 2 * box[3 + 4 * k] * share * at for k, at in enumerate((x, y))]
        made = {"boundingVolume": {"box": list(file.boxes[row])}, "geometricError": file.errors[row], "level": level, "children": [],
                "subtree": name, "square": [(a, a + 2 * box[3 + 4 * k] * share) for k, a in enumerate(low)],
                "implicitError": root["geometricError"] * share}
        if file.contents[index]:
            made["content"] = {"uri": named(root["content"]["uri"], level, x, y)}
        for cx, cy in ((2 * x + right, 2 * y + upper) for upper in (0, 1) for right in (0, 1)):
            if local + 1 < levels:
                lx, ly = cx & (1 << local + 1) - 1, cy & (1 << local + 1) - 1
                if file.tiles[(4 ** (local + 1) - 1) // 3 + morton(lx, ly, local + 1)]:
                    made["children"].append(tile(file, name, level + 1, cx, cy))
            elif file.below[morton(cx & (1 << levels) - 1, cy & (1 << levels) - 1, levels)]:
                made["children"].append(tile(*subtree(level + 1, cx, cy), level + 1, cx, cy))
        if not made["children"]:
            del made["children"]
        return made

    made = tile(*subtree(0, 0, 0), 0, 0, 0)
    tileset["root"] = {**{k: v for k, v in root.items() if k != "content"}, **made}
    tileset["subtrees"] = names
    return tileset
