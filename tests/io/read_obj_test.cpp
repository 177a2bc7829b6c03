#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace foldless {
namespace {

using Faces = std::vector<Triangle>;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ObjReader, ReadsFacesInEveryForm) {
    const Faces expected{{0, 1, 2}};
    for (const char* face : {"f 1 2 3", "f 1/1 2/2 3/3", "f 1//1 2//1 3//1", "f 1/1/1 2/2/1 3/3/1", "f\t1  2\t3 ",
                             "f -4 -3 -2", "f +1 -3 3", "fo 1 2 3", "f 1 \\\n2 3", "f 1 2\\\r\n 3 # end", "f 1 2 3#"}) {
        EXPECT_EQ(scan_of("a.obj", square + face + "\n").scan.faces, expected) << face;
        EXPECT_EQ(scan_of("a.obj", square + face).scan.faces, expected) << face;
    }
}

TEST(ObjReader, ReadsPositionsAsTheNearestDoubles) {
    const ReadScan read = scan_of("a.obj", "v 0.1 -2.5e-3 +4\r\nv 0.5 0 1e300\r\n");
    EXPECT_EQ(read.scan.positions, (std::vector<Vec3>{{0.1, -2.5e-3, 4}, {0.5, 0, 1e300}}));
    EXPECT_FALSE(read.scan.float32);
    EXPECT_TRUE(scan_of("a.obj", square).scan.float32);
}

TEST(ObjReader, CountsNegativeIndicesFromTheVerticesSoFar) {
    const std::string text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 -2 -1\n";
    EXPECT_EQ(scan_of("a.obj", text).scan.faces, (Faces{{0, 1, 2}, {0, 2, 3}}));
}

TEST(ObjReader, LetsFacesNameLaterVertices) {
    EXPECT_EQ(scan_of("a.obj", "f 1 2 3\n" + square).scan.faces, (Faces{{0, 1, 2}}));
    EXPECT_EQ(unreadable("a.obj", "\nf 1 2 5\n" + square),
              "a.obj: line 2: vertex index 5 is out of range (4 vertices)");
}

TEST(ObjReader, FansConvexPolygonsAndCountsThem) {
    const ReadScan read = scan_of("a.obj", square + "f 1 2 3 4\nf 4 3 2\n");
    EXPECT_EQ(read.scan.faces, (Faces{{0, 1, 2}, {0, 2, 3}, {3, 2, 1}}));
    EXPECT_EQ(read.notes.fanned_polygons, 1U);
    EXPECT_EQ(refused("a.obj", square + "f 1 3 2 4\nf 1 2 4 3\nf 1 2\nf\n"),
              "a.obj: 2 polygons are not convex and planar, 2 faces have fewer than three corners");
}

TEST(ObjReader, NotesWhatItIgnores) {
    const std::string text = "mtllib a.mtl\no thing\ng left\ns 1\nusemtl b\nv 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0\n"
                             "vt 0 0\nvn 0 0 1\nvp 1\nl 1 2\np 1\ncsh -x\nf 1 2 3\nusemtl c\ng f 1 2 3\n";
    const ReadScan read = scan_of("a.obj", text);
    EXPECT_EQ(read.scan.faces.size(), 1U);
    EXPECT_EQ(read.notes.ignored,
              (std::vector<std::string>{"materials", "object names", "groups", "smoothing groups", "vertex weights",
                                        "colours", "texture coordinates", "normals", "free-form geometry", "lines",
                                        "points", "'csh' statements"}));
}

TEST(ObjReader, DoesNotCheckIndicesOfWhatItIgnores) {
    EXPECT_EQ(scan_of("a.obj", square + "f 1/9/9 2//7 3/-8\n").scan.faces.size(), 1U);
}

TEST(ObjReader, RefusesMalformedStatements) {
    struct Malformed {
        const char* line;
        const char* message;
    };
    const Malformed cases[] = {
        {"v 1 2", "z is missing"},
        {"v 1 2 z", "'z' for z is not a number"},
        {"v 1 2 1e400", "'1e400' for z is too large"},
        {"v 1 2 3 red", "'red' for a colour or weight is not a number"},
        {"f 0 1 2", "vertex index 0 is out of range (4 vertices)"},
        {"f 1 2 5", "vertex index 5 is out of range (4 vertices)"},
        {"f -5 1 2", "vertex index -5 is out of range (4 vertices)"},
        {"f 1 2 4294967297", "vertex index 4294967297 is out of range (4 vertices)"},
        {"f 1 2 99999999999999999999", "'99999999999999999999' for a vertex index is not an integer"},
        {"f 1 2 1.5", "'1.5' for a vertex index is not an integer"},
        {"f 1 2 /3", "'' for a vertex index is not an integer"},
        {"f 1 2 3/", "'' for a texture index is not an integer"},
        {"f 1 2 3//", "'' for a normal index is not an integer"},
        {"f 1 2 3/x", "'x' for a texture index is not an integer"},
        {"f 1 2 3/1/1/1", "'1/1' for a normal index is not an integer"},
        {"f 1 2 3,", "'3,' for a vertex index is not an integer"},
        {"1 2 3", "'1' is no OBJ statement"},
        {"\x89PNG", "'?PNG' is no OBJ statement"},
        {"\x01", "byte 0x01 is not text"},
    };
    for (const auto& [line, message] : cases) {
        EXPECT_EQ(unreadable("a.obj", square + line + "\n"), std::string("a.obj: line 5: ") + message) << line;
    }
}

} // namespace
} // namespace foldless
