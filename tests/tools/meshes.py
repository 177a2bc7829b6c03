"""Small scans with known properties, and how to write them to files."""

import array
import math
import sys


def tetrahedron():
    return [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]


def octahedron():
    points = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (-1, 0, 0), (0, -1, 0), (0, 0, -1)]
    return points, [(0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2), (1, 0, 5), (3, 1, 5), (4, 3, 5), (0, 4, 5)]


def sphere(rings, segments):
    """A closed sphere with gentle bumps: 2 * segments * (rings - 1) faces."""

    def point(ring, segment):
        theta, phi = math.pi * ring / rings, 2 * math.pi * segment / segments
        radius = 1 + 0.02 * math.sin(5 * theta) * math.cos(4 * phi)
        return (
            radius * math.sin(theta) * math.cos(phi),
            radius * math.sin(theta) * math.sin(phi),
            radius * math.cos(theta),
        )

    points = [point(0, 0)]
    points += [point(ring, segment) for ring in range(1, rings) for segment in range(segments)]
    points.append(point(rings, 0))
    last = len(points) - 1

    def index(ring, segment):
        return 1 + (ring - 1) * segments + segment % segments

    faces = [(0, index(1, s), index(1, s + 1)) for s in range(segments)]
    for ring in range(1, rings - 1):
        for s in range(segments):
            a, b = index(ring, s), index(ring, s + 1)
            c, d = index(ring + 1, s), index(ring + 1, s + 1)
            faces += [(a, c, d), (a, d, b)]
    faces += [(last, index(rings - 1, s + 1), index(rings - 1, s)) for s in range(segments)]
    return points, faces


def hill(cells):
    """An open height field over the unit square: 2 * cells * cells faces, 4 * cells border edges."""
    row = cells + 1
    steps = [i / cells for i in range(row)]
    points = [(x, y, 0.1 * math.sin(3 * x) * math.cos(2 * y)) for y in steps for x in steps]
    corners = [j * row + i for j in range(cells) for i in range(cells)]
    faces = [face for a in corners for face in ((a, a + 1, a + row + 1), (a, a + row + 1, a + row))]
    return points, faces


def write_off(path, mesh):
    points, faces = mesh
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [f"{x!r} {y!r} {z!r}" for x, y, z in points]
    lines += [" ".join(map(str, (len(face), *face))) for face in faces]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def write_obj(path, mesh):
    points, faces = mesh
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in points]
    lines += ["f " + " ".join(str(corner + 1) for corner in face) for face in faces]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def write_ply(path, mesh):
    """Binary little endian, float32: quick to write and to read for large meshes."""
    points, faces = mesh
    header = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {len(points)}\nproperty float x\nproperty float y\nproperty float z\n"
        f"element face {len(faces)}\nproperty list int int vertex_indices\nend_header\n"
    )
    vertices = array.array("f", [coordinate for point in points for coordinate in point])
    indices = array.array("i", [number for face in faces for number in (3, *face)])
    if sys.byteorder == "big":
        vertices.byteswap()
        indices.byteswap()
    path.write_bytes(header.encode("ascii") + vertices.tobytes() + indices.tobytes())


def ply_header(path):
    """The lines of the header of a PLY file."""
    return path.read_bytes().split(b"end_header\n")[0].decode("ascii").splitlines()


def ply_count(path, element):
    """How many of an element the header of a PLY file announces."""
    return next(int(line.split()[2]) for line in ply_header(path) if line.startswith(f"element {element} "))
