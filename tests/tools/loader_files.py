"""Files for loaders of meshes: 52 malformed ones, from which no honest mesh can be read, and odd ones that are honest."""

import struct
from dataclasses import dataclass

from encoded_meshes import (
    TEXTS,
    changed,
    compressed,
    content,
    encoded,
    extension,
    obj,
    off,
    ply_ascii,
    ply_big_endian,
    ply_binary,
    small_mesh,
    stl_ascii,
    stl_binary,
)
from layouts import HARMLESS, ply_bytes_with, ply_with

MESH = small_mesh()
POINTS, FACES = MESH
N = len(POINTS)
# Where sections end, as numbers into Encoded.edges.
PLY_FORMAT, PLY_VERTEX_HEADER, PLY_HEADER, PLY_VERTICES, PLY_FACES = range(5)
OFF_KEYWORD, OFF_COUNTS, OFF_VERTICES, OFF_FACES = range(4)
STL_START, STL_COUNT, STL_TRIANGLES = range(3)


@dataclass(frozen=True)
class LoaderFile:
    """A file, and the mesh that it spells: None where it is malformed."""

    name: str
    suffix: str
    data: bytes
    mesh: tuple | None = None


def until(whole, section):
    """The file as far as a section, that one included."""
    return whole.data[: whole.edges[section]]


def half(whole, section):
    """The file as far as the middle of a section."""
    return whole.data[: (whole.edges[section - 1] + whole.edges[section]) // 2]


def truncations():
    """Group A. OBJ announces nothing: it is malformed only if it ends within a line."""
    for name in ("ply ascii", "ply little endian", "ply big endian"):
        whole = encoded(name, MESH)
        yield f"{name}: half of the vertices", "ply", half(whole, PLY_VERTICES)
        yield f"{name}: half of the faces", "ply", half(whole, PLY_FACES)
    yield "ply ascii: half of the header", "ply", half(ply_ascii(MESH), PLY_HEADER)
    yield "ply big endian: the header alone", "ply", until(ply_big_endian(MESH), PLY_HEADER)
    yield "obj: the last face lacks a corner", "obj", obj(MESH).data.rpartition(b" ")[0]
    yield "off: half of the faces", "off", half(off(MESH), OFF_FACES)
    yield "stl ascii: half of the facets", "stl", half(stl_ascii(MESH), STL_TRIANGLES)
    yield "stl binary: half of the triangles", "stl", half(stl_binary(MESH), STL_TRIANGLES)


def counts():
    """Group B."""
    text, little = ply_ascii(MESH).data, ply_binary(MESH).data
    vertices, faces = f"element vertex {N}\n".encode(), f"element face {len(FACES)}\n".encode()
    for count in (N - 1, N + 1, -N, 99999999999999999999):
        yield f"ply ascii: {count} vertices", "ply", changed(text, vertices, f"element vertex {count}\n".encode())
    for count in (len(FACES) - 1, len(FACES) + 1):
        yield f"ply ascii: {count} faces", "ply", changed(text, faces, f"element face {count}\n".encode())
    yield "ply little endian: 2^31 vertices", "ply", changed(little, vertices, b"element vertex 2147483648\n")
    yield "ply little endian: a list of 255", "ply", little[:-13] + b"\xff" + little[-12:]
    signed = ply_binary(MESH, length="int").data
    yield "ply little endian: a list of -3", "ply", signed[:-16] + struct.pack("<i", -3) + signed[-12:]
    for spelled in (f"{N} {len(FACES) + 1}", f"-{N} {len(FACES)}"):
        yield f"off: counts {spelled}", "off", changed(off(MESH).data, f"\n{N} {len(FACES)} ".encode(), f"\n{spelled} ".encode())
    triangles = stl_binary(MESH).data
    for count in (len(FACES) - 1, len(FACES) + 1, 2**32 - 1):
        yield f"stl binary: {count} triangles", "stl", triangles[:80] + struct.pack("<I", count) + triangles[84:]


def indices():
    """Group C: the last corner, or the last face."""
    corner = f" {FACES[-1][-1]}\n".encode()
    for index in (str(N), "-1", str(2**32 + 1), "1.5"):
        yield f"ply ascii: index {index}", "ply", ply_ascii(MESH).data.removesuffix(corner) + f" {index}\n".encode()
    for index in (N, -1):
        yield f"ply little endian: index {index}", "ply", ply_binary(MESH).data[:-4] + struct.pack("<i", index)
    yield f"ply big endian: index {2**31 - 1}", "ply", ply_big_endian(MESH).data[:-4] + struct.pack(">i", 2**31 - 1)
    for index in (N, -1):
        yield f"off: index {index}", "off", off(MESH).data.removesuffix(corner) + f" {index}\n".encode()
    start = obj(MESH).data.rpartition(b" ")[0]
    for index in ("0", str(N + 1), str(-N - 1), str(2**32 + 1)):
        yield f"obj: index {index}", "obj", start + f" {index}\n".encode()


def numbers():
    """Group D: the first vertex, at 0.0 0.0 1.0."""
    double = ply_ascii(MESH, vertex="double").data
    for name, data, spelled in (
        ("ply ascii", double, b"zero 0.0 1.0"),
        ("ply ascii", double, b"1e400 0.0 1.0"),
        ("obj", obj(MESH).data, b"0,5 0,0 1,0"),
        ("obj", obj(MESH).data, b"0.0 0.0"),
        ("off", off(MESH).data, b"1.0.0 0.0 1.0"),
        ("off", off(MESH).data, b"--1 0.0 1.0"),
        ("stl ascii", stl_ascii(MESH).data, b"zero 0.0 1.0"),
        ("stl ascii", stl_ascii(MESH).data, b"0.0 0.0"),
    ):
        yield f"{name}: coordinates {spelled.decode()}", extension(name), changed(data, b"0.0 0.0 1.0\n", spelled + b"\n")


def lies():
    """Group E."""
    text, little = ply_ascii(MESH).data, ply_binary(MESH).data
    yield "ply little endian, which says big endian", "ply", changed(little, b"little", b"big")
    yield "ply ascii, which says little endian", "ply", changed(text, b"ascii", b"binary_little_endian")
    yield "ply little endian, which says ascii", "ply", changed(little, b"binary_little_endian", b"ascii")
    yield "ply ascii without a property z", "ply", changed(text, b"property float z", b"property float w")
    yield "obj, compressed", "obj", compressed(obj(MESH).data)


def malformed_files():
    files = [LoaderFile(*file) for group in (truncations, counts, indices, numbers, lies) for file in group()]
    assert len(files) == 52, len(files)
    return files


LAYOUTS = (
    "CR LF", "CR only", "a byte order mark", "no final line end", "tabs", "blanks behind each line", "empty lines at the end"
)
LIST_TYPES = (
    ("ushort", "int"), ("uint", "int"), ("int", "uint"), ("uchar", "uchar"), ("uchar", "short"), ("char", "ushort")
)


def layouts():
    for name in TEXTS:
        for how in LAYOUTS:
            yield f"{name}: {how}", extension(name), HARMLESS[how](encoded(name, MESH).data), content(name, MESH)
    whole = ply_binary(MESH)
    header = HARMLESS["CR LF"](until(whole, PLY_HEADER))
    yield "ply little endian: a header with CR LF", "ply", header + whole.data[whole.edges[PLY_HEADER] :], MESH
    for name in ("ply ascii", "obj", "off", "stl binary"):
        suffix = extension(name).upper()
        yield f"{name}: extension {suffix}", suffix, encoded(name, MESH).data, content(name, MESH)


def types():
    for length, index in LIST_TYPES:
        for name, encode in (("little", ply_binary), ("big", ply_big_endian)):
            yield f"ply {name} endian: list {length} {index}", "ply", encode(MESH, length=length, index=index).data, MESH
    sized = ply_ascii(MESH).data.replace(b"float", b"float32").replace(b"uchar int", b"uint8 int32")
    yield "ply ascii: float32, uint8, int32", "ply", sized, MESH
    thirds = [tuple(x / 3 for x in point) for point in POINTS], FACES
    for encode in (ply_ascii, ply_binary, ply_big_endian):
        name = encode.__name__.replace("_", " ")
        yield f"{name}: double coordinates", "ply", encode(thirds, vertex="double").data, thirds
    for name in ("obj", "off"):
        yield f"{name}: coordinates of 17 digits", extension(name), encoded(name, thirds).data, thirds


def ply_with_more():
    rows = b"1 2 0.5 3\n" * 3
    extra = b"element extra 3\nproperty int a\nproperty list uchar float b\n"
    for i, place in enumerate(("before", "between", "after")):
        data = ply_with(**{place: extra}, rows=tuple(rows if i == j else b"" for j in range(3)))
        yield f"ply ascii: an unknown element {place}", "ply", data, MESH
    for order, name in (("<", "little"), (">", "big")):
        data = ply_bytes_with(order, lambda i: [i] * 3, lambda i: [0.25] * 3)
        yield f"ply {name} endian: unknown properties", "ply", data, MESH
    form = b"format ascii 1.0\n"
    for name, comments in (
        ("comments", b"comment made by hand\nobj_info 1 2 3\n"),
        ("a comment that says end_header", b"comment end_header\n"),
    ):
        yield f"ply ascii: {name}", "ply", changed(ply_ascii(MESH).data, form, form + comments), MESH


def obj_with_more():
    data = obj(MESH).data
    more = b"o thing\ng one two\ns off\nvt 0.5 0.5\nvn 0 0 1\n"
    yield "obj: comments on lines of their own", "obj", data.replace(b"f ", b"# f 1 2 3\nf "), MESH
    yield "obj: comments behind statements", "obj", data.replace(b"\n", b" # v 1 2 3\n"), MESH
    yield "obj: names, groups, normals", "obj", more + data.replace(b"f ", more + b"f ", 1), MESH
    slashes = [" ".join(f"{c + 1}/1/1" for c in face) for face in FACES]
    vertices = data[: data.index(b"f ")]
    yield "obj: indices with slashes", "obj", vertices + more + "".join(f"f {s}\n" for s in slashes).encode(), MESH
    yield "obj: negative indices", "obj", obj((POINTS, [tuple(c - N - 1 for c in face) for face in FACES])).data, MESH
    yield "obj: continued lines", "obj", data.replace(b"f ", b"f \\\n"), MESH


def off_with_more():
    whole = off(MESH)
    start, faces = until(whole, OFF_VERTICES), whole.data[whole.edges[OFF_VERTICES] :]
    yield "off: comments on lines of their own", "off", changed(whole.data, b"\n", b"\n# 1 2 3\n", 5), MESH
    yield "off: comments behind numbers", "off", changed(whole.data, b"\n", b" # 1 2 3\n", 5), MESH
    yield "off: counts behind the keyword", "off", changed(whole.data, b"OFF\n", b"OFF "), MESH
    yield "off: colours of faces", "off", start + faces.replace(b"\n", b" 0.1 0.2 0.3 1\n"), MESH
    counts_end = whole.edges[OFF_COUNTS]
    coloured = start[counts_end:].replace(b"\n", b" 255 0 0 255\n")
    yield "off: colours of vertices", "off", b"C" + start[:counts_end] + coloured + faces, MESH


def stl_with_more():
    welded = content("stl binary", MESH)
    for header in (b"solid", b"solid ascii", b"solid x\nfacet normal 0 0 1\n"):
        yield f"stl binary: starts with {header.decode()!r}", "stl", stl_binary(MESH, header).data, welded
    data = bytearray(stl_binary(MESH).data)
    for at in range(84, len(data), 50):
        data[at + 48 : at + 50] = b"\xff\x7f"
    yield "stl binary: attributes", "stl", bytes(data), welded
    yield "stl ascii: upper case", "stl", stl_ascii(MESH).data.upper(), welded
    yield "stl ascii: no name", "stl", changed(stl_ascii(MESH).data, b"solid small mesh", b"solid"), welded


def honest_files():
    groups = (layouts, types, ply_with_more, obj_with_more, off_with_more, stl_with_more)
    return [LoaderFile(*file) for group in groups for file in group()]
