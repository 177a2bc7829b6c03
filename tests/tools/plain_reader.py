"""Reads meshes in the plainest way, to say what an honest file spells: positions and polygons, in the order of the file.

It trusts the file, knows nothing of limits, and shares nothing with the readers of foldless.
"""

import re
import struct

SCALARS = {
    "char": "b", "int8": "b", "uchar": "B", "uint8": "B", "short": "h", "int16": "h", "ushort": "H", "uint16": "H",
    "int": "i", "int32": "i", "uint": "I", "uint32": "I", "float": "f", "float32": "f", "double": "d", "float64": "d",
}  # fmt: skip


def as_float32(value):
    return struct.unpack("<f", struct.pack("<f", value))[0]


def read_off(data):
    text = re.sub("#.*", "", data.decode("utf-8-sig", "replace"))
    rows = [line.split() for line in re.sub(r"\A\s*[A-Z]*OFF", "", text).splitlines()]
    counts, *rows = [row for row in rows if row]
    vertices, faces = int(counts[0]), int(counts[1])
    points = [tuple(map(float, row[:3])) for row in rows[:vertices]]
    polygons = [tuple(map(int, row[1 : 1 + int(row[0])])) for row in rows[vertices : vertices + faces]]
    return points, polygons


def read_obj(data):
    points, polygons = [], []
    text = data.decode("latin-1").replace("\\\r\n", " ").replace("\\\n", " ")
    for line in text.splitlines():
        words = line.split("#")[0].split()
        if words[:1] == ["v"]:
            points.append(tuple(map(float, words[1:4])))
        elif words[:1] in (["f"], ["fo"]):
            corners = [int(word.split("/")[0]) for word in words[1:]]
            polygons.append(tuple(corner - 1 if corner > 0 else len(points) + corner for corner in corners))
    return points, polygons


class PlyBody:
    """The values of a PLY file one after the other."""

    def __init__(self, form, body):
        self.order = ">" if form == "binary_big_endian" else "<"
        self.words = iter(body.split()) if form == "ascii" else None
        self.body = body
        self.position = 0

    def value(self, kind):
        if self.words is not None:
            word = next(self.words)
            return float(word) if kind in "fd" else int(float(word))
        (value,) = struct.unpack_from(self.order + kind, self.body, self.position)
        self.position += struct.calcsize(kind)
        return value

    def property(self, kinds):
        if len(kinds) == 1:
            value = self.value(kinds[0])
            return as_float32(value) if kinds[0] == "f" else value
        return tuple(self.value(kinds[1]) for _ in range(self.value(kinds[0])))


def read_ply(data):
    header, body = data.split(b"end_header", 1)
    body = body.split(b"\n", 1)[1] if b"\n" in body[:2] else body[1:]
    form, elements = "", []
    for words in (line.split() for line in header.decode("latin-1").splitlines()):
        if words[:1] == ["format"]:
            form = words[1]
        elif words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:1] == ["property"]:
            elements[-1][2].append((words[-1], [SCALARS[word] for word in words[1:-1] if word in SCALARS]))
    values = PlyBody(form, body)
    points, polygons = [], []
    for name, count, properties in elements:
        for _ in range(count):
            row = {name: values.property(kinds) for name, kinds in properties}
            if name == "vertex":
                points.append((row["x"], row["y"], row["z"]))
            elif name == "face":
                polygons.append(row["vertex_indices"] if "vertex_indices" in row else row["vertex_index"])
    return points, polygons


def read_stl(data):
    if len(data) >= 84 and 84 + 50 * struct.unpack_from("<I", data, 80)[0] == len(data):
        rows = [struct.unpack_from("<12f", data, 84 + 50 * i)[3:] for i in range((len(data) - 84) // 50)]
        points = [row[3 * k : 3 * k + 3] for row in rows for k in range(3)]
    else:
        words = data.decode("latin-1").lower().split()
        starts = [i for i, word in enumerate(words) if word == "vertex"]
        points = [tuple(map(float, words[i + 1 : i + 4])) for i in starts]
    return points, [(i, i + 1, i + 2) for i in range(0, len(points), 3)]


READERS = {".off": read_off, ".obj": read_obj, ".ply": read_ply, ".stl": read_stl}


def triangles(path):
    """The three points of each triangle; polygons are fanned from their first corner."""
    points, polygons = READERS[path.suffix.lower()](path.read_bytes())
    return [
        (points[polygon[0]], points[polygon[k]], points[polygon[k + 1]])
        for polygon in polygons
        for k in range(1, len(polygon) - 1)
    ]
