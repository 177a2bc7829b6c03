#!/usr/bin/env python3
"""Writes the inputs that the fuzzers start from: seeds.py FOLDER

Small valid files for the readers, command lines, and for the other fuzzers, which draw numbers from bytes, bytes of
some length that are the same in every run. One folder for each fuzzer.
"""

import random
import struct
import sys
from pathlib import Path

CORNERS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
FACES = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]


def lines(*texts):
    return "".join(text + "\n" for text in texts).encode()


def numbers(values):
    return " ".join(str(value) for value in values)


def ply_header(kind, scalar, vertex_extra="", face_extra=""):
    def properties(names):
        return [f"property {scalar} {name}" for name in names.split()]

    return lines(
        "ply", f"format {kind} 1.0", "comment a tetrahedron",
        f"element vertex {len(CORNERS)}", *properties("x y z " + vertex_extra),
        f"element face {len(FACES)}", "property list uchar int vertex_indices", *properties(face_extra),
        "end_header",
    )


def ascii_ply():
    body = [numbers(corner) for corner in CORNERS] + [numbers((3, *face)) for face in FACES]
    return ply_header("ascii", "float") + lines(*body)


def binary_ply(order, base=False):
    vertex = struct.Struct(order + ("6f" if base else "3f"))
    face = struct.Struct(order + ("B3i2f" if base else "B3i"))
    direction = (0.5, 0.25, 1.0) if base else ()
    span = (-0.5, 0.5) if base else ()
    kind = "binary_little_endian" if order == "<" else "binary_big_endian"
    header = ply_header(kind, "float", "nx ny nz" if base else "", "t_min t_max" if base else "")
    return (
        header
        + b"".join(vertex.pack(*corner, *direction) for corner in CORNERS)
        + b"".join(face.pack(3, *corners, *span) for corners in FACES)
    )


def ascii_base_ply():
    body = [numbers((*corner, 0, 0.5, 1)) for corner in CORNERS] + [numbers((3, *face, -1, 1)) for face in FACES]
    return ply_header("ascii", "double", "nx ny nz", "t_min t_max") + lines(*body)


def kept_base_ply():
    """With scan vertices and directions of the faces."""
    header = lines(
        "ply", "format ascii 1.0", "element vertex 4", "property float x", "property float y", "property float z",
        "property int scan_vertex", "element face 4", "property list uchar uint vertex_indices",
        "property float nx", "property float ny", "property float nz", "end_header",
    )
    body = [numbers((*corner, at - 1)) for at, corner in enumerate(CORNERS)]
    return header + lines(*body, *[numbers((3, *face, 0, 0, 1)) for face in FACES])


def obj(normals):
    def corner(index):
        return f"{index + 1}//{index + 1}" if normals else str(index + 1)

    return lines(
        "# a tetrahedron", *["v " + numbers(corner) for corner in CORNERS],
        *["vn " + numbers((0, 0.5, 1)) for _ in CORNERS if normals],
        *["f " + " ".join(corner(index) for index in face) for face in FACES],
    )


def coloured_ply():
    """With the colours and texture coordinates of vertices."""
    header = ply_header("ascii", "float", "red green blue s t")
    body = [numbers((*corner, 0.5, 0, 1, *corner[:2])) for corner in CORNERS]
    return header + lines(*body, *[numbers((3, *face)) for face in FACES])


def textured_ply():
    """With the texture coordinates of corners, and bytes as colours."""
    vertex, face = struct.Struct("<3f3B"), struct.Struct("<B3iB6fB")
    header = lines(
        "ply", "format binary_little_endian 1.0", "comment TextureFile a b.png", f"element vertex {len(CORNERS)}",
        *[f"property float {name}" for name in "xyz"], *[f"property uchar {name}" for name in ("red", "green", "blue")],
        f"element face {len(FACES)}", "property list uchar int vertex_indices", "property list uchar float texcoord",
        "property uchar texnumber", "end_header",
    )
    return (
        header
        + b"".join(vertex.pack(*corner, 255, 9, 0) for corner in CORNERS)
        + b"".join(face.pack(3, *corners, 6, 0, 0, 1, 0, 0, 1, 0) for corners in FACES)
    )


def textured_obj():
    return lines(
        "mtllib a.mtl", *["v " + numbers((*corner, 1, 0.5, 0)) for corner in CORNERS],
        *["vt " + numbers(corner[:2]) for corner in CORNERS], "usemtl a b",
        *["f " + " ".join(f"{index + 1}/{index - 4}" for index in face) for face in FACES],
    )


def off(header):
    colour = " 255 0 0" if header == "COFF" else ""
    return lines(
        header, f"{len(CORNERS)} {len(FACES)} 0", *[numbers(corner) + colour for corner in CORNERS],
        *[numbers((3, *face)) for face in FACES],
    )


def ascii_stl():
    texts = ["solid a"]
    for face in FACES:
        texts += ["facet normal 0 0 1", "outer loop"]
        texts += ["vertex " + numbers(CORNERS[index]) for index in face] + ["endloop", "endfacet"]
    return lines(*texts, "endsolid a")


def binary_stl():
    def record(face):
        return struct.pack("<12fH", 0, 0, 1, *[x for index in face for x in CORNERS[index]], 0)

    return bytes(80) + struct.pack("<I", len(FACES)) + b"".join(record(face) for face in FACES)


QUADS_OFF = lines("OFF", "4 1 4", "0 0 0", "1 0 0", "1 1 0", "0 1 0", "4 0 1 2 3")

TEXTURED_OFF = lines("STCOFF", "3 1 0", "0 0 0 1 0 0 0 0", "1 0 0 0 1 0 1 0", "0 1 0 0 0 1 0 1", "3 0 1 2 255 0 0")

MATERIALS = lines("newmtl a b", "Kd 1 1 1", "map_Kd -s 2 1 1 -clamp on c d.png", "newmtl e", "map_Kd ..\\f.png # g")

COMMAND_LINES = [
    ["--help"], ["simplify", "--version"], ["info", "mesh.stl", "--json"],
    ["simplify", "scan.ply", "-o", "base.ply", "--faces", "100", "--report", "r.json", "--correspondence", "c.ply"],
    ["simplify", "--ratio=0.5", "--time-limit", "1.5", "--max-displacement", "1%", "scan.off", "--output=b.obj"],
    ["simplify", "--preset", "paper", "--directions", "area", "--store-directions", "no", "--placement", "midpoint",
     "--boundary", "trim", "--threads", "2", "--no-verify", "--quiet", "-o", "b.ply", "--", "-scan.ply"],
    ["verify", "base.ply", "scan.ply", "--report", "r.json", "--violations", "v.ply", "--threads", "2", "--quiet"],
]


def drawn():
    """Bytes for the fuzzers that draw from them."""
    source = random.Random(20230914)
    return [source.randbytes(size) for size in (32, 64, 128, 256, 512) for _ in range(8)]


SEEDS = {
    "read_ply": [ascii_ply(), binary_ply("<"), binary_ply(">"), binary_ply("<", base=True), ascii_base_ply(),
                 coloured_ply(), textured_ply()],
    "read_obj": [obj(normals=False), obj(normals=True), textured_obj()],
    "read_off": [off("OFF"), off("COFF"), QUADS_OFF, TEXTURED_OFF],
    "read_stl": [ascii_stl(), binary_stl()],
    "read_base_mesh": [binary_ply("<", base=True), ascii_base_ply(), kept_base_ply(), obj(normals=True)],
    "read_material_library": [MATERIALS],
    "command_line": [lines(*arguments) for arguments in COMMAND_LINES],
    "inverse_displacement": drawn(),
    "point_in_prismoid": drawn(),
    "line_in_prismoid": drawn(),
    "vertex_signs": drawn(),
    "decimate": drawn(),
    "verify": drawn(),
}


def main():
    for fuzzer, seeds in SEEDS.items():
        folder = Path(sys.argv[1]) / fuzzer
        folder.mkdir(parents=True, exist_ok=True)
        for number, seed in enumerate(seeds):
            (folder / f"seed-{number}").write_bytes(seed)


if __name__ == "__main__":
    main()
