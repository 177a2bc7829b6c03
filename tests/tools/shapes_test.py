"""Shapes that scanners, modellers and mistakes make: each is certified, or refused by the name of its defect."""

import math
import unittest

from meshes import hill, octahedron, sphere, tetrahedron, write_off
from program import ProgramTest


def joined(*meshes):
    """The meshes as one, side by side in the file."""
    points, faces = [], []
    for more_points, more_faces in meshes:
        faces += [tuple(corner + len(points) for corner in face) for face in more_faces]
        points += more_points
    return points, faces


def moved(mesh, by):
    points, faces = mesh
    return [tuple(a + b for a, b in zip(point, by)) for point in points], faces


def strip(segments, half_turns):
    """A band around the z axis: an annulus, or with one half turn a Moebius strip."""
    points, faces = [], []
    for i in range(segments):
        angle = 2 * math.pi * i / segments
        tilt = half_turns * angle / 2
        for w in (-0.3, 0.3):
            radius = 1 + w * math.cos(tilt)
            points.append((radius * math.cos(angle), radius * math.sin(angle), w * math.sin(tilt)))
    for i in range(segments):
        a, b, c, d = 2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 3
        if i == segments - 1:
            c, d = (1, 0) if half_turns % 2 else (0, 1)
        faces += [(a, c, d), (a, d, b)]
    return points, faces


def klein_bottle(around, across):
    points, faces = [], []
    for i in range(around):
        u = 2 * math.pi * i / around
        for j in range(across):
            v = 2 * math.pi * j / across
            radius = 2 + math.cos(u / 2) * math.sin(v) - math.sin(u / 2) * math.sin(2 * v)
            height = math.sin(u / 2) * math.sin(v) + math.cos(u / 2) * math.sin(2 * v)
            points.append((radius * math.cos(u), radius * math.sin(u), height))

    def index(i, j):
        return j % across + i * across if i < around else -j % across

    for i in range(around):
        for j in range(across):
            a, b, c, d = index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)
            faces += [(a, b, c), (a, c, d)]
    return points, faces


def cube(cells):
    """Each side cut into cells * cells squares: all collapses tie."""
    numbers, faces = {}, []

    def number(point):
        return numbers.setdefault(point, len(numbers))

    for axis in range(3):
        for side in (0, cells):

            def corner(a, b, axis=axis, side=side):
                point = [side] * 3
                point[(axis + 1) % 3], point[(axis + 2) % 3] = a, b
                return number(tuple(point))

            for i in range(cells):
                for j in range(cells):
                    square = corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)
                    if side == 0:
                        square = square[::-1]
                    faces += [square[:3], (square[0], square[2], square[3])]
    return [tuple(coordinate / cells for coordinate in point) for point in numbers], faces


def double_cone(edges):
    """Two vertices of that many edges."""
    angles = [2 * math.pi * i / edges for i in range(edges)]
    points = [(0, 0, 1), (0, 0, -1)] + [(math.cos(a), math.sin(a), 0) for a in angles]
    ring = [(2 + i, 2 + (i + 1) % edges) for i in range(edges)]
    return points, [(0, a, b) for a, b in ring] + [(1, b, a) for a, b in ring]


def perfect_sphere(rings, segments):
    points, faces = sphere(rings, segments)
    return [tuple(c / math.hypot(*point) for c in point) for point in points], faces


BALL = sphere(8, 12)
OCTAHEDRON = octahedron()
SQUARE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]


def with_far_face(third_corner):
    """The ball, and a face beside it on (5, 0, 0), (6, 0, 0) and a third corner."""
    return joined(BALL, ([(5, 0, 0), (6, 0, 0), third_corner], [(0, 1, 2)]))


def tetrahedra_at_one_vertex():
    points, faces = tetrahedron()
    mirrored = [tuple(0 if corner == 0 else corner + 3 for corner in face)[::-1] for face in faces]
    return points + [tuple(-c for c in point) for point in points[1:]], faces + mirrored


ACCEPTED = {
    "a vertex twice, bit for bit": (OCTAHEDRON[0] + OCTAHEDRON[0][:1], [(6, 1, 2)] + OCTAHEDRON[1][1:]),
    "a vertex twice, one ulp apart": (
        OCTAHEDRON[0] + [(math.nextafter(1, 2), 0, 0)],
        [(6, 1, 2)] + OCTAHEDRON[1][1:],
    ),
    "inside out": (BALL[0], [face[::-1] for face in BALL[1]]),
    "one component inside out": joined(BALL, moved((BALL[0], [face[::-1] for face in BALL[1]]), (4, 0, 0))),
    "a pair of faces on the same corners": (SQUARE[:3], [(0, 1, 2), (0, 2, 1)]),
    "vertices that no face uses": (BALL[0] + [(9, 9, 9), (0, 0, 0)], BALL[1]),
    "one triangle": (SQUARE[:3], [(0, 1, 2)]),
    "an open disc": hill(6),
    "an open annulus": strip(24, 0),
    "a strip of two half turns": strip(24, 2),
    "a thousand components": joined(*(moved(OCTAHEDRON, (3 * i, 0, 0)) for i in range(1000))),
    "convex polygons": (SQUARE, [(0, 1, 2, 3)]),
    "an area of 1e-300": with_far_face((6, 1e-300, 0)),
    "components that cross": joined(BALL, moved(BALL, (0.7, 0, 0))),
    "components that touch": joined(OCTAHEDRON, moved(OCTAHEDRON, (2, 0, 0))),
    "components that lie on each other": joined(hill(4), moved(hill(4), (0.1, 0.1, 0))),
    "a fold of less than a tenth of a degree": ([*SQUARE[:3], (0.5, 0.1, 1e-4)], [(0, 1, 2), (1, 0, 3)]),
    "a fan of slivers": (
        [(0, 0, 0)] + [(1, 1e-9 * i, 1e-12 * (i % 3)) for i in range(40)],
        [(0, i, i + 1) for i in range(1, 39)],
    ),
    "a flat square": ([(x, y, 0) for x, y, _ in hill(12)[0]], hill(12)[1]),
    "a perfect sphere": perfect_sphere(16, 32),
    "a cube of many faces in a plane": cube(16),
    "a vertex of ten thousand edges": double_cone(10000),
}

REFUSED = {
    "no faces": ((SQUARE, []), "no faces"),
    "no vertices": (([], []), "no faces"),
    "a face twice": ((OCTAHEDRON[0], OCTAHEDRON[1] + OCTAHEDRON[1][:1]), "3 non-manifold edges"),
    "a face turned over": ((BALL[0], [BALL[1][0][::-1]] + BALL[1][1:]), "3 inconsistently oriented edges"),
    "an edge of three faces": (
        ([*SQUARE[:2], (0, 1, 0), (0, -1, 0), (0, 0, 1)], [(0, 1, 2), (1, 0, 3), (0, 1, 4)]),
        "1 non-manifold edge",
    ),
    "an edge of four faces": (
        (
            [*SQUARE[:2], (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)],
            [(0, 1, 2), (1, 0, 3), (0, 1, 4), (1, 0, 5)],
        ),
        "1 non-manifold edge",
    ),
    "a bow tie": (
        ([(0, 0, 0), (1, 0, 0), (1, 1, 0), (-1, 0, 0), (-1, -1, 0)], [(0, 1, 2), (0, 3, 4)]),
        "1 non-manifold vertex",
    ),
    "two tetrahedra at one vertex": (tetrahedra_at_one_vertex(), "1 non-manifold vertex"),
    "a vertex in the middle of another's edge": (
        (SQUARE + [(0.5, 0.5, 0)], [(0, 1, 2), (0, 4, 3), (4, 2, 3)]),
        "2 non-manifold vertices",
    ),
    "a Moebius strip": (strip(24, 1), "1 non-orientable component"),
    "a Klein bottle": (klein_bottle(24, 12), "1 non-orientable component"),
    "a face on a line": (with_far_face((7, 0, 0)), "1 zero-area face"),
    "a face on two points": (with_far_face((6, 0, 0)), "1 zero-area face"),
    "a polygon with a dent": (
        ([(0, 0, 0), (2, 0, 0), (0.5, 0.5, 0), (0, 2, 0)], [(0, 1, 2, 3)]),
        "1 polygon is not convex and planar",
    ),
    "a polygon that is bent": ((SQUARE[:3] + [(0, 1, 0.5)], [(0, 1, 2, 3)]), "1 polygon is not convex and planar"),
    "a polygon of two corners": ((SQUARE, [(0, 1), (0, 1, 2)]), "1 face has fewer than three corners"),
}


class ShapesTest(ProgramTest):
    def test_shapes_without_defects_are_certified(self):
        for name, mesh in ACCEPTED.items():
            with self.subTest(name):
                write_off(self.folder / "scan.off", mesh)
                self.assertIn("simplify accepts this mesh", self.expect(0, "info", "scan.off").stdout)
                self.expect(0, "simplify", "scan.off", "-o", "base.ply", "--report", "report.json")
                self.expect(0, "verify", "base.ply", "scan.off", "--report", "verified.json")
                self.assertEqual(self.json_of("verified.json")["certificate"]["level"], "surface")
                report = self.json_of("report.json")
                self.assertEqual(report["input"]["faces"], sum(len(face) - 2 for face in mesh[1]))
                self.assertLessEqual(report["output"]["faces"], report["input"]["faces"])

    def test_what_repair_leaves_is_accepted(self):
        beyond_repair = {"no faces", "no vertices", "a polygon with a dent", "a polygon that is bent"}
        beyond_repair |= {"a polygon of two corners"}
        for name, (mesh, _) in REFUSED.items():
            with self.subTest(name):
                write_off(self.folder / "scan.off", mesh)
                if name in beyond_repair:
                    self.expect_one_line(4, "repair", "scan.off", "-o", "whole.ply")
                    continue
                self.expect(0, "repair", "scan.off", "-o", "whole.ply")
                self.expect(0, "simplify", "whole.ply", "-o", "base.ply")
                self.expect(0, "verify", "base.ply", "whole.ply")

    def test_shapes_with_a_defect_are_refused_by_its_name(self):
        for name, (mesh, defect) in REFUSED.items():
            with self.subTest(name):
                write_off(self.folder / "scan.off", mesh)
                self.assertIn(defect, self.expect(0, "info", "scan.off").stdout)
                self.assertIn(defect, self.expect_one_line(4, "simplify", "scan.off", "-o", "base.ply"))
                self.assertEqual(self.files(), ["scan.off"])


if __name__ == "__main__":
    unittest.main()
