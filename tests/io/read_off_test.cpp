#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace foldless {
namespace {

const std::string body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

void expect_triangle(const std::string& text) {
    const ReadScan read = scan_of("a.off", text);
    EXPECT_EQ(read.scan.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})) << text;
    EXPECT_EQ(read.scan.faces, (std::vector<Triangle>{{0, 1, 2}})) << text;
}

TEST(OffReader, FindsTheCountsOnTheHeaderLineOrTheNext) {
    for (const char* header : {"OFF\n3 1 3\n", "OFF 3 1 0\n", "OFF\n\n# comment\n3 1\n", "OFF3 1 0\n",
                               "OFF # 9 9 9\n3 1 0\n", "# first\n\t OFF\r\n3 1 3\r\n", "\xef\xbb\xbfOFF\r3 1 3\r"}) {
        expect_triangle(header + body);
    }
}

TEST(OffReader, ReadsOverColoursNormalsAndTextureCoordinates) {
    expect_triangle("COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 0 0 0#red\n0 1 0 1 1 1 1\n3 0 1 2 0.9 0 0 # blue\n");
    expect_triangle("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 17\n");
    const std::string all =
        "STCNOFF\n3 1 0\n0 0 0 0 0 1 1 1 1 1 0 0\n1 0 0 0 0 1 1 1 1 1 0 0\n0 1 0 0 0 1 1 1 1 1 0 0\n";
    expect_triangle(all + "3 0 1 2\n");
    EXPECT_EQ(scan_of("a.off", all + "3 0 1 2\n").notes.ignored,
              (std::vector<std::string>{"texture coordinates", "colours", "normals"}));
    EXPECT_EQ(scan_of("a.off", "OFF\n1 0 0\n0 0 0 1 1 1\n").notes.ignored, (std::vector<std::string>{"colours"}));
}

TEST(OffReader, FansConvexPolygonsAndCountsThem) {
    const ReadScan read = scan_of("a.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3");
    EXPECT_EQ(read.scan.faces, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(read.notes.fanned_polygons, 1U);
    EXPECT_EQ(refused("a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 2 1 3\n2 0 1\n"),
              "a.off: 1 polygon is not convex and planar, 1 face has fewer than three corners");
}

TEST(OffReader, RefusesMalformedFiles) {
    struct Malformed {
        std::string text;
        const char* message;
    };
    const Malformed cases[] = {
        {"ply\n", "line 1: an OFF file starts with 'OFF', not with 'ply'"},
        {"3 1 0\n" + body, "line 1: an OFF file starts with 'OFF', not with '3'"},
        {"OFF BINARY\n", "line 1: binary OFF cannot be read"},
        {"4OFF\n3 1 0\n" + body, "line 1: only OFF of dimension three can be read"},
        {"nOFF 3\n3 1 0\n" + body, "line 1: only OFF of dimension three can be read"},
        {"OFF\n", "line 2: the counts are missing"},
        {"OFF\n3\n" + body, "line 2: the count of faces is missing"},
        {"OFFx 1 0\n" + body, "line 1: 'x' for the count of vertices is not a number"},
        {"OFF\n3 -1 0\n" + body, "line 2: the count of faces is negative"},
        {"OFF\n3 1 0 0\n" + body, "line 2: unexpected '0' at the end of the line"},
        {"OFF\n3 x 0\n" + body, "line 2: 'x' for the count of faces is not a number"},
        {"OFF\n9223372036854775807 1 0\n" + body,
         "line 2: 9223372036854775807 vertices and 1 faces do not fit into the 27 bytes that are left"},
        {"OFF\n3 2147483648 0\n" + body,
         "line 2: 3 vertices and 2147483648 faces do not fit into the 27 bytes that are left"},
        {"OFF\n3 2 0\n" + body, "line 7: the file ends after 1 of 2 faces"},
        {"OFF\n4 1 0\n" + body, "line 7: the file ends after 0 of 1 faces"},
        {"OFF\n2 1 0\n" + body, "line 6: data behind the last face"},
        {"OFF\n3 1 0\n" + body + "3 0 1 2\n", "line 7: data behind the last face"},
        {"OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "line 4: z is missing"},
        {"OFF\n3 1 0\n0 0 0\n1 0 0 x\n0 1 0\n3 0 1 2\n", "line 4: 'x' for a colour is not a number"},
        {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "line 6: vertex index 3 is out of range (3 vertices)"},
        {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "line 6: vertex index -1 is out of range (3 vertices)"},
        {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000000 0 1 2\n", "line 6: a vertex index is missing"},
        {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n", "line 6: the length of a face is negative"},
    };
    for (const auto& [text, message] : cases) {
        EXPECT_EQ(unreadable("a.off", text), std::string("a.off: ") + message) << text;
    }
}

} // namespace
} // namespace foldless
