"""Honest files that are laid out in odd ways. Shares no code with foldless."""

import struct

from encoded_meshes import MEGABYTE, changed, ply_ascii, small_mesh

MESH = small_mesh()


def mixed_line_ends(data):
    """LF, CR LF and CR in turn."""
    ends = (b"\n", b"\r\n", b"\r")
    rows = data.split(b"\n")
    return b"".join(row + ends[i % 3] for i, row in enumerate(rows[:-1])) + rows[-1]


# Changes of a text that change nothing of what it says.
HARMLESS = {
    "as it is": lambda data: data,
    "CR LF": lambda data: data.replace(b"\n", b"\r\n"),
    "CR only": lambda data: data.replace(b"\n", b"\r"),
    "mixed line ends": mixed_line_ends,
    "a byte order mark": lambda data: b"\xef\xbb\xbf" + data,
    "a byte order mark and CR LF": lambda data: b"\xef\xbb\xbf" + data.replace(b"\n", b"\r\n"),
    "no final line end": lambda data: data.rstrip(b"\n"),
    "tabs": lambda data: data.replace(b" ", b"\t"),
    "many blanks": lambda data: data.replace(b" ", b" \t  \t "),
    "form feeds": lambda data: data.replace(b" ", b" \f\v"),
    "blanks before each line": lambda data: b"  \t" + data.replace(b"\n", b"\n \t"),
    "blanks behind each line": lambda data: data.replace(b"\n", b" \t\n"),
    "blanks and CR LF": lambda data: data.replace(b"\n", b" \r\n"),
    "empty lines": lambda data: data.replace(b"\n", b"\n\n \n"),
    "empty lines at the start": lambda data: b"\n \r\n\t\n" + data,
    "empty lines at the end": lambda data: data + b"\n\r\n\r \t\n\n",
    "a megabyte of empty lines at the end": lambda data: data + b"\n" * MEGABYTE,
    "a megabyte of blanks in a line": lambda data: changed(data, b" ", b" " * MEGABYTE),
}
FIRST_PLY_LINE = b"ply\n"


def ply_with(before=b"", between=b"", after=b"", rows=(b"", b"", b"")):
    """An ascii PLY file with further elements before, between and behind vertices and faces."""
    whole = ply_ascii(MESH)
    cuts = [0, *whole.edges]
    start, vertex, face, vertices, faces = (whole.data[a:b] for a, b in zip(cuts, cuts[1:]))
    face = face.removesuffix(b"end_header\n")
    return b"".join([start, before, vertex, between, face, after, b"end_header\n", rows[0], vertices, rows[1], faces, rows[2]])


def ply_bytes_with(order, extra_vertex, extra_face, mesh=MESH):
    """A binary PLY file whose vertices and faces have further properties, before and behind those that are read."""
    points, faces = mesh
    form = "big" if order == ">" else "little"
    header = (
        f"ply\nformat binary_{form}_endian 1.0\nelement vertex {len(points)}\n"
        "property list uchar short before\nproperty float x\nproperty uchar red\nproperty float y\nproperty float z\n"
        "property double behind\n"
        f"element face {len(faces)}\nproperty uchar flag\nproperty list uchar int vertex_index\n"
        "property list int float texcoord\nproperty ushort colour\nend_header\n"
    )
    data = header.encode("ascii")
    for i, (x, y, z) in enumerate(points):
        values = extra_vertex(i)
        data += struct.pack(f"{order}B{len(values)}h", len(values), *values)
        data += struct.pack(order + "fBffd", x, i % 256, y, z, 1 / 3)
    for i, face in enumerate(faces):
        values = extra_face(i)
        data += struct.pack(order + "BB3i", i % 256, 3, *face)
        data += struct.pack(f"{order}i{len(values)}fH", len(values), *values, i)
    return data
