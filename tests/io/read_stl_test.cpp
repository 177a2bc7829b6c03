#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <string>
#include <vector>

namespace foldless {
namespace {

using Corners = std::array<Vec3, 3>;

const Corners lower{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
const Corners upper{Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
const std::vector<Vec3> welded_positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
const std::vector<Triangle> welded_faces{{0, 1, 2}, {1, 3, 2}};

std::string facet(const Corners& corners) {
    std::string text = "facet normal 0 0 1\n outer loop\n";
    for (const Vec3& c : corners) {
        text += "  vertex " + std::to_string(c.x()) + " " + std::to_string(c.y()) + " " + std::to_string(c.z()) + "\n";
    }
    return text + " endloop\nendfacet\n";
}

const std::string ascii_square = "solid a b c\n" + facet(lower) + facet(upper) + "endsolid a b c\n";

void append(std::string& bytes, float number) {
    char stored[sizeof(float)];
    std::memcpy(stored, &number, sizeof(float));
    if (std::endian::native == std::endian::big) {
        std::swap(stored[0], stored[3]);
        std::swap(stored[1], stored[2]);
    }
    bytes.append(stored, sizeof(float));
}

std::string binary(std::string header, const std::vector<Corners>& triangles) {
    header.resize(80, ' ');
    std::string bytes = header + std::string{static_cast<char>(triangles.size()), 0, 0, 0};
    for (const Corners& triangle : triangles) {
        bytes.append(12, '\0');
        for (const Vec3& corner : triangle) {
            for (const double coordinate : corner) {
                append(bytes, static_cast<float>(coordinate));
            }
        }
        bytes.append(2, '\0');
    }
    return bytes;
}

void expect_square(const ReadScan& read) {
    EXPECT_EQ(read.scan.positions, welded_positions);
    EXPECT_EQ(read.scan.faces, welded_faces);
    EXPECT_EQ(read.notes.welded_vertices, 2U);
    EXPECT_EQ(read.notes.ignored, (std::vector<std::string>{"normals"}));
    EXPECT_TRUE(read.scan.float32);
}

TEST(StlReader, ReadsAscii) {
    expect_square(scan_of("a.stl", ascii_square));
    expect_square(scan_of("a.stl", "\xef\xbb\xbf \n" + ascii_square));
    std::string shouted = ascii_square;
    for (char& c : shouted) {
        c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    }
    expect_square(scan_of("a.STL", shouted));
}

TEST(StlReader, ReadsSeveralSolids) {
    expect_square(scan_of("a.stl", "solid\n" + facet(lower) + "endsolid\nsolid two\n" + facet(upper) + "endsolid"));
}

TEST(StlReader, ReadsBinary) {
    expect_square(scan_of("a.stl", binary("any header", {lower, upper})));
}

TEST(StlReader, TellsABinaryFileBySizeEvenIfItSaysSolid) {
    expect_square(scan_of("a.stl", binary("solid facet normal", {lower, upper})));
    EXPECT_EQ(scan_of("a.stl", binary("solid", {})).scan.faces.size(), 0U);
}

TEST(StlReader, WeldsMinusZeroButNothingThatIsOnlyNear) {
    const Corners minus{Vec3(-0.0, 0, -0.0), Vec3(1, -0.0, 0), Vec3(0, -1, 0)};
    EXPECT_EQ(scan_of("a.stl", binary("", {lower, minus})).scan.positions.size(), 4U);
    const Corners near{Vec3(1e-45, 0, 0), Vec3(1, 0, 0), Vec3(0, -1, 0)};
    EXPECT_EQ(scan_of("a.stl", binary("", {lower, near})).scan.positions.size(), 5U);
}

TEST(StlReader, KeepsFacesThatWeldingMadeDegenerate) {
    const Corners flat{Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(1, 0, 0)};
    EXPECT_EQ(scan_of("a.stl", binary("", {flat})).scan.faces, (std::vector<Triangle>{{0, 0, 1}}));
}

TEST(StlReader, RefusesMalformedAsciiFiles) {
    struct Malformed {
        std::string_view from;
        std::string_view to;
        const char* message;
    };
    const Malformed cases[] = {
        {"facet normal 0 0 1", "facet normal 0 0", "line 2: z is missing"},
        {"facet normal 0 0 1", "facet normal 0 0 up", "line 2: 'up' for z is not a number"},
        {"facet normal", "facet normals", "line 2: 'normals' stands where 'normal' should stand"},
        {"outer loop", "outer", "line 4: 'vertex' stands where 'loop' should stand"},
        {"endloop", "vertex 0 0 0\nendloop", "line 7: 'vertex' stands where 'endloop' should stand"},
        {"endfacet", "", "line 9: 'facet' stands where 'endfacet' should stand"},
        {"0.000000 0.000000 0.000000", "0 0", "line 4: z is missing"},
        {"0.000000 0.000000 0.000000", "0 0 0,0", "line 4: '0,0' for z is not a number"},
        {"endsolid a b c\n", "", "line 16: the file ends before 'endsolid'"},
        {"endsolid a b c\n", "endsolid\nfacet", "line 17: 'facet' stands where 'solid' should stand"},
        {"facet", "color", "line 2: 'color' stands where 'facet' or 'endsolid' should stand"},
    };
    for (const auto& [from, to, message] : cases) {
        std::string text = ascii_square;
        text.replace(text.find(from), from.size(), to);
        EXPECT_EQ(unreadable("a.stl", text), std::string("a.stl: ") + message) << to;
    }
    EXPECT_EQ(unreadable("a.stl", "solid\nfacet normal 0 0 1 outer loop vertex 0 0 0"),
              "a.stl: line 2: the file ends where 'vertex' should stand");
}

TEST(StlReader, RefusesBinaryFilesOfAnotherSize) {
    const std::string whole = binary("x", {lower, upper});
    EXPECT_EQ(unreadable("a.stl", whole.substr(0, 183)),
              "a.stl: byte 80: 2 triangles take 184 bytes, but the file has 183");
    EXPECT_EQ(unreadable("a.stl", whole + "x"), "a.stl: byte 80: 2 triangles take 184 bytes, but the file has 185");
    EXPECT_EQ(unreadable("a.stl", whole.substr(0, 83)),
              "a.stl: byte 83: neither ascii STL nor the 84 bytes of a binary header");
    std::string many = whole;
    many.replace(80, 4, "\xff\xff\xff\xff");
    EXPECT_EQ(unreadable("a.stl", many),
              "a.stl: byte 80: 4294967295 triangles take 214748364834 bytes, but the file has 184");
}

} // namespace
} // namespace foldless
