"""One mesh in every encoding that foldless reads, and the exact content of a base mesh. Shares no code with foldless."""

import gzip
import math
import re
import struct
from dataclasses import dataclass

MEGABYTE = 1 << 20
PLY_TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d"}


@dataclass(frozen=True)
class Encoded:
    """The bytes of a file, and where its sections end: the header, the counts, the vertices, the faces."""

    data: bytes
    edges: tuple


def small_mesh():
    """A closed mesh of 22 vertices and 40 faces. Every coordinate is a short decimal and a float32 value; vertex 0 has
    coordinates that are 0; the last face ends with a vertex of one digit."""
    segments = 5
    heights = (0.75, 0.5, 0.0, -0.5)
    radii = (0.5, 0.875, 1.0, 0.75)
    points = [(0.0, 0.0, 1.0)]
    for height, radius in zip(heights, radii):
        for i in range(segments):
            angle = 2 * math.pi * i / segments
            points.append((round(radius * math.cos(angle) * 64) / 64, round(radius * math.sin(angle) * 64) / 64, height))
    points.append((0.0, 0.0, -1.0))
    last = len(points) - 1

    def index(ring, i):
        return 1 + ring * segments + i % segments

    faces = [(last, index(3, i + 1), index(3, i)) for i in range(segments)]
    for ring in range(3):
        for i in range(segments):
            faces += [(index(ring, i), index(ring + 1, i), index(ring + 1, i + 1))]
            faces += [(index(ring, i), index(ring + 1, i + 1), index(ring, i + 1))]
    faces += [(0, index(0, i), index(0, i + 1)) for i in range(segments)]
    return points, faces


def joined(sections):
    """The sections of a file one after another."""
    edges, end = [], 0
    for section in sections:
        end += len(section)
        edges.append(end)
    return Encoded(b"".join(sections), tuple(edges))


def lines(rows):
    return "".join(" ".join(map(str, row)) + "\n" for row in rows).encode("ascii")


def ply_header(form, mesh, vertex="float", length="uchar", index="int"):
    points, faces = mesh
    return [
        f"ply\nformat {form} 1.0\n".encode("ascii"),
        f"element vertex {len(points)}\nproperty {vertex} x\nproperty {vertex} y\nproperty {vertex} z\n".encode("ascii"),
        f"element face {len(faces)}\nproperty list {length} {index} vertex_indices\nend_header\n".encode("ascii"),
    ]


def ply_ascii(mesh, **types):
    points, faces = mesh
    sections = [lines(points), lines((len(face), *face) for face in faces)]
    return joined(ply_header("ascii", mesh, **types) + sections)


def ply_binary(mesh, big=False, vertex="float", length="uchar", index="int"):
    points, faces = mesh
    order, form = (">", "binary_big_endian") if big else ("<", "binary_little_endian")
    vertices = b"".join(struct.pack(order + "3" + PLY_TYPES[vertex], *point) for point in points)
    indices = b"".join(
        struct.pack(f"{order}{PLY_TYPES[length]}{len(face)}{PLY_TYPES[index]}", len(face), *face) for face in faces
    )
    return joined(ply_header(form, mesh, vertex, length, index) + [vertices, indices])


def ply_big_endian(mesh, **types):
    return ply_binary(mesh, big=True, **types)


def obj(mesh):
    points, faces = mesh
    return joined([lines(("v", *point) for point in points), lines(("f", *(c + 1 for c in face)) for face in faces)])


def off(mesh):
    points, faces = mesh
    counts = lines([(len(points), len(faces), 0)])
    return joined([b"OFF\n", counts, lines(points), lines((len(face), *face) for face in faces)])


def stl_ascii(mesh):
    points, faces = mesh
    facets = [
        "facet normal 0 0 0\nouter loop\n"
        + "".join(f"vertex {x} {y} {z}\n" for x, y, z in (points[corner] for corner in face))
        + "endloop\nendfacet\n"
        for face in faces
    ]
    half = len(facets) // 2
    parts = ["solid small mesh\n", "".join(facets[:half]), "".join(facets[half:]), "endsolid"]
    return joined([part.encode("ascii") for part in parts])


def stl_binary(mesh, header=b"made by a test"):
    points, faces = mesh
    facets = b"".join(
        struct.pack("<12fH", 0, 0, 0, *(x for corner in face for x in points[corner]), 0) for face in faces
    )
    return joined([header.ljust(80, b"\0"), struct.pack("<I", len(faces)), facets])


# Each encoding by name: how it is written, and the extension of its files.
ENCODINGS = {
    "ply ascii": (ply_ascii, "ply"),
    "ply little endian": (ply_binary, "ply"),
    "ply big endian": (ply_big_endian, "ply"),
    "obj": (obj, "obj"),
    "off": (off, "off"),
    "stl ascii": (stl_ascii, "stl"),
    "stl binary": (stl_binary, "stl"),
}
TEXTS = ("ply ascii", "obj", "off", "stl ascii")


def encoded(name, mesh):
    return ENCODINGS[name][0](mesh)


def extension(name):
    return ENCODINGS[name][1]


def welded(mesh):
    """The mesh as STL can hold it: vertices in the order in which the faces first name them."""
    points, faces = mesh
    order = list(dict.fromkeys(corner for face in faces for corner in face))
    number = {old: new for new, old in enumerate(order)}
    return [points[old] for old in order], [tuple(number[corner] for corner in face) for face in faces]


def content(name, mesh):
    """What a reader must find in a file of this encoding."""
    return welded(mesh) if extension(name) == "stl" else mesh


def written_base(path):
    """Points and faces of a base mesh that foldless wrote as PLY, to the last bit."""
    header, data = path.read_bytes().split(b"end_header\n", 1)
    text = header.decode("ascii")
    vertices, faces = (int(re.search(rf"element {name} (\d+)", text).group(1)) for name in ("vertex", "face"))
    coordinate = "d" if "property double x" in text else "f"
    vertex = struct.Struct(f"<3{coordinate}3fi")
    face = struct.Struct("<B3i2f")
    points = [vertex.unpack_from(data, i * vertex.size)[:3] for i in range(vertices)]
    start = vertices * vertex.size
    return points, [face.unpack_from(data, start + i * face.size)[1:4] for i in range(faces)]


def changed(data, old, new, count=1):
    """The data with the first `count` occurrences of `old` replaced; fails where there is none."""
    assert data.count(old) >= count, (old, count)
    return data.replace(old, new, count)


def compressed(data):
    return gzip.compress(data, mtime=0)
