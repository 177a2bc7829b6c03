"""Group E, polygons: those that are convex and planar are fanned from their first vertex, all others are refused."""

import math
import unittest

from encoded_meshes import encoded, extension
from faults import Case, FaultTest

INDEXED = ("ply ascii", "ply little endian", "ply big endian", "obj", "off")
CUBE = (
    [(float(x), float(y), float(z)) for z in (0, 1) for y in (0, 1) for x in (0, 1)],
    [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)],
)


def fanned(mesh):
    points, faces = mesh
    return points, [(face[0], a, b) for face in faces for a, b in zip(face[1:], face[2:])]


def polygon(*corners):
    """An open mesh of one polygon."""
    return [tuple(map(float, corner)) for corner in corners], [tuple(range(len(corners)))]


def star(corners, step):
    """A regular polygon that goes to every `step`-th corner."""
    return polygon(
        *((math.cos(2 * math.pi * step * i / corners), math.sin(2 * math.pi * step * i / corners), 0) for i in range(corners))
    )


def rounded(mesh):
    """Coordinates that a float holds."""
    return [tuple(round(x * 4096) / 4096 for x in point) for point in mesh[0]], mesh[1]


CONVEX = {
    "a cube of squares": CUBE,
    "a square": polygon((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)),
    "a polygon of 60 corners": rounded(star(60, 1)),
    "a pentagon that is flat to a ten thousandth": polygon((0, 0, 0), (2, 0, 0.0001220703125), (3, 1, 0), (2, 2, 0), (0, 2, 0)),
}
# Each is missed by all conditions but one.
REFUSED = {
    "concave at its first corner": polygon((0.5, 0.5, 0), (0, 2, 0), (0, 0, 0), (2, 0, 0)),
    "concave at another corner": polygon((0, 0, 0), (2, 0, 0), (0.5, 0.5, 0), (0, 2, 0)),
    "not planar": polygon((0, 0, 0), (1, 0, 0), (1, 1, 0.5), (0, 1, 0)),
    "folded along its diagonal": polygon((0, 0, 0), (1, 0, 0), (1, 1, 0.015625), (0, 1, 0)),
    "crossing itself": polygon((0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)),
    "a star that turns twice": rounded(star(5, 2)),
    "wound twice": polygon((0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 1, 0), (1.5, 1, 0), (1.5, 1.5, 0), (1, 1.5, 0)),
    "all in one point": polygon((1, 1, 1), (1, 1, 1), (1, 1, 1), (1, 1, 1)),
    "all on one line": polygon((0, 0, 0), (1, 1, 1), (2, 2, 2), (3, 3, 3)),
}


class Polygons(FaultTest):
    group = "E polygons"

    def test_that_are_convex_and_planar_are_fanned(self):
        for what, mesh in CONVEX.items():
            for name in INDEXED:
                with self.case(what=what, encoding=name):
                    self.expect_accepted(f"polygon.{extension(name)}", encoded(name, mesh).data, fanned(mesh))

    def test_that_are_not_are_counted(self):
        says = r"\A1 polygon is not convex and planar\Z"
        for what, mesh in REFUSED.items():
            for name in INDEXED:
                with self.case(what=what, encoding=name):
                    self.expect_refused(Case(what, f"polygon.{extension(name)}", encoded(name, mesh).data, 4, says))

    def test_are_counted_together_with_faces_that_are_too_short(self):
        points, faces = REFUSED["crossing itself"]
        for name in INDEXED:
            with self.case(encoding=name):
                data = encoded(name, (points, [faces[0], (0, 1), faces[0], ()])).data
                says = r"\A2 polygons are not convex and planar, 2 faces have fewer than three corners\Z"
                self.expect_refused(Case("both", f"polygon.{extension(name)}", data, 4, says))

    def test_with_a_coordinate_that_is_not_finite_are_refused_for_that(self):
        points, faces = CUBE
        for name in INDEXED:
            with self.case(encoding=name):
                data = encoded(name, ([(float("nan"), 0.0, 0.0), *points[1:]], faces)).data
                self.expect_refused(Case("nan", f"polygon.{extension(name)}", data, 4, r"\A1 vertex that is not finite\Z"))


if __name__ == "__main__":
    unittest.main()
